"""Working days, which pass over weekends ("in two working days"), and days that are none of others."""

from collections.abc import Iterator
from dataclasses import dataclass
from datetime import date, timedelta

from fuzzytime.language.meaning.calendar import SEARCHED_YEARS, Calendar, Cycle, Days, Today
from fuzzytime.language.meaning.days.relations import CountedDay
from fuzzytime.language.policy import Policy
from fuzzytime.requirement import Unit


@dataclass(frozen=True, slots=True)
class Workdays(CountedDay):
    """So many working days after (or before) another day: "in two working days"."""

    count: int
    anchor: Calendar

    def counted(self, today: Today, day: date) -> date:
        """Give the day so many working days away."""
        left = abs(self.count)
        while left:
            day += timedelta(days=1 if self.count > 0 else -1)
            left -= is_working(today.policy, day)
        return day


@dataclass(frozen=True, slots=True)
class Workday(Calendar):
    """Every day that is none of a weekend."""

    @property
    def grain(self) -> Unit:
        """A day."""
        return Unit.DAY

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:
        """Give working days in ascending order."""
        for days in range(SEARCHED_YEARS * 366):
            day = since + timedelta(days=days)
            if is_working(today.policy, day):
                yield Days.single(day)

    def past(self, today: Today, until: date) -> Iterator[Days]:
        """Give working days in descending order."""
        for days in range(1, SEARCHED_YEARS * 366):
            day = until - timedelta(days=days)
            if is_working(today.policy, day):
                yield Days.single(day)


def is_working(policy: Policy, day: date) -> bool:
    """Whether a day is none of a weekend."""
    return (day.weekday() - policy.weekend_from) % 7 >= policy.weekend_days


@dataclass(frozen=True, slots=True)
class SparedDays(Calendar):
    """Every day that lies in no period of some series."""

    others: tuple[Calendar, ...]

    @property
    def grain(self) -> Unit:
        """A day."""
        return Unit.DAY

    def upcoming(self, today: Today, since: date) -> Iterator[Days]:
        """Give days in ascending order."""
        return (days for days in Cycle(Unit.DAY).upcoming(today, since) if self._is_spared(today, days))

    def past(self, today: Today, until: date) -> Iterator[Days]:
        """Give days in descending order."""
        return (days for days in Cycle(Unit.DAY).past(today, until) if self._is_spared(today, days))

    def _is_spared(self, today: Today, days: Days) -> bool:
        found = (next(other.upcoming(today, days.first), None) for other in self.others)
        return not any(other is not None and other.first <= days.first < other.end for other in found)
