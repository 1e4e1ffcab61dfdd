"""Charts over one time axis: what is drawn, apart from how.

A chart is a stack of panels; the terminal and SVG draw the same chart.
"""

from dataclasses import dataclass, field
from datetime import datetime

import numpy as np
from numpy.typing import NDArray

from fuzzytime.satisfaction import Floats, SatisfactionFunction


@dataclass(frozen=True, slots=True, eq=False)
class Curve:
    """Values over times; NaN interrupts it. ``dots`` draws points instead of lines."""

    label: str
    times: Floats
    values: Floats
    dots: bool = False
    band: tuple[Floats, Floats] | None = None


@dataclass(frozen=True, slots=True, eq=False)
class Panel:
    """Curves that share one vertical axis."""

    title: str
    curves: tuple[Curve, ...]
    low: float = 0.0
    high: float = 1.0
    unit: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class Mark:
    """A moment to mark in every panel."""

    time: float
    label: str


@dataclass(frozen=True, slots=True, eq=False)
class Chart:
    """Panels over one time axis, in seconds from ``now`` where that is known."""

    panels: tuple[Panel, ...]
    start: float
    end: float
    now: datetime | None = None
    marks: tuple[Mark, ...] = field(default=())

    def share(self, times: Floats) -> NDArray[np.float64]:
        """Give times as shares of the axis, from 0 to 1."""
        return np.asarray((times - self.start) / (self.end - self.start))


def sample_times(function: SatisfactionFunction, start: float, end: float, count: int = 400) -> Floats:
    """Give times to draw a function at: evenly, and on both sides of its kinks."""
    kinks = np.asarray([kink for kink in function.kinks if start <= kink <= end][:200], float)
    around = np.concatenate([np.nextafter(kinks, -np.inf), kinks, np.nextafter(kinks, np.inf)])
    return np.union1d(np.linspace(start, end, count), around)


def window_of(function: SatisfactionFunction, start: float = 0.0) -> tuple[float, float]:
    """Give a stretch of time that shows a function whole, from now or from where it begins to matter."""
    window = function.acceptable(0.01)
    if window.empty:
        return start, start + 600.0
    high = window.high if np.isfinite(window.high) else max(window.low, start) + 3600.0
    low = max(start, window.low if np.isfinite(window.low) else start)
    margin = max(0.08 * (high - min(low, start)), 10.0)
    near_now = low - start < 2 * (high - low)
    return (start if near_now else low - margin), high + margin


def satisfaction_panel(function: SatisfactionFunction, start: float, end: float) -> Panel:
    """Give the panel of one satisfaction function."""
    times = sample_times(function, start, end)
    return Panel("ψ: satisfaction with a start at that time", (Curve("ψ", times, function(times)),))
