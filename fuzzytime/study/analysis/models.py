"""Shapes that can be fitted: their parameters, bounds, guesses from a curve, values and derivatives.

Inside, time runs from 0 to 1 over the curve's timeline, so that parameters are of one size. A trapezoid's
parameters are centre, core, left and right width; a triangle has no core.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from fuzzytime.satisfaction import Bell, Floats, SatisfactionFunction, Trapezoid, Triangle
from fuzzytime.study.analysis.density import first_passage, mean_time, variance

GUESS_LEVELS = ((0.1, 0.9), (0.25, 0.75), (0.4, 0.6), (0.02, 0.98))
"""Pairs of a curve's levels from whose passages its corners are guessed, the surest first."""

NARROW = 0.02
"""The narrowest flank of a trapezoid, in distances between samples: less cannot be told from a jump."""

STEEPEST_BELL = 400.0
"""The largest slope of a bell that is tried: by then its flank is a jump at any sampling in use."""


@dataclass(frozen=True, slots=True, eq=False)
class Curve:
    """A curve to fit, on a timeline from 0 to 1: arrays of shape (k,)."""

    start: float
    length: float
    positions: Floats
    values: Floats

    @classmethod
    def of(cls, times: Floats, values: Floats) -> "Curve":
        """Scale a curve's times."""
        start, length = float(times[0]), float(times[-1] - times[0])
        return cls(start, length, (times - start) / length, values)

    @property
    def step(self) -> float:
        """The mean distance between samples."""
        return 1.0 / (self.positions.size - 1)

    def time(self, position: float) -> float:
        """Give a position in seconds."""
        return self.start + self.length * position

    def corners(self, low: float, high: float) -> tuple[float, float, float, float]:
        """Guess the corners of a trapezoid from the outermost passages of two shares of the maximum."""
        peak = float(self.values.max())
        outer, inner = low * peak, high * peak
        backwards = self.positions[::-1], self.values[::-1]
        rise = [first_passage(self.positions, self.values, level) for level in (outer, inner)]
        fall = [first_passage(*backwards, level) for level in (inner, outer)]
        beyond_low, beyond_high = low / (high - low), (1 - high) / (high - low)
        left, right = rise[1] - rise[0], fall[1] - fall[0]
        full_start, full_end = rise[1] + beyond_high * left, fall[0] - beyond_high * right
        if full_start > full_end:
            full_start = full_end = (full_start + full_end) / 2
        return rise[0] - beyond_low * left, full_start, full_end, fall[1] + beyond_low * right


class Shape(ABC):
    """A family of ψ by a vector of parameters."""

    @abstractmethod
    def guesses(self, curve: Curve) -> Sequence[Floats]:
        """Give parameter vectors to start from, the surest first."""

    @abstractmethod
    def bounds(self, curve: Curve) -> tuple[Floats, Floats]:
        """Give the smallest and the largest value of each parameter."""

    @abstractmethod
    def value(self, parameters: Floats, positions: Floats) -> Floats:
        """Give ψ at positions of shape (k,)."""

    @abstractmethod
    def derivatives(self, parameters: Floats, positions: Floats) -> Floats:
        """Give ∂ψ/∂parameter, of shape (k, parameters)."""

    @abstractmethod
    def function(self, parameters: Floats, curve: Curve) -> SatisfactionFunction:
        """Give ψ over seconds."""

    @abstractmethod
    def parameters_in_seconds(self, parameters: Floats, curve: Curve) -> dict[str, float]:
        """Name the parameters, as times in seconds."""


class TrapezoidShape(Shape):
    """Centre, core, left and right width, or fewer parameters that determine the four linearly.

    Parameters
    ----------
    matrix : array of shape (4, parameters)
    offset : array of shape (4,)
        (centre, core, left, right) = matrix · parameters + offset.
    """

    def __init__(self, matrix: Floats, offset: Floats) -> None:
        self.matrix = matrix
        self.offset = offset

    def guesses(self, curve: Curve) -> Sequence[Floats]:
        """Guess by levels, and by the moments of the density; the nearest parameters stand for them."""
        found = [self._of_corners(*curve.corners(*levels)) for levels in GUESS_LEVELS]
        mean = float(mean_time(curve.positions, curve.values))
        deviation = float(np.sqrt(variance(curve.positions, curve.values)))
        found.insert(2, np.array([mean, 2 * deviation, 1.5 * deviation, 1.5 * deviation]))
        back = np.linalg.pinv(self.matrix)
        return [np.asarray(back @ (full - self.offset), float) for full in found]

    @staticmethod
    def _of_corners(rise_start: float, full_start: float, full_end: float, fall_end: float) -> Floats:
        centre, core = (full_start + full_end) / 2, full_end - full_start
        return np.array([centre, core, full_start - rise_start, fall_end - full_end])

    def bounds(self, curve: Curve) -> tuple[Floats, Floats]:
        """Keep the centre within reach and the flanks from becoming jumps between floats."""
        low, high = np.array([-1.0, 0.0, NARROW, NARROW]), np.array([2.0, 2.0, 4.0, 4.0])
        low[2:] *= curve.step
        chief = self.matrix.shape[0] - 1 - np.argmax(self.matrix[::-1] != 0, axis=0)
        return low[chief], high[chief]

    def value(self, parameters: Floats, positions: Floats) -> Floats:
        """Give the lower one of both flanks' lines, cut off at 0 and 1."""
        rise, fall, _, _ = self._lines(parameters, positions)
        return np.asarray(np.clip(np.minimum(rise, fall), 0.0, 1.0))

    def derivatives(self, parameters: Floats, positions: Floats) -> Floats:
        """Give the flanks' derivatives where ψ lies on a flank, and 0 elsewhere."""
        rise, fall, left, right = self._lines(parameters, positions)
        rising = ((rise > 0) & (rise < 1) & (rise <= fall)) / left
        falling = ((fall > 0) & (fall < 1) & (fall < rise)) / right
        four = [falling - rising, (falling + rising) / 2, (1 - rise) * rising, (1 - fall) * falling]
        return np.asarray(np.stack(four, axis=-1) @ self.matrix)

    def _lines(self, parameters: Floats, positions: Floats) -> tuple[Floats, Floats, float, float]:
        """Give the lines on which both flanks lie, and the flanks' widths."""
        centre, core, left, right = (self.matrix @ parameters + self.offset).tolist()
        rise = (positions - (centre - core / 2)) / left + 1
        fall = ((centre + core / 2) - positions) / right + 1
        return rise, fall, left, right

    def corners(self, parameters: Floats, curve: Curve) -> tuple[float, float, float, float]:
        """Give the corners in seconds."""
        centre, core, left, right = (self.matrix @ parameters + self.offset).tolist()
        begin, end = curve.time(centre - core / 2), curve.time(centre + core / 2)
        return begin - left * curve.length, begin, max(begin, end), max(begin, end + right * curve.length)

    def function(self, parameters: Floats, curve: Curve) -> SatisfactionFunction:
        """Give the trapezoid; a flank that is too narrow to see becomes a jump."""
        rise_start, full_start, full_end, fall_end = self.corners(parameters, curve)
        narrow = 2 * NARROW * curve.step * curve.length
        return Trapezoid(
            full_start if full_start - rise_start < narrow else rise_start,
            full_start,
            full_end,
            full_end if fall_end - full_end < narrow else fall_end,
        )

    def parameters_in_seconds(self, parameters: Floats, curve: Curve) -> dict[str, float]:
        """Give centre, core and the flanks' widths."""
        rise_start, full_start, full_end, fall_end = self.corners(parameters, curve)
        return {
            "centre": (full_start + full_end) / 2,
            "core": full_end - full_start,
            "left": full_start - rise_start,
            "right": fall_end - full_end,
        }


class TriangleShape(TrapezoidShape):
    """Peak, left and right width: a trapezoid without a core."""

    def function(self, parameters: Floats, curve: Curve) -> SatisfactionFunction:
        """Give the triangle."""
        rise_start, peak, _, fall_end = self.corners(parameters, curve)
        return Triangle(rise_start, peak, fall_end)

    def parameters_in_seconds(self, parameters: Floats, curve: Curve) -> dict[str, float]:
        """Give the peak's time and the flanks' widths."""
        rise_start, peak, _, fall_end = self.corners(parameters, curve)
        return {"peak": peak, "left": peak - rise_start, "right": fall_end - peak}


class BellShape(Shape):
    """Centre, log width and log slope of the generalised bell 1 / (1 + |(t − c) / w|^(2s))."""

    def guesses(self, curve: Curve) -> Sequence[Floats]:
        """Guess the slope from where a pair of levels is passed, on the wider flank."""
        found = []
        for low, high in GUESS_LEVELS:
            rise_start, full_start, full_end, fall_end = curve.corners(low, high)
            centre, width = (rise_start + full_start + full_end + fall_end) / 4, 0.0
            width = max((full_end + fall_end - rise_start - full_start) / 4, curve.step)
            core = max((full_end - full_start) / 2, width / 20)
            foot = max((fall_end - rise_start) / 2, core * 1.01)
            # At core and foot a trapezoid is 1 and 0; a bell is taken there as 0.95 and 0.05.
            slope = np.log(19.0) / np.log(foot / core)
            found.append(np.array([centre, np.log(width), np.log(np.clip(slope, 0.6, STEEPEST_BELL / 2))]))
        return found

    def bounds(self, curve: Curve) -> tuple[Floats, Floats]:
        """Keep the centre on the timeline: the best time is one that people could see."""
        return (
            np.array([0.0, np.log(curve.step / 10), np.log(0.3)]),
            np.array([1.0, np.log(4.0), np.log(STEEPEST_BELL)]),
        )

    def _level(self, parameters: Floats, positions: Floats) -> tuple[Floats, Floats]:
        """Log |x|^(2s), and ψ, at positions."""
        centre, log_width, log_slope = parameters
        distance = np.maximum(np.abs(positions - centre), 1e-12)
        level = 2 * np.exp(log_slope) * (np.log(distance) - log_width)
        return level, np.exp(-np.logaddexp(0.0, level))

    def value(self, parameters: Floats, positions: Floats) -> Floats:
        """Give the bell."""
        return self._level(parameters, positions)[1]

    def derivatives(self, parameters: Floats, positions: Floats) -> Floats:
        """Give the bell's derivatives; at its very centre they are 0."""
        level, value = self._level(parameters, positions)
        power = 2 * np.exp(parameters[2])
        distance = positions - parameters[0]
        apart = np.abs(distance) > 1e-9
        down = -value * np.exp(level - np.logaddexp(0.0, level))
        toward = np.where(apart, -power / np.where(apart, distance, 1.0), 0.0)
        return np.stack([down * toward, -down * power, down * level], axis=-1)

    def function(self, parameters: Floats, curve: Curve) -> SatisfactionFunction:
        """Give the bell."""
        named = self.parameters_in_seconds(parameters, curve)
        return Bell(named["centre"], named["width"], named["slope"])

    def parameters_in_seconds(self, parameters: Floats, curve: Curve) -> dict[str, float]:
        """Give centre and width in seconds, and the slope."""
        centre, log_width, log_slope = map(float, parameters)
        width, slope = float(np.exp(log_width)) * curve.length, float(np.exp(log_slope))
        return {"centre": curve.time(centre), "width": width, "slope": slope}


TRAPEZOID = TrapezoidShape(np.eye(4), np.zeros(4))

TRIANGLE = TriangleShape(np.eye(4)[:, [0, 2, 3]], np.zeros(4))

FULL_AT_START = TrapezoidShape(np.array([[0.5, 0], [1, 0], [0, 0], [0, 1]]), np.array([0, 0, 1e-6, 0]))
"""Core and right width: the plateau is under way when the timeline begins, so nobody drew its left flank."""

FULL_AT_END = TrapezoidShape(np.array([[-0.5, 0], [1, 0], [0, 1], [0, 0]]), np.array([1, 0, 0, 1e-6]))
"""Core and left width: the plateau still lasts when the timeline ends."""

BELL = BellShape()
