"""A stretch by where it begins, or ends, and how long it goes on: "from 4pm for thirty minutes"."""

from dataclasses import replace

from fuzzytime.language.english.amounts.durations import typed as typed_length
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer, Typed
from fuzzytime.language.meaning.expressions import (
    Duration,
    Goal,
    Offset,
    Range,
    Said,
    Wall,
)
from fuzzytime.language.meaning.joined.beside import lasts_then
from fuzzytime.requirement import Constraint

grammar = Grammar()


@grammar.rule(
    "said",
    "from|starting|beginning at? the? <goal> ,? for <duration>",
    "for <duration> ,? from|starting|beginning from|at|on? the? <goal>",
    "<duration> starting|beginning from|at|on|in? the? <goal>",
    weight=0.9,
)
def lasting(first: Goal | Duration, second: Duration | Goal) -> Said | None:
    """From 4pm for thirty minutes, for 2 hours from 2pm: a start, and how long."""
    goal, duration = (second, first) if isinstance(first, Duration) else (first, second)
    if not isinstance(goal, Goal) or not isinstance(duration, Duration) or not isinstance(goal.time, Wall):
        return None
    return Said(goal.time, None, "at", goal.hedges, lasting=duration)


@grammar.rule("said", "for <15h30> ,? from|at|on? the? <wall>", weight=1.2)
def lasting_typed(numbers: Typed, wall: Wall) -> Said | None:
    """For 1h30 on friday at 15:00: of two clock times the first is how long."""
    duration = typed_length(numbers)
    return None if duration is None or wall.clock is None else Said(wall, None, None, lasting=duration)


@grammar.rule("said", "from <duration>|<integer> to <duration>", weight=-2)
def changed_length(first: Duration | Integer, second: Duration) -> Said | None:
    """(change the timer) from ten to fifteen minutes: the second is how long it is then."""
    return None if second.until is not None else lasts_then(second)


@grammar.rule("said", "for|during|in|over the? last|final <duration> before the? <wall>", weight=1.2)
def last_before(duration: Duration, wall: Wall) -> Said | None:
    """For the last half hour before bedtime."""
    if wall.bare or duration.until is not None:
        return None
    begins = Offset(replace(duration, hedges=()), -1, wall)
    return Said(Range(begins, wall), Constraint.BETWEEN, "during", duration.hedges)
