"""Prices that make a relaxation's bound as high as they can.

The bound D(λ) is concave in the prices λ, and each evaluation gives a plane above it. A few dozen steps of
the volume algorithm come close: steps along a running average of gradients from the best prices so far. Cutting
planes finish: a linear program finds where the planes promise most, and the next evaluation lies between
there and the best prices, which keeps its answers from jumping about.

Barahona and Anbil, The volume algorithm: producing primal solutions with a subgradient method, Math.
Programming 87 (2000) 385-399. Wentges, Weighted Dantzig-Wolfe decomposition for linear mixed-integer
programming, Int. Trans. Oper. Res. 4 (1997) 151-162.
"""

from typing import Protocol

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.limits import Stopwatch

SMOOTHING = 0.85
"""How far from the planes' best prices toward the best yet the next evaluation lies."""

PROMISE = 0.02
"""Cutting planes end where they promise less than this share of what is left to prove."""

SMALLEST = 1e-9


class Bound(Protocol):
    """A concave function of prices, each between 0 and a ceiling."""

    ceiling: Floats

    def evaluate(self, prices: Floats) -> tuple[float, Floats]:
        """Give its value, and a gradient."""
        ...


class Multipliers:
    """The best prices found so far, and what they prove.

    Parameters
    ----------
    bound
        What is to become high.
    prices
        Where to begin.
    """

    def __init__(self, bound: Bound, prices: Floats) -> None:
        self._bound = bound
        self._ceiling = bound.ceiling
        self._gradients: list[Floats] = []
        self._levels: list[float] = []
        self.lower = -np.inf
        self.prices = prices
        self._gradient = self._evaluate(prices)

    def _evaluate(self, prices: Floats) -> Floats:
        value, gradient = self._bound.evaluate(prices)
        self._gradients.append(gradient)
        self._levels.append(value - float(gradient @ prices))
        self._improved = value > self.lower
        if self._improved:
            self.lower, self.prices = value, prices
        return gradient

    def volume(self, upper: float, steps: int, watch: Stopwatch) -> None:
        """Take steps along an average of gradients; their scale falls after ten that fail."""
        average, scale, failures = self._gradient, 0.1, 0
        most = float(self._ceiling.max(initial=0.0))
        for _ in range(steps):
            blocked = (self.prices <= 0) & (average < 0) | (self.prices >= self._ceiling) & (average > 0)
            direction = np.where(blocked, 0.0, average)
            length = float(direction @ direction)
            if length < SMALLEST or upper - self.lower < SMALLEST or watch.is_over():
                return
            target = min(upper, max(1.5 * self.lower, self.lower + most))
            step = scale * (target - self.lower) / length
            gradient = self._evaluate(np.clip(self.prices + step * direction, 0.0, self._ceiling))
            change = gradient - average
            share = -float(average @ change) / max(float(change @ change), SMALLEST)
            average = average + np.clip(share, 0.01, 0.1) * change
            failures = 0 if self._improved else failures + 1
            scale *= 1.1 if self._improved else 0.66 if failures % 10 == 0 else 1.0

    def cutting_planes(self, upper: float, steps: int, watch: Stopwatch) -> None:
        """Evaluate near where all planes so far promise most, until they promise little."""
        from scipy.optimize import Bounds, LinearConstraint, milp

        count = self.prices.size
        box = Bounds(np.append(np.zeros(count), -np.inf), np.append(self._ceiling, np.inf))
        for _ in range(steps):
            planes = np.column_stack([-np.array(self._gradients), np.ones(len(self._gradients))])
            below = LinearConstraint(planes, -np.inf, np.array(self._levels))
            master = milp(np.append(np.zeros(count), -1.0), constraints=below, bounds=box)
            if master.x is None or watch.is_over():
                return
            promise = -master.fun - self.lower
            if promise < max(PROMISE * (upper - self.lower), SMALLEST):
                return
            self._evaluate(SMOOTHING * self.prices + (1 - SMOOTHING) * master.x[:count])
