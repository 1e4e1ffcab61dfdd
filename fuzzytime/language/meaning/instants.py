"""Stretches of wall-clock time, and moments so long apart on it."""

from dataclasses import dataclass, replace
from datetime import date, datetime, time, timedelta

from fuzzytime.language.meaning.calendar import moved
from fuzzytime.language.meaning.expressions import Duration
from fuzzytime.language.meaning.times_of_day import Clock, Half
from fuzzytime.requirement import Unit

SUB_DAY = frozenset({Unit.SECOND, Unit.MINUTE, Unit.HOUR})
CALENDAR_UNITS = frozenset({Unit.MONTH, Unit.QUARTER, Unit.YEAR})


@dataclass(frozen=True, slots=True)
class Instants:
    """Wall-clock time, from ``start`` to before ``end``; a moment where the two are one.

    ``choices`` are the starts that the words may mean, ascending, where the policy had to decide; ``zone``
    is that of the clock that the words named.
    """

    start: datetime
    end: datetime
    grain: Unit
    choices: tuple[datetime, ...] = ()
    zone: str | None = None

    @property
    def is_point(self) -> bool:
        """Whether it is a moment."""
        return self.start == self.end


def midnight(day: date) -> datetime:
    """Give the moment a day begins on the wall clock."""
    return datetime.combine(day, time())


def shifted(moment: datetime, duration: Duration, direction: int) -> datetime:
    """Give the moment a duration away: months and years by the calendar, all else by the clock."""
    found = moment
    for amount, unit in duration.terms:
        if unit is Unit.YEAR and amount != int(amount):
            # Half a year is six months.
            amount, unit = amount * 12, Unit.MONTH  # noqa: PLW2901 - the same length
        if unit in CALENDAR_UNITS and amount == int(amount):
            day = moved(found.date(), unit, int(amount) * direction)
            found = datetime.combine(day, found.time())
        else:
            found += timedelta(seconds=direction * Duration(((amount, unit),)).seconds)
    return found


def halved(clock: Clock, half: Half) -> Clock:
    """Give a clock time in a half of the day, where its own is open."""
    return replace(clock, half=half) if clock.is_open else clock


def next_minute(moment: datetime, minute: int) -> datetime:
    """Give the next moment of a minute of an hour."""
    there = moment.replace(minute=minute, second=0, microsecond=0)
    return there + timedelta(hours=there <= moment)
