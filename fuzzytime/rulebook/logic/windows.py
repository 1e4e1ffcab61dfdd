"""Operators over windows of time, on traces that run linearly between points.

A window looks back over ages a ≥ 0 with weight w(a) = 1 up to its length d, falling linearly to 0 at
d·(1 + σ). What an operator gives has shape (curves, k): one value at each whole step of the traces' points.
Windows that look ahead are these on the reversed trace.
"""

import math
from dataclasses import dataclass

import numpy as np

from fuzzytime.rulebook.logic.traces import Integrals, Past, Points
from fuzzytime.satisfaction import Floats

_ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class Extent:
    """A window in steps: its full length, and where its weight has fallen to 0."""

    full: float
    whole: float

    @classmethod
    def of(cls, length: float, reach: float, step: float) -> "Extent":
        """Measure a window; lengths that are whole numbers of steps are recognised as such."""
        full, whole = _snapped(length / step), _snapped(reach / step)
        return cls(full, whole if whole - full > _ROUNDING * full else full)

    @property
    def padding(self) -> int:
        """How many steps before a time the window can touch."""
        return math.ceil(self.whole) + 1

    def weight(self, age: float) -> float:
        """Give w at an age in steps."""
        if age <= self.full:
            return 1.0
        return (self.whole - age) / (self.whole - self.full) if age < self.whole else 0.0


def _snapped(steps: float) -> float:
    return float(round(steps)) if abs(steps - round(steps)) < _ROUNDING * max(steps, 1.0) else steps


def sometime(past: Past, extent: Extent) -> Floats:
    """Give sup_a min(w(a), φ(t − a)).

    Of the step in which the full part ends, and of those of the fading part, what lies inside counts by its
    weight in the middle of the step.
    """
    whole_steps = math.floor(extent.full)
    found = past.largest(whole_steps)
    if extent.full > whole_steps:
        np.maximum(found, past.earlier(extent.full), out=found)
    for age in range(whole_steps + 1, math.ceil(extent.whole) + 1):
        _include(found, past.trace, age, extent.weight(age), past.unknown)
        if past.between is not None:
            _include(found, past.between, age - 1, extent.weight(age - 0.5))
    return found


def _include(
    found: Floats, trace: Floats, age: int, weight: float, unknown: float | Floats | None = None
) -> None:
    """Let what a trace was so many steps earlier count by its weight, and what was not known before it."""
    if weight <= 0:
        return
    known, before = found[..., age:], found[..., :age]
    np.maximum(known, np.minimum(trace[..., : known.shape[-1]], weight), out=known)
    if unknown is not None:
        np.maximum(before, np.minimum(unknown, weight), out=before)


def throughout(past: Past, extent: Extent) -> Floats:
    """Give inf_a max(1 − w(a), φ(t − a)): there is no time in the window when φ fails."""
    return np.asarray(1.0 - sometime(past.negated, extent))


def mean(past: Past, extent: Extent) -> Floats:
    """Give ∫ w·φ / ∫ w over the window."""
    size = past.trace.shape[-1]
    integrals = Integrals.of(past, extent.padding)
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


def slope(traces: Floats, extent: Extent, points: Points | None = None) -> Floats:
    """Give the slope, per step, of the least-squares line over the window; NaN where any of it is unknown.

    (12 / d³) ∫ (u − m) x(u) du, with m the window's middle, by parts from the running integrals.
    """
    unknown = np.isnan(traces)
    centre = np.nanmean(traces) if not unknown.all() else 0.0
    past = Past(np.where(unknown, 0.0, traces - centre), 0.0, points)
    size, length = past.trace.shape[-1], extent.full
    integrals = Integrals.of(past, extent.padding)
    now, now_second = integrals.back(0.0, size)
    then, then_second = integrals.back(length, size)
    moment = length / 2 * (now + then) - (now_second - then_second)
    gaps, whole = np.cumsum(unknown, axis=-1), past.points.whole
    before = np.arange(size) - math.ceil(length)
    start = whole[np.maximum(before, 0)]
    missing = (before < 0) | (gaps[..., whole] > gaps[..., start] - unknown[..., start])
    return np.where(missing, np.nan, 12 / length**3 * moment)
