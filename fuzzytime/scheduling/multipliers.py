"""Prices that make a network's bound as high as they can: a proximal bundle method.

For prices λ ∈ [0, L]ⁿ every schedule costs at least

    D(λ) = Σ_i (L_i − λ_i) + the cheapest way through the network,

a concave function, and the way that is cheapest visits job i so often that D changes by visits_i − 1 with λ_i.
Each evaluation gives a plane above D. The next prices are the best by all planes so far, less a penalty for
going far from the best prices yet, which a small quadratic program over the planes' weights finds. Lemarechal,
Nemirovskii and Nesterov, New variants of bundle methods, Math. Programming 69 (1995) 111-147.
"""

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.network import Network

PLANES = 50
"""Planes that are kept."""

STEPS_OF_PROGRAM = 100
"""Exchanges of weight in one quadratic program, at most."""


class Multipliers:
    """The best prices found for a network, and the bound they prove.

    Parameters
    ----------
    network
        Whose ways are priced.
    rejections : array of shape (jobs,)
        L, the cost of rejecting each job.
    free : array of bool of shape (jobs,)
        Jobs that have a price; the others' stays 0.
    prices : array of shape (jobs,)
        Where to begin.
    """

    def __init__(self, network: Network, rejections: Floats, free: np.ndarray, prices: Floats) -> None:
        self.network = network
        self.ceiling = np.where(free, rejections, 0.0)
        self._total = float(rejections.sum())
        self.prices = np.clip(prices, 0.0, self.ceiling)
        self.bound, gradient = self._evaluate(self.prices)
        self._gradients = gradient[None, :]
        self._levels = np.array([self.bound - gradient @ self.prices])
        self._weights = np.ones(1)
        self._stiffness = 1.0

    def _evaluate(self, prices: Floats) -> tuple[float, Floats]:
        """Give D and its gradient."""
        value = self._total - prices.sum() + self.network.run_forward(prices)
        visits = np.bincount([step.job for step in self.network.cheapest_way()], minlength=prices.size)
        self.visits = visits
        return float(value), visits - 1.0

    def improve(self, steps: int, goal: float, precision: float, watch: Stopwatch) -> None:
        """Take steps until the planes promise less than a precision, or the bound reaches a goal."""
        failures = 0
        for _ in range(steps):
            point, model = self._proposal()
            promise = model - self.bound
            if promise < precision or self.bound >= goal or watch.is_over():
                return
            value, gradient = self._evaluate(point)
            rise = value - self.bound
            self._keep(gradient, value - gradient @ point)
            if rise > 0.1 * promise:
                if rise > 0.5 * promise:
                    self._stiffness = max(self._stiffness * max(2 * (1 - rise / promise), 0.1), 1e-8)
                self.prices, self.bound, failures = point, value, 0
            else:
                failures += 1
                if failures > 3:
                    self._stiffness *= 1.3

    def _proposal(self) -> tuple[Floats, float]:
        """Solve max over λ of (least plane at λ) − stiffness/2·|λ − best|², by its dual over weights of planes.

        The best λ for weights w is best + w·gradients / stiffness, cut to the box; weight moves from the
        highest plane at that λ that has some to the lowest, as long as the two differ.
        """
        gradients, levels, weights = self._gradients, self._levels, self._weights
        point = self._point(weights)
        for _ in range(STEPS_OF_PROGRAM):
            heights = levels + gradients @ point
            low = int(heights.argmin())
            high = int(np.where(weights > 1e-12, heights, -np.inf).argmax())
            if heights[high] - heights[low] < 1e-6:
                break
            direction = gradients[low] - gradients[high]
            inner = ((point > 0) | (direction > 0)) & ((point < self.ceiling) | (direction < 0))
            curvature = float(direction[inner] @ direction[inner]) / self._stiffness
            moved = min(float(weights[high]), float(heights[high] - heights[low]) / max(curvature, 1e-12))
            weights[low] += moved
            weights[high] -= moved
            point = self._point(weights)
        return point, float((levels + gradients @ point).min())

    def _point(self, weights: Floats) -> Floats:
        return np.clip(self.prices + weights @ self._gradients / self._stiffness, 0.0, self.ceiling)

    def _keep(self, gradient: Floats, level: float) -> None:
        """Add a plane; where there are too many, forget the one with the least weight."""
        self._gradients = np.vstack([self._gradients, gradient])
        self._levels = np.append(self._levels, level)
        self._weights = np.append(self._weights, 0.0)
        if self._levels.size > PLANES:
            # Two that weigh little become the plane between them, which is above D, too.
            first, second = np.argsort(self._weights[:-1])[:2]
            one, two = self._weights[[first, second]] + 1e-12
            share = two / (one + two)
            self._gradients[first] += share * (self._gradients[second] - self._gradients[first])
            self._levels[first] += share * (self._levels[second] - self._levels[first])
            self._weights[first] += self._weights[second]
            self._gradients = np.delete(self._gradients, second, axis=0)
            self._levels = np.delete(self._levels, second)
            self._weights = np.delete(self._weights, second)
