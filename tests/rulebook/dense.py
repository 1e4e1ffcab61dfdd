"""What conditions mean by their definition, sampled densely: slow, plain, and nothing of the engine's."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from fuzzytime.rulebook.logic.formula import And, Direction, Formula, Happened, Is, Not, Operator, Or, Window
from fuzzytime.satisfaction import Floats

Corners = tuple[float, float, float, float]


@dataclass(frozen=True)
class Dense:
    """Signals that hold after their last reading, and terms over their values; one variable a signal.

    ``readings`` are (time, value) by signal, ``terms`` corners by name, ``powers`` those of hedges. Times run
    from ``-reach`` to ``reach`` in steps of ``step``.
    """

    readings: Mapping[str, Sequence[tuple[float, float]]]
    terms: Mapping[str, Corners]
    powers: Mapping[str, float]
    step: float
    reach: float
    max_gap: float = math.inf

    @property
    def times(self) -> Floats:
        number = round(self.reach / self.step)
        return np.arange(-number, number + 1, dtype=float) * self.step

    def now(self, formula: Formula) -> tuple[float, float]:
        """Both bounds of a formula's truth at time 0."""
        low, high = self.bounds(formula)
        return float(low[low.size // 2]), float(high[high.size // 2])

    def bounds(self, formula: Formula) -> tuple[Floats, Floats]:
        """Both bounds at all times."""
        match formula:
            case Is():
                return self._atom(formula)
            case Happened():
                raise ValueError("events have moments and no values: only signals are sampled here")
            case Not(part):
                low, high = self.bounds(part)
                return 1 - high, 1 - low
            case And(parts):
                lows, highs = zip(*map(self.bounds, parts), strict=True)
                return np.min(lows, axis=0), np.min(highs, axis=0)
            case Or(parts):
                lows, highs = zip(*map(self.bounds, parts), strict=True)
                return np.max(lows, axis=0), np.max(highs, axis=0)
            case Window():
                low, high = self.bounds(formula.part)
                return self._through(formula, low, 0.0), self._through(formula, high, 1.0)

    def _atom(self, atom: Is) -> tuple[Floats, Floats]:
        values = self._values(atom.variable)
        rise, full, end, fall = self.terms[atom.term]
        degree = np.ones(values.size)
        if math.isfinite(full):
            degree = np.minimum(degree, np.clip((values - rise) / (full - rise), 0, 1))
        if math.isfinite(end):
            degree = np.minimum(degree, np.clip((fall - values) / (fall - end), 0, 1))
        for hedge in atom.hedges:
            degree = degree ** self.powers[hedge]
        unknown = np.isnan(values)
        return np.where(unknown, 0.0, degree), np.where(unknown, 1.0, degree)

    def _values(self, signal: str) -> Floats:
        at, values = self.times, np.full(self.times.size, np.nan)
        read = sorted(self.readings[signal])
        for (time, value), (following, next_value) in pairwise(read):
            inside = (at >= time) & (at <= following)
            if following - time > self.max_gap:
                inside = np.isclose(at, time) | np.isclose(at, following)
            values[inside] = value + (next_value - value) * (at[inside] - time) / (following - time)
        if read:
            values[at >= read[-1][0]] = read[-1][1]
        return values

    def _through(self, window: Window, degree: Floats, unknown: float) -> Floats:
        if window.direction is Direction.NEXT:
            degree = degree[::-1]
        ages = np.arange(math.ceil(window.reach / self.step - 1e-9) + 1) * self.step
        fade = window.reach - window.length
        weight = np.where(ages <= window.length + 1e-9, 1.0, (window.reach - ages) / (fade or 1.0))
        weight = np.maximum(weight, 0.0)
        seen = np.concatenate([np.full(ages.size - 1, unknown), degree])
        looked_at = np.lib.stride_tricks.sliding_window_view(seen, ages.size)[:, ::-1]
        if window.operator is Operator.SOMETIME:
            found = np.minimum(looked_at, weight).max(axis=1)
        elif window.operator is Operator.THROUGHOUT:
            found = np.maximum(looked_at, 1 - weight).min(axis=1)
        else:
            inner = weight.copy()
            inner[[0, -1]] /= 2
            found = np.clip((looked_at @ inner / inner.sum() - 0.5) / 0.3, 0, 1)
        return np.asarray(found[::-1] if window.direction is Direction.NEXT else found)
