"""ψ by corners: trapezoid, triangle and rectangle, the last two special trapezoids.

Trapezoids fit best what people draw (the paper's F1).
"""

import math
from abc import abstractmethod
from dataclasses import dataclass, fields
from functools import lru_cache
from itertools import pairwise
from typing import ClassVar, Self

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction.linear import Knots, PiecewiseLinear
from fuzzytime.satisfaction.protocol import Interval, check_factor


class _Corners(PiecewiseLinear):
    """A trapezoid by its four corners, whichever fields give them; all fields are times."""

    __slots__ = ()

    @property
    @abstractmethod
    def corners(self) -> tuple[float, float, float, float]:
        """Times where ψ starts to rise, is full from, is full until, and has fallen."""

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

    @property
    def knots(self) -> Knots:
        """The table of knots."""
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
        check_factor(factor)
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
