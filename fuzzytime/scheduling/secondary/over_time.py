"""Quantities over time, such as a tariff or how much work would disturb, and what they sum up to."""

import math
from dataclasses import dataclass

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Floats


@dataclass(frozen=True, slots=True)
class OverTime:
    """A quantity ≥ 0 over time: linear between points, a jump where a time stands twice, flat outside.

    Raises
    ------
    FuzzytimeError
        If there is no point, times decrease, or a number is negative or not finite.
    """

    times: tuple[float, ...]
    values: tuple[float, ...]

    def __post_init__(self) -> None:
        if not self.times or len(self.times) != len(self.values):
            raise FuzzytimeError(
                f"a curve needs as many values as times, at least one, got {len(self.times)} times "
                f"and {len(self.values)} values"
            )
        if not all(map(math.isfinite, (*self.times, *self.values))) or min(self.values) < 0:
            raise FuzzytimeError("a curve's times must be finite, and its values finite and at least 0")
        if any(later < earlier for earlier, later in zip(self.times, self.times[1:], strict=False)):
            raise FuzzytimeError(f"a curve's times must not decrease, got {self.times}")

    def over(self, starts: Floats, duration: float) -> Floats:
        """Give the integral over [start, start + duration] for start times of any shape."""
        times, values = np.array(self.times), np.array(self.values)
        running = np.concatenate([[0.0], np.cumsum((values[1:] + values[:-1]) / 2 * np.diff(times))])

        def until(moments: Floats) -> Floats:
            cell = np.clip(np.searchsorted(times, moments, "right") - 1, 0, times.size - 1)
            after = moments - times[cell]
            following = np.minimum(cell + 1, times.size - 1)
            width = np.where(following > cell, times[following] - times[cell], 1.0)
            slope = np.where(
                following > cell, (values[following] - values[cell]) / np.maximum(width, 1e-300), 0.0
            )
            slope = np.where(after < 0, 0.0, slope)
            return np.asarray(running[cell] + after * (values[cell] + slope * after / 2))

        return np.asarray(until(starts + duration) - until(starts))
