"""Days as people name them: series of days, weeks, months that can be asked for the next or the last one.

Every expression ("monday", "the 15th of february", "first week of 2027", "three days after Easter") is a
value that gives its periods in order of time, from a day on or back from a day. Choosing among them is the
business of `grounding`.
"""

import calendar
from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from datetime import MAXYEAR, date, timedelta
from itertools import takewhile

from fuzzytime.language.policy import Policy
from fuzzytime.requirement import Unit

ONE_DAY = timedelta(days=1)
SEARCHED_YEARS = 60
"""How far a date is searched: a weekday returns to the 29th of February within 40 years."""


@dataclass(frozen=True, slots=True)
class Days:
    """Consecutive days, from ``first`` to before ``end``."""

    first: date
    end: date

    @property
    def middle(self) -> date:
        """The day that decides where a week belongs: the Thursday of a week from Monday."""
        return self.first + (self.end - self.first - ONE_DAY) // 2

    @classmethod
    def single(cls, day: date) -> "Days":
        """Give one day."""
        return cls(day, day + ONE_DAY)


@dataclass(frozen=True, slots=True)
class Today:
    """The day of the instruction, and the policy that reads it."""

    day: date
    policy: Policy


class Calendar(ABC):
    """A series of periods of whole days."""

    __slots__ = ()

    @property
    @abstractmethod
    def grain(self) -> Unit:
        """The unit that the words name: day, week, month, quarter or year."""

    @property
    def fixed(self) -> bool:
        """Whether the words mean one period whatever day is asked from: "last week", "March 2015"."""
        return False

    @abstractmethod
    def upcoming(self, today: Today, since: date) -> Iterator[Days]:
        """Give the periods that end after the day ``since`` begins, ascending; all where it is fixed."""

    @abstractmethod
    def past(self, today: Today, until: date) -> Iterator[Days]:
        """Give the periods that begin before the day ``until``, descending; all where it is fixed."""

    def between(self, today: Today, since: date, end: date) -> Iterator[Days]:
        """Give the upcoming periods that begin before the day ``end``.

        Series that may be empty for decades search no further than that: series inside each other would
        otherwise take the product of their searches.
        """
        return takewhile(lambda days: days.first < end, self.upcoming(today, since))


def month_after(year: int, month: int, months: int) -> tuple[int, int]:
    """Give year and month some months away."""
    count = year * 12 + month - 1 + months
    return count // 12, count % 12 + 1


def moved(day: date, unit: Unit, count: int) -> date:
    """Give the same day some units away; the last day of a shorter month stands for a day that it lacks.

    Raises
    ------
    OverflowError, ValueError
        If the day lies outside the calendar.
    """
    if unit is Unit.DAY:
        return day + timedelta(days=count)
    if unit is Unit.WEEK:
        return day + timedelta(weeks=count)
    months = {Unit.MONTH: 1, Unit.QUARTER: 3, Unit.YEAR: 12}[unit] * count
    year, month = month_after(day.year, day.month, months)
    if not 1 <= year <= MAXYEAR:
        raise OverflowError(f"a year must be 1 to {MAXYEAR}, got {year}")
    return date(year, month, min(day.day, calendar.monthrange(year, month)[1]))


@dataclass(frozen=True, slots=True)
class Cycle(Calendar):
    """Every day, week, month, quarter or year, or every so many of them: a fortnight, a decade."""

    unit: Unit
    count: int = 1

    @property
    def grain(self) -> Unit:
        """The unit; a fortnight counts as weeks, a decade as years."""
        return self.unit

    def holding(self, today: Today, day: date) -> Days:
        """Give the period that holds a day."""
        if self.unit is Unit.DAY:
            return Days(day, moved(day, Unit.DAY, self.count))
        if self.unit is Unit.WEEK:
            first = day - timedelta(days=(day.weekday() - today.policy.week_starts) % 7)
        elif self.unit is Unit.YEAR:
            first = date(max(1, day.year // self.count * self.count), 1, 1)
        else:
            months = 3 if self.unit is Unit.QUARTER else 1
            first = date(day.year, (day.month - 1) // months * months + 1, 1)
        return Days(first, moved(first, self.unit, self.count))

    def away(self, today: Today, day: date, periods: int) -> Days:
        """Give the period some periods away from the one that holds a day."""
        first = moved(self.holding(today, day).first, self.unit, periods * self.count)
        return Days(first, moved(first, self.unit, self.count))

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:
        """Give the period that holds the day, and on."""
        for periods in range(SEARCHED_YEARS * 366):
            yield self.away(today, since, periods)

    def past(self, today: Today, until: date) -> Iterator[Days]:
        """Give the period that holds the day before, and back."""
        for periods in range(SEARCHED_YEARS * 366):
            yield self.away(today, until - ONE_DAY, -periods)


@dataclass(frozen=True, slots=True)
class Fields(Calendar):
    """What of a date is said: any of year, month, day of the month and weekday (0 for Monday).

    ``turnable`` says that month and day are numbers that may change places: "thu 05/03"; ``told`` is the day
    as said once more: "tomorrow, the 5th".
    """

    year: int | None = None
    month: int | None = None
    day: int | None = None
    weekday: int | None = None
    turnable: bool = field(default=False, compare=False)
    told: Calendar | None = field(default=None, compare=False)

    @property
    def grain(self) -> Unit:
        """The finest unit said."""
        if self.day is not None or self.weekday is not None:
            return Unit.DAY
        return Unit.MONTH if self.month is not None else Unit.YEAR

    @property
    def fixed(self) -> bool:
        """Whether the year is said, and all between it and the finest unit."""
        return self.year is not None and not (self.day is not None and self.month is None)

    @property
    def weekly(self) -> bool:
        """Whether only a weekday is said."""
        return self.weekday is not None and self.year is self.month is self.day is None

    def joined(self, other: "Fields") -> "Fields | None":
        """Give both as one, or None where both say the same field."""
        said: dict[str, int | None] = {}
        for name in ("year", "month", "day", "weekday"):
            own, others = getattr(self, name), getattr(other, name)
            if own is not None and others is not None:
                return None
            said[name] = others if own is None else own
        return Fields(**said, turnable=self.turnable or other.turnable, told=self.told or other.told)

    def filled(self, other: "Fields") -> "Fields":
        """Give this with the year and month that it lacks from another."""
        return replace(
            self,
            year=self.year if self.year is not None else other.year,
            month=self.month if self.month is not None or self.weekday is not None else other.month,
        )

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:  # noqa: ARG002
        """Give matching periods in ascending order."""
        for days in self._occurrences(since, 1):
            if days.end > since or self.fixed:
                yield days

    def past(self, today: Today, until: date) -> Iterator[Days]:  # noqa: ARG002
        """Give matching periods in descending order."""
        for days in self._occurrences(until, -1):
            if days.first < until or self.fixed:
                yield days

    def between(self, today: Today, since: date, end: date) -> Iterator[Days]:  # noqa: ARG002
        """Give the matching periods of the years up to that day."""
        for days in self._occurrences(since, 1, end.year - since.year + 1):
            if days.first < end and (days.end > since or self.fixed):
                yield days

    def _occurrences(self, near: date, step: int, searched: int = SEARCHED_YEARS) -> Iterator[Days]:
        if self.weekly:
            ahead = ((self.weekday or 0) - near.weekday()) % 7
            first = near + timedelta(days=ahead - (7 if step < 0 else 0))
            for weeks in range(searched * 53):
                yield Days.single(first + timedelta(weeks=step * weeks))
            return
        if self.grain is Unit.YEAR:
            yield Days(date(self.year or 1, 1, 1), moved(date(self.year or 1, 1, 1), Unit.YEAR, 1))
            return
        for year, month in self._months(near, step, searched):
            yield from self.in_month(year, month, step)

    def _months(self, near: date, step: int, searched: int) -> Iterator[tuple[int, int]]:
        years = [self.year] if self.year is not None else range(near.year, near.year + step * searched, step)
        for year in years:
            months = [self.month] if self.month is not None else list(range(1, 13))[::step]
            for month in months:
                if 1 <= year < MAXYEAR:
                    yield year, month

    def in_month(self, year: int, month: int, step: int) -> Iterator[Days]:
        """Give the matching periods of one month, backwards where ``step`` is -1."""
        length = calendar.monthrange(year, month)[1]
        if self.day is not None:
            wanted = [self.day] if self.day <= length else []
        elif self.weekday is not None:
            wanted = list(range(1, length + 1))[::step]
        else:
            yield Days(date(year, month, 1), moved(date(year, month, 1), Unit.MONTH, 1))
            return
        for day in wanted:
            if self.weekday is None or date(year, month, day).weekday() == self.weekday:
                yield Days.single(date(year, month, day))


@dataclass(frozen=True, slots=True)
class Weekend(Calendar):
    """Every weekend, or every longer stretch of weekdays: Saturday and Sunday, Monday to Friday."""

    working: bool = False

    @property
    def grain(self) -> Unit:
        """Days."""
        return Unit.DAY

    def of_week(self, today: Today, day: date) -> Days:
        """Give the weekend, or working days, of the week that holds a day."""
        week = Cycle(Unit.WEEK).holding(today, day)
        policy = today.policy
        offset = (policy.weekend_from - policy.week_starts) % 7
        if self.working:
            return Days(week.first, week.first + timedelta(days=7 - policy.weekend_days))
        first = week.first + timedelta(days=offset)
        return Days(first, first + timedelta(days=policy.weekend_days))

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:
        """Give weekends in ascending order."""
        for weeks in range(-1, SEARCHED_YEARS * 53):
            days = self.of_week(today, since + timedelta(weeks=weeks))
            if days.end > since:
                yield days

    def past(self, today: Today, until: date) -> Iterator[Days]:
        """Give weekends in descending order."""
        for weeks in range(SEARCHED_YEARS * 53):
            days = self.of_week(today, until - timedelta(weeks=weeks))
            if days.first < until:
                yield days


def is_weekday(days: Calendar | None) -> bool:
    """Whether it is a day of the week, of any week."""
    return isinstance(days, Fields) and days.weekly


def is_weekly(calendar: Calendar) -> bool:
    """Whether it comes each week: a weekday, or the weekend."""
    return isinstance(calendar, Weekend) or is_weekday(calendar)


def is_day_of_month(days: Calendar | None) -> bool:
    """Whether it is on a day of some month, and says nothing else: "the 15th"."""
    return isinstance(days, Fields) and days.day is not None and days == Fields(day=days.day)
