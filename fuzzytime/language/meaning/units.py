"""Units of time, and how many of them are said."""

from dataclasses import dataclass

from fuzzytime.requirement import Unit

UNIT_SECONDS = {
    Unit.SECOND: 1.0,
    Unit.MINUTE: 60.0,
    Unit.HOUR: 3600.0,
    Unit.DAY: 86400.0,
    Unit.WEEK: 7 * 86400.0,
    Unit.MONTH: 30 * 86400.0,
    Unit.QUARTER: 90 * 86400.0,
    Unit.YEAR: 365 * 86400.0,
}
"""Seconds in a unit of a duration; a month counts 30 days, a year 365."""


@dataclass(frozen=True, slots=True)
class Quantity:
    """How many: a number, and the hedge that it is ("a few"); ``indefinite`` for "a" and "an"."""

    value: float
    hedges: tuple[str, ...] = ()
    indefinite: bool = False


@dataclass(frozen=True, slots=True)
class UnitWord:
    """A unit as said, and how many of it the word means (a fortnight: 2 weeks)."""

    unit: Unit
    count: int
    form: str
