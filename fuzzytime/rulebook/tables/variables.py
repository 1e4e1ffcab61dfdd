"""Linguistic variables: terms such as "hot" over a signal, its rate, or the time since an event."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from types import MappingProxyType

import numpy as np

from fuzzytime.satisfaction import Floats


class Source(StrEnum):
    """What a variable looks at."""

    OF = "of"
    """The value of a signal."""

    RATE_OF = "rate_of"
    """The slope of a signal, by least squares over a stretch of time."""

    SINCE = "since"
    """The seconds since an event."""


@dataclass(frozen=True, slots=True)
class Term:
    """μ over the values of a variable: a trapezoid, open on a side that is infinite.

    ``words`` are further ways to say it in a sentence; ``meaning`` explains one that no table declares.
    """

    name: str
    corners: tuple[float, float, float, float]
    words: tuple[str, ...] = ()
    meaning: str = ""

    def __call__(self, values: Floats) -> Floats:
        """Give μ at values of any shape; unknown values (NaN) stay unknown."""
        points, degrees = self._points()
        return np.interp(values.ravel(), points, degrees).reshape(values.shape)

    def _points(self) -> tuple[list[float], list[float]]:
        """Give the breakpoints; a jump becomes a flank of one unit in the last place, outside the plateau."""
        rise, full, end, fall = self.corners
        points: list[float] = []
        degrees: list[float] = []
        if math.isfinite(full):
            points += [min(rise, math.nextafter(full, -math.inf)), full]
            degrees += [0.0, 1.0]
        if math.isfinite(end):
            if end > full or not points:
                points.append(end)
                degrees.append(1.0)
            points.append(max(fall, math.nextafter(end, math.inf)))
            degrees.append(0.0)
        return (points, degrees) if points else ([0.0], [1.0])

    @property
    def breakpoints(self) -> tuple[float, ...]:
        """The finite corners."""
        return tuple(corner for corner in self.corners if math.isfinite(corner))


@dataclass(frozen=True, slots=True, kw_only=True)
class Variable:
    """A name for what a signal, or its course, means to people.

    Parameters
    ----------
    source, signal
        What it looks at.
    unit
        The unit of its signal in which its terms are given.
    over, per
        For a rate: the stretch of time in seconds, and the seconds per which it is given.
    words
        How a sentence names it: "frying pan".
    """

    name: str
    source: Source
    signal: str
    terms: Mapping[str, Term] = field(default_factory=lambda: MappingProxyType({}))
    unit: str | None = None
    over: float = 0.0
    per: float = 1.0
    words: tuple[str, ...] = ()
    place: str = ""

    @property
    def breakpoints(self) -> tuple[float, ...]:
        """The finite corners of all terms, ascending."""
        return tuple(sorted({corner for term in self.terms.values() for corner in term.breakpoints}))
