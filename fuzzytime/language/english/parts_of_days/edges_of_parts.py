"""The start and the end of a part of a day: "by the end of the afternoon", "at the start of the evening"."""

from dataclasses import dataclass, replace

from fuzzytime.language.english.at_times.goals import before_goal
from fuzzytime.language.english.at_times.prepositions import said_of
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.meaning.calendar import Calendar, Cycle
from fuzzytime.language.meaning.days.relations import Deictic, Which
from fuzzytime.language.meaning.expressions import Duration, Edge, Ending, Goal, Repeat, Said, Wall
from fuzzytime.language.meaning.times_of_day import Part
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()

HALF = 0.5

THIRD = 1 / 3
"""How much of a part of the day its start, or its end, is, as of longer periods."""


@dataclass(frozen=True, slots=True)
class EdgeOfPart:
    """The start or the end of a part of a day."""

    edge: Edge
    wall: Wall

    @property
    def goal(self) -> Goal:
        """As when something is done: in its first third, or in its last."""
        share = (0.0, THIRD) if self.edge is Edge.START else (1 - THIRD, 1.0)
        part = self.wall.part
        return Goal(
            self.wall if part is None else replace(self.wall, part=replace(part, late=None).share(*share))
        )

    def bound(self, preposition: Preposition, constraint: Constraint) -> Said:
        """As a bound: where it begins, or is over."""
        return said_of(Goal(self.wall), preposition.name, constraint, self.edge)


@grammar.rule("edge of part", "the? <edge> of? the? <wall>")
def edge_of_part(edge: Edge, wall: Wall) -> EdgeOfPart | None:
    """The end of the afternoon, the start of tomorrow morning; but the end of lunch is an event's."""
    part = wall.part
    if part is None or part.meal or part.is_point or wall.clock is not None or wall.weak:
        return None
    return EdgeOfPart(edge, wall)


@grammar.rule("said", "<preposition_at> <edge of part>", "near <edge of part>", weight=0.5)
def at_edge(first: Preposition | EdgeOfPart, second: EdgeOfPart | None = None) -> Said | None:
    """At the end of the evening, towards the end of the afternoon."""
    edge = second if isinstance(first, Preposition) else first
    name = first.name if isinstance(first, Preposition) else "around"
    return said_of(edge.goal, name) if isinstance(edge, EdgeOfPart) and name != "for" else None


@grammar.rule("said", "<preposition_before> <edge of part>", weight=0.7)
def by_edge(preposition: Preposition, edge: EdgeOfPart) -> Said:
    """By the end of the morning: before it is over."""
    return edge.bound(preposition, Constraint.BEFORE)


@grammar.rule("said", "<preposition_after> <edge of part>", weight=0.7)
def after_edge(preposition: Preposition, edge: EdgeOfPart) -> Said:
    """After the end of the morning, from the start of the afternoon."""
    return edge.bound(preposition, Constraint.AFTER)


@grammar.rule("repeat", "at|by|towards? <edge> every|each <part>", weight=0.5)
def edge_of_every_part(edge: Edge, part: Part) -> Repeat | None:
    """At the end of every afternoon."""
    found = edge_of_part(edge, Wall(Cycle(Unit.DAY), part))
    return (
        None if found is None or not isinstance(found.goal.time, Wall) else Repeat(walls=(found.goal.time,))
    )


@grammar.rule(
    "said",
    "<preposition_before> the? <share> the? <part>",
    "<preposition_before> <share> this|that <part>",
    weight=0.7,
)
def by_late_part(preposition: Preposition, share: tuple[float, float], part: Part) -> Said | None:
    """By late afternoon: before the middle of what is late in it, as it is late from then on."""
    low, high = share
    if low < HALF or part.is_point or part.meal:
        return None
    late = part.share(low, high)
    found = Wall(part=replace(late, start=(late.start + late.end) // 2, late=None))
    return said_of(Goal(found), preposition.name, Constraint.BEFORE, Edge.START)


@grammar.rule("period end", "<series> -? end")
def period_end(series: Calendar) -> Goal | None:
    """(by) month end; but "the year end report", and a week end is free."""
    longer = isinstance(series, Cycle) and series.unit not in {Unit.DAY, Unit.WEEK}
    return Goal(Ending(Edge.END, Deictic(Which.THIS, series))) if longer else None


@grammar.rule("goal", "<duration> before <period end>", "<duration> prior to <period end>", weight=0.2)
def before_period_end(duration: Duration, goal: Goal) -> Goal | None:
    """A week before month end."""
    return before_goal(duration, goal)


@grammar.rule("said", "<preposition_before> <period end>", weight=0.4)
def by_period_end(preposition: Preposition, goal: Goal) -> Said:
    """By month end."""
    return said_of(goal, preposition.name, Constraint.BEFORE, preposition.edge)


@grammar.rule("said", "<preposition_at> <period end>", weight=0.4)
def at_period_end(preposition: Preposition, goal: Goal) -> Said:
    """At month end."""
    return said_of(goal, preposition.name)
