"""Repetitions as values that give their occurrences: evenly spaced, or by the calendar."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import timedelta
from itertools import islice
from typing import TYPE_CHECKING

from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields, Today
from fuzzytime.language.meaning.expressions import DAY_SECONDS, Half, Repeat, Time, Wall
from fuzzytime.language.meaning.instants import SUB_DAY, UngroundedError, midnight
from fuzzytime.requirement import Unit

if TYPE_CHECKING:
    from fuzzytime.language.meaning.moment import Moment

MOST = 10_000
"""Occurrences that are given at most."""


@dataclass(frozen=True, slots=True, kw_only=True)
class EvenRecurrence:
    """Every so many seconds, from a first time on.

    >>> EvenRecurrence(step=1200, first=1200).occurrences(3600)
    (1200, 2400, 3600)
    """

    step: float
    first: float
    last: float = math.inf

    @property
    def interval(self) -> float | None:
        """Seconds between occurrences."""
        return self.step

    def occurrences(self, until: float) -> tuple[float, ...]:
        """Give the times from 0 to ``until``, in seconds from when the instruction was given."""
        end = min(until, self.last)
        start = self.first if self.first >= 0 else self.first % self.step
        if end < start:
            return ()
        count = min(MOST, math.floor((end - start) / self.step + 1e-9) + 1)
        return tuple(start + i * self.step for i in range(count))

    def coming(self, count: int) -> tuple[float, ...]:
        """Give the next occurrences, at most so many."""
        return self.occurrences(self.first + self.step * count)[:count]


@dataclass(frozen=True, slots=True, kw_only=True)
class CalendarRecurrence:
    """At each of some days, parts of the day and clock times, of which only every ``skip``-th counts."""

    walls: tuple[Wall, ...]
    moment: "Moment"
    skip: int = 1
    first: float = 0.0
    last: float = math.inf

    @property
    def interval(self) -> float | None:
        """Seconds between occurrences, None where they are not evenly spaced."""
        if len(self.walls) > 1:
            return None
        days = self.walls[0].days
        if isinstance(days, Cycle) and days.unit in {Unit.DAY, Unit.WEEK}:
            return float(DAY_SECONDS * (7 if days.unit is Unit.WEEK else 1) * self.skip * days.count)
        return 7.0 * DAY_SECONDS * self.skip if isinstance(days, Fields) and days.weekly else None

    def occurrences(self, until: float) -> tuple[float, ...]:
        """Give the times from 0 to ``until``, in seconds from when the instruction was given.

        Without a time of day an occurrence is when its day begins, or now where that day is today.
        """
        end = min(until, self.last)
        found: set[float] = set()
        for wall in self.walls:
            for seconds in islice(self._times(wall), 0, MOST * self.skip, self.skip):
                if seconds > end:
                    break
                found.add(seconds)
        return tuple(sorted(found))[:MOST]

    def coming(self, count: int) -> tuple[float, ...]:
        """Give the next occurrences, at most so many."""
        found: set[float] = set()
        for wall in self.walls:
            series = islice(self._times(wall), 0, count * self.skip, self.skip)
            found.update(seconds for seconds in series if seconds <= self.last)
        return tuple(sorted(found))[:count]

    def _times(self, wall: Wall) -> Iterator[float]:
        """Give the times of one wall-clock expression, up to the end of the calendar."""
        try:
            yield from self._all_times(wall)
        except (OverflowError, ValueError, UngroundedError):
            return

    def _all_times(self, wall: Wall) -> Iterator[float]:
        now = self.moment.grounding().now
        today = Today(now.date(), self.moment.policy)
        clock = _seconds_of_day(wall)
        for days in _series(wall.days).upcoming(today, today.day):
            start = midnight(days.first) + timedelta(seconds=clock or 0)
            if start < now:
                # The day that is running counts from now on, unless its time of day is over.
                if clock is not None and (wall.part is None or wall.clock is not None):
                    continue
                if wall.part is not None and midnight(days.first) + timedelta(seconds=wall.part.end) <= now:
                    continue
                start = now
            seconds = self.moment.seconds(start)
            if seconds >= self.first:
                yield seconds


def _series(days: Calendar | None) -> Calendar:
    return days if days is not None else Cycle(Unit.DAY)


def _seconds_of_day(wall: Wall) -> int | None:
    if wall.clock is not None:
        clock = wall.clock
        candidates = clock.candidates()
        if wall.part is not None and len(candidates) > 1:
            return candidates[1] if wall.part.half in {Half.PM, Half.NIGHT} else candidates[0]
        # Without am or pm, the one in the usual hours: from seven in the morning on.
        return next((c for c in candidates if c >= 7 * 3600), candidates[0])
    return wall.part.start if wall.part is not None else None


def recurrence_of(repeat: Repeat, moment: "Moment") -> EvenRecurrence | CalendarRecurrence:
    """Ground a repetition.

    Raises
    ------
    UngroundedError
        If it needs a clock that is not known.
    """
    first = _bound(repeat.starting, moment, last=False)
    last = _bound(repeat.until, moment, last=True)
    if repeat.walls and not _is_even(repeat):
        moment.grounding()
        return CalendarRecurrence(
            walls=repeat.walls,
            moment=moment,
            skip=repeat.skip,
            first=0.0 if first is None else max(0.0, first),
            last=math.inf if last is None else last,
        )
    if repeat.every is None:
        raise UngroundedError("a repetition must say how often")
    step = repeat.every.seconds
    sub_day = all(unit in SUB_DAY for _, unit in repeat.every.terms)
    start = first if first is not None else (step if sub_day else 0.0)
    return EvenRecurrence(step=step, first=start, last=math.inf if last is None else last)


def _is_even(repeat: Repeat) -> bool:
    """Whether days are counted from today: "every two days", without a time of day."""
    return repeat.every is not None and all(wall.clock is None and wall.part is None for wall in repeat.walls)


def _bound(time: Time | None, moment: "Moment", *, last: bool) -> float | None:
    if time is None:
        return None
    from fuzzytime.language.meaning.expressions import TimeWord

    if isinstance(time, TimeWord):
        return 0.0
    found = moment.grounding().instants(time)
    return moment.seconds(found.end if last else found.start)
