"""Repetitions by months and years as values: "every month", "every three months", "once a year"."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from datetime import datetime
from itertools import islice, takewhile
from typing import TYPE_CHECKING

from fuzzytime.language.meaning.expressions import Duration
from fuzzytime.language.meaning.instants import CALENDAR_UNITS, shifted
from fuzzytime.language.meaning.recurrences.recurrence import JUST_BEFORE, MOST, PlainRecurrence
from fuzzytime.language.meaning.ungrounded import UngroundedError
from fuzzytime.language.meaning.units import UNIT_SECONDS
from fuzzytime.requirement import Unit, Window

if TYPE_CHECKING:
    from fuzzytime.language.meaning.grounded.moment import Moment


@dataclass(frozen=True, slots=True, kw_only=True)
class RecurrenceByMonths(PlainRecurrence):
    """On the same day of every so many months from a day on, or on the last of those that lack it.

    It is done within a ``unit`` from there on: "every three months" in the first of them.
    """

    amount: int
    unit: Unit
    begins: datetime
    moment: "Moment"
    last: float = math.inf

    @property
    def endless(self) -> bool:
        """Whether no end of the repetition is named."""
        return math.isinf(self.last)

    @property
    def interval(self) -> float:
        """Seconds between occurrences, a month of 30 days."""
        return self.amount * UNIT_SECONDS[self.unit]

    def windows(self, until: float) -> tuple[Window, ...]:
        """Give the occurrences from 0 to ``until``, with their ends."""
        end = min(until, self.last - JUST_BEFORE)
        return tuple(takewhile(lambda window: window[0] <= end, self._windows()))

    def coming(self, count: int) -> tuple[Window, ...]:
        """Give the next occurrences, at most so many."""
        return tuple(islice((one for one in self._windows() if one[0] <= self.last - JUST_BEFORE), count))

    def _windows(self) -> Iterator[Window]:
        """Give the occurrences that are not over, up to the end of the calendar."""
        for turn in range(MOST):
            try:
                first, last = self._at(turn * self.amount), self._at(turn * self.amount + 1)
            except (OverflowError, ValueError, UngroundedError):
                return
            if first >= 0:
                yield first, min(last, max(self.last, first))

    def _at(self, units: int) -> float:
        """Give the seconds from now to so many units after the first day."""
        return self.moment.seconds(shifted(self.begins, Duration(((units, self.unit),)), 1))


def is_by_months(every: Duration) -> bool:
    """Whether a length is so many whole months or years."""
    (amount, unit), *more = every.terms
    return not more and unit in CALENDAR_UNITS and amount == int(amount) and amount >= 1
