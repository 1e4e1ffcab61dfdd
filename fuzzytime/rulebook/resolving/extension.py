"""Adding fuzzy times by the extension principle: "five minutes after" a moment that is itself fuzzy."""

import numpy as np

from fuzzytime.satisfaction import NEVER, Interval, Sampled, SatisfactionFunction, Trapezoid

_LEVELS = 64
_LEAST = 1e-6


def added(first: SatisfactionFunction, second: SatisfactionFunction) -> SatisfactionFunction:
    """Give sup over s + d = t of min(ψ₁(s), ψ₂(d)).

    For trapezoids the corners add. In general the intervals on which each is at least α add, at every level
    α: exact for functions that rise once and fall once, an upper bound for others.

    >>> added(Trapezoid(0, 10, 20, 30), Trapezoid(100, 100, 100, 100)).parameters
    {'rise_start': 100, 'full_start': 110, 'full_end': 120, 'fall_end': 130}
    """
    if isinstance(first, Trapezoid) and isinstance(second, Trapezoid):
        return Trapezoid(*(one + other for one, other in zip(first.corners, second.corners, strict=True)))
    peak = min(_peak(first), _peak(second))
    if peak <= 0:
        return NEVER
    levels = np.linspace(_LEAST, peak, _LEVELS)
    cuts = [_sum(first.acceptable(level), second.acceptable(level)) for level in levels.tolist()]
    rising = [(cut.low, level) for level, cut in zip(levels.tolist(), cuts, strict=True)]
    falling = [(cut.high, level) for level, cut in zip(levels.tolist(), cuts, strict=True)]
    points = [*_flank(rising), *reversed(_flank(falling))]
    # A moment without a plateau is in both flanks.
    kept = [point for i, point in enumerate(points) if i == 0 or point != points[i - 1]]
    if kept[0][0] == kept[-1][0]:
        return Sampled((kept[0][0],), (peak,))
    return Sampled([time for time, _ in kept], [value for _, value in kept])


def _flank(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """Keep of the points at one time the lowest and the highest: a jump."""
    last = len(points) - 1
    return [
        point
        for i, point in enumerate(points)
        if i in (0, last) or not points[i - 1][0] == point[0] == points[i + 1][0]
    ]


def _sum(first: Interval, second: Interval) -> Interval:
    return Interval(first.low + second.low, first.high + second.high)


def _peak(function: SatisfactionFunction) -> float:
    best = function.best
    return 0.0 if best.empty else float(function(best.high if np.isfinite(best.high) else best.low))
