"""Operators over windows of time, on traces that run linearly between the points of a regular grid.

A window looks back over ages a ≥ 0 with weight w(a) = 1 up to its length d, falling linearly to 0 at
d·(1 + σ). Traces have shape (curves, k); before their first point stands what is not known: one constant, or
one for each curve, of shape (curves, 1).
Windows that look ahead are these on the reversed trace.
"""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from fuzzytime.satisfaction import Floats

_ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class Extent:
    """A window in steps of the grid: its full length, and where its weight has fallen to 0."""

    full: float
    whole: float

    @classmethod
    def of(cls, length: float, reach: float, step: float) -> "Extent":
        """Measure a window; lengths that are whole numbers of steps are recognised as such."""
        full, whole = _snapped(length / step), _snapped(reach / step)
        return cls(full, whole if whole - full > _ROUNDING * full else full)

    @property
    def padding(self) -> int:
        """How many points before a time the window can touch."""
        return math.ceil(self.whole) + 1


def _snapped(steps: float) -> float:
    return float(round(steps)) if abs(steps - round(steps)) < _ROUNDING * max(steps, 1.0) else steps


class Past:
    """Traces, and what stands before their first points, as windows look back over them.

    The largest values over 1, 2, 4 … points are worked out once for all windows over the same traces (the
    sparse table of Bender and Farach-Colton, LATIN 2000: two of its rows cover any width).

    Parameters
    ----------
    trace : array of shape (curves, k)
    unknown : number, or array of shape (curves, 1)
        What stands before the first point.
    """

    def __init__(self, trace: Floats, unknown: float | Floats) -> None:
        self.trace = trace
        self.unknown = unknown
        self._doubled = [trace]

    @cached_property
    def negated(self) -> "Past":
        """1 − φ."""
        return Past(1.0 - self.trace, 1.0 - self.unknown)

    def largest(self, points: int) -> Floats:
        """Give the largest value of the last so many points, with what stands before the first."""
        points = min(points, self.trace.shape[-1] + 1)
        level = points.bit_length() - 1
        while len(self._doubled) <= level:
            self._doubled.append(_larger(self._doubled[-1], 1 << len(self._doubled) - 1))
        found = _larger(self._doubled[level], points - (1 << level))
        before = found[..., : points - 1]
        np.maximum(before, self.unknown, out=before)
        return found

    def earlier(self, steps: float) -> Floats:
        """Give the traces so many steps earlier, linear between points."""
        padded = _padded(self.trace, math.ceil(steps), self.unknown)
        return _shifted(padded, steps, math.ceil(steps), self.trace.shape[-1])


def _larger(trace: Floats, points: int) -> Floats:
    """Give the larger of each point and the one so many points earlier, where there is one."""
    found = trace.copy()
    if 0 < points < trace.shape[-1]:
        np.maximum(trace[..., points:], trace[..., :-points], out=found[..., points:])
    return found


def sometime(past: Past, extent: Extent) -> Floats:
    """Give sup_a min(w(a), φ(t − a))."""
    whole_steps = math.floor(extent.full)
    found = past.largest(whole_steps + 1)
    if extent.full > whole_steps:
        np.maximum(found, past.earlier(extent.full), out=found)
    fade = extent.whole - extent.full
    for age in range(whole_steps + 1, math.ceil(extent.whole)):
        weight = (extent.whole - age) / fade
        known, before = found[..., age:], found[..., :age]
        np.maximum(known, np.minimum(past.trace[..., : known.shape[-1]], weight), out=known)
        np.maximum(before, np.minimum(past.unknown, weight), out=before)
    return found


def throughout(past: Past, extent: Extent) -> Floats:
    """Give inf_a max(1 − w(a), φ(t − a)): there is no time in the window when φ fails."""
    return np.asarray(1.0 - sometime(past.negated, extent))


def _padded(trace: Floats, number: int, unknown: float | Floats) -> Floats:
    padded = np.empty((*trace.shape[:-1], number + trace.shape[-1]))
    padded[..., :number] = unknown
    padded[..., number:] = trace
    return padded


def _shifted(padded: Floats, steps: float, padding: int, size: int) -> Floats:
    """Give the trace ``steps`` steps earlier, linear between points."""
    start = padding - math.ceil(steps)
    share = math.ceil(steps) - steps
    earlier = padded[..., start : start + size]
    return np.asarray(
        earlier if share == 0 else earlier + share * (padded[..., start + 1 :][..., :size] - earlier)
    )


@dataclass(frozen=True, slots=True)
class Integrals:
    """A trace's first and second running integrals, in steps; exact where it is linear between points."""

    padded: Floats
    first: Floats
    second: Floats
    padding: int

    @classmethod
    def of(cls, trace: Floats, padding: int, unknown: float | Floats) -> "Integrals":
        """Integrate a trace from ``padding`` points before its start."""
        padded = _padded(trace, padding, unknown)
        zero = np.zeros((*trace.shape[:-1], 1))
        first = np.concatenate([zero, np.cumsum((padded[..., 1:] + padded[..., :-1]) / 2, axis=-1)], axis=-1)
        cells = first[..., :-1] + padded[..., :-1] / 3 + padded[..., 1:] / 6
        return cls(padded, first, np.concatenate([zero, np.cumsum(cells, axis=-1)], axis=-1), padding)

    def back(self, steps: float, size: int) -> tuple[Floats, Floats]:
        """Give both integrals ``steps`` steps before each point of the trace."""
        start = self.padding - math.ceil(steps)
        share = math.ceil(steps) - steps
        value, first, second = (
            part[..., start:][..., :size] for part in (self.padded, self.first, self.second)
        )
        if share == 0:
            return first, second
        slope = self.padded[..., start + 1 :][..., :size] - value
        return (
            first + share * value + share**2 / 2 * slope,
            second + share * first + share**2 / 2 * value + share**3 / 6 * slope,
        )


def mean(past: Past, extent: Extent) -> Floats:
    """Give ∫ w·φ / ∫ w over the window."""
    size = past.trace.shape[-1]
    integrals = Integrals.of(past.trace, extent.padding, past.unknown)
    now, _ = integrals.back(0.0, size)
    full, full_second = integrals.back(extent.full, size)
    area = now - full
    fade = extent.whole - extent.full
    if fade > 0:
        # ∫ (u − (t − D)) φ(u) du over the fading part, by parts, in units of its length.
        _, whole_second = integrals.back(extent.whole, size)
        area = area + full - (full_second - whole_second) / fade
    return np.asarray(area / (extent.full + fade / 2))


def mostly(past: Past, extent: Extent) -> Floats:
    """Give Q(∫ w·φ / ∫ w) with Q(p) = (p − 0.5) / 0.3, cut to [0, 1]."""
    # Running integrals leave 1 − 1e-15 where all of the window holds: rounding keeps it all.
    share = np.round(mean(past, extent), 12)
    return np.asarray(np.clip((share - 0.5) / 0.3, 0.0, 1.0))


def slope(trace: Floats, extent: Extent) -> Floats:
    """Give the slope, per step, of the least-squares line over the window; NaN where any of it is unknown.

    (12 / d³) ∫ (u − m) x(u) du, with m the window's middle, by parts from the running integrals.
    """
    size, length = trace.shape[-1], extent.full
    unknown = np.isnan(trace)
    centre = np.nanmean(trace) if not unknown.all() else 0.0
    integrals = Integrals.of(np.where(unknown, 0.0, trace - centre), extent.padding, 0.0)
    now, now_second = integrals.back(0.0, size)
    then, then_second = integrals.back(length, size)
    moment = length / 2 * (now + then) - (now_second - then_second)
    gaps = np.cumsum(_padded(unknown.astype(float), extent.padding, 1.0), axis=-1)
    first = extent.padding - math.ceil(length) - 1
    missing = gaps[..., extent.padding :] - gaps[..., first:][..., :size] > 0.5
    return np.where(missing, np.nan, 12 / length**3 * moment)
