"""Periods that come once a year: holidays and seasons."""

from abc import abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import MAXYEAR, date, timedelta
from enum import StrEnum

from fuzzytime.language.meaning.calendar import SEARCHED_YEARS, Calendar, Days, Fields, Today
from fuzzytime.requirement import Unit


class Yearly(Calendar):
    """A period that comes once a year."""

    __slots__ = ()

    @abstractmethod
    def of_year(self, year: int) -> Days:
        """Give the period that begins in a year."""

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:  # noqa: ARG002
        """Give the periods in ascending order."""
        for year in range(max(1, since.year - 1), min(MAXYEAR, since.year + SEARCHED_YEARS)):
            days = self.of_year(year)
            if days.end > since:
                yield days

    def past(self, today: Today, until: date) -> Iterator[Days]:  # noqa: ARG002
        """Give the periods in descending order."""
        for year in range(until.year, max(1, until.year - SEARCHED_YEARS), -1):
            days = self.of_year(year)
            if days.first < until:
                yield days


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


class Reckoning(StrEnum):
    """How a feast finds its day."""

    DATE = "date"
    NTH = "nth"
    EASTER = "easter"


@dataclass(frozen=True, slots=True)
class Feast(Yearly):
    """A holiday: a date, the nth weekday of a month, or days from Easter; moved by ``days``.

    A date that is ``never_on`` a weekday is the day before where it would be: king's day on a sunday.
    """

    name: str
    reckoning: Reckoning
    month: int = 1
    day: int = 1
    nth: int = 1
    weekday: int = 0
    days: int = 0
    never_on: int | None = None

    @property
    def grain(self) -> Unit:
        """A day."""
        return Unit.DAY

    def of_year(self, year: int) -> Days:
        """Give its day in a year."""
        if self.reckoning is Reckoning.EASTER:
            day = easter(year)
        elif self.reckoning is Reckoning.DATE:
            day = date(year, self.month, self.day)
            day -= timedelta(days=day.weekday() == self.never_on)
        else:
            matching = list(Fields(year, self.month, None, self.weekday).in_month(year, self.month, 1))
            day = matching[self.nth - 1 if self.nth > 0 else self.nth].first
        return Days.single(day + timedelta(days=self.days))


@dataclass(frozen=True, slots=True)
class Season(Yearly):
    """A stretch of the year from a month and day to before another."""

    name: str
    begins: tuple[int, int]
    ends: tuple[int, int]

    @property
    def grain(self) -> Unit:
        """Days."""
        return Unit.DAY

    def of_year(self, year: int) -> Days:
        """Give the season that begins in a year."""
        return Days(date(year, *self.begins), date(year + (self.ends <= self.begins), *self.ends))
