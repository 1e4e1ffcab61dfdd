"""Sums such as ``t - 0.4w + 10 s``: how a model's breakpoints depend on what was said.

Read by hand into coefficients; nothing is ever evaluated as a program.
"""

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass

from fuzzytime.errors import FuzzytimeError

VARIABLES: Mapping[str, str] = {
    "t": "the time that was named, t_spec",
    "w": "the half-base that the width law gives for t",
    "c": "the half-plateau: w times the plateau's share",
    "a": "the start of an interval",
    "b": "its end",
}
"""What a sum may speak of; all are times in seconds."""

LARGEST = 1e6
"""The largest factor or number of a duration in a sum."""

_UNITS = {"ms": 0.001, "s": 1.0, "sec": 1.0, "min": 60.0, "h": 3600.0, "d": 86400.0}
_SUMMAND = re.compile(r"\s*([-+]?)\s*(\d+(?:\.\d*)?|\.\d+)?\s*\*?\s*([A-Za-z]+)?\s*")


class SumError(FuzzytimeError):
    """A sum that cannot be read, and the character from which on."""

    def __init__(self, message: str, offset: int) -> None:
        super().__init__(message)
        self.offset = offset


@dataclass(frozen=True, slots=True)
class Sum:
    """A constant in seconds plus multiples of variables."""

    constant: float
    factors: tuple[tuple[str, float], ...] = ()

    @property
    def variables(self) -> frozenset[str]:
        """The variables it speaks of."""
        return frozenset(name for name, _ in self.factors)

    def value(self, values: Mapping[str, float]) -> float:
        """Give the sum for values of its variables, in seconds."""
        return self.constant + math.fsum(factor * values[name] for name, factor in self.factors)


def parse_sum(text: str) -> Sum:
    """Read a sum of variables with factors and of durations; ``inf`` and ``-inf`` stand alone.

    Raises
    ------
    SumError
        If the text is no such sum.

    >>> parse_sum("t - 0.4w + 10.5 s").value({"t": 600.0, "w": 100.0})
    570.5
    """
    if text.strip() in ("inf", "-inf"):
        return Sum(float(text))
    constant, factors, at = 0.0, dict[str, float](), 0
    while at < len(text) or at == 0:
        part = _SUMMAND.match(text, at)
        if part is None or (part[2] is None and part[3] is None) or (at > 0 and not part[1]):
            raise SumError(f"a sum must look like 't - 0.4w + 10 s', got {text!r}", at)
        size = float(part[2] or 1.0) * (-1.0 if part[1] == "-" else 1.0)
        if abs(size) > LARGEST:
            raise SumError(f"a number in a sum must be at most {LARGEST:g}, got {part[2]!r}", part.start(2))
        name = part[3]
        if name in VARIABLES:
            factors[name] = factors.get(name, 0.0) + size
        elif name in _UNITS and part[2] is not None:
            constant += size * _UNITS[name]
        elif name is None and size == 0:
            pass
        elif name is None:
            raise SumError(f"a duration must have a unit (s, min, h, d), got {part[2]!r}", part.start(2))
        else:
            known = ", ".join((*VARIABLES, "s, min, h, d"))
            raise SumError(f"a sum may speak of {known}, got {name!r}", part.start(3))
        at = part.end()
    return Sum(constant, tuple(sorted(factors.items())))
