"""Instants as people read them: no more than they need beside the plan's now."""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from datetime import datetime

from fuzzytime.times import instant_after, seconds_between


def date_of(moment: datetime) -> str:
    """Print a date as people write it.

    >>> date_of(datetime(2026, 3, 4))
    'Wednesday 4 March 2026'
    """
    return f"{moment:%A} {moment.day} {moment:%B %Y}"


@dataclass(frozen=True, slots=True)
class Clock:
    """Prints times of a plan: with seconds where one of them needs them, with the day where it is another.

    ``grain`` is what times are rounded to, in seconds.
    """

    now: datetime
    with_seconds: bool
    grain: float = 1.0

    @classmethod
    def for_times(cls, now: datetime, times: Iterable[float]) -> "Clock":
        """Choose the least precision that tells all these times from full minutes."""
        return cls(now, any(round(time + now.second + _part(now)) % 60 for time in times))

    @classmethod
    def to_minutes(cls, now: datetime) -> "Clock":
        """Round all times to the minute."""
        return cls(now, with_seconds=False, grain=60.0)

    def of(self, time: float) -> str:
        """Print a time, in seconds from now, as ``09:02:30``, ``Thu 09:02`` or ``01 May 2027 09:02``."""
        instant = self._instant(time)
        clock = self._time_of_day(instant)
        return clock if instant.date() == self.now.date() else f"{self.day(time)} {clock}"

    def end_of(self, start: float, end: float) -> str:
        """Print the end of what starts at a time: without its day where that is the same."""
        instant = self._instant(end)
        same = instant.date() == self._instant(start).date()
        return self._time_of_day(instant) if same else self.of(end)

    def day(self, time: float) -> str:
        """Print the day of a time: ``Thu``, ``01 May``, or ``01 May 2027`` where it is of another year."""
        date = self._instant(time).date()
        if 0 <= (date - self.now.date()).days < 7:
            return f"{date:%a}"
        return f"{date:%d %b}" if date.year == self.now.year else f"{date:%d %b %Y}"

    def is_midnight(self, time: float) -> bool:
        """Say whether a day begins at a time."""
        instant = self._instant(time)
        return (instant.hour, instant.minute, instant.second) == (0, 0, 0)

    def _time_of_day(self, instant: datetime) -> str:
        return instant.strftime("%H:%M:%S" if self.with_seconds else "%H:%M")

    def _instant(self, time: float) -> datetime:
        past = _part(self.now) + (self.now.second if self.grain > 1 else 0)
        # Halves go up, so that what takes a minute does so on the clock.
        grains = math.floor((time + past) / self.grain + 0.5)
        return instant_after(self.now, self.grain * grains - past)

    def at(self, instant: datetime) -> str:
        """Print an instant as `of` does the time until it."""
        return self.of(seconds_between(self.now, instant))


def _part(now: datetime) -> float:
    """Give the part of a second that a moment has: what is rounded is the instant, not the time until it."""
    return now.microsecond / 1e6
