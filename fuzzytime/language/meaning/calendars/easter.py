"""Easter of the western and of the eastern churches."""

from dataclasses import dataclass
from datetime import date, timedelta

from fuzzytime.language.meaning.calendars.observance import KNOWN_YEARS, Observance

FIRST_YEAR = 326
"""The year after the council that set the rule of Easter."""


def easter(year: int) -> date:
    """Give Easter Sunday of the Gregorian calendar.

    The arithmetic is the anonymous Gregorian computus, as printed in Nature, 20 April 1876.

    >>> easter(2026)
    datetime.date(2026, 4, 5)
    """
    golden = year % 19
    century, rest = divmod(year, 100)
    leap_centuries, common_centuries = divmod(century, 4)
    correction = (century - (century + 8) // 25 + 1) // 3
    epact = (19 * golden + century - leap_centuries - correction + 15) % 30
    leaps, common = divmod(rest, 4)
    sunday = (32 + 2 * common_centuries + 2 * leaps - epact - common) % 7
    shift = (golden + 11 * epact + 22 * sunday) // 451
    month, day = divmod(epact + sunday - 7 * shift + 114, 31)
    return date(year, month, day + 1)


def orthodox_easter(year: int) -> date:
    """Give Easter Sunday of the Julian calendar, as a day of the Gregorian.

    The arithmetic is that of Meeus, Astronomical Algorithms, chapter 9.

    >>> orthodox_easter(2026)
    datetime.date(2026, 4, 12)
    """
    moon = (19 * (year % 19) + 15) % 30
    sunday = (2 * (year % 4) + 4 * (year % 7) - moon + 34) % 7
    month, day = divmod(moon + sunday + 114, 31)
    leaps_more = year // 100 - year // 400 - 2
    return date(year, month, day + 1) + timedelta(days=leaps_more)


@dataclass(frozen=True, slots=True)
class FromEaster(Observance):
    """So many days from Easter Sunday."""

    days: int = 0
    orthodox: bool = False

    @property
    def years(self) -> range:
        """Those that the rule of Easter is kept in."""
        return range(FIRST_YEAR, KNOWN_YEARS.stop)

    def in_year(self, year: int) -> tuple[date, ...]:
        """Give its day."""
        found = orthodox_easter(year) if self.orthodox else easter(year)
        return (found + timedelta(days=self.days),)
