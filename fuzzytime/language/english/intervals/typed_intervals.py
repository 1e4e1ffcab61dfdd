"""Intervals as they are typed: "2026-03-28T17:00/PT2H" as ISO 8601 has it, "5-7/3/2026", "around 3-4"."""

from dataclasses import replace

from fuzzytime.language.english.calendar.dates import century, month_first
from fuzzytime.language.english.clock_times.clocks import number, typed_to_the_second
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer, Typed
from fuzzytime.language.meaning.calendar import Calendar, Fields
from fuzzytime.language.meaning.expressions import Duration, Offset, Range, Said, Wall
from fuzzytime.language.meaning.joined.distances import LOWER, UPPER
from fuzzytime.language.meaning.times_of_day import Clock
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()

LONGEST_MONTH, MONTHS = 31, 12

FRACTIONS = frozenset({3, 6})
"""Digits of the thousandths of a second, and of its millionths."""

HALF_DAY, HOUR = 12, 60
"""Hours of half a day, and minutes of one of them."""

FEW_HOURS = 3
"""Hours between two that something is around, at most."""

NEAR_YEARS = range(25, 40)
"""Years in two digits that are more than any hour."""

UNITS = (Unit.YEAR, Unit.MONTH, Unit.WEEK, Unit.DAY, Unit.HOUR, Unit.MINUTE, Unit.SECOND)
"""Units of a typed length, in their order."""


@grammar.rule("duration", "<iso length>", weight=0.5)
def typed_length(numbers: Typed) -> Duration | None:
    """PT45M, P1DT12H."""
    terms = tuple((float(part), unit) for part, unit in zip(numbers.parts, UNITS, strict=True) if int(part))
    return Duration(terms) if terms else None


@grammar.rule("said", "<wall> / <wall>", "<wall> - - <wall>", weight=1.5)
def interval(first: Wall, last: Wall) -> Said | None:
    """2026-03-28T17:00/2026-03-29T19:30, 2026-03-28/2026-03-30, 2026-03-28T17:00/19:30."""
    if not _is_dated(first) or not (_is_dated(last) or _is_clock(last)):
        return None
    if (first.clock is None) is not (last.clock is None):
        return None
    return Said(Range(first, last), Constraint.BETWEEN, "between")


@grammar.rule("said", "<wall> / <iso length>", "<wall> - - <iso length>", weight=1.5)
def begun(first: Wall, numbers: Typed) -> Said | None:
    """2026-03-28T17:00/PT2H: a start, and how long."""
    length = typed_length(numbers)
    return Said(first, None, "at", lasting=length) if _is_dated(first) and length is not None else None


@grammar.rule("said", "<iso length> / <wall>", weight=1.5)
def ended(numbers: Typed, last: Wall) -> Said | None:
    """PT2H/2026-03-28T17:00: how long, and its end."""
    length = typed_length(numbers)
    if length is None or not _is_dated(last):
        return None
    return Said(Range(Offset(length, -1, last), last), Constraint.BETWEEN, "between")


@grammar.rule("clock", "<hh:mm:ss> . <integer>", weight=0.4)
def with_fraction(numbers: Typed, fraction: Integer) -> Clock | None:
    """17:00:00.000: the fraction of the second is left out."""
    return typed_to_the_second(numbers) if len(fraction.digits) in FRACTIONS else None


@grammar.rule("wall", "<date> t <integer> z?", weight=0.5)
def basic(days: Calendar, digits: Integer) -> Wall | None:
    """20260328T170000: hour, minute and second without marks."""
    if len(digits.digits) != len("hhmmss"):
        return None
    parts = tuple(digits.digits[place : place + 2] for place in range(0, len(digits.digits), 2))
    clock = typed_to_the_second(Typed(parts))
    return None if clock is None else Wall(days, clock=replace(clock, full_day=True))


@grammar.rule("said", "<integer> .? - <n-n-n>", weight=2.0)
def days_of_typed_month(first: Integer, last: Typed) -> Said | None:
    """5-7/3/2026: whichever of the first two is a day behind the other."""
    year = century(last[2], last.parts[2])
    for month, day in ((last[0], last[1]), (last[1], last[0])):
        if 1 <= first.value < day <= LONGEST_MONTH and 1 <= month <= MONTHS:
            ends = (Wall(Fields(year, month, one)) for one in (first.value, day))
            return Said(Range(*ends), Constraint.BETWEEN, "between")
    return None


@grammar.rule("said", "<hedge> <integer> - <integer>", weight=1.0)
def around_hours(hedge: str, first: Integer, last: Integer) -> Said | None:
    """(call) around 3-4: hours, and no date."""
    clocks = [number(one) for one in (first, last)]
    if None in clocks or not 1 <= last.value - first.value <= FEW_HOURS or hedge in UPPER | LOWER:
        return None
    return Said(Range(*(Wall(clock=clock) for clock in clocks)), Constraint.BETWEEN, "between", (hedge,))


@grammar.rule("said", "at? <clock> for <clock>", weight=1.5)
def for_later(first: Clock, last: Clock) -> Said | None:
    """(Supper) 7 for 7.30pm, 6.30 for 7pm: guests come between both; but "at 7 for 8" is how many."""
    minutes = [clock.hour % HALF_DAY * HOUR + clock.minute for clock in (first, last)]
    near = 0 < (minutes[1] - minutes[0]) % (HALF_DAY * HOUR) <= HOUR
    told = last.minute > 0 or last.half is not None
    if not (near and told) or first.shift or last.shift:
        return None
    return Said(Range(*(Wall(clock=clock) for clock in (first, last))), Constraint.BETWEEN, "between")


@grammar.rule("date", "<month day> <month> <integer>", weight=0.9)
def with_bare_year(day: int, month: int, number: Integer) -> Fields | None:
    """5 july 26: the number is a year, as an hour stands behind "at" and none is as high."""
    near = number.digits and number.value in NEAR_YEARS
    return replace(month_first(month, day), year=century(number.value, number.digits)) if near else None


@grammar.rule("date", "<month> <month day> <integer>", "<month> <month day> , <integer>", weight=0.9)
def with_bare_year_behind(month: int, day: int, number: Integer) -> Fields | None:
    """July 5 26."""
    return with_bare_year(day, month, number)


def _is_dated(wall: Wall) -> bool:
    """Whether it is on a day of a month of a year."""
    days = wall.days
    return isinstance(days, Fields) and days.fixed and days.grain is Unit.DAY and wall.part is None


def _is_clock(wall: Wall) -> bool:
    """Whether it is nothing but a clock time, and no number."""
    return wall.clock is not None and wall.days is None and wall.part is None and not wall.clock.bare
