"""The Hebrew calendar: its new years by the mean new moons and the four postponements.

A Hebrew day begins in the evening; the day given is the one whose daylight it holds. Its arithmetic is exact:
Dershowitz and Reingold, Calendrical Calculations, tell it, and Maimonides before them.
"""

from dataclasses import dataclass
from datetime import date
from functools import cache

from fuzzytime.language.meaning.calendars.observance import Observance

HOUR = 1080
"""Parts of an hour."""

DAY = 24 * HOUR
MONTH = 29 * DAY + 12 * HOUR + 793
"""From one mean new moon to the next, in parts."""

FIRST_NEW_MOON = DAY + 5 * HOUR + 204
"""The new moon of the first Tishri, from the beginning of that week: a Monday, at 5 hours and 204 parts."""

EPOCH = -1_373_428
"""The Sunday before the first Tishri, as an ordinal of the Gregorian calendar."""

SUNDAY, MONDAY, TUESDAY, WEDNESDAY, FRIDAY = 0, 1, 2, 3, 5
TISHRI, LAST = 7, 12
"""The first month of a year and, before Nisan, the one that is doubled in a leap year."""

YEARS_AHEAD = 3760
"""How many years the Hebrew calendar is ahead of the Gregorian before its new year."""


def is_leap(year: int) -> bool:
    """Whether a year has thirteen months: seven of nineteen have."""
    return (7 * year + 1) % 19 < 7


@cache
def new_year(year: int) -> int:
    """Give the ordinal of the first of Tishri."""
    months = (235 * year - 234) // 19
    day, parts = divmod(FIRST_NEW_MOON + months * MONTH, DAY)
    late = parts >= 18 * HOUR
    # Else the year would be too long, or the one before too short.
    too_long = day % 7 == TUESDAY and parts >= 9 * HOUR + 204 and not is_leap(year)
    too_short = day % 7 == MONDAY and parts >= 15 * HOUR + 589 and is_leap(year - 1)
    day += late or too_long or too_short
    # No first of Tishri is on these: holy days would lie beside Sabbaths.
    return EPOCH + day + (day % 7 in {SUNDAY, WEDNESDAY, FRIDAY})


def month_lengths(year: int) -> list[int]:
    """Give the lengths of a year's months, from Tishri on."""
    length = new_year(year + 1) - new_year(year)
    spare = length % 10 - 4
    heshvan, kislev = 29 + (spare > 0), 30 - (spare < 0)
    winter = [30, heshvan, kislev, 29, 30]
    adar = [30, 29] if is_leap(year) else [29]
    return [*winter, *adar, 30, 29, 30, 29, 30, 29]


def gregorian(year: int, month: int, day: int) -> date:
    """Give a day of the Hebrew calendar; months from Nisan on, the 12th is the last Adar.

    >>> gregorian(5787, 7, 1)
    datetime.date(2026, 9, 12)
    """
    lengths = month_lengths(year)
    if TISHRI <= month < LAST:
        first = new_year(year) + sum(lengths[: month - TISHRI])
    else:
        # Whether there is one Adar or two: counted back from the next new year.
        first = new_year(year + 1) - sum(lengths[month % LAST - TISHRI :])
    return date.fromordinal(first + day - 1)


@dataclass(frozen=True, slots=True)
class OnHebrewDate(Observance):
    """On a day of the Hebrew calendar; months from Nisan on, the 12th is Adar, of a leap year the second."""

    month: int
    day: int

    def in_year(self, year: int) -> tuple[date, ...]:
        """Give its days."""
        near = (year + YEARS_AHEAD, year + YEARS_AHEAD + 1)
        found = (gregorian(hebrew, self.month, self.day) for hebrew in near)
        return tuple(day for day in found if day.year == year)
