"""Days inside others: the nth of a period, a part of it, the week around a day."""

from collections.abc import Iterator
from dataclasses import dataclass
from datetime import date, timedelta
from itertools import islice

from fuzzytime.language.meaning.calendar import (
    Calendar,
    Cycle,
    Days,
    Today,
)
from fuzzytime.requirement import Unit


@dataclass(frozen=True, slots=True)
class Within(Calendar):
    """The first of one series inside another: "wednesday of next week", "christmas 2014"."""

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

    def _in(self, today: Today, outer: Days) -> Days | None:
        for days in islice(self.inner.upcoming(today, outer.first), 64):
            if outer.first <= days.middle < outer.end:
                return days
            if days.first >= outer.end:
                return None
        return None

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:
        """Give the periods that lie in a period of the outer series."""
        for outer in islice(self.outer.upcoming(today, since), 400):
            found = self._in(today, outer)
            if found is not None and (self.fixed or found.end > since):
                yield found

    def past(self, today: Today, until: date) -> Iterator[Days]:
        """Give the periods that lie in a period of the outer series."""
        for outer in islice(self.outer.past(today, until), 400):
            found = self._in(today, outer)
            if found is not None and (self.fixed or found.first < until):
                yield found


@dataclass(frozen=True, slots=True)
class Nth(Calendar):
    """The nth of one series inside another, from its end where negative; ``count`` of them from there.

    A week belongs to the month or year that holds its middle day, as in ISO 8601.
    """

    number: int
    inner: Calendar
    outer: Calendar
    count: int = 1

    @property
    def grain(self) -> Unit:
        """That of the inner."""
        return self.inner.grain

    @property
    def fixed(self) -> bool:
        """Whether the outer is."""
        return self.outer.fixed

    def _in(self, today: Today, outer: Days) -> Days | None:
        inside = [
            days
            for days in islice(self.inner.upcoming(today, outer.first), self._needed(outer))
            if outer.first <= days.middle < outer.end
        ]
        place = self.number - 1 if self.number > 0 else len(inside) + self.number
        stop = place + self.count if self.number > 0 else place + 1
        start = place if self.number > 0 else place - self.count + 1
        if start < 0 or stop > len(inside):
            return None
        return Days(inside[start].first, inside[stop - 1].end)

    def _needed(self, outer: Days) -> int:
        return min((outer.end - outer.first).days, 40_000) + 2

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:
        """Give the nth of each outer period."""
        for outer in islice(self.outer.upcoming(today, since), 100):
            found = self._in(today, outer)
            if found is not None and (self.fixed or found.end > since):
                yield found

    def past(self, today: Today, until: date) -> Iterator[Days]:
        """Give the nth of each outer period."""
        for outer in islice(self.outer.past(today, until), 100):
            found = self._in(today, outer)
            if found is not None and (self.fixed or found.first < until):
                yield found


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
