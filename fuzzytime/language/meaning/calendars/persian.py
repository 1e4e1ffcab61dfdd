"""The Persian calendar: its year begins on the day at whose noon in Tehran the sun has reached spring."""

from dataclasses import dataclass
from datetime import date, timedelta
from math import ceil

from fuzzytime.language.meaning.calendars.astronomy import sun_reaches
from fuzzytime.language.meaning.calendars.observance import BySky

TEHRAN_HOURS = 3.5
LONG_MONTHS = 6
"""The first months of a year, which have 31 days; the others have 30."""


@dataclass(frozen=True, slots=True)
class OnPersianDate(BySky):
    """On a day of the Persian calendar; months from Farvardin on."""

    month: int
    day: int

    def in_year(self, year: int) -> tuple[date, ...]:
        """Give its days."""
        days = 30 * (self.month - 1) + min(self.month - 1, LONG_MONTHS) + self.day - 1
        found = (_new_year(near) + timedelta(days=days) for near in (year - 1, year))
        return tuple(day for day in found if day.year == year)


def _new_year(year: int) -> date:
    return date.fromordinal(ceil(sun_reaches(0, year) + TEHRAN_HOURS / 24 - 0.5))
