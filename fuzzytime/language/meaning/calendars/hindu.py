"""Hindu feasts: on a lunar day of a month of the moon, where it prevails at a time of the day, or by the sun.

A month runs from new moon to new moon and is named by the sign that the sun enters in it; where it enters
none, the month is a leap month, which has no feasts. A lunar day is a thirtieth of the moon's way from the
sun and back to it, 1 behind the new moon, 15 to the full moon, 30 to the new. Signs are counted from the
fixed stars (the Lahiri zero point), and the day is that of Ujjain. Calendars of other places, schools and
temples differ by a day now and then.
"""

from collections.abc import Callable
from dataclasses import dataclass
from datetime import date
from enum import StrEnum
from functools import cache
from itertools import islice
from math import floor

from fuzzytime.language.meaning.calendars.astronomy import (
    SYNODIC_MONTH,
    Place,
    centuries,
    daylight,
    elongation,
    moment_in_year,
    moment_of,
    moon,
    new_moon,
    new_moon_near,
    sun,
)
from fuzzytime.language.meaning.calendars.observance import BySky

UJJAIN = Place(23.18, 75.77, 5.5)

LUNAR_DAY = 12
"""Degrees of a lunar day."""

STAR = 360 / 27
"""Degrees of a star of the moon."""

SUN_AT_NEW_YEAR = 255
"""Longitude of the sun among the stars on the first of January, about."""

ZERO_POINT, PRECESSION = 23.8531, 1.39697
"""Degrees from the point of spring to Lahiri's zero point of the stars in 2000, and more in a century."""


class At(StrEnum):
    """A time of the day at which a lunar day is to prevail."""

    DAWN = "dawn"
    SUNRISE = "sunrise"
    FORENOON = "forenoon"
    MIDDAY = "midday"
    AFTERNOON = "afternoon"
    LATE_AFTERNOON = "late afternoon"
    SUNSET = "sunset"
    DUSK = "dusk"
    MIDNIGHT = "midnight"

    def of(self, day: int) -> float:
        """Give the moment of a day."""
        rise, sets = daylight(day, UJJAIN)
        by_day, by_night = _SHARES[self]
        return rise + by_day * (sets - rise) + by_night * (1 - sets + rise)


_SHARES = {
    At.DAWN: (0.0, -2 / 15),
    At.SUNRISE: (0.0, 0.0),
    At.FORENOON: (3 / 15, 0.0),
    At.MIDDAY: (1 / 2, 0.0),
    At.AFTERNOON: (10 / 15, 0.0),
    At.LATE_AFTERNOON: (7 / 8, 0.0),
    At.SUNSET: (1.0, 0.0),
    At.DUSK: (1.0, 1.5 / 15),
    At.MIDNIGHT: (1.0, 1 / 2),
}
"""Which share of the daylight, and of the night, is over; in fifteenths, as these are divided."""


def _among_stars(body: Callable[[float], float], moment: float) -> float:
    return (body(moment) - ZERO_POINT - PRECESSION * centuries(moment)) % 360


def _sun_among_stars(moment: float) -> float:
    return _among_stars(sun, moment)


@cache
def _sign(number: int) -> int:
    """Give the sign, from 0 for Mesha, in which the sun stands at a new moon."""
    return floor(_sun_among_stars(new_moon(number)) / 30)


def months_of(number: int) -> tuple[int, ...]:
    """Give the months, 1 for Chaitra, that begin with a new moon: none, one, or rarely two at once."""
    first, last = _sign(number), _sign(number + 1)
    return tuple((first + 1 + more) % 12 + 1 for more in range((last - first) % 12))


@cache
def lunar_day(number: int, day: int) -> tuple[float, float]:
    """Give where a lunar day behind a new moon begins, and where it is over."""
    begins, ends = (
        moment_of(
            elongation, LUNAR_DAY * count % 360, new_moon(number) + count * SYNODIC_MONTH / 30, SYNODIC_MONTH
        )
        for count in (day - 1, day)
    )
    return begins, ends


@dataclass(frozen=True, slots=True)
class OnLunarDay(BySky):
    """On the day on which a lunar day prevails at a time; of several times, the first at which it ever does.

    Of two such days, it is the first, or the ``later``; where there is none, that in which it begins.
    """

    month: int
    day: int
    at: tuple[At, ...] = (At.SUNRISE,)
    later: bool = False

    def in_year(self, year: int) -> tuple[date, ...]:
        """Give its days."""
        first = new_moon_near(date(year, 1, 1).toordinal())
        # In a year, the month begins about then; a leap month before it puts it off.
        near = [first + (self.month + 2) % 12 + turn for turn in (-13, -12, -11, -1, 0, 1)]
        found = (self._day(number) for number in near if self.month in months_of(number))
        return tuple(sorted(day for day in found if day.year == year))

    def _day(self, number: int) -> date:
        begins, ends = lunar_day(number, self.day)
        first = floor(begins + UJJAIN.hours / 24)
        for at in self.at:
            days = [day for day in range(first - 1, first + 3) if begins <= at.of(day) < ends]
            if days:
                return date.fromordinal(days[-1 if self.later else 0])
        return date.fromordinal(first)


@dataclass(frozen=True, slots=True)
class OnSunsEntry(BySky):
    """On the day on which the sun reaches a longitude among the stars; behind a time of it, on the next."""

    longitude: int
    at: At = At.SUNSET

    def in_year(self, year: int) -> tuple[date, ...]:
        """Give its day."""
        moment = _sun_enters(self.longitude, year)
        day = floor(moment + UJJAIN.hours / 24)
        return (date.fromordinal(day + (moment > self.at.of(day))),)


@cache
def _sun_enters(longitude: int, year: int) -> float:
    """Give the moment of a year at which the sun reaches a longitude among the stars."""
    return moment_in_year(_sun_among_stars, longitude, SUN_AT_NEW_YEAR, year)


@dataclass(frozen=True, slots=True)
class OnStar(BySky):
    """On the last day of a month of the sun at whose sunrise the moon is with a star, of 27."""

    sign: int
    star: int

    def in_year(self, year: int) -> tuple[date, ...]:
        """Give its day."""
        enters = (_sun_enters(30 * sign % 360, year) for sign in (self.sign, self.sign + 1))
        first, end = (floor(moment + UJJAIN.hours / 24) for moment in enters)
        days = (day for day in range(end - 1, first - 1, -1) if _star(day) == self.star)
        return tuple(map(date.fromordinal, islice(days, 1)))


@cache
def _star(day: int) -> int:
    """Give the star, from 1, with which the moon is at the sunrise of a day."""
    return floor(_among_stars(moon, At.SUNRISE.of(day)) / STAR) + 1
