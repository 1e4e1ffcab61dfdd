"""What a satisfaction function is: ψ, from start times in seconds to [0, 1] (the paper's eq. 3)."""

import math
from dataclasses import dataclass
from typing import ClassVar, Protocol, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from fuzzytime.errors import FuzzytimeError

Floats = NDArray[np.float64]

ACCEPTABLE = 0.5
"""The satisfaction from which on a start time counts as acceptable, unless another level is asked for."""


@dataclass(frozen=True, slots=True)
class Interval:
    """A closed interval of times in seconds; empty where ``low > high``, and either end may be infinite."""

    low: float
    high: float

    @property
    def empty(self) -> bool:
        """Whether no time lies inside."""
        return not self.low <= self.high

    @property
    def length(self) -> float:
        """Its length in seconds, 0 where it is empty."""
        return 0.0 if self.empty else self.high - self.low

    def intersection(self, other: "Interval") -> "Interval":
        """Give the times that lie in both."""
        return Interval(max(self.low, other.low), min(self.high, other.high))

    def __contains__(self, time: float) -> bool:
        return self.low <= time <= self.high


EMPTY = Interval(math.inf, -math.inf)
EVERYWHERE = Interval(-math.inf, math.inf)


@runtime_checkable
class SatisfactionFunction(Protocol):
    """ψ: how satisfied a person is if a skill starts at a time, in seconds from when it was asked for.

    Implementations are frozen values. Every one keeps 0 ≤ ψ ≤ 1 and is upper semicontinuous: at a jump it
    takes the larger value, so that a best time exists.
    """

    model: ClassVar[str]
    """The shape's name: trapezoid, triangle, rectangle, bell, points, clipped, floored or either."""

    def __call__(self, times: ArrayLike) -> Floats:
        """Give ψ at times of any shape, in that shape."""
        ...

    def log(self, times: ArrayLike) -> Floats:
        """Give log ψ at times of any shape, −inf where ψ is 0."""
        ...

    @property
    def parameters(self) -> dict[str, float | list[float]]:
        """The numbers that with the model describe ψ completely."""
        ...

    @property
    def support(self) -> Interval:
        """The smallest interval that holds every time with ψ > 0."""
        ...

    @property
    def kinks(self) -> tuple[float, ...]:
        """The finite times, ascending, where ψ jumps or its slope does."""
        ...

    @property
    def best(self) -> Interval:
        """The interval, from the earliest best time on, on which ψ keeps its maximum; empty where ψ is 0."""
        ...

    @property
    def log_concave(self) -> bool:
        """Whether log ψ is known to be concave, so that a schedule's order has one best timing."""
        ...

    def acceptable(self, level: float = ACCEPTABLE) -> Interval:
        """Give the smallest interval that holds every time with ψ ≥ level."""
        ...

    def crossings(self, level: float) -> tuple[float, ...]:
        """Give the finite times, ascending, at which ψ reaches, leaves or jumps across a level."""
        ...

    def chord_error(self, starts: ArrayLike, ends: ArrayLike) -> Floats:
        """Bound how far the chord of −log ψ rises above −log ψ on pieces without a kink inside.

        At the ends of a piece ψ is meant as its limit from inside. The answer has the pieces' shape and is
        ≥ 0, infinite where −log ψ is unbounded. See `fuzzytime.satisfaction.chord`.
        """
        ...

    def shifted(self, by: float) -> "SatisfactionFunction":
        """Give ψ(t − by): the same, ``by`` seconds later."""
        ...

    def widened(self, factor: float, anchor: float) -> "SatisfactionFunction":
        """Give ψ(anchor + (t − anchor) / factor): ``factor`` times as wide about a time that stays."""
        ...


def check_factor(factor: float) -> None:
    """Check that ψ may be widened by a factor.

    Raises
    ------
    FuzzytimeError
        If it is not above 0 and finite.
    """
    if not 0 < factor < math.inf:
        raise FuzzytimeError(f"a factor of width must be above 0 and finite, got {factor}")
