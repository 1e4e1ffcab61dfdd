"""ψ of several times one of which is enough: "at seven or at eight"."""

from collections.abc import Sequence
from itertools import pairwise
from typing import ClassVar

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction.algebra import TOLERANCE, points_of
from fuzzytime.satisfaction.linear import Knots, PiecewiseLinear
from fuzzytime.satisfaction.protocol import Floats, SatisfactionFunction


class Either(PiecewiseLinear):
    """max(ψ₁, ψ₂, …): the logical OR beside the product, which is AND; open sides stay open.

    What is not piecewise linear stands in it by points, within the tolerance of a product.

    Parameters
    ----------
    functions : sequence of SatisfactionFunction
        At least one.

    Raises
    ------
    FuzzytimeError
        If there is none, or one that is not piecewise linear has no end.

    >>> from fuzzytime.satisfaction import Rectangle, Trapezoid
    >>> Either([Rectangle(0, 10), Trapezoid(5, 25, 30, 40)])([10, 15, 30]).tolist()
    [1.0, 0.5, 1.0]
    """

    __slots__ = ("_table", "functions")
    model: ClassVar[str] = "either"

    functions: tuple[SatisfactionFunction, ...]
    _table: Knots

    def __init__(self, functions: Sequence[SatisfactionFunction]) -> None:
        if not functions:
            raise FuzzytimeError("one of several times needs at least one")
        object.__setattr__(self, "functions", tuple(functions))
        object.__setattr__(self, "_table", _highest([_by_knots(function) for function in functions]))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a satisfaction function does not change: {name!r} cannot be set")

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Either) and self.functions == other.functions

    def __hash__(self) -> int:
        return hash(self.functions)

    def __repr__(self) -> str:
        return f"Either({list(self.functions)})"

    def __reduce__(self) -> tuple[type["Either"], tuple[tuple[SatisfactionFunction, ...]]]:
        return Either, (self.functions,)

    @property
    def knots(self) -> Knots:
        """The table of knots."""
        return self._table

    @property
    def parameters(self) -> dict[str, float | list[float]]:
        """The knots with their limits from both sides, and ψ before the first and after the last."""
        knots = self._table
        columns = {"times": knots.times, "left": knots.left, "values": knots.at, "right": knots.right}
        lists: dict[str, float | list[float]] = {name: column.tolist() for name, column in columns.items()}
        return {**lists, "before": knots.before, "after": knots.after}

    def shifted(self, by: float) -> "Either":
        """Give the same ``by`` seconds later."""
        return Either([function.shifted(by) for function in self.functions])

    def widened(self, factor: float, anchor: float) -> "Either":
        """Give all of them scaled about a time by a factor above 0."""
        return Either([function.widened(factor, anchor) for function in self.functions])


def _by_knots(function: SatisfactionFunction) -> PiecewiseLinear:
    if isinstance(function, PiecewiseLinear):
        return function
    return points_of(function, function.kinks, function.acceptable(TOLERANCE))


def _highest(functions: Sequence[PiecewiseLinear]) -> Knots:
    """Give the knots of the highest of several: all of theirs, and where two of them cross."""
    tables = [function.knots for function in functions]
    times = np.unique(np.concatenate([table.times for table in tables]))
    crossings = [
        crossing
        for place, one in enumerate(tables)
        for other in tables[place + 1 :]
        for crossing in _crossings(one, other, times)
    ]
    times = np.unique([*times.tolist(), *crossings])
    columns = [_limits(table, times) for table in tables]
    left, at, right = (np.max([column[k] for column in columns], axis=0) for k in range(3))
    before, after = (max(ends) for ends in zip(*((t.before, t.after) for t in tables), strict=True))
    return Knots(times, left, at, right, before, after)


def _crossings(one: Knots, other: Knots, times: Floats) -> list[float]:
    """Give where two functions cross between neighbouring times, between which both are linear."""
    (left, _, right), (other_left, _, other_right) = _limits(one, times), _limits(other, times)
    first, last = right[:-1] - other_right[:-1], left[1:] - other_left[1:]
    share = np.divide(first, first - last, out=np.zeros_like(first), where=first * last < 0)
    found = (begin + part * (end - begin) for (begin, end), part in zip(pairwise(times), share, strict=True))
    return [float(time) for time, part in zip(found, share, strict=True) if part > 0]


def _limits(table: Knots, times: Floats) -> tuple[Floats, Floats, Floats]:
    """Give limits from the left, values and limits from the right at ascending times."""
    at = table.evaluate(times)
    left, right = at.copy(), at.copy()
    own = np.isin(times, table.times)
    left[own], at[own], right[own] = table.left, table.at, table.right
    return left, at, right
