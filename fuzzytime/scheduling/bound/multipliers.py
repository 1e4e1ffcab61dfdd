"""Prices that make a bound as high as they can: a proximal bundle method.

The bound D is concave in the prices λ, and each evaluation gives a plane above it. The next prices are the
best by all planes so far, less a penalty stiffness/2·|λ − best|² for going far from the best prices yet.
The dual of that quadratic program is over weights of the planes, and a few dozen exchanges of weight
between two planes solve it well enough: the method needs promising prices, not the most promising ones.

Everything depends on the stiffness. It falls with each step that makes the bound higher and rises with each
that was too long; and where the planes promise little, it may be what keeps the promise small: only planes
that promise little however loose the penalty end the search. Stiffness that rose ten times faster than it
fell ended it far below the highest bound, where prices had a long way to go.

Kiwiel, Proximity control in bundle methods for convex nondifferentiable minimization, Math. Programming 46
(1990) 105-122.
"""

from typing import Protocol

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.limits import Stopwatch

PLANES = 50
"""Planes that are kept; more make steps better and each one slower."""

EXCHANGES = 100
"""Exchanges of weight before the next evaluation, at most."""

FIRST_REACH = 3.0
"""How far the first step goes: this many times as far as the first plane needs to promise the known cost."""

PROMISE = 0.02
"""The search ends where the planes promise less than this share of what is left to prove."""

RISE = 0.1
"""Prices become the best if the bound rises by this share of what was promised; else the planes learn."""

LITTLE_RISE = 0.01
"""That share where the bound has come to rise slowly: far up planes promise too much for long."""

LOOSER = 0.7
"""The stiffness changes so where prices become the best …"""

STIFFER = 1.4
"""… and so where a step was too long."""

MUCH_LOOSER = 0.3
"""… and so where little is promised, up to `LOOSENED` times in a row."""

LOOSENED = 8

SMALLEST = 1e-6


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
    upper
        The cost of a known schedule.
    """

    def __init__(self, bound: Bound, prices: Floats, upper: float) -> None:
        self._bound = bound
        self._ceiling = bound.ceiling
        self.prices = prices
        self.lower, gradient = bound.evaluate(prices)
        self._gradients = gradient[None, :]
        self._levels = np.array([self.lower - gradient @ prices])
        self._weights = np.ones(1)
        inner = ((prices > 0) | (gradient > 0)) & ((prices < self._ceiling) | (gradient < 0))
        steepness = float(gradient[inner] @ gradient[inner])
        self._stiffness = max(steepness, 1.0) / max(upper - self.lower, SMALLEST) / FIRST_REACH

    def improve(self, upper: float, steps: int, watch: Stopwatch, rise: float = RISE) -> bool:
        """Take steps until the planes promise little, the bound reaches a known cost, or time is over.

        Tells whether nothing is promised any more.

        Parameters
        ----------
        upper
            The known cost.
        steps
            At most.
        watch
            Asked before each step.
        rise
            Of what was promised, for prices to become the best.
        """
        for _ in range(steps):
            point, promise = self._promising(max(PROMISE * (upper - self.lower), SMALLEST))
            if point is None:
                return True
            if watch.is_over():
                return False
            value, gradient = self._bound.evaluate(point)
            self._keep(gradient, value - float(gradient @ point))
            # How far the new plane lies above D at the best prices tells whether the step was too long.
            above = value + float(gradient @ (self.prices - point)) - self.lower
            if value - self.lower > rise * promise:
                self.prices, self.lower = point, value
                self._stiffness *= LOOSER
            elif above > promise:
                self._stiffness *= STIFFER
        return False

    def _promising(self, enough: float) -> tuple[Floats | None, float]:
        """Give prices for which the planes promise enough, and what; None where none is, however loose."""
        for _ in range(LOOSENED):
            point = self._proposal()
            promise = float((self._levels + self._gradients @ point).min()) - self.lower
            if promise >= enough:
                return point, promise
            self._stiffness *= MUCH_LOOSER
        return None, 0.0

    def _proposal(self) -> Floats:
        """Give prices that promise most, less the penalty.

        For weights w of the planes they are best + w·gradients / stiffness, cut to the box. Weight moves to
        the lowest plane there from the highest one that has some, as long as the two differ.
        """
        gradients, weights = self._gradients, self._weights
        point = self._point()
        close = SMALLEST * max(1.0, abs(self.lower))
        for _ in range(EXCHANGES):
            heights = self._levels + gradients @ point
            low = int(heights.argmin())
            high = int(np.where(weights > 1e-12, heights, -np.inf).argmax())
            difference = float(heights[high] - heights[low])
            if difference < close:
                break
            direction = gradients[low] - gradients[high]
            inner = ((point > 0) | (direction > 0)) & ((point < self._ceiling) | (direction < 0))
            curvature = float(direction[inner] @ direction[inner]) / self._stiffness
            moved = min(float(weights[high]), difference / max(curvature, 1e-12))
            weights[low] += moved
            weights[high] -= moved
            point = self._point()
        return point

    def _point(self) -> Floats:
        return np.clip(self.prices + self._weights @ self._gradients / self._stiffness, 0.0, self._ceiling)

    def _keep(self, gradient: Floats, level: float) -> None:
        """Add a plane; where there are too many, two that weigh little become the plane between them."""
        self._gradients = np.vstack([self._gradients, gradient])
        self._levels = np.append(self._levels, level)
        self._weights = np.append(self._weights, 0.0)
        if self._levels.size <= PLANES:
            return
        first, second = np.argsort(self._weights[:-1])[:2].tolist()
        one, two = self._weights[[first, second]] + 1e-12
        share = two / (one + two)
        self._gradients[first] += share * (self._gradients[second] - self._gradients[first])
        self._levels[first] += share * (self._levels[second] - self._levels[first])
        self._weights[first] += self._weights[second]
        self._gradients = np.delete(self._gradients, second, axis=0)
        self._levels = np.delete(self._levels, second)
        self._weights = np.delete(self._weights, second)
