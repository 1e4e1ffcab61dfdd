"""Days inside others: the nth of a period, a part of it, the week around a day."""

from abc import abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import date, timedelta
from itertools import islice

from fuzzytime.language.meaning.calendar import Calendar, Cycle, Days, Today, moved
from fuzzytime.requirement import Unit

SEARCHED_PERIODS = 400
"""How many outer periods are searched for one that holds what is asked for."""

MOST_TRIED = 64
"""How many periods that begin in the outer one are tried for one whose middle lies there."""

MOST_INSIDE = 40_000
"""Inner periods that are counted in one outer period at most: a century of days."""

THIRD_OF_MONTH = 10
"""Days of a month's first and second third, as calendars of weather and of markets count them."""


def thirds(whole: Days) -> tuple[date, date]:
    """Give the days before which the first third of a period is over and on which its last begins.

    Whole months are counted in months, one month in tens of days, all else in days: of a week three.
    """
    if whole.first.day == whole.end.day == 1:
        months = 12 * (whole.end.year - whole.first.year) + whole.end.month - whole.first.month
        if months % 3 == 0:
            third = months // 3
            return moved(whole.first, Unit.MONTH, third), moved(whole.end, Unit.MONTH, -third)
        if months == 1:
            ten = timedelta(days=THIRD_OF_MONTH)
            return whole.first + ten, whole.first + 2 * ten
    third_of_days = timedelta(days=-(-(whole.end - whole.first).days // 3))
    return whole.first + third_of_days, whole.end - third_of_days


class _Inside(Calendar):
    """Periods of one series that lie inside those of another: at most one of each."""

    __slots__ = ()
    inner: Calendar
    outer: Calendar

    @property
    def grain(self) -> Unit:
        """That of the inner."""
        return self.inner.grain

    @property
    def fixed(self) -> bool:
        """Whether the outer is."""
        return self.outer.fixed

    @abstractmethod
    def inside(self, today: Today, outer: Days) -> Days | None:
        """Give the one inside a period of the outer series, None where there is none."""

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:
        """Give the one of each outer period."""
        for outer in islice(self.outer.upcoming(today, since), SEARCHED_PERIODS):
            found = self.inside(today, outer)
            if found is not None and (self.fixed or found.end > since):
                yield found

    def between(self, today: Today, since: date, end: date) -> Iterator[Days]:
        """Give the one of each outer period that can hold one which begins before that day."""
        # The week that belongs to a month may begin before it.
        for outer in self.outer.between(today, since, end + timedelta(weeks=1)):
            found = self.inside(today, outer)
            if found is not None and found.first < end and (self.fixed or found.end > since):
                yield found

    def past(self, today: Today, until: date) -> Iterator[Days]:
        """Give the one of each outer period."""
        for outer in islice(self.outer.past(today, until), SEARCHED_PERIODS):
            found = self.inside(today, outer)
            if found is not None and (self.fixed or found.first < until):
                yield found


@dataclass(frozen=True, slots=True)
class EachDay(Calendar):
    """Each day of some periods: those of every weekend."""

    of: Calendar

    @property
    def grain(self) -> Unit:
        """Days."""
        return Unit.DAY

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:
        """Give the days in ascending order."""
        for period in self.of.upcoming(today, since):
            yield from (day for day in _days_of(period) if day.end > since)

    def past(self, today: Today, until: date) -> Iterator[Days]:
        """Give the days in descending order."""
        for period in self.of.past(today, until):
            yield from (day for day in reversed(_days_of(period)) if day.first < until)


def _days_of(period: Days) -> list[Days]:
    firsts = (period.first + timedelta(days=later) for later in range((period.end - period.first).days))
    return [Days(first, first + timedelta(days=1)) for first in firsts]


@dataclass(frozen=True, slots=True)
class Within(_Inside):
    """The first of one series inside another: "wednesday of next week", "christmas 2014"."""

    inner: Calendar
    outer: Calendar

    def inside(self, today: Today, outer: Days) -> Days | None:
        """Give the first whose middle lies inside."""
        inside = islice(self.inner.between(today, outer.first, outer.end), MOST_TRIED)
        return next((days for days in inside if outer.first <= days.middle < outer.end), None)


@dataclass(frozen=True, slots=True)
class Nth(_Inside):
    """The nth of one series inside another, from its end where negative; ``count`` of them from there.

    A week belongs to the month or year that holds its middle day, as in ISO 8601; of a month's first week
    no day is in the month before: "the first week of april" is from the 1st on.
    """

    number: int
    inner: Calendar
    outer: Calendar
    count: int = 1

    def inside(self, today: Today, outer: Days) -> Days | None:
        """Give the nth of those whose middle lies inside, and as many more as wanted."""
        needed = min((outer.end - outer.first).days, MOST_INSIDE) + 2
        upcoming = islice(self.inner.between(today, outer.first, outer.end), needed)
        inside = [days for days in upcoming if outer.first <= days.middle < outer.end]
        place = self.number - 1 if self.number > 0 else len(inside) + self.number
        stop = place + self.count if self.number > 0 else place + 1
        start = place if self.number > 0 else place - self.count + 1
        if start < 0 or stop > len(inside):
            return None
        first = inside[start].first
        return Days(
            max(first, outer.first) if self.outer.grain is Unit.MONTH else first, inside[stop - 1].end
        )


@dataclass(frozen=True, slots=True)
class Share(Calendar):
    """A part of each period, from one share of its days to another: "early next week", "mid november"."""

    low: float
    high: float
    of: Calendar

    @property
    def grain(self) -> Unit:
        """A day."""
        return Unit.DAY

    @property
    def fixed(self) -> bool:
        """Whether the whole is."""
        return self.of.fixed

    def _part(self, whole: Days) -> Days:
        days = (whole.end - whole.first).days
        first, end = int(days * self.low), max(int(days * self.high + 0.5), 1)
        return Days(whole.first + timedelta(days=min(first, end - 1)), whole.first + timedelta(days=end))

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:
        """Give the part of each period."""
        for whole in self.of.upcoming(today, since):
            part = self._part(whole)
            if self.fixed or part.end > since:
                yield part

    def past(self, today: Today, until: date) -> Iterator[Days]:
        """Give the part of each period."""
        for whole in self.of.past(today, until):
            part = self._part(whole)
            if self.fixed or part.first < until:
                yield part


@dataclass(frozen=True, slots=True)
class WeekOf(Calendar):
    """The week that holds a day: "the week of october 7th"."""

    day: Calendar

    @property
    def grain(self) -> Unit:
        """A week."""
        return Unit.WEEK

    @property
    def fixed(self) -> bool:
        """Whether the day is."""
        return self.day.fixed

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:
        """Give the week of each such day."""
        for days in self.day.upcoming(today, since):
            yield Cycle(Unit.WEEK).holding(today, days.first)

    def past(self, today: Today, until: date) -> Iterator[Days]:
        """Give the week of each such day."""
        for days in self.day.past(today, until):
            yield Cycle(Unit.WEEK).holding(today, days.first)
