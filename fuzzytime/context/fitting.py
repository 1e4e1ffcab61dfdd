"""Fitting the course of a signal to its readings, with what remains uncertain.

x(t) = S + b·exp(−(t − t₁) / τ): given τ this is linear in b and S, so the fit is a search along log τ alone
(variable projection; Golub & Pereyra 1973). What the readings leave open is kept: the posterior of log τ is
tabulated, and given τ that of b and S is normal. The signal's set point S is known beforehand or free.
"""

import math
from dataclasses import dataclass
from typing import TypeVar

import numpy as np

from fuzzytime.context.sampling import normal_points, unit_points
from fuzzytime.satisfaction import Floats

_V = TypeVar("_V", float, Floats)

BINS = 24
"""Readings are averaged into so many bins: a lack of fit shows as well, and cost stays bounded."""

_LONGEST = 48 * 3600.0
_SHORTEST = 2.0
_TABLE = 41
_DEPTH = 12.0
"""How far below its peak, in log probability, the posterior of log τ is still tabulated."""

_NOISE_WEIGHT = 3.0
"""How many readings the expected noise counts for, beside what the readings show of it."""


@dataclass(frozen=True, slots=True)
class Readings:
    """Readings by time, averaged into bins: times, values, numbers of readings.

    ``noise`` is the standard deviation of a single one, known as well as ``freedom`` readings tell it.
    """

    times: Floats
    values: Floats
    counts: Floats
    noise: float
    freedom: float

    @classmethod
    def of(cls, times: Floats, values: Floats, noise: float, freedom: float) -> "Readings":
        """Average readings into at most `BINS` bins of equal numbers."""
        if times.size <= BINS:
            return cls(times, values, np.ones(times.size), noise, freedom)
        edges = np.linspace(0, times.size, BINS + 1).astype(int)
        counts = np.diff(edges).astype(float)
        return cls(
            np.add.reduceat(times, edges[:-1]) / counts,
            np.add.reduceat(values, edges[:-1]) / counts,
            counts,
            noise,
            freedom,
        )

    def inflation(self, misfit: float) -> float:
        """Give the variance that a fit shows, in units of the noise's: where it misses, less is known."""
        return (self.times.size * misfit + self.freedom) / (self.times.size + self.freedom)


def noise_of(times: Floats, values: Floats, expected: float) -> float:
    """Estimate the standard deviation of single readings from how each misses the line of its neighbours.

    A course that bends misses it as well, by much where readings lie far apart: as two neighbours bend alike,
    four readings tell the one from the other.
    """
    if times.size < 3:
        return expected
    before, after = times[1:-1] - times[:-2], times[2:] - times[1:-1]
    share = before / (before + after)
    # Of each reading and its two neighbours, by how much every one of the three counts.
    parts = np.stack([share - 1, np.ones_like(share), -share])
    missed = (parts * np.stack([values[:-2], values[1:-1], values[2:]])).sum(axis=0)
    if missed.size > 1:
        bend = before * after
        ratio = bend[1:] / bend[:-1]
        missed = missed[1:] - ratio * missed[:-1]
        none = np.zeros_like(ratio)
        first = np.stack([*(ratio * parts[:, :-1]), none])
        parts = np.stack([none, *parts[:, 1:]]) - first
    squares = missed**2 / (parts**2).sum(axis=0)
    total = float(squares.sum()) + _NOISE_WEIGHT * expected**2
    return math.sqrt(total / (squares.size + _NOISE_WEIGHT))


def freedom_of(number: int) -> float:
    """Give how many independent readings stand behind `noise_of`; neighbouring misses share readings."""
    return _NOISE_WEIGHT + max(number - 3, 0) / 2


@dataclass(frozen=True, slots=True)
class Normal:
    """A prior belief: mean and standard deviation."""

    mean: float
    deviation: float

    def log_density(self, value: _V) -> _V:
        """Give the log density, up to a constant, that is 0 at the mean."""
        return -0.5 * ((value - self.mean) / self.deviation) ** 2


@dataclass(frozen=True, slots=True, eq=False)
class Curves:
    """x(t) = level + slope·(t − t₀) + amplitude·exp(−(t − t₀) / τ), from the last reading t₀ on.

    All arrays have shape (curves,); together they stand for what the readings allow.
    """

    level: Floats
    slope: Floats
    amplitude: Floats
    time_constant: Floats

    def __call__(self, since: Floats) -> Floats:
        """Give values of shape (curves, k) at times of shape (k,), in seconds since t₀."""
        decay = np.exp(-since / self.time_constant[:, None])
        return self.level[:, None] + self.slope[:, None] * since + self.amplitude[:, None] * decay


@dataclass(frozen=True, slots=True)
class Fitted:
    """Curves that the readings allow, and what speaks for them.

    ``misfit`` is the mean square of the best one's residuals in units of the noise, about 1 for a true model,
    over ``number`` (averaged) readings; ``belief`` is how far, in log probability, it departs from what was
    believed of τ beforehand.
    """

    curves: Curves
    misfit: float
    number: int
    belief: float = 0.0


def fit_approach(readings: Readings, last: float, level: float | Normal, log_tau: Normal) -> Fitted:
    """Fit an approach to a known level, or to one about which only a belief is held.

    ``last`` is the time t₀ from which the curves count.
    """
    widest = np.linspace(math.log(_SHORTEST), math.log(_LONGEST), 3 * _TABLE)
    misfit = _least_squares(_Projection(readings, level, 1.0), widest) / readings.times.size
    model = _Projection(readings, level, readings.inflation(misfit))
    table, logs = widest, model.log_posterior(widest, log_tau)
    for _ in range(2):
        inside = np.flatnonzero(logs > logs.max() - _DEPTH)
        low, high = table[max(inside[0] - 1, 0)], table[min(inside[-1] + 1, table.size - 1)]
        table = np.linspace(low, high, _TABLE)
        logs = model.log_posterior(table, log_tau)
    density = np.exp(logs - logs.max())
    running = np.concatenate([[0.0], np.cumsum((density[1:] + density[:-1]) / 2)])
    taus = np.exp(np.interp(unit_points(3)[:, 0], running / running[-1], table))
    levels, amplitudes = model.sampled(taus, normal_points(3)[:, 1:])
    at_last = amplitudes * np.exp(-(last - readings.times[0]) / taus)
    belief = log_tau.log_density(float(table[np.argmax(logs)]))
    return Fitted(Curves(levels, np.zeros_like(taus), at_last, taus), misfit, readings.times.size, belief)


def _least_squares(model: "_Projection", log_taus: Floats) -> float:
    """Give the least sum of squares over log τ, by tables around the least of the table before."""
    table = log_taus
    for _ in range(2):
        least = int(np.argmin(model.projected(np.exp(table)).squares))
        around = table[max(least - 1, 0)], table[min(least + 1, table.size - 1)]
        table = np.linspace(*around, _TABLE)
    return float(model.projected(np.exp(table)).squares.min())


def fit_line(readings: Readings, last: float, rate: float | None, steepest: Normal) -> Fitted:
    """Fit a straight course of a known rate, or of one about which only a belief is held."""
    since = readings.times - last
    weights = readings.counts / readings.noise**2
    mean_rate = steepest.mean if rate is None else rate
    values = readings.values - mean_rate * since
    ll, ly = float(weights.sum()), float(weights @ values)
    if rate is None:
        ls, ss = float(weights @ since), float(weights @ since**2) + 1 / steepest.deviation**2
        sy = float(weights @ (since * values))
        determinant = ll * ss - ls**2
        level, slope = (ss * ly - ls * sy) / determinant, (ll * sy - ls * ly) / determinant
        slope_deviation = math.sqrt(ll / determinant)
    else:
        level, slope, slope_deviation, ls = ly / ll, 0.0, 0.0, 0.0
    residuals = values - level - slope * since
    misfit = float(weights @ residuals**2) / readings.times.size
    normals = normal_points(2) * math.sqrt(readings.inflation(misfit))
    slopes = slope_deviation * normals[:, 0]
    levels = level - ls / ll * slopes + normals[:, 1] / math.sqrt(ll)
    zero = np.zeros_like(levels)
    return Fitted(Curves(levels, mean_rate + slope + slopes, zero, zero + 1.0), misfit, readings.times.size)


@dataclass(frozen=True, slots=True)
class _Projected:
    """For each τ the best linear parameters, their precision, and what is left, all of shape (taus,)."""

    amplitude: Floats
    level: Floats
    precision: tuple[Floats, Floats, Floats]
    squares: Floats
    half_log_determinant: Floats


class _Projection:
    """The linear part of the fit, for many τ at once; variances are ``inflation`` times the noise's."""

    def __init__(self, readings: Readings, level: float | Normal, inflation: float) -> None:
        self._since = readings.times - readings.times[0]
        self._level = level
        self._weights = readings.counts / (readings.noise**2 * inflation)
        self._centre = level.mean if isinstance(level, Normal) else level
        self._values = readings.values - self._centre

    def projected(self, taus: Floats) -> _Projected:
        """Solve for amplitude and level, given each τ."""
        shape = np.exp(-self._since / taus[:, None])
        weighted = self._weights * self._values
        bb, by, yy = shape**2 @ self._weights, shape @ weighted, float(weighted @ self._values)
        if not isinstance(self._level, Normal):
            zero = np.zeros_like(bb)
            return _Projected(by / bb, zero + self._centre, (bb, zero, zero), yy - by**2 / bb, np.log(bb) / 2)
        bs, sy = shape @ self._weights, float(weighted.sum())
        ss = float(self._weights.sum()) + 1 / self._level.deviation**2
        determinant = bb * ss - bs**2
        amplitude, offset = (ss * by - bs * sy) / determinant, (bb * sy - bs * by) / determinant
        return _Projected(
            amplitude,
            self._centre + offset,
            (bb, bs, np.full_like(bb, ss)),
            yy - amplitude * by - offset * sy,
            np.log(determinant) / 2,
        )

    def log_posterior(self, log_taus: Floats, prior: Normal) -> Floats:
        """Give log p(log τ | readings) up to a constant, with amplitude and level integrated out."""
        best = self.projected(np.exp(log_taus))
        return np.asarray(prior.log_density(log_taus) - best.squares / 2 - best.half_log_determinant)

    def sampled(self, taus: Floats, normals: Floats) -> tuple[Floats, Floats]:
        """Draw levels and amplitudes given τ, by standard normal points of shape (samples, 2)."""
        best = self.projected(taus)
        bb, bs, _ = best.precision
        spread = normals[:, 0] / np.sqrt(bb)
        if not isinstance(self._level, Normal):
            return best.level, best.amplitude + spread
        offset = normals[:, 1] * np.sqrt(bb / np.exp(2 * best.half_log_determinant))
        return best.level + offset, best.amplitude - bs / bb * offset + spread
