"""How degrees are joined: pairs of a t-norm for "and" and its dual for "or"."""

from collections.abc import Sequence
from enum import StrEnum
from functools import reduce

import numpy as np

from fuzzytime.satisfaction import Floats


class Norm(StrEnum):
    """The t-norms that tables may choose."""

    MIN = "min"
    PRODUCT = "product"
    LUKASIEWICZ = "lukasiewicz"

    @property
    def dual(self) -> str:
        """The name of its t-conorm."""
        return {"min": "max", "product": "sum", "lukasiewicz": "bounded"}[self]

    def conjunction(self, parts: Sequence[Floats]) -> Floats:
        """Join degrees by "and": min(u, v), u·v or max(0, u + v − 1)."""
        if self is Norm.MIN:
            return reduce(np.minimum, parts)
        if self is Norm.PRODUCT:
            return reduce(np.multiply, parts)
        return reduce(lambda one, other: np.maximum(one + other - 1.0, 0.0), parts)

    def disjunction(self, parts: Sequence[Floats]) -> Floats:
        """Join degrees by "or": 1 minus the "and" of their contraries."""
        if self is Norm.MIN:
            return reduce(np.maximum, parts)
        return np.asarray(1.0 - self.conjunction([1.0 - part for part in parts]))
