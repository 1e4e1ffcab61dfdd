"""Traces of degrees and of values, as windows of time look back over them.

A trace runs linearly between its points: one at each step of time, and more between where something changes
within a step. Traces have shape (curves, m); before their first point stands what is not known: one constant,
or one for each curve, of shape (curves, 1).
"""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from fuzzytime.satisfaction import Floats

Positions = np.ndarray[tuple[int], np.dtype[np.intp]]


@dataclass(frozen=True, slots=True, eq=False)
class Points:
    """Where traces are known.

    ``at`` has shape (m,), ascending, in steps; ``whole``, of shape (k,), are the positions of the whole steps
    in it, the first and the last point among them.
    """

    at: Floats
    whole: Positions

    @classmethod
    def even(cls, number: int) -> "Points":
        """Give one point a step."""
        whole = np.arange(number)
        return cls(whole.astype(float), whole)

    @property
    def some_between(self) -> bool:
        """Whether there are points between the steps."""
        return self.at.size > self.whole.size

    @property
    def reversed(self) -> "Points":
        """The same points for reversed traces."""
        return Points(self.at[-1] - self.at[::-1], self.at.size - 1 - self.whole[::-1])


class Past:
    """Traces, and what stands before their first points, as windows look back over them.

    The largest values over 1, 2, 4 … steps are worked out once for all windows over the same traces (the
    sparse table of Bender and Farach-Colton, LATIN 2000: two of its rows cover any width).

    Parameters
    ----------
    traces : array of shape (curves, m)
    unknown : number, or array of shape (curves, 1)
        What stands before the first point.
    points
        Where the traces are known; at each step where none are given.

    Attributes
    ----------
    trace : array of shape (curves, k)
        The traces at the whole steps.
    """

    def __init__(self, traces: Floats, unknown: float | Floats, points: Points | None = None) -> None:
        self.traces = traces
        self.unknown = unknown
        self.points = Points.even(traces.shape[-1]) if points is None else points
        self.trace = traces[..., self.points.whole] if self.points.some_between else traces
        self._doubled: list[Floats] = []

    @cached_property
    def between(self) -> Floats | None:
        """The largest value inside the step that ends at each whole one, 0 without points there.

        Of shape (curves, k); None where no step has points inside.
        """
        if not self.points.some_between:
            return None
        inside = self.traces.copy()
        inside[..., self.points.whole] = 0.0
        largest = np.zeros_like(self.trace)
        largest[..., 1:] = np.maximum.reduceat(inside, self.points.whole[:-1], axis=-1)
        return largest

    @cached_property
    def negated(self) -> "Past":
        """1 − φ."""
        return Past(1.0 - self.traces, 1.0 - self.unknown, self.points)

    def largest(self, steps: int) -> Floats:
        """Give the largest value over the last so many steps, both ends included."""
        if self.between is None:
            return self._largest(steps + 1)
        found = self.earlier(steps)
        return np.maximum(found, self._largest(steps)) if steps else found

    def _largest(self, points: int) -> Floats:
        """Give the largest of the last so many whole points, each with what lies between it and the last."""
        points = min(points, self.trace.shape[-1] + 1)
        level = points.bit_length() - 1
        if not self._doubled:
            self._doubled = [self.trace if self.between is None else np.maximum(self.trace, self.between)]
        while len(self._doubled) <= level:
            self._doubled.append(_larger(self._doubled[-1], 1 << len(self._doubled) - 1))
        found = _larger(self._doubled[level], points - (1 << level))
        before = found[..., : points - 1]
        np.maximum(before, self.unknown, out=before)
        return found

    def earlier(self, steps: float) -> Floats:
        """Give the traces so many steps earlier, linear between whole steps."""
        number, size = math.ceil(steps), self.trace.shape[-1]
        padded = _padded(self.trace, number, self.unknown)
        share = number - steps
        found = padded[..., :size]
        return found if share == 0 else found + share * (padded[..., 1:][..., :size] - found)


def _larger(trace: Floats, points: int) -> Floats:
    """Give the larger of each point and the one so many points earlier, where there is one."""
    found = trace.copy()
    if 0 < points < trace.shape[-1]:
        np.maximum(trace[..., points:], trace[..., :-points], out=found[..., points:])
    return found


def _padded(trace: Floats, number: int, unknown: float | Floats) -> Floats:
    padded = np.empty((*trace.shape[:-1], number + trace.shape[-1]))
    padded[..., :number] = unknown
    padded[..., number:] = trace
    return padded


@dataclass(frozen=True, slots=True)
class Integrals:
    """Traces' first and second running integrals at whole steps; exact where it is linear between points."""

    padded: Floats
    first: Floats
    second: Floats
    padding: int

    @classmethod
    def of(cls, past: Past, padding: int) -> "Integrals":
        """Integrate traces from ``padding`` steps before their start."""
        points = past.points
        values = _padded(past.traces, padding, past.unknown)
        widths = np.diff(_padded(points.at - points.at[0], padding, np.arange(-padding, 0.0)))
        earlier, later = values[..., :-1], values[..., 1:]
        zero = np.zeros((*values.shape[:-1], 1))
        first = np.concatenate([zero, np.cumsum(widths * (earlier + later) / 2, axis=-1)], axis=-1)
        parts = widths * first[..., :-1] + widths**2 * (earlier / 3 + later / 6)
        second = np.concatenate([zero, np.cumsum(parts, axis=-1)], axis=-1)
        if not points.some_between:
            return cls(values, first, second, padding)
        whole = np.concatenate([np.arange(padding), padding + points.whole])
        return cls(values[..., whole], first[..., whole], second[..., whole], padding)

    def back(self, steps: float, size: int) -> tuple[Floats, Floats]:
        """Give both integrals ``steps`` steps before each of the traces' ``size`` whole steps.

        Inside a step they bend as those of a line between its ends do.
        """
        start = self.padding - math.ceil(steps)
        share = math.ceil(steps) - steps
        value, first, second = (
            part[..., start:][..., :size] for part in (self.padded, self.first, self.second)
        )
        if share == 0:
            return first, second
        next_value, next_first, next_second = (
            part[..., start + 1 :][..., :size] for part in (self.padded, self.first, self.second)
        )
        slope, bend = next_value - value, share * (1 - share)
        return (
            first + share * (next_first - first) - bend / 2 * slope,
            second + share * (next_second - second) - bend / 2 * (value + (1 + share) / 3 * slope),
        )
