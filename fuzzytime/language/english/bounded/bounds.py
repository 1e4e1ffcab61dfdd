"""Bounds of a time: "by noon", "from six", "at noon at the latest", "until after lunch"."""

from dataclasses import replace

from fuzzytime.language.english.at_times.prepositions import said_of
from fuzzytime.language.english.calendar.feasts import feast_in
from fuzzytime.language.english.from_now.counted import coming_deadline
from fuzzytime.language.english.intervals.ranges import range_of
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields, Weekend
from fuzzytime.language.meaning.days.relations import Deictic, Relative, Which
from fuzzytime.language.meaning.expressions import (
    Coming,
    Duration,
    Edge,
    Ending,
    Goal,
    Offset,
    Said,
    TimeWord,
    Wall,
)
from fuzzytime.language.meaning.joined.distances import said_length
from fuzzytime.language.meaning.times_of_day import Clock
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()


@grammar.rule("said", "before the <days>|<series> is|'s out|over|up|through", weight=0.4)
def before_it_is_over(days: Calendar) -> Said:
    """Before the week is out."""
    period = Deictic(Which.THIS, days) if isinstance(days, Cycle) else days
    return Said(Ending(Edge.END, period), Constraint.BEFORE, "before", (), Edge.LAST)


@grammar.rule("said", "until|till the <days>|<series> is|'s out|over|up|through", weight=0.4)
def until_it_is_over(days: Calendar) -> Said:
    """Until the week is over."""
    return replace(before_it_is_over(days), preposition="until")


@grammar.rule("said", "<preposition_before> the? <goal>", weight=0.2)
def deadline(preposition: Preposition, goal: Goal) -> Said | None:
    """By noon, no later than six, before tomorrow; but "talk it through over lunch" is at lunch."""
    if preposition.name == "through" and (
        goal.hedges or (goal.wall.part is not None and goal.wall.part.meal)
    ):
        return None
    if isinstance(goal.time, TimeWord) and goal.time.constraint is not Constraint.AT:
        return None
    if isinstance(goal.time, Coming):
        return replace(coming_deadline(goal), preposition=preposition.name)
    edge = Edge.START if preposition.name == "by" and _is_prepared_for(goal) else preposition.edge
    return said_of(goal, preposition.name, Constraint.BEFORE, edge)


@grammar.rule("said", "<preposition_before>|<preposition_after> <clock> ,? <days away>", weight=1.5)
def bound_days_away(preposition: Preposition, clock: Clock, days: Calendar) -> Said | None:
    """By 11 a week from today: no eleven a week."""
    if not clock.bare:
        return None
    wall = Wall(days, clock=replace(clock, bare=False))
    return Said(wall, preposition.constraint, preposition.name, (), preposition.edge)


@grammar.rule("said", "due|deadline : by|on|at? <goal>", "( due|deadline by|on|at? <goal> )", weight=0.4)
def due(goal: Goal) -> Said | None:
    """(pay the rent) due: fri, (due friday): as lists of things to do have it; of a morning, its end."""
    parted = isinstance(goal.time, Wall) and goal.time.part is not None
    return said_of(goal, "by", Constraint.BEFORE, Edge.LAST if parted else Edge.DUE)


@grammar.rule("said", "due|deadline by|on|at? <goal>", weight=0.4)
def due_behind_thing(goal: Goal) -> Said | None:
    """(Create a task) due friday, (the report) due on the 15th."""
    return due(goal)


@grammar.rule("said", "due in|within <duration>", weight=0.6)
def due_in(duration: Duration) -> Said:
    """(The report is) due in two hours."""
    return said_length(duration, Constraint.BEFORE, "within")


def _is_prepared_for(goal: Goal) -> bool:
    """Whether it is a weekend, or a feast, by whose first day something is done: "by passover"."""
    days = goal.time.days if isinstance(goal.time, Wall) and goal.time.part is None else None
    feast = feast_in(days)
    if feast is not None:
        return feast.is_several
    of = days.of if isinstance(days, Deictic) else days
    return isinstance(of, Weekend) and not of.working


@grammar.rule("said", "<preposition_after> the? <goal>", weight=0.2)
def release(preposition: Preposition, goal: Goal) -> Said | None:
    """After 5 pm, from monday, not before noon."""
    if isinstance(goal.time, TimeWord) and goal.time.constraint is not Constraint.AT:
        return None
    return said_of(goal, preposition.name, Constraint.AFTER, preposition.edge)


@grammar.rule("said", "<preposition_before>|<preposition_after> <preposition_at> the? <goal>", weight=0.2)
def bound_at(preposition: Preposition, at: Preposition, goal: Goal) -> Said | None:
    """By sometime friday, no later than at six; not "up to around six", nor (read it) "through at six"."""
    if preposition.name == "through":
        return None
    side = deadline if preposition.constraint is Constraint.BEFORE else release
    return side(preposition, goal) if at.name in {"at", "on", "sometime"} else None


@grammar.rule("said", "<preposition_after> <late clock with h>", weight=0.6)
def not_before_with_h(preposition: Preposition, clock: Clock) -> Said | None:
    """Not before 14h30; but "after 14h" may be so long from now."""
    said = Said(Wall(clock=clock), Constraint.AFTER, preposition.name, (), preposition.edge)
    return said if preposition.name == "not before" else None


@grammar.rule(
    "said", "<preposition_before>|<preposition_after> <hedge>? <four digits with hours>", weight=0.8
)
def bound_with_hours(preposition: Preposition, hedge: str | None, clock: Clock) -> Said | None:
    """After 1330 hours, not before about 1800 hours; but "within 1000 hours" is so long."""
    if preposition.name == "within":
        return None
    hedges = () if hedge is None else (hedge,)
    return Said(Wall(clock=clock), preposition.constraint, preposition.name, hedges, preposition.edge)


@grammar.rule("said", "until|till|til after|past|gone the? <goal>", weight=0.4)
def until_after(goal: Goal) -> Said | None:
    """Until after lunch: until its end; "don't start it until after ten" is turned like every deadline."""
    if isinstance(goal.time, TimeWord):
        return None
    return said_of(goal, "until", Constraint.BEFORE, Edge.END)


@grammar.rule("said", "not until|till|before after|past|gone the? <goal>", weight=0.4)
def not_until_after(goal: Goal) -> Said | None:
    """Not until after ten."""
    if isinstance(goal.time, TimeWord):
        return None
    return said_of(goal, "not before", Constraint.AFTER, Edge.END)


@grammar.rule("said", "past|gone <clock>", weight=0.1)
def past_clock(clock: Clock) -> Said:
    """Past six; but "past tuesday" is the last one."""
    return Said(Wall(clock=clock), Constraint.AFTER, "after")


@grammar.rule("said", "ending on|with the? <wall>", weight=0.3)
def ending_on(wall: Wall) -> Said | None:
    """Ending on friday; but "a card ending with 12" is no time."""
    days = wall.days
    if days is None or wall.clock is not None or wall.part is not None or days.grain is Unit.YEAR:
        return None
    return Said(wall, Constraint.BEFORE, "through", (), Edge.LAST)


@grammar.rule("said", "past the? <goal>", weight=0.15)
def past_goal(goal: Goal) -> Said | None:
    """Past the weekend, past tomorrow evening, past the 15th; but "past tuesday" is the last one."""
    days = goal.wall.days
    timed = goal.wall.is_timed or (isinstance(days, Fields) and days.day is not None)
    if not (isinstance(goal.time, Ending) or timed or isinstance(days, (Deictic, Relative))):
        return None
    return said_of(goal, "after", Constraint.AFTER, Edge.END)


@grammar.rule("said", "by <goal> or|and later|after|onwards|onward", weight=0.4)
def by_or_later(goal: Goal) -> Said:
    """By friday or later."""
    return said_of(goal, "not before", Constraint.AFTER, Edge.START)


@grammar.rule("said", "<duration> from now on|onwards|onward", weight=0.6)
def from_then_on_counted(duration: Duration) -> Said:
    """An hour from now on."""
    return said_length(duration, Constraint.AFTER, "from now")


@grammar.rule("said", "from <goal> on|onwards|onward", weight=0.4)
def from_then_on(goal: Goal) -> Said | None:
    """From monday on, from now on; but "from 3 pm onwards" is not before that, and "from school" is where."""
    if goal.wall.part is not None and goal.wall.part.place:
        return None
    of_day = isinstance(goal.time, Wall) and (goal.time.clock is not None or goal.time.days is None)
    return said_of(goal, "not before" if of_day else "from", Constraint.AFTER, Edge.START)


@grammar.rule(
    "said",
    "<said> ,? at? the? very? latest",
    "at the? very? latest ,? <said>",
    "latest <said>",
    "<said> ,? or|and before|earlier|sooner",
    "<said> ,? or|and before that",
    "<said> ,? if not before|earlier|sooner",
    "<said> ,? no|not later than that",
    "<said> ,? no later",
    "<said> ,? and|but no|not later",
    weight=0.5,
)
@grammar.rule("said", "before|by it gets|is|turns <said> at the very? latest", weight=1.2)
def latest(said: Said) -> Said | None:
    """In, or after, ten minutes at the latest; before it gets dark at the latest: no state is waited for."""
    elapsed = said.constraint is Constraint.AFTER and isinstance(said.time, Duration)
    bound = elapsed or said.constraint in {None, Constraint.AT, Constraint.BEFORE}
    if not bound or isinstance(said.time, TimeWord):
        return None
    return replace(said, constraint=Constraint.BEFORE, preposition="no later than", edge=Edge.LAST)


@grammar.rule("said", "on? <wall> or on? <wall> ,? at the? very? latest", weight=1.6)
def latest_of_two(first: Wall, last: Wall) -> Said | None:
    """Today or tomorrow morning at the latest."""
    return None if first.days is None or last.days is None else latest(Said(last))


@grammar.rule(
    "said",
    "<said> ,? at? the? very? earliest|soonest",
    "at the? very? earliest ,? <said>",
    "earliest <said>",
    "<said> ,? or|and later|after|greater|onwards|onward",
    "<said> onwards|onward",
    "<said> ,? or any|some time after|later",
    "<said> ,? or anytime|sometime after|later",
    "<said> ,? and|but no|not before|earlier|sooner",
    "<said> ,? no earlier|sooner",
    weight=0.5,
)
def earliest(said: Said) -> Said | None:
    """In ten minutes at the earliest, at the earliest on friday."""
    if said.constraint not in {None, Constraint.AT, Constraint.AFTER} or isinstance(said.time, TimeWord):
        return None
    return replace(said, constraint=Constraint.AFTER, preposition="not before", edge=Edge.START)


@grammar.rule(
    "said",
    "any|some day|time ,? but|except|excluding|bar|save for|not? on|at|in? <said>",
    "anytime|whenever ,? but|except|excluding|bar|save for|not? on|at|in? <said>",
    "any|some day|time other|apart than|from <said>",
    weight=1.5,
)
def any_but(said: Said) -> Said | None:
    """Any day but friday, anytime except lunchtime."""
    return None if said.denied or isinstance(said.time, TimeWord) else replace(said, denied=True)


@grammar.rule(
    "said",
    "any|some time ,? but|except|excluding|bar|save for|from? <clock> to|- <clock>",
    "anytime|whenever ,? but|except|excluding|bar|save for|from? <clock> to|- <clock>",
    weight=2.4,
)
def any_but_hours(first: Clock, last: Clock) -> Said | None:
    """Any time except 12 to 2."""
    hours = range_of(Goal(Wall(clock=first)), Goal(Wall(clock=last)))
    return None if hours is None else any_but(hours)


@grammar.rule("said", "apart|aside from on|at|in? <said>", weight=0.5)
def apart_from(said: Said) -> Said | None:
    """(every day at nine) apart from sunday."""
    return None if said.denied or isinstance(said.time, (TimeWord, Duration)) else replace(said, denied=True)


@grammar.rule("said", "<hedge>? within the? <deictic>? <goal>", weight=0.2)
def within_time(hedge: str | None, which: object, goal: Goal) -> Said | None:
    """Within the day."""
    if isinstance(goal.time, (TimeWord, Offset)):
        return None
    if isinstance(goal.time, Coming):
        return replace(coming_deadline(goal), preposition="within")
    hedges = () if hedge is None else (hedge,)
    return Said(goal.time, Constraint.BEFORE, "within", (*hedges, *goal.hedges), Edge.LAST)
