"""ψ with a floor under it."""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction.protocol import ACCEPTABLE, EVERYWHERE, Floats, Interval, SatisfactionFunction


@dataclass(frozen=True, slots=True)
class Floored:
    """max(ψ, floor): the paper's minimum threshold, with which one hopeless skill does not spoil the product.

    Raises
    ------
    FuzzytimeError
        If the floor is not in (0, 1].
    """

    model: ClassVar[str] = "floored"

    function: SatisfactionFunction
    floor: float

    def __post_init__(self) -> None:
        if not 0 < self.floor <= 1:
            raise FuzzytimeError(f"a floor must lie in (0, 1], got {self.floor}")

    def __call__(self, times: ArrayLike) -> Floats:
        """Give ψ, at least the floor, at times of any shape, in that shape."""
        return np.asarray(np.maximum(self.function(times), self.floor))

    def log(self, times: ArrayLike) -> Floats:
        """Give log ψ, at least that of the floor."""
        return np.asarray(np.maximum(self.function.log(times), math.log(self.floor)))

    @property
    def parameters(self) -> dict[str, float | list[float]]:
        """The floor beside the parameters of the function above it."""
        return {"floor": self.floor, **self.function.parameters}

    @property
    def support(self) -> Interval:
        """All times."""
        return EVERYWHERE

    @property
    def kinks(self) -> tuple[float, ...]:
        """Those of the function, and where it meets the floor."""
        return tuple(sorted({*self.function.kinks, *self.function.crossings(self.floor)}))

    @property
    def best(self) -> Interval:
        """Those of the function, where they lie above the floor."""
        best = self.function.best
        return best if not best.empty and float(self(best.high)) > self.floor else EVERYWHERE

    @property
    def log_concave(self) -> bool:
        """Not known."""
        return False

    def acceptable(self, level: float = ACCEPTABLE) -> Interval:
        """Give the smallest interval that holds every time with satisfaction ≥ level."""
        return EVERYWHERE if level <= self.floor else self.function.acceptable(level)

    def crossings(self, level: float) -> tuple[float, ...]:
        """Give the times at which the function passes a level above the floor."""
        return self.function.crossings(level) if level >= self.floor else ()

    def chord_error(self, starts: ArrayLike, ends: ArrayLike) -> Floats:
        """Give the function's own bound on pieces above the floor, and 0 on the flat ones."""
        first, last = np.asarray(starts, float), np.asarray(ends, float)
        above = self.function((first + last) / 2) > self.floor
        return np.asarray(np.where(above, self.function.chord_error(first, last), 0.0))

    def shifted(self, by: float) -> "Floored":
        """Give the same ``by`` seconds later."""
        return Floored(self.function.shifted(by), self.floor)

    def widened(self, factor: float, anchor: float) -> "Floored":
        """Give the function scaled about a time, on the same floor."""
        return Floored(self.function.widened(factor, anchor), self.floor)
