"""Bounds a little off a time: "by just before noon", "from just after 3 to just before 5"."""

from dataclasses import replace

from fuzzytime.language.english.bounded.bounds import deadline, release
from fuzzytime.language.english.intervals.ranges import between, range_of
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.meaning.expressions import Duration, Edge, Ending, Goal, Offset, Said, Wall
from fuzzytime.language.meaning.joined.distances import EARLIER, far_off, said_offset
from fuzzytime.requirement import Constraint

grammar = Grammar()

UNBOUND = frozenset({"from", "until", "since"})
"""Bounds that nothing is made for."""


@grammar.rule("goal off", "<beside> the? <goal>", weight=0.4)
def goal_off(hedge: str, goal: Goal) -> Goal | None:
    """(by) just before noon."""
    return replace(goal, hedges=(hedge, *goal.hedges)) if isinstance(goal.time, (Wall, Ending)) else None


@grammar.rule("said", "<preposition_before> <goal off>", weight=0.6)
def deadline_off(preposition: Preposition, goal: Goal) -> Said | None:
    """By just before noon, until shortly after lunch."""
    said = deadline(preposition, goal)
    return None if said is None else replace(said, edge=_edge_of(goal))


@grammar.rule("said", "<preposition_after> <goal off>", weight=0.6)
def release_off(preposition: Preposition, goal: Goal) -> Said | None:
    """From just after three, not before a bit after five."""
    said = release(preposition, goal)
    return None if said is None else replace(said, edge=_edge_of(goal))


@grammar.rule("said", "with at? least? <duration> to spare before|for the? <goal>", weight=2.0)
def with_time_to_spare(duration: Duration, goal: Goal) -> Said | None:
    """(be there) with twenty minutes to spare before the 7:52."""
    clocked = goal.wall.clock is not None and isinstance(goal.time, Wall)
    return (
        Said(Offset(duration, -1, goal.time), Constraint.BEFORE, "before", goal.hedges) if clocked else None
    )


@grammar.rule("said", "with at? least? <duration> to spare", "with at? least? <duration> in hand", weight=0.3)
def with_some_to_spare(duration: Duration) -> Said:
    """(be there at six) with twenty minutes to spare: so long before what was just named."""
    return replace(said_offset(duration, EARLIER, -1), constraint=Constraint.BEFORE)


@grammar.rule(
    "said",
    "<said> with at? least? <duration> to spare",
    "<said> with at? least? <duration> in hand",
    weight=0.6,
)
def so_long_to_spare(named: Said, duration: Duration) -> Said | None:
    """At six with twenty minutes to spare: by twenty to six."""
    due = replace(named, constraint=Constraint.BEFORE) if named.wall.clock is not None else named
    return far_off(due, with_some_to_spare(duration))


def _edge_of(goal: Goal) -> Edge:
    """Give which edge of a time is meant: before it its start, after it its end."""
    return Edge.END if goal.hedges[0].endswith("after") else Edge.START


@grammar.rule("said", "for <preposition_before>|<preposition_after> <goal>", weight=0.3)
def for_bound(preposition: Preposition, goal: Goal) -> Said | None:
    """(an alarm) for no later than eight: made for a time that is a bound; but "for after lunch"."""
    clocked = goal.wall.clock is not None
    if not clocked or preposition.name in UNBOUND:
        return None
    side = deadline if preposition.constraint is Constraint.BEFORE else release
    return side(preposition, goal)


@grammar.rule("said", "for between <goal> and <goal>", weight=1.2)
def for_between(first: Goal, last: Goal) -> Said | None:
    """(a table) for between seven and eight."""
    clocked = first.wall.clock is not None and last.wall.clock is not None
    return between(first, last) if clocked else None


@grammar.rule("said", "for <goal off>", weight=0.3)
def for_off(goal: Goal) -> Said | None:
    """(an alarm) for just before eight."""
    clocked = goal.wall.clock is not None
    return Said(goal.time, None, None, goal.hedges, _edge_of(goal), beside=True) if clocked else None


@grammar.rule(
    "said",
    "between <goal off> and <goal>|<goal off>",
    "between the? <goal> and <goal off>",
    "from <goal off> to|-|until|till|til <goal>|<goal off>",
    "from the? <goal> to|-|until|till|til <goal off>",
    weight=1.1,
)
def between_off(first: Goal, last: Goal) -> Said | None:
    """From just after three to just before five, between noon and shortly after one."""
    return range_of(first, last)
