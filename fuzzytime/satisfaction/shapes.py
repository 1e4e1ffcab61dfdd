"""The shapes of ψ: trapezoid, triangle, rectangle, generalised bell, sampled points, and a floor under any.

Trapezoids fit best what people draw (the paper's F1); rectangle and triangle are special trapezoids. The
bell is the generalised one, 1 / (1 + |(t − c) / w|^(2s)), which has a plateau where a Gaussian has none.
"""

import math
from dataclasses import dataclass, fields
from functools import lru_cache
from itertools import pairwise
from typing import ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction.linear import Knots, PiecewiseLinear
from fuzzytime.satisfaction.protocol import (
    ACCEPTABLE,
    EMPTY,
    EVERYWHERE,
    Floats,
    Interval,
    SatisfactionFunction,
)


class _Corners(PiecewiseLinear):
    """A trapezoid by its four corners, whichever fields give them; all fields are times."""

    __slots__ = ()

    @property
    def corners(self) -> tuple[float, float, float, float]:
        """Times where ψ starts to rise, is full from, is full until, and has fallen."""
        raise NotImplementedError

    def _checked(self) -> None:
        corners = self.corners
        if any(math.isnan(corner) for corner in corners):
            raise FuzzytimeError(f"corners must be numbers, got {corners}")
        if any(low > high for low, high in pairwise(corners)):
            raise FuzzytimeError(f"corners must not decrease, got {corners}")
        rise_start, full_start, full_end, fall_end = corners
        rise_open, fall_open = rise_start == -math.inf, fall_end == math.inf
        if rise_open != (full_start == -math.inf) or fall_open != (full_end == math.inf):
            raise FuzzytimeError(f"a flank must lie between two finite times, got {corners}")

    def _knots(self) -> Knots:
        return _trapezoid_knots(*self.corners)

    @property
    def parameters(self) -> dict[str, float | list[float]]:
        """The fields by name, in seconds."""
        return {entry.name: getattr(self, entry.name) for entry in fields(self)}  # type: ignore[arg-type]

    @property
    def best(self) -> Interval:
        """The plateau."""
        return Interval(*self.corners[1:3])

    @property
    def log_concave(self) -> bool:
        """Always: a trapezoid is concave where it is not 0."""
        return True

    def shifted(self, by: float) -> Self:
        """Give the same shape ``by`` seconds later."""
        return type(self)(*(value + by for value in self.parameters.values()))  # type: ignore[operator]

    def widened(self, factor: float, anchor: float) -> Self:
        """Give the shape scaled about a time by a factor above 0."""
        _check_factor(factor)
        times = (anchor + factor * (value - anchor) for value in self.parameters.values())  # type: ignore[operator]
        return type(self)(*times)


@lru_cache(maxsize=1024)
def _trapezoid_knots(rise_start: float, full_start: float, full_end: float, fall_end: float) -> Knots:
    """Knots at the finite corners; equal corners become one knot with a jump or a peak."""
    rows: dict[float, tuple[float, float, float]] = {}
    rises, falls = rise_start < full_start, full_end < fall_end
    if rises:
        rows[rise_start] = (0.0, 0.0, 0.0)
    if math.isfinite(full_start):
        rows[full_start] = (float(rises), 1.0, 1.0)
    if math.isfinite(full_end):
        left = rows[full_end][0] if full_end == full_start else 1.0
        rows[full_end] = (left, 1.0, float(falls))
    if falls:
        rows[fall_end] = (0.0, 0.0, 0.0)
    left_limits, at, right_limits = np.array(list(rows.values()), float).reshape(-1, 3).T
    before, after = float(rise_start == -math.inf), float(fall_end == math.inf)
    return Knots(np.array(list(rows), float), left_limits, at, right_limits, before, after)


@dataclass(frozen=True, slots=True)
class Trapezoid(_Corners):
    """ψ rises linearly, is 1 on a plateau, falls linearly.

    A pair of equal corners is a jump. An open side has both its corners infinite:
    ``Trapezoid(0, 0, inf, inf)`` is satisfied at any time from now on.

    Raises
    ------
    FuzzytimeError
        If corners decrease, are not numbers, or only one corner of a flank is infinite.

    >>> Trapezoid(60, 96, 144, 180)([0, 78, 120, 180]).tolist()
    [0.0, 0.5, 1.0, 0.0]
    """

    model: ClassVar[str] = "trapezoid"

    rise_start: float
    full_start: float
    full_end: float
    fall_end: float

    def __post_init__(self) -> None:
        self._checked()

    @property
    def corners(self) -> tuple[float, float, float, float]:
        """The fields."""
        return self.rise_start, self.full_start, self.full_end, self.fall_end


@dataclass(frozen=True, slots=True)
class Triangle(_Corners):
    """ψ rises linearly to 1 at its peak and falls linearly.

    Raises
    ------
    FuzzytimeError
        If the times decrease or are not numbers.
    """

    model: ClassVar[str] = "triangle"

    rise_start: float
    peak: float
    fall_end: float

    def __post_init__(self) -> None:
        self._checked()

    @property
    def corners(self) -> tuple[float, float, float, float]:
        """The peak stands for both ends of the plateau."""
        return self.rise_start, self.peak, self.peak, self.fall_end


@dataclass(frozen=True, slots=True)
class Rectangle(_Corners):
    """ψ is 1 between two times, both included, and 0 elsewhere.

    Raises
    ------
    FuzzytimeError
        If the end lies before the start, or one is not a number.
    """

    model: ClassVar[str] = "rectangle"

    start: float
    end: float

    def __post_init__(self) -> None:
        self._checked()

    @property
    def corners(self) -> tuple[float, float, float, float]:
        """Both flanks are jumps."""
        return self.start, self.start, self.end, self.end


@dataclass(frozen=True, slots=True)
class Bell:
    """The generalised bell ψ(t) = 1 / (1 + |(t − centre) / width|^(2·slope)); ½ one width from its centre.

    Raises
    ------
    FuzzytimeError
        If the centre is not finite, or width or slope is not above 0.
    """

    model: ClassVar[str] = "bell"

    centre: float
    width: float
    slope: float

    def __post_init__(self) -> None:
        if not math.isfinite(self.centre):
            raise FuzzytimeError(f"a bell's centre must be finite, got {self.centre}")
        for name, value in (("width", self.width), ("slope", self.slope)):
            if not (0 < value < math.inf):
                raise FuzzytimeError(f"a bell's {name} must be above 0 and finite, got {value}")

    def __call__(self, times: ArrayLike) -> Floats:
        """Give ψ at times of any shape, in that shape."""
        return np.asarray(np.exp(self.log(times)))

    def log(self, times: ArrayLike) -> Floats:
        """Give log ψ at times of any shape."""
        distance = np.abs((np.asarray(times, float) - self.centre) / self.width)
        with np.errstate(divide="ignore"):
            return np.asarray(-np.logaddexp(0.0, 2 * self.slope * np.log(distance)))

    @property
    def parameters(self) -> dict[str, float | list[float]]:
        """Centre and width in seconds, and the slope."""
        return {"centre": self.centre, "width": self.width, "slope": self.slope}

    @property
    def support(self) -> Interval:
        """All times: a bell never reaches 0."""
        return EVERYWHERE

    @property
    def kinks(self) -> tuple[float, ...]:
        """The centre, where the slope may jump (slope ≤ ½)."""
        return (self.centre,)

    @property
    def best(self) -> Interval:
        """The centre."""
        return Interval(self.centre, self.centre)

    @property
    def log_concave(self) -> bool:
        """Never: the flanks of a generalised bell are long."""
        return False

    def acceptable(self, level: float = ACCEPTABLE) -> Interval:
        """Give the interval of times with ψ ≥ level."""
        if level <= 0:
            return EVERYWHERE
        if level > 1:
            return EMPTY
        with np.errstate(over="ignore"):
            reach = self.width * float(np.float64(1 / level - 1) ** (1 / (2 * self.slope)))
        return Interval(self.centre - reach, self.centre + reach)

    def crossings(self, level: float) -> tuple[float, ...]:
        """Give the two times at which ψ passes a level between 0 and 1."""
        if not 0 < level < 1:
            return ()
        inside = self.acceptable(level)
        return inside.low, inside.high

    def chord_error(self, starts: ArrayLike, ends: ArrayLike) -> Floats:
        """Bound by the curvature: an arc of length h stays within h² / 8 · max (−log ψ)'' of its chord."""
        first, last = np.asarray(starts, float), np.asarray(ends, float)
        return np.asarray((last - first) ** 2 / 8 * self._curvature(first, last))

    def _curvature(self, starts: Floats, ends: Floats) -> Floats:
        """Bound (−log ψ)'' on pieces that do not cross the centre.

        With x = |t − c| / w and p = 2s it is p x^(p−2) (p − 1 − x^p) / (1 + x^p)² / w², at most
        p (p − 1) x^(p−2) / (1 + x^p)² / w², whose largest value is where x^p = (p − 2) / (p + 2).
        """
        power = 2 * self.slope
        if power <= 1:
            return np.zeros_like(starts)
        first, last = np.abs(starts - self.centre) / self.width, np.abs(ends - self.centre) / self.width
        near, far = np.minimum(first, last), np.maximum(first, last)
        peak = ((power - 2) / (power + 2)) ** (1 / power) if power > 2 else 0.0
        with np.errstate(divide="ignore", over="ignore", invalid="ignore"):
            distance = np.log(np.clip(peak, near, far))
            scale = np.where(np.isneginf(distance) & (power == 2), 0.0, (power - 2) * distance)
            value = np.exp(scale - 2 * np.logaddexp(0.0, power * distance))
        return np.asarray(power * (power - 1) * value / self.width**2)

    def shifted(self, by: float) -> "Bell":
        """Give the same bell ``by`` seconds later."""
        return Bell(self.centre + by, self.width, self.slope)

    def widened(self, factor: float, anchor: float) -> "Bell":
        """Give the bell scaled about a time by a factor above 0."""
        _check_factor(factor)
        return Bell(anchor + factor * (self.centre - anchor), self.width * factor, self.slope)


class Sampled(PiecewiseLinear):
    """ψ by points, linear between neighbours and 0 outside: drawn curves, traces of conditions, products.

    Two points at one time make a jump.

    Parameters
    ----------
    times : array of shape (k,), k ≥ 1
        Finite, not decreasing; at most two equal.
    values : array of shape (k,)
        Satisfactions in [0, 1].

    Raises
    ------
    FuzzytimeError
        If the two do not fit, or break these rules.
    """

    __slots__ = ("_table", "times", "values")
    model: ClassVar[str] = "points"

    times: Floats
    values: Floats
    _table: Knots

    def __init__(self, times: ArrayLike, values: ArrayLike) -> None:
        at, value = np.array(times, float), np.array(values, float)
        if at.ndim != 1 or at.shape != value.shape or not at.size:
            raise FuzzytimeError(f"points need as many times as values, got {at.shape} and {value.shape}")
        if not np.isfinite(at).all() or (np.diff(at) < 0).any():
            raise FuzzytimeError("times of points must be finite and must not decrease")
        if (at[2:] == at[:-2]).any():
            raise FuzzytimeError("at most two points may share a time")
        if not ((value >= 0) & (value <= 1)).all():
            raise FuzzytimeError(f"satisfactions must lie in [0, 1], got {value.min():g} to {value.max():g}")
        at.flags.writeable = value.flags.writeable = False
        object.__setattr__(self, "times", at)
        object.__setattr__(self, "values", value)
        object.__setattr__(self, "_table", self._built())

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a satisfaction function does not change: {name!r} cannot be set")

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, Sampled)
            and np.array_equal(self.times, other.times)
            and np.array_equal(self.values, other.values)
        )

    def __hash__(self) -> int:
        return hash((self.times.tobytes(), self.values.tobytes()))

    def __repr__(self) -> str:
        return f"Sampled({self.times.tolist()}, {self.values.tolist()})"

    def __reduce__(self) -> tuple[type["Sampled"], tuple[Floats, Floats]]:
        return Sampled, (self.times, self.values)

    def _built(self) -> Knots:
        times, first, count = np.unique(self.times, return_index=True, return_counts=True)
        left, right = self.values[first], self.values[first + count - 1]
        at = np.maximum(left, right)
        # Outside ψ is 0: a curve that starts or ends above 0 jumps there.
        left[0] = left[0] if count[0] == 2 else 0.0
        right[-1] = right[-1] if count[-1] == 2 else 0.0
        return Knots(times, left, at, right, 0.0, 0.0)

    def _knots(self) -> Knots:
        return self._table

    @property
    def parameters(self) -> dict[str, float | list[float]]:
        """The points, as two lists."""
        return {"times": self.times.tolist(), "values": self.values.tolist()}

    def shifted(self, by: float) -> "Sampled":
        """Give the same points ``by`` seconds later."""
        return Sampled(self.times + by, self.values)

    def widened(self, factor: float, anchor: float) -> "Sampled":
        """Give the points scaled about a time by a factor above 0."""
        _check_factor(factor)
        return Sampled(anchor + factor * (self.times - anchor), self.values)


@dataclass(frozen=True, slots=True)
class Floored:
    """max(ψ, floor): the paper's minimum threshold, with which one hopeless skill does not spoil the product.

    Raises
    ------
    FuzzytimeError
        If the floor is not in (0, 1].
    """

    model: ClassVar[str] = "floored"

    function: SatisfactionFunction
    floor: float

    def __post_init__(self) -> None:
        if not 0 < self.floor <= 1:
            raise FuzzytimeError(f"a floor must lie in (0, 1], got {self.floor}")

    def __call__(self, times: ArrayLike) -> Floats:
        """Give ψ, at least the floor, at times of any shape, in that shape."""
        return np.asarray(np.maximum(self.function(times), self.floor))

    def log(self, times: ArrayLike) -> Floats:
        """Give log ψ, at least that of the floor."""
        return np.asarray(np.maximum(self.function.log(times), math.log(self.floor)))

    @property
    def parameters(self) -> dict[str, float | list[float]]:
        """The floor beside the parameters of the function above it."""
        return {"floor": self.floor, **self.function.parameters}

    @property
    def support(self) -> Interval:
        """All times."""
        return EVERYWHERE

    @property
    def kinks(self) -> tuple[float, ...]:
        """Those of the function, and where it meets the floor."""
        return tuple(sorted({*self.function.kinks, *self.function.crossings(self.floor)}))

    @property
    def best(self) -> Interval:
        """Those of the function, where they lie above the floor."""
        best = self.function.best
        return best if not best.empty and float(self(best.high)) > self.floor else EVERYWHERE

    @property
    def log_concave(self) -> bool:
        """Not known."""
        return False

    def acceptable(self, level: float = ACCEPTABLE) -> Interval:
        """Give the smallest interval that holds every time with satisfaction ≥ level."""
        return EVERYWHERE if level <= self.floor else self.function.acceptable(level)

    def crossings(self, level: float) -> tuple[float, ...]:
        """Give the times at which the function passes a level above the floor."""
        return self.function.crossings(level) if level >= self.floor else ()

    def chord_error(self, starts: ArrayLike, ends: ArrayLike) -> Floats:
        """Give the function's own bound on pieces above the floor, and 0 on the flat ones."""
        first, last = np.asarray(starts, float), np.asarray(ends, float)
        above = self.function((first + last) / 2) > self.floor
        return np.asarray(np.where(above, self.function.chord_error(first, last), 0.0))

    def shifted(self, by: float) -> "Floored":
        """Give the same ``by`` seconds later."""
        return Floored(self.function.shifted(by), self.floor)

    def widened(self, factor: float, anchor: float) -> "Floored":
        """Give the function scaled about a time, on the same floor."""
        return Floored(self.function.widened(factor, anchor), self.floor)


def _check_factor(factor: float) -> None:
    if not 0 < factor < math.inf:
        raise FuzzytimeError(f"a factor of width must be above 0 and finite, got {factor}")
