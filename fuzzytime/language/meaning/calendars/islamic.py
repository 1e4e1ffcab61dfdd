"""The Islamic calendar, by the rule of Umm al-Qura: a month begins behind the evening of the new moon.

On the day of the conjunction, the moon must be new before the sun sets at Mecca, and must set after it.
That is how the calendar of Saudi Arabia has been reckoned since 1423 AH (2002); where a month is begun by
sighting, it may begin a day later, rarely earlier. A day begins in the evening; the one given holds its
daylight.
"""

from dataclasses import dataclass
from datetime import date
from functools import cache
from math import floor

from fuzzytime.language.meaning.calendars.astronomy import (
    Place,
    daylight,
    moon_is_up,
    new_moon,
    new_moon_near,
)
from fuzzytime.language.meaning.calendars.observance import BySky

MECCA = Place(21.4225, 39.8262, 3)
MUHARRAM_1421 = 3
"""The number of the new moon with which the year 1421 began."""


@cache
def month_start(number: int) -> int:
    """Give the ordinal of the first day of the month that begins with a new moon."""
    conjunction = new_moon(number)
    day = floor(conjunction + MECCA.hours / 24)
    _, sunset = daylight(day, MECCA)
    begun = conjunction < sunset and moon_is_up(sunset, MECCA)
    return day + 1 if begun else day + 2


@dataclass(frozen=True, slots=True)
class OnIslamicDate(BySky):
    """On a day of the Islamic calendar; months from Muharram on."""

    month: int
    day: int

    def in_year(self, year: int) -> tuple[date, ...]:
        """Give its days."""
        first = new_moon_near(date(year, 1, 1).toordinal())
        # The month of a day may have begun some weeks before the year.
        numbers = (k for k in range(first - 2, first + 14) if (k - MUHARRAM_1421) % 12 == self.month - 1)
        found = (date.fromordinal(month_start(number) + self.day - 1) for number in numbers)
        return tuple(day for day in found if day.year == year)
