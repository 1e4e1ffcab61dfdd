"""What a solver may use: time by a stopwatch that is passed in, memory, and somebody's wish to stop."""

import time
from collections.abc import Callable
from dataclasses import dataclass

from fuzzytime.errors import FuzzytimeError


def never() -> bool:
    """Nobody wishes to stop."""
    return False


@dataclass(frozen=True, slots=True)
class Limits:
    """Time and memory for one call of a solver; out of either, the best schedule so far comes back.

    Parameters
    ----------
    seconds
        Time by ``clock``; infinity for no limit.
    memory
        Bytes for the solver's tables.
    clock
        A stopwatch: gives ascending seconds from any origin.
    stopped
        Asked now and then; once it says True the search ends with the best so far.

    Raises
    ------
    FuzzytimeError
        If time is negative or not a number, or memory is below a megabyte.
    """

    seconds: float = 10.0
    memory: int = 1 << 30
    clock: Callable[[], float] = time.perf_counter
    stopped: Callable[[], bool] = never

    def __post_init__(self) -> None:
        if not self.seconds >= 0:
            raise FuzzytimeError(f"a time limit must be at least 0 seconds, got {self.seconds}")
        if self.memory < 1 << 20:
            raise FuzzytimeError(f"a memory limit must be at least {1 << 20} bytes, got {self.memory}")


class Stopwatch:
    """Time spent and left under limits, from the moment it is made."""

    def __init__(self, limits: Limits) -> None:
        self.limits = limits
        self._began = limits.clock()
        self._deadline = self._began + limits.seconds
        self._stopped = False
        self._whole: Stopwatch | None = None

    @property
    def seconds(self) -> float:
        """Time spent."""
        return self.limits.clock() - self._began

    @property
    def remaining(self) -> float:
        """Time left, at least 0."""
        return max(0.0, self._deadline - self.limits.clock())

    def is_over(self) -> bool:
        """Tell whether to end now with the best so far."""
        return self._stopped or self.limits.stopped() or self.limits.clock() >= self._deadline

    def stop(self) -> None:
        """End now, and also that of which this is a share: somebody interrupted."""
        self._stopped = True
        if self._whole is not None:
            self._whole.stop()

    def share(self, fraction: float) -> "Stopwatch":
        """Give a stopwatch that ends after a fraction of the time left."""
        part = Stopwatch(self.limits)
        part._deadline = part._began + fraction * self.remaining
        part._whole, part._stopped = self, self._stopped
        return part
