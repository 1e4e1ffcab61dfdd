"""Repetitions by an interval on some days as values: "every five minutes on weekdays"."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import islice

from fuzzytime.language.meaning.recurrences.recurrence import (
    JUST_BEFORE,
    MOST,
    CalendarRecurrence,
    PlainRecurrence,
)
from fuzzytime.requirement import Window

MORE = 3
"""How many stretches tell how long one is that has begun."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RecurrenceOnDays(PlainRecurrence):
    """Every so many seconds within each stretch of ``days``, from its beginning on, and ``offset`` seconds.

    Each lasts a ``length``.
    """

    days: CalendarRecurrence
    step: float
    offset: float = 0.0
    length: float = 0.0

    @property
    def endless(self) -> bool:
        """Whether no end of the repetition is named."""
        return self.days.endless

    @property
    def interval(self) -> float | None:
        """Seconds between occurrences of one day."""
        return self.step

    def windows(self, until: float) -> tuple[Window, ...]:
        """Give the occurrences from 0 to ``until``, with their ends."""
        stretches = self.days.windows(until)
        return tuple(islice((turn for one in stretches for turn in self._turns(one, until)), MOST))

    def coming(self, count: int) -> tuple[Window, ...]:
        """Give the next occurrences, at most so many."""
        stretches = self.days.coming(count)
        return tuple(islice((turn for one in stretches for turn in self._turns(one, math.inf)), count))

    def _turns(self, stretch: Window, until: float) -> Iterator[Window]:
        """Give the occurrences in one stretch; at its very end too, where its hours are said."""
        begin, end = stretch
        # One that is running has begun before now.
        whole = end - begin if begin > 0 else max(b - a for a, b in (stretch, *self.days.coming(MORE)))
        start = end - whole + self.offset
        passed = max(0, math.floor((begin - self.length - start) / self.step))
        for turn in range(passed, passed + MOST):
            time = start + turn * self.step
            if time + self.length < begin or (self.length and time + self.length == begin):
                continue
            over = time > end - JUST_BEFORE and (self.length > 0 or not self.days.spans)
            if time > min(end, until) or over:
                return
            yield max(time, begin), min(time + self.length, end) if self.length else time
