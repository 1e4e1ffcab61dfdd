"""Bounds a little off a time: "by just before noon", "from just after 3 to just before 5"."""

from dataclasses import replace

from fuzzytime.language.english.bounds import deadline, release
from fuzzytime.language.english.ranges import between
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.meaning.expressions import Edge, Ending, Goal, Said, Wall

grammar = Grammar()


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


def _edge_of(goal: Goal) -> Edge:
    """Give which edge of a time is meant: before it its start, after it its end."""
    return Edge.END if goal.hedges[0].endswith("after") else Edge.START


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
    return between(first, last)
