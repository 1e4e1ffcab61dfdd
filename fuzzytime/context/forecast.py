"""How a signal goes on: what its readings and its declared course say, and what they leave open.

A forecast is a mixture. Each component explains the readings of some stretch up to now, by the set point
that is known beforehand or by a free one; its weight falls with its misfit. So a pan that stalls below its
set point, or that was turned down a minute ago, is recognised, and no small change of a reading makes the
forecast jump.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from fuzzytime.context.fitting import (
    Curves,
    Fitted,
    Normal,
    Readings,
    fit_approach,
    fit_line,
    freedom_of,
    noise_of,
)
from fuzzytime.context.sampling import normal_points
from fuzzytime.context.signals import Approach, Linear, Signal
from fuzzytime.satisfaction import Floats

LEAST_WEIGHT = 1e-4
"""Components below this weight are left out."""

_STRETCHES = (1.0, 0.5, 0.25, 0.125)
_FEWEST = 4
_CHANGE = -12.0
"""Log prior odds of a change of course, as against none."""

_OTHER_LEVEL = math.log(0.003)
"""Log prior odds of another level than the set point: it must explain the readings clearly better."""

_TOLERATED = 1.6
"""A mean square misfit up to this is chance."""

_NOISE_SHARE = 0.005
"""The noise expected beforehand, as a share of a signal's range."""

_ANY_TAU = Normal(math.log(300.0), 1.5)


@dataclass(frozen=True, slots=True, eq=False)
class Component:
    """Curves and how much they count."""

    weight: float
    curves: Curves


@dataclass(frozen=True, slots=True, eq=False)
class Forecast:
    """A signal after its last reading.

    Parameters
    ----------
    start
        The time t₀ of the last reading, in seconds.
    until
        The time beyond which nothing is forecast.
    low, high
        The signal's range, in which every curve stays.
    components
        Their weights add to 1.
    """

    start: float
    until: float
    low: float
    high: float
    components: tuple[Component, ...]

    def values(self, component: int, times: Floats) -> Floats:
        """Give a component's curves, of shape (curves, k), at times after the last reading."""
        curves = self.components[component].curves(times - self.start)
        return np.clip(curves, self.low, self.high)

    @property
    def _weights(self) -> Floats:
        """The weight of every single curve; together 1."""
        sizes = [part.curves.level.size for part in self.components]
        weights = np.repeat([part.weight for part in self.components] / np.array(sizes, float), sizes)
        return np.asarray(weights / weights.sum())

    @property
    def level(self) -> float:
        """The value that the curves approach: the median over them by their weights."""
        levels = np.concatenate([part.curves.level for part in self.components])
        order = np.argsort(levels)
        middle = int(np.argmax(np.cumsum(self._weights[order]) >= 0.5 - 1e-12))
        return float(np.clip(levels[order][middle], self.low, self.high))

    def settled(self, breakpoints: Sequence[float] = ()) -> float:
        """Give the time from which no curve changes any more, or crosses any of these values.

        Infinite for a line that goes on for ever.
        """
        latest = self.start
        low, high = (min(breakpoints), max(breakpoints)) if breakpoints else (self.low, self.high)
        for component in self.components:
            curves = component.curves
            if np.any(curves.amplitude != 0):
                latest = max(latest, self.start + 7 * float(np.quantile(curves.time_constant, 0.9)))
            for level, slope in zip(curves.level.tolist(), curves.slope.tolist(), strict=True):
                limit = min(high, self.high) if slope > 0 else max(low, self.low)
                if slope != 0:
                    latest = max(latest, self.start + (limit - level) / slope)
        return min(latest, self.until)

    def quantiles(self, times: Floats, shares: Sequence[float]) -> Floats:
        """Give quantiles of shape (shares, k) over all curves by their weights."""
        values = np.concatenate([self.values(i, times) for i in range(len(self.components))])
        order = np.argsort(values, axis=0)
        running = np.cumsum(self._weights[order], axis=0)
        chosen = [np.argmax(running >= share - 1e-12, axis=0) for share in shares]
        ranked = np.take_along_axis(values, order, axis=0)
        return np.stack([np.take_along_axis(ranked, rows[None], axis=0)[0] for rows in chosen])


def forecast(signal: Signal, times: Floats, values: Floats) -> Forecast:
    """Give how a signal goes on after readings at ascending times, at least one.

    Parameters
    ----------
    signal
        The declared course, range and horizon.
    times, values : array of shape (n,), n ≥ 1
        In seconds and in the signal's unit.
    """
    course, last = signal.course, float(times[-1])
    fits: list[tuple[float, Fitted]] = []
    if isinstance(course, Approach):
        fits = _approaches(course, signal, times, values)
    elif isinstance(course, Linear):
        fits = _lines(course, signal, times, values)
    components = (
        _weighed(fits, freedom_of(times.size)) if fits else (Component(1.0, _held(float(values[-1]))),)
    )
    return Forecast(last, last + course.horizon, signal.low, signal.high, components)


def _held(value: float) -> Curves:
    zero = np.zeros(1)
    return Curves(np.array([value]), zero, zero, zero + 1.0)


def _weighed(fits: Sequence[tuple[float, Fitted]], freedom: float) -> tuple[Component, ...]:
    scores = np.array([odds + _score(fit, freedom) for odds, fit in fits])
    weights = np.exp(scores - scores.max())
    weights /= weights.sum()
    return tuple(
        Component(float(weight), fit.curves)
        for weight, (_, fit) in zip(weights, fits, strict=True)
        if weight >= LEAST_WEIGHT
    )


def _score(fit: Fitted, freedom: float) -> float:
    """Give the log likelihood of a component, up to what chance explains.

    ``freedom`` readings tell the noise. Tails are those of Student's t, so that one odd reading does not
    decide alone.
    """
    excess = max(fit.misfit / _TOLERATED, 1.0) - 1.0
    total = fit.number + freedom
    return fit.belief - 0.5 * total * math.log1p(excess * fit.number / total)


def _stretches(signal: Signal, times: Floats, values: Floats) -> list[tuple[float, Readings]]:
    """Give the readings of shorter and shorter stretches up to now, each with its log prior odds."""
    noise = noise_of(times, values, _expected_noise(signal, values))
    freedom = freedom_of(times.size)
    found: dict[int, tuple[float, Readings]] = {}
    since_gap = _since_gap(signal, times)
    if since_gap > 1:
        # Nobody knows what happened in a gap: a change of course within it needs no reason.
        recent = Readings.of(times[-since_gap:], values[-since_gap:], noise, freedom)
        found[since_gap] = (0.0, recent)
    for share in _STRETCHES:
        number = min(times.size, max(math.ceil(times.size * share), _FEWEST))
        odds = 0.0 if number == times.size else _CHANGE
        found.setdefault(number, (odds, Readings.of(times[-number:], values[-number:], noise, freedom)))
    return list(found.values())


def _since_gap(signal: Signal, times: Floats) -> int:
    """Count the readings since the last gap in which anything may have happened; 0 where there is none."""
    gaps = np.flatnonzero(np.diff(times) > signal.max_gap)
    return times.size - 1 - int(gaps[-1]) if gaps.size else 0


def _alone(signal: Signal, times: Floats) -> float | None:
    """Give the log prior odds that only the last reading counts: it stands behind a gap, or is the only one.

    None where it does not. A few readings before the gap tell no course that it could go on with.
    """
    if times.size == 1:
        return 0.0
    if _since_gap(signal, times) != 1:
        return None
    return 0.0 if times.size <= _FEWEST else _CHANGE + _OTHER_LEVEL


def _width(signal: Signal, values: Floats) -> float:
    """Give the range of a signal, or where it is open ten times what its readings span."""
    declared = signal.high - signal.low
    return declared if math.isfinite(declared) else max(10 * float(np.ptp(values)), 1.0)


def _expected_noise(signal: Signal, values: Floats) -> float:
    if signal.noise is not None:
        return signal.noise
    return max(_NOISE_SHARE * _width(signal, values), 1e-9)


def _approaches(
    course: Approach, signal: Signal, times: Floats, values: Floats
) -> list[tuple[float, Fitted]]:
    log_tau = _ANY_TAU
    if course.time_constant is not None:
        log_tau = Normal(math.log(course.time_constant), math.log(course.spread))
    fits: list[tuple[float, Fitted]] = []
    alone = _alone(signal, times)
    if alone is not None and course.set_point is not None and course.time_constant is not None:
        fits.append((alone, _from_one(float(values[-1]), course.set_point, log_tau)))
    if times.size == 1:
        return fits
    last = float(times[-1])
    for odds, readings in _stretches(signal, times, values):
        if course.set_point is not None:
            fits.append((odds, fit_approach(readings, last, course.set_point, log_tau)))
        belief = Normal(
            float(values[-1]) if course.set_point is None else course.set_point, _width(signal, values) / 2
        )
        other = 0.0 if course.set_point is None else _OTHER_LEVEL
        fits.append((odds + other, fit_approach(readings, last, belief, log_tau)))
    return fits


def _from_one(value: float, set_point: float, log_tau: Normal) -> Fitted:
    """Approach the set point from one reading, which leaves τ to the belief about it."""
    taus = np.exp(log_tau.mean + log_tau.deviation * normal_points(1)[:, 0])
    level = np.full_like(taus, set_point)
    return Fitted(Curves(level, np.zeros_like(taus), value - level, taus), 1.0, 1)


def _lines(course: Linear, signal: Signal, times: Floats, values: Floats) -> list[tuple[float, Fitted]]:
    last = float(times[-1])
    fits: list[tuple[float, Fitted]] = []
    alone = _alone(signal, times)
    if alone is not None and course.rate is not None:
        zero = np.zeros(1)
        fits.append((alone, Fitted(Curves(values[-1:], zero + course.rate, zero, zero + 1.0), 1.0, 1)))
    if times.size == 1:
        return fits
    span = max(float(np.ptp(times)), 1e-3)
    steepest = Normal(0.0, 10 * _width(signal, values) / span)
    fits += [
        (odds, fit_line(readings, last, course.rate, steepest))
        for odds, readings in _stretches(signal, times, values)
    ]
    return fits
