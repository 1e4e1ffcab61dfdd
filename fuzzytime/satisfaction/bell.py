"""ψ as a generalised bell, which has a plateau where a Gaussian has none."""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction.protocol import ACCEPTABLE, EMPTY, EVERYWHERE, Floats, Interval, check_factor


@dataclass(frozen=True, slots=True)
class Bell:
    """The generalised bell ψ(t) = 1 / (1 + |(t − centre) / width|^(2·slope)); ½ one width from its centre.

    Raises
    ------
    FuzzytimeError
        If the centre is not finite, or width or slope is not above 0.
    """

    model: ClassVar[str] = "bell"

    centre: float
    width: float
    slope: float

    def __post_init__(self) -> None:
        if not math.isfinite(self.centre):
            raise FuzzytimeError(f"a bell's centre must be finite, got {self.centre}")
        for name, value in (("width", self.width), ("slope", self.slope)):
            if not (0 < value < math.inf):
                raise FuzzytimeError(f"a bell's {name} must be above 0 and finite, got {value}")

    def __call__(self, times: ArrayLike) -> Floats:
        """Give ψ at times of any shape, in that shape."""
        return np.asarray(np.exp(self.log(times)))

    def log(self, times: ArrayLike) -> Floats:
        """Give log ψ at times of any shape."""
        distance = np.abs((np.asarray(times, float) - self.centre) / self.width)
        with np.errstate(divide="ignore"):
            return np.asarray(-np.logaddexp(0.0, 2 * self.slope * np.log(distance)))

    @property
    def parameters(self) -> dict[str, float | list[float]]:
        """Centre and width in seconds, and the slope."""
        return {"centre": self.centre, "width": self.width, "slope": self.slope}

    @property
    def support(self) -> Interval:
        """All times: a bell never reaches 0."""
        return EVERYWHERE

    @property
    def kinks(self) -> tuple[float, ...]:
        """The centre, where the slope may jump (slope ≤ ½)."""
        return (self.centre,)

    @property
    def best(self) -> Interval:
        """The centre."""
        return Interval(self.centre, self.centre)

    @property
    def log_concave(self) -> bool:
        """Never: the flanks of a generalised bell are long."""
        return False

    def acceptable(self, level: float = ACCEPTABLE) -> Interval:
        """Give the interval of times with ψ ≥ level."""
        if level <= 0:
            return EVERYWHERE
        if level > 1:
            return EMPTY
        with np.errstate(over="ignore"):
            reach = self.width * float(np.float64(1 / level - 1) ** (1 / (2 * self.slope)))
        return Interval(self.centre - reach, self.centre + reach)

    def crossings(self, level: float) -> tuple[float, ...]:
        """Give the two times at which ψ passes a level between 0 and 1."""
        if not 0 < level < 1:
            return ()
        inside = self.acceptable(level)
        return inside.low, inside.high

    def chord_error(self, starts: ArrayLike, ends: ArrayLike) -> Floats:
        """Bound by the curvature: an arc of length h stays within h² / 8 · max (−log ψ)'' of its chord."""
        first, last = np.asarray(starts, float), np.asarray(ends, float)
        return np.asarray((last - first) ** 2 / 8 * self._curvature(first, last))

    def _curvature(self, starts: Floats, ends: Floats) -> Floats:
        """Bound (−log ψ)'' on pieces that do not cross the centre.

        With x = |t − c| / w and p = 2s it is p x^(p−2) (p − 1 − x^p) / (1 + x^p)² / w², at most
        p (p − 1) x^(p−2) / (1 + x^p)² / w², whose largest value is where x^p = (p − 2) / (p + 2).
        """
        power = 2 * self.slope
        if power <= 1:
            return np.zeros_like(starts)
        first, last = np.abs(starts - self.centre) / self.width, np.abs(ends - self.centre) / self.width
        near, far = np.minimum(first, last), np.maximum(first, last)
        peak = ((power - 2) / (power + 2)) ** (1 / power) if power > 2 else 0.0
        with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
            distance = np.log(np.clip(peak, near, far))
            scale = np.where(np.isneginf(distance) & (power == 2), 0.0, (power - 2) * distance)
            value = np.exp(scale - 2 * np.logaddexp(0.0, power * distance))
        return np.asarray(power * (power - 1) * value / self.width**2)

    def shifted(self, by: float) -> "Bell":
        """Give the same bell ``by`` seconds later."""
        return Bell(self.centre + by, self.width, self.slope)

    def widened(self, factor: float, anchor: float) -> "Bell":
        """Give the bell scaled about a time by a factor above 0."""
        check_factor(factor)
        return Bell(anchor + factor * (self.centre - anchor), self.width * factor, self.slope)
