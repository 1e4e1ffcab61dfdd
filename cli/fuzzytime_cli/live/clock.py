"""Time in a run: seconds since it began, by the machine's clock, faster than that, or simulated."""

import math
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Protocol

from fuzzytime_cli.live.inbox import Inbox

BEAT = 1.0
"""Seconds of the machine that are waited at most at once: a machine that wakes from sleep is noticed."""


class Clock(Protocol):
    """What tells a run the time, and lets it go on."""

    @property
    def now(self) -> float:
        """Seconds of the run since it began."""
        ...

    def wait(self, until: float, inbox: Inbox) -> None:
        """Let time go on to a moment, or less far where something comes in."""
        ...


def elapsed_seconds() -> float:
    """Give ascending seconds that count the time in which the machine sleeps, as `time.monotonic` may not."""
    kind = getattr(time, "CLOCK_BOOTTIME", None)
    if kind is None and sys.platform == "darwin":
        kind = time.CLOCK_MONOTONIC
    return time.monotonic() if kind is None else time.clock_gettime(kind)


@dataclass(slots=True)
class MachineClock:
    """The machine's time, each of its seconds counting for ``speed`` of the run."""

    speed: float = 1.0
    stopwatch: Callable[[], float] = elapsed_seconds
    _began: float = field(init=False)

    def __post_init__(self) -> None:
        self._began = self.stopwatch()

    @property
    def now(self) -> float:
        """Seconds of the run since it began."""
        return (self.stopwatch() - self._began) * self.speed

    def wait(self, until: float, inbox: Inbox) -> None:
        """Wait for something to come in, at most until a moment, and at most a beat."""
        inbox.wait(min(BEAT, max(0.0, (until - self.now) / self.speed)))


@dataclass(slots=True)
class SimulatedClock:
    """Time that passes at once: a run as fast as it can be, and each time the same."""

    now: float = 0.0

    def wait(self, until: float, inbox: Inbox) -> None:  # noqa: ARG002 - all news has its time already
        """Jump to a moment; where none is to come, time stands."""
        if until < math.inf:
            self.now = max(self.now, until)
