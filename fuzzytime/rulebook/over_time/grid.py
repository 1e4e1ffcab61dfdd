"""Times at which a condition is followed: regular ones, and more where something happens between them."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from fuzzytime.rulebook.logic.traces import Points, Positions
from fuzzytime.satisfaction import Floats

MOST_POINTS = 1800
MOST_FINE_POINTS = 20_000
_STEPS = (0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 30.0, 60.0, 120.0, 300.0, 600.0)
_STEPS_A_WINDOW = 8

_MOST_READINGS = 20_000
"""So many readings are all looked at; of more, the least and the greatest of half as many stretches."""


@dataclass(frozen=True, slots=True, eq=False)
class Grid:
    """Regular times that hold 0, and finer times where more than the grid is wanted.

    ``times`` has shape (m,); ``regular`` are the positions of the k regular ones, ``zero`` that of time 0.
    """

    step: float
    times: Floats
    regular: Positions

    @classmethod
    def of(cls, past: float, future: float, finest: float) -> "Grid":
        """Make a grid from ``past`` seconds before 0 to ``future`` after it.

        Its step is a round number that keeps it within `MOST_POINTS`, unless windows want it finer.
        """
        total = past + future
        step = next((step for step in _STEPS if total / step <= MOST_POINTS), total / MOST_POINTS)
        if finest / _STEPS_A_WINDOW < step:
            step = max(finest / _STEPS_A_WINDOW, total / MOST_FINE_POINTS)
        before, after = math.ceil(past / step - 1e-9), math.ceil(future / step - 1e-9)
        times = np.arange(-before, after + 1, dtype=float) * step
        return cls(step, times, np.arange(times.size))

    @property
    def zero(self) -> int:
        """The position of time 0."""
        return int(np.searchsorted(self.times, 0.0))

    @property
    def points(self) -> Points:
        """Its times in steps."""
        return Points(self.times / self.step, self.regular)

    def refined(self, more: Iterable[float]) -> "Grid":
        """Give the grid with further times inside it."""
        inside = np.fromiter(more, float)
        inside = inside[(inside > self.times[0]) & (inside < self.times[-1])]
        if not inside.size:
            return self
        times = np.union1d(self.times, inside)
        return Grid(self.step, times, np.searchsorted(times, self.times[self.regular]))

    def telling(self, times: Floats, values: Floats) -> Floats:
        """Give those of a signal's readings inside the grid that tell its course.

        All of them, but of very many only the least and the greatest within each short stretch.
        """
        first, last = np.searchsorted(times, self.times[[0, -1]])
        times, values = times[first:last], values[first:last]
        if times.size <= _MOST_READINGS:
            return times
        stretches = np.floor((times - times[0]) / (times[-1] - times[0]) * (_MOST_READINGS // 2))
        order = np.lexsort((values, stretches))
        bounds = np.flatnonzero(np.diff(stretches[order])) + 1
        ends = np.concatenate([[0], bounds, bounds - 1, [times.size - 1]])
        return np.asarray(times[order[ends]])

    def at_all_times(self, trace: Floats) -> Floats:
        """Carry traces of shape (curves, k) from the regular times to all of them, linearly."""
        if self.regular.size == self.times.size:
            return trace
        regular = self.times[self.regular]
        after = np.clip(np.searchsorted(regular, self.times), 1, regular.size - 1)
        share = (self.times - regular[after - 1]) / (regular[after] - regular[after - 1])
        low, high = trace[:, after - 1], trace[:, after]
        # At a regular time the value is its own, also where its neighbour's is unknown.
        return np.where(share == 1.0, high, np.where(share == 0.0, low, low + share * (high - low)))


def jump(time: float) -> tuple[float, float]:
    """Give two times between which something happens at a time."""
    return float(np.nextafter(time, -np.inf)), time
