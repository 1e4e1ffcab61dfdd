"""Repetitions as values that give their occurrences: evenly spaced, or by the calendar.

An occurrence is a moment ("at nine"), or a stretch of time within which what is asked for is done once
("every morning").
"""

import math
from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass, replace
from datetime import datetime, timedelta
from itertools import islice
from typing import TYPE_CHECKING, Self

from fuzzytime.language.meaning.calendar import Calendar, Cycle, Days, Fields, Today, is_weekday
from fuzzytime.language.meaning.expressions import Wall
from fuzzytime.language.meaning.instants import halved, midnight
from fuzzytime.language.meaning.midnights import over_at_midnight
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS, Clock
from fuzzytime.language.meaning.ungrounded import UngroundedError
from fuzzytime.requirement import Unit, Window

if TYPE_CHECKING:
    from fuzzytime.language.meaning.grounded.moment import Moment

JUST_BEFORE = 1.0
"""Seconds before the end of what an occurrence lies in."""

MOST = 10_000
"""Occurrences that are given at most."""

WORKDAYS = frozenset(Fields(weekday=day) for day in range(5))
"""The days of "on weekdays"."""


class PlainRecurrence(ABC):
    """What most repetitions have in common: they lie in nothing else that goes on, and stay as said."""

    __slots__ = ()

    @property
    def closing(self) -> float | None:
        """None: no end of what goes on."""
        return None

    @property
    def spans(self) -> bool:
        """Whether words say where each occurrence begins and where it is over."""
        return False

    @property
    def all_day(self) -> bool:
        """Whether nothing but a day bounds it."""
        return False

    @abstractmethod
    def windows(self, until: float) -> tuple[Window, ...]:
        """Give the occurrences from 0 to ``until``, with their ends."""

    def occurrences(self, until: float) -> tuple[float, ...]:
        """Give the times from 0 to ``until``, in seconds from when the instruction was given.

        Without a time of day an occurrence is when its day begins, or now where that day is today.
        """
        return tuple(dict.fromkeys(start for start, _ in self.windows(until)))

    def spaced(self, length: float) -> Self:  # noqa: ARG002 - how often is said
        """Give the same."""
        return self


@dataclass(frozen=True, slots=True, kw_only=True)
class EvenRecurrence(PlainRecurrence):
    """Every so many seconds, from a first time on; each lasts a length.

    ``counted`` says that how often is said, and how long is waited in between: "three sets, a minute apart";
    ``all_day`` that nothing but a day bounds it: "on thursday every hour".

    >>> EvenRecurrence(step=1200, first=1200).occurrences(3600)
    (1200, 2400, 3600)
    """

    step: float
    first: float
    last: float = math.inf
    length: float = 0.0
    counted: bool = False
    all_day: bool = False

    @property
    def endless(self) -> bool:
        """Whether no end of the repetition is named."""
        return math.isinf(self.last)

    @property
    def interval(self) -> float | None:
        """Seconds between occurrences."""
        return self.step

    def occurrences(self, until: float) -> tuple[float, ...]:
        """Give the times from 0 to ``until``, in seconds from when the instruction was given."""
        # "Every day for three days": no fourth begins where the third is over.
        end = min(until, self.last - (JUST_BEFORE if self.length else 0.0))
        start = self.first if self.first >= 0 else self.first % self.step
        if end < start:
            return ()
        count = min(MOST, math.floor((end - start) / self.step + 1e-9) + 1)
        return tuple(start + i * self.step for i in range(count))

    def windows(self, until: float) -> tuple[Window, ...]:
        """Give the same with their ends."""
        return tuple(
            (time, min(time + self.length, max(self.last, time))) for time in self.occurrences(until)
        )

    def coming(self, count: int) -> tuple[Window, ...]:
        """Give the next occurrences, at most so many."""
        return self.windows(max(self.first, 0.0) + self.step * count)[:count]

    def spaced(self, length: float) -> Self:
        """Give the same for what goes on that many seconds: none begins before the one before it is over."""
        if not self.counted or length < self.step or math.isclose(length, self.step):
            return self
        turns = round((self.last - self.first) / self.step)
        step = self.step + length
        return replace(self, step=step, last=self.first + turns * step)


@dataclass(frozen=True, slots=True, kw_only=True)
class CalendarRecurrence(PlainRecurrence):
    """At each of some days, parts of the day and clock times, of which only every ``skip``-th counts."""

    walls: tuple[Wall, ...]
    moment: "Moment"
    skip: int = 1
    first: float = 0.0
    last: float = math.inf

    @property
    def endless(self) -> bool:
        """Whether no end of the repetition is named."""
        return math.isinf(self.last)

    @property
    def spans(self) -> bool:
        """Whether words say where each occurrence begins and where it is over."""
        return all(wall.part is not None and not wall.part.name for wall in self.walls)

    @property
    def interval(self) -> float | None:
        """Seconds between occurrences, None where they are not evenly spaced."""
        if len(self.walls) > 1:
            return None
        days = self.walls[0].days
        if isinstance(days, Cycle) and days.unit in {Unit.DAY, Unit.WEEK}:
            return float(DAY_SECONDS * (7 if days.unit is Unit.WEEK else 1) * self.skip * days.count)
        return 7.0 * DAY_SECONDS * self.skip if is_weekday(days) else None

    def windows(self, until: float) -> tuple[Window, ...]:
        """Give the occurrences from 0 to ``until``, with their ends."""
        end = min(until, self.last)
        found: set[Window] = set()
        for wall in self.walls:
            for window in islice(self._windows(wall), 0, MOST * self.skip, self.skip):
                if window[0] > end:
                    break
                found.add(window)
        return tuple(sorted(found))[:MOST]

    def coming(self, count: int) -> tuple[Window, ...]:
        """Give the next occurrences, at most so many."""
        found: set[Window] = set()
        for wall in self.walls:
            series = islice(self._windows(wall), 0, count * self.skip, self.skip)
            found.update(window for window in series if window[0] <= self.last)
        return tuple(sorted(found))[:count]

    def _windows(self, wall: Wall) -> Iterator[Window]:
        """Give the occurrences of one wall-clock expression, up to the end of the calendar."""
        try:
            yield from self._all_windows(wall)
        except (OverflowError, ValueError, UngroundedError):
            return

    def _all_windows(self, wall: Wall) -> Iterator[Window]:
        now = self.moment.grounding().now
        today = Today(now.date(), self.moment.policy)
        for days in _series(wall.days).upcoming(today, today.day):
            start, end = self._on_days(wall, days)
            if start < now:
                # A stretch that is running counts from now on.
                if end <= now:
                    continue
                start = now
            first, last = self.moment.seconds(start), self.moment.seconds(end)
            if first >= self.first:
                yield first, min(last, max(self.last, first))

    @property
    def begun(self) -> float:
        """Seconds since a part of the day began that is running; 0 where none is."""
        now = self.moment.grounding().now
        today = Today(now.date(), self.moment.policy)
        parted = (wall for wall in self.walls if wall.part is not None and wall.clock is None)
        days = ((wall, next(_series(wall.days).upcoming(today, today.day), None)) for wall in parted)
        there = (self._on_days(wall, day) for wall, day in days if day is not None)
        return max(((now - start).total_seconds() for start, end in there if start < now < end), default=0.0)

    def _on_days(self, wall: Wall, days: Days) -> tuple[datetime, datetime]:
        """Give where a wall-clock expression begins and is over, on its days."""
        begins = midnight(days.first)
        if wall.clock is not None:
            moment = begins + timedelta(seconds=self.time_of_day(wall, wall.clock))
            if isinstance(wall.days, Fields):
                # "Every friday at midnight"
                moment += over_at_midnight(wall, self.moment.policy)
            return moment, moment
        if wall.part is not None:
            start, end = wall.part.start, wall.part.end
            start = self.moment.policy.begin_before(end) if wall.part.due else start
            return begins + timedelta(seconds=start), begins + timedelta(seconds=end)
        return begins, midnight(days.end)

    def time_of_day(self, wall: Wall, clock: Clock) -> int:
        """Give the seconds since midnight of a clock time: without am or pm, as the policy says."""
        if wall.part is not None:
            clock = halved(clock, wall.part.half)
        policy = self.moment.policy
        early = self._is_of_workdays(wall)
        return clock.first_from(policy.workday_from if early else policy.plausible_from)

    def _is_of_workdays(self, wall: Wall) -> bool:
        """Whether a clock time is that of all workdays: "at six on weekdays and at eight at weekends"."""
        return {other.days for other in self.walls if other.clock == wall.clock} == WORKDAYS


def _series(days: Calendar | None) -> Calendar:
    return days if days is not None else Cycle(Unit.DAY)
