"""Days in relation to today or another day: this and next, and so long after."""

from abc import abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import date, timedelta
from enum import StrEnum
from itertools import islice

from fuzzytime.language.meaning.calendar import (
    ONE_DAY,
    Calendar,
    Cycle,
    Days,
    Fields,
    Today,
    is_weekly,
    moved,
)
from fuzzytime.language.meaning.expressions import Duration
from fuzzytime.language.meaning.feasts import OfYear, Yearly
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.requirement import Unit

YEAR, MONTH = 365, 30
"""Days."""


class Which(StrEnum):
    """Which one of a series is meant."""

    THIS = "this"
    NEXT = "next"
    COMING = "coming"
    LAST = "last"
    PAST = "past"

    @property
    def offset(self) -> int:
        """How many periods from the one that holds now."""
        return {"this": 0, "next": 1, "coming": 1, "last": -1, "past": -1}[self.value]


class _Single(Calendar):
    """A calendar expression that means one period whatever day one asks from."""

    __slots__ = ()

    @property
    def fixed(self) -> bool:
        """Always."""
        return True

    @abstractmethod
    def period(self, today: Today) -> Days | None:
        """Give the period; None where there is none, such as a fifth Monday."""

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:  # noqa: ARG002
        """Give the period."""
        found = self.period(today)
        if found is not None:
            yield found

    def past(self, today: Today, until: date) -> Iterator[Days]:  # noqa: ARG002
        """Give the period."""
        return self.upcoming(today, today.day)


@dataclass(frozen=True, slots=True)
class Relative(_Single):
    """A day by its distance from today: "tomorrow".

    ``onward`` says that it counts from the day that was said before, where that is one to come: "the day
    after"; of an ``event``, from the day of what was told to happen: "on the day".
    """

    days: int
    onward: bool = False
    event: bool = False

    @property
    def grain(self) -> Unit:
        """A day."""
        return Unit.DAY

    def period(self, today: Today) -> Days:
        """Give the day."""
        return Days.single(today.day + timedelta(days=self.days))


@dataclass(frozen=True, slots=True)
class Deictic(_Single):
    """The one that "this", "next" or "last" means of a series.

    A weekday or a weekend is that of this, the next or the last week ("next Friday", said on a Tuesday, is
    ten days away), unless "coming" and "past" ask for the nearest. A month, a feast or a date is the next
    to begin, or the last to end.
    """

    which: Which
    of: Calendar

    @property
    def grain(self) -> Unit:
        """That of the series."""
        return self.of.grain

    def period(self, today: Today) -> Days | None:
        """Give the one that is meant."""
        if isinstance(self.of, Cycle):
            return self.of.away(today, today.day, self.which.offset)
        weekly = is_weekly(self.of)
        if weekly and self.which in {Which.THIS, Which.NEXT, Which.LAST}:
            week = Cycle(Unit.WEEK).away(today, today.day, self.which.offset)
            found = next(self.of.upcoming(today, week.first))
            if self.which is Which.THIS and found.end <= today.day:
                found = next(self.of.upcoming(today, today.day))
            return found
        if self.which is Which.THIS:
            year = Cycle(Unit.YEAR).holding(today, today.day)
            here = islice(self.of.upcoming(today, year.first), 8)
            return next((days for days in here if days.first >= year.first), None)
        if self.which.offset > 0:
            series = islice(self.of.upcoming(today, today.day), 4)
            return next((days for days in series if days.first > today.day), None)
        series = islice(self.of.past(today, today.day), 4)
        return next((days for days in series if days.end <= today.day), None)


@dataclass(frozen=True, slots=True)
class Stretch(_Single):
    """So many days, weeks or months after or before today: "the next three days", "the last two weeks".

    Quarters are those of the calendar: "the next two quarters".
    """

    count: int
    unit: Unit

    @property
    def grain(self) -> Unit:
        """A day."""
        return Unit.DAY

    def period(self, today: Today) -> Days:
        """Give the days after today, or those before."""
        first, last = today.day + ONE_DAY, today.day
        if self.unit is Unit.QUARTER:
            here = Cycle(self.unit).holding(today, today.day)
            first, last = here.end, here.first
        if self.count < 0:
            return Days(moved(last, self.unit, self.count), last)
        return Days(first, moved(first, self.unit, self.count))


@dataclass(frozen=True, slots=True)
class Numbered(_Single):
    """The nth day, or week, of a plan, and as many as ``count``: "Day 3", "Week 1", "Weeks 2-4".

    They count from the day ``since``; without it from today, the first week being that which begins then, or
    next.
    """

    number: int
    unit: Unit
    count: int = 1
    since: Calendar | None = None

    @property
    def grain(self) -> Unit:
        """The unit."""
        return self.unit

    def period(self, today: Today) -> Days:
        """Give the days from its begin to its end."""
        start = Cycle(self.unit).holding(today, today.day)
        first = start.first if start.first == today.day else start.end
        if self.since is not None:
            first = next((days.first for days in self.since.upcoming(today, today.day)), first)
        return Days(*(moved(first, self.unit, self.number - 1 + later) for later in (0, self.count)))


def days_onward(days: Calendar | None) -> int | None:
    """Give how many days behind the one said before a day is: "the next day"; None for other days."""
    if isinstance(days, Relative) and days.onward:
        return days.days
    return 1 if days == Deictic(Which.NEXT, Cycle(Unit.DAY)) else None


class CountedDay(Calendar):
    """A day that is counted from another one, the anchor."""

    __slots__ = ()

    anchor: Calendar

    @abstractmethod
    def counted(self, today: Today, day: date) -> date:
        """Give the day that is meant, counted from one of the anchor's."""

    def base(self, anchor: Days) -> date:
        """Give the day of the anchor's that is counted from: the first."""
        return anchor.first

    @property
    def grain(self) -> Unit:
        """A day."""
        return Unit.DAY

    @property
    def fixed(self) -> bool:
        """Whether the anchor is."""
        return self.anchor.fixed

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:
        """Give each day counted from the anchor's next ones."""
        for anchor in self.anchor.upcoming(today, since):
            yield Days.single(self.counted(today, self.base(anchor)))

    def past(self, today: Today, until: date) -> Iterator[Days]:
        """Give each day counted from the anchor's last ones."""
        for anchor in self.anchor.past(today, until):
            yield Days.single(self.counted(today, self.base(anchor)))


@dataclass(frozen=True, slots=True)
class Away(CountedDay):
    """So many units after (or before) another day: "three days after Easter", "a week from tuesday"."""

    count: int
    unit: Unit
    anchor: Calendar

    def base(self, anchor: Days) -> date:
        """Give the first day of the anchor's, or the last behind a feast of several days or a season."""
        behind = self.count > 0 and isinstance(self.anchor, (Yearly, OfYear))
        return anchor.end - ONE_DAY if behind else anchor.first

    def counted(self, today: Today, day: date) -> date:  # noqa: ARG002 - working days need today
        """Give the day so many units away."""
        return moved(day, self.unit, self.count)

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:
        """Give each day counted from the anchor's next ones, or from one just gone: "9 days from the 1st"."""
        begun = moved(since, self.unit, -self.count)
        if not 0 < (since - begun).days <= self._half_turn:
            yield from CountedDay.upcoming(self, today, since)
            return
        for anchor in self.anchor.upcoming(today, begun):
            day = self.counted(today, self.base(anchor))
            if day >= since:
                yield Days.single(day)

    @property
    def _half_turn(self) -> int:
        """Half of the days after which a date comes again; 0 for weekdays, of which the next counts."""
        if isinstance(self.anchor, Yearly):
            return YEAR // 2
        if not isinstance(self.anchor, Fields) or self.anchor.day is None or self.anchor.fixed:
            return 0
        return YEAR // 2 if self.anchor.month is not None else MONTH // 2


def days_away(duration: Duration, anchor: Calendar, direction: int) -> Calendar | None:
    """Give the day some whole days, weeks, months after another; None for hours."""
    found = anchor
    for amount, unit in duration.terms:
        if unit in SUB_DAY or amount != int(amount) or duration.until is not None:
            return None
        found = Away(int(amount) * direction, unit, found)
    return found


@dataclass(frozen=True, slots=True)
class Following(_Single):
    """The nth of a series after or before a day: "three fridays from now", "second tuesday after easter"."""

    number: int
    series: Calendar
    anchor: Calendar

    @property
    def grain(self) -> Unit:
        """That of the series."""
        return self.series.grain

    def period(self, today: Today) -> Days | None:
        """Give the nth that begins after the anchor, or ends before it."""
        anchor = next(self.anchor.upcoming(today, today.day), None)
        if anchor is None:
            return None
        if self.number > 0:
            later = (days for days in self.series.upcoming(today, anchor.end) if days.first >= anchor.end)
            return next(islice(later, self.number - 1, None), None)
        earlier = (days for days in self.series.past(today, anchor.first) if days.end <= anchor.first)
        return next(islice(earlier, -self.number - 1, None), None)
