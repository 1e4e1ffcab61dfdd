"""Clock times with the letter h: "15h30", "15h", "18.30h", and "at 7h"."""

from fuzzytime.language.english.clock_times.clocks import FULL_DIGITS, NOON_HOUR, military, typed
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer, Typed
from fuzzytime.language.meaning.times_of_day import Clock
from fuzzytime.requirement import Unit

grammar = Grammar()

EARLIEST_WITH_H = 8
"""From here on, "15h" is a clock time, where "3h" is a length."""

EARLIEST_WITH_MINUTES = 6
"""The same of "6h30", behind what binds a clock time and a length alike."""


@grammar.rule("clock", "<15h30>")
def typed_with_h(numbers: Typed) -> Clock | None:
    """15h30, 3h18."""
    hour, minute = numbers[0], numbers[1]
    return Clock(hour % 24, minute, 0, Unit.MINUTE, full_day=True) if hour <= 24 and minute < 60 else None


@grammar.rule("clock", "<integer> h <integer>", weight=-0.1)
def spaced_with_h(hour: Integer, minute: Integer) -> Clock | None:
    """10 H 10."""
    if hour.value > 24 or minute.value >= 60 or not (hour.digits and minute.digits):
        return None
    return Clock(hour.value % 24, minute.value, 0, Unit.MINUTE)


@grammar.rule("clock", "<integer> h", weight=-0.2)
def hour_with_h(hour: Integer) -> Clock | None:
    """15h, 1830h; but 3h alone is a length, and so is 24h."""
    if len(hour.digits) == FULL_DIGITS:
        return military(hour)
    return (
        Clock(hour.value, 0, 0, Unit.MINUTE, full_day=True)
        if hour.digits and EARLIEST_WITH_H <= hour.value < 24
        else None
    )


@grammar.rule("late clock with h", "<15h30> .?")
@grammar.rule("late clock with h", "<integer> h .?")
def late_with_h(said: Typed | Integer) -> Clock | None:
    """(not before) 14h30, 6h30: a length of time is hardly as long, nor as exact; but "not before 2h"."""
    found = typed_with_h(said) if isinstance(said, Typed) else hour_with_h(said)
    earliest = EARLIEST_WITH_MINUTES if isinstance(said, Typed) else EARLIEST_WITH_H
    return found if found is not None and found.hour >= earliest else None


@grammar.rule("clock behind at", "<integer> h .?")
def short_hour(hour: Integer) -> Clock | None:
    """(at) 7h, 1830h.: so many hours are hardly waited."""
    if len(hour.digits) == FULL_DIGITS:
        return military(hour)
    return Clock(hour.value, 0, 0, Unit.MINUTE, full_day=True) if hour.digits and hour.value <= 24 else None


@grammar.rule("clock", "<hh.mm> h", weight=0.6)
def dotted_with_h(numbers: Typed) -> Clock | None:
    """18.30h; but 8.30h alone may be a length."""
    return typed(numbers) if numbers[0] > NOON_HOUR else None
