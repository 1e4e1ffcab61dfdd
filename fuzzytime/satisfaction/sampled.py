"""ψ by points: drawn curves, traces of conditions, products."""

from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction.linear import Knots, PiecewiseLinear
from fuzzytime.satisfaction.protocol import Floats, check_factor


class Sampled(PiecewiseLinear):
    """ψ by points, linear between neighbours and 0 outside.

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
        if not np.isfinite(at).all():
            raise FuzzytimeError(f"times of points must be finite, got {at[~np.isfinite(at)][0]}")
        if (falls := np.diff(at) < 0).any():
            before, after = at[:-1][falls][0], at[1:][falls][0]
            raise FuzzytimeError(f"times of points must not decrease, got {before:g} and then {after:g}")
        if (thrice := at[2:] == at[:-2]).any():
            raise FuzzytimeError(f"at most two points may share a time, got {at[2:][thrice][0]:g} thrice")
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
        left[0] = right[-1] = 0.0
        return Knots(times, left, at, right, 0.0, 0.0)

    @property
    def knots(self) -> Knots:
        """The table of knots."""
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
        check_factor(factor)
        return Sampled(anchor + factor * (self.times - anchor), self.values)
