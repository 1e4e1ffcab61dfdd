"""Round times for an axis."""

import math

MINUTES = (1, 2, 5, 10, 15, 30)
HOURS = (1, 2, 3, 6, 12)
DAYS = (1, 2, 7, 14, 28)
STEPS = (*MINUTES, *(60 * m for m in MINUTES), *(3600 * h for h in HOURS), *(86400 * d for d in DAYS))
"""Distances between ticks that people find round, in seconds."""


def round_times(start: float, end: float, most: int, offset: float = 0.0) -> list[float]:
    """Give at most so many round times from start to end.

    ``offset`` is the distance from the last full hour or day to time 0, so that ticks fall on full minutes.

    >>> round_times(0, 1000, 4)
    [0.0, 300.0, 600.0, 900.0]
    """
    needed = (end - start) / max(1, most)
    step = next((step for step in STEPS if step >= needed), STEPS[-1] * math.ceil(needed / STEPS[-1]))
    first = math.ceil((start + offset) / step)
    last = math.floor((end + offset) / step)
    return [float(index * step - offset) for index in range(first, last + 1)]
