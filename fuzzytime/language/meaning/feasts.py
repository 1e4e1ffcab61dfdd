"""Periods that come every year: feasts and seasons."""

from abc import abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import date, timedelta
from functools import reduce

from fuzzytime.language.meaning.calendar import SEARCHED_YEARS, Calendar, Days, Today
from fuzzytime.language.meaning.calendars.observance import KNOWN_YEARS, Observance
from fuzzytime.language.meaning.ungrounded import UngroundedError
from fuzzytime.requirement import Unit


class Yearly(Calendar):
    """A period that comes every year, of this calendar or of another."""

    __slots__ = ()

    @property
    def years(self) -> range:
        """The years in which it is known."""
        return KNOWN_YEARS

    @abstractmethod
    def of_year(self, year: int) -> tuple[Days, ...]:
        """Give the periods that begin in a year, ascending.

        One mostly; a year of the moon is shorter, and its feasts may come twice in a year, or not at all.
        """

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:  # noqa: ARG002
        """Give the periods in ascending order.

        Raises
        ------
        UngroundedError
            In a year in which it is not known.
        """
        self.check(since.year)
        for year in range(since.year - 1, since.year + SEARCHED_YEARS):
            for days in self.of_year(year) if year in self.years else ():
                if days.end > since:
                    yield days

    def past(self, today: Today, until: date) -> Iterator[Days]:  # noqa: ARG002
        """Give the periods in descending order.

        Raises
        ------
        UngroundedError
            In a year in which it is not known.
        """
        self.check(until.year)
        for year in range(until.year, until.year - SEARCHED_YEARS, -1):
            for days in reversed(self.of_year(year) if year in self.years else ()):
                if days.first < until:
                    yield days

    def check(self, year: int) -> None:
        """Refuse a year in which it is not known."""
        if year not in self.years:
            first, last = self.years[0], self.years[-1]
            raise UngroundedError(f"its days are known for the years {first} to {last}, not for {year}")


@dataclass(frozen=True, slots=True)
class OfYear(Calendar):
    """The one of a year, by where it begins; the first, where two begin in it: "ramadan 2027"."""

    feast: Yearly
    year: int

    @property
    def grain(self) -> Unit:
        """That of the feast."""
        return self.feast.grain

    @property
    def fixed(self) -> bool:
        """Always."""
        return True

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:  # noqa: ARG002
        """Give it.

        Raises
        ------
        UngroundedError
            If it is not known in that year.
        """
        self.feast.check(self.year)
        yield from self.feast.of_year(self.year)[:1]

    def past(self, today: Today, until: date) -> Iterator[Days]:  # noqa: ARG002
        """Give it."""
        return self.upcoming(today, today.day)


@dataclass(frozen=True, slots=True)
class Feast(Yearly):
    """A holiday: a day of some calendar, and those behind it where it ``lasts``, or is ``until`` another.

    It is moved by the days that its weekday has in ``moves`` (king's day on a sunday is the day before), then
    by ``days``. ``from_evening`` says that its days begin in the evening before, ``doubtful`` that its name
    may be something else: "lent".
    """

    name: str
    kept: Observance
    days: int = 0
    moves: tuple[tuple[int, int], ...] = ()
    lasts: int = 1
    until: "Feast | None" = None
    from_evening: bool = False
    doubtful: bool = False

    @property
    def is_several(self) -> bool:
        """Whether it has several days."""
        return self.lasts > 1 or self.until is not None

    @property
    def grain(self) -> Unit:
        """A day."""
        return Unit.DAY

    @property
    def years(self) -> range:
        """The years in which its days, and the one that it lasts until, are known."""
        return self.kept.years if self.until is None else _common(self.kept.years, self.until.years)

    def of_year(self, year: int) -> tuple[Days, ...]:
        """Give its days in a year."""
        found = []
        for kept in self.kept.in_year(year):
            first = kept + timedelta(days=self.days + dict(self.moves).get(kept.weekday(), 0))
            found.append(Days(first, self._end(first)))
        return tuple(found)

    def _end(self, first: date) -> date:
        """Give the day before which it ends: a feast that it lasts until is the next."""
        if self.until is None:
            return first + timedelta(days=self.lasts)
        years = (first.year, first.year + 1)
        ends = (days.first for year in years for days in self.until.of_year(year))
        return next(end for end in ends if end > first)


def _common(first: range, second: range) -> range:
    """Give the years of both."""
    return range(max(first.start, second.start), min(first.stop, second.stop))


@dataclass(frozen=True, slots=True)
class OneOf(Observance):
    """On the days of several feasts: an eid is either of two."""

    feasts: tuple[Feast, ...]

    @property
    def years(self) -> range:
        """Those in which all are known."""
        return reduce(_common, (feast.years for feast in self.feasts))

    def in_year(self, year: int) -> tuple[date, ...]:
        """Give the days of all."""
        return tuple(sorted(days.first for feast in self.feasts for days in feast.of_year(year)))


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

    def of_year(self, year: int) -> tuple[Days, ...]:
        """Give the season that begins in a year."""
        end = date(year + (self.ends <= self.begins), *self.ends)
        return (Days(date(year, *self.begins), end),)
