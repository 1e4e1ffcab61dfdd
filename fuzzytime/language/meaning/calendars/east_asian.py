"""The lunisolar calendars of China, Korea and Vietnam: the same rule, by the clocks of each country.

A month begins on the day of its new moon; the eleventh holds the winter solstice. Where thirteen new moons
lie between two of these, the first month in which the sun enters no sign is a leap month, named as the one
before it. Feasts are in the months that are none.
"""

from dataclasses import dataclass
from datetime import date
from functools import cache
from math import floor

from fuzzytime.language.meaning.calendars.astronomy import new_moon, new_moon_before, sun, sun_reaches
from fuzzytime.language.meaning.calendars.observance import BySky

CHINA, KOREA, VIETNAM = 8, 9, 7
"""Hours by which their clocks are ahead of universal time."""

ELEVENTH = 11
LONGEST = 13
"""Months of a year that has a leap month."""


def _eleventh_month(year: int, hours: int) -> int:
    """Give the number of the new moon of the month that holds the winter solstice of a year."""
    solstice = floor(sun_reaches(270, year) + hours / 24)
    return new_moon_before(solstice + 1 - hours / 24 - 1e-9)


@cache
def month_starts(year: int, hours: int) -> dict[int, int]:
    """Give the ordinals of the first days of months, from the eleventh of the year before to the tenth."""
    numbers = range(_eleventh_month(year - 1, hours), _eleventh_month(year, hours) + 1)
    starts = [floor(new_moon(number) + hours / 24) for number in numbers]
    signs = [floor(sun(start - hours / 24) / 30) for start in starts]
    leap = None
    if len(starts) == LONGEST + 1:
        leap = next(place for place in range(1, LONGEST) if signs[place] == signs[place + 1])
    months = [start for place, start in enumerate(starts[:-1]) if place != leap]
    return {(ELEVENTH - 1 + place) % 12 + 1: start for place, start in enumerate(months)}


@dataclass(frozen=True, slots=True)
class OnEastAsianDate(BySky):
    """On a day of a lunisolar calendar, by the clocks of its country."""

    month: int
    day: int
    hours: int = CHINA

    def in_year(self, year: int) -> tuple[date, ...]:
        """Give its days."""
        near = (year, year + 1) if self.month >= ELEVENTH else (year,)
        found = (month_starts(cycle, self.hours)[self.month] + self.day - 1 for cycle in near)
        days = map(date.fromordinal, found)
        return tuple(day for day in days if day.year == year)


@dataclass(frozen=True, slots=True)
class OnSolarTerm(BySky):
    """On the day on which the sun reaches a longitude, by the clocks of China."""

    longitude: int

    def in_year(self, year: int) -> tuple[date, ...]:
        """Give its day."""
        return (date.fromordinal(floor(sun_reaches(self.longitude, year) + CHINA / 24)),)
