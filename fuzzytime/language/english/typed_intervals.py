"""Intervals and lengths as ISO 8601 has them: "2026-03-28T17:00/19:30", "2026-03-28T17:00/PT2H", "PT45M"."""

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Typed
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import Duration, Offset, Range, Said, Wall
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()

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


def _is_dated(wall: Wall) -> bool:
    """Whether it is on a day of a month of a year."""
    days = wall.days
    return isinstance(days, Fields) and days.fixed and days.grain is Unit.DAY and wall.part is None


def _is_clock(wall: Wall) -> bool:
    """Whether it is nothing but a clock time, and no number."""
    return wall.clock is not None and wall.days is None and wall.part is None and not wall.clock.bare
