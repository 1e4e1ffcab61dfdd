"""ψ cut off outside a window: what may start no earlier or no later than something else allows."""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction.protocol import ACCEPTABLE, EMPTY, Floats, Interval, SatisfactionFunction


@dataclass(frozen=True, slots=True)
class Clipped:
    """ψ inside a closed window, 0 outside; unlike a product it keeps shape and open ends.

    Raises
    ------
    FuzzytimeError
        If the window is empty.

    >>> from fuzzytime.satisfaction import Trapezoid
    >>> Clipped(Trapezoid(0, 60, math.inf, math.inf), Interval(30, math.inf))([15, 30, 90]).tolist()
    [0.0, 0.5, 1.0]
    """

    model: ClassVar[str] = "clipped"

    function: SatisfactionFunction
    window: Interval

    def __post_init__(self) -> None:
        if self.window.empty:
            raise FuzzytimeError(f"a window must not be empty, got {self.window.low} to {self.window.high}")

    def _inside(self, times: ArrayLike) -> np.ndarray:
        at = np.asarray(times, float)
        return np.asarray((at >= self.window.low) & (at <= self.window.high))

    def __call__(self, times: ArrayLike) -> Floats:
        """Give ψ at times of any shape, in that shape."""
        return np.asarray(np.where(self._inside(times), self.function(times), 0.0))

    def log(self, times: ArrayLike) -> Floats:
        """Give log ψ at times of any shape, −inf outside the window."""
        return np.asarray(np.where(self._inside(times), self.function.log(times), -math.inf))

    @property
    def parameters(self) -> dict[str, float | list[float]]:
        """The window beside the parameters of the function."""
        return {"earliest": self.window.low, "latest": self.window.high, **self.function.parameters}

    @property
    def support(self) -> Interval:
        """The part of the function's support inside the window."""
        return self.function.support.intersection(self.window)

    @property
    def kinks(self) -> tuple[float, ...]:
        """Those of the function inside, and the window's ends."""
        ends = {end for end in (self.window.low, self.window.high) if math.isfinite(end)}
        return tuple(sorted(ends.union(kink for kink in self.function.kinks if kink in self.window)))

    @property
    def best(self) -> Interval:
        """The interval on which ψ is largest inside the window."""
        inside = self.function.best.intersection(self.window)
        if not inside.empty:
            return inside
        marks = self.kinks
        values = [float(self(mark)) for mark in marks]
        most = max(values, default=0.0)
        if most <= 0:
            return EMPTY
        first = values.index(most)
        # Not its best plateau, yet perhaps another one, from this kink to the next.
        flat = first + 1 < len(marks) and float(self((marks[first] + marks[first + 1]) / 2)) == most
        return Interval(marks[first], marks[first + 1] if flat else marks[first])

    @property
    def log_concave(self) -> bool:
        """As the function: a window does not bend it."""
        return self.function.log_concave

    def acceptable(self, level: float = ACCEPTABLE) -> Interval:
        """Give the smallest interval that holds every time with ψ ≥ level."""
        if level <= 0:
            return self.function.acceptable(level)
        marks = [*self.kinks, *(time for time in self.crossings(level)), self.window.low, self.window.high]
        good = [mark for mark in marks if float(self(mark)) >= level * (1 - 1e-12)]
        return Interval(min(good), max(good)) if good else EMPTY

    def crossings(self, level: float) -> tuple[float, ...]:
        """Give the times at which ψ passes a level: those of the function inside, and ends with a jump."""
        found = {time for time in self.function.crossings(level) if time in self.window}
        found |= {
            end
            for end in (self.window.low, self.window.high)
            if math.isfinite(end) and float(self.function(end)) >= level > 0
        }
        return tuple(sorted(found))

    def chord_error(self, starts: ArrayLike, ends: ArrayLike) -> Floats:
        """As the function's: pieces without a kink lie on one side of each end of the window."""
        return self.function.chord_error(starts, ends)

    def shifted(self, by: float) -> "Clipped":
        """Give the same, ``by`` seconds later."""
        return Clipped(self.function.shifted(by), Interval(self.window.low + by, self.window.high + by))

    def widened(self, factor: float, anchor: float) -> "Clipped":
        """Give function and window scaled about a time by a factor above 0."""
        ends = (anchor + factor * (end - anchor) for end in (self.window.low, self.window.high))
        return Clipped(self.function.widened(factor, anchor), Interval(*ends))
