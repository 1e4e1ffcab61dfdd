"""Fewer points for a curve, none of them far from it."""

import numpy as np

from fuzzytime.satisfaction import Floats

MOST_POINTS = 2000


def thinned(times: Floats, values: Floats, tolerance: float = 1e-4) -> tuple[Floats, Floats]:
    """Leave out points that lie within a tolerance of the line between those that stay.

    The first and the last of the highest points stay: nobody is to wait for a last part in ten thousand.

    One pass: from each point that stays, the cone of slopes that pass all points since is narrowed until it
    is empty (Reumann & Witkam 1974; the cone variant). The tolerance grows while more than `MOST_POINTS`
    remain.

    Parameters
    ----------
    times, values : array of shape (k,)
        The curve, by times that do not decrease.
    """
    highest = np.flatnonzero(values == values.max())[[0, -1]].tolist()
    kept = _kept(times.tolist(), values.tolist(), tolerance, highest)
    while len(kept) > MOST_POINTS:
        tolerance *= 4
        kept = _kept(times.tolist(), values.tolist(), tolerance, highest)
    return times[kept], values[kept]


def _kept(times: list[float], values: list[float], tolerance: float, always: list[int]) -> list[int]:
    kept = [0]
    low, high = -np.inf, np.inf
    for i in range(1, len(times)):
        anchor = kept[-1]
        span = times[i] - times[anchor]
        if i - 1 > anchor:
            # The point before i must lie near the line from the anchor to i: that is what the cone says.
            slope = (values[i] - values[anchor]) / span
            if i - 1 in always or not low <= slope <= high:
                kept.append(i - 1)
                anchor, span = i - 1, times[i] - times[i - 1]
                low, high = -np.inf, np.inf
        if span > 0:
            low = max(low, (values[i] - tolerance - values[anchor]) / span)
            high = min(high, (values[i] + tolerance - values[anchor]) / span)
    if len(times) > 1:
        kept.append(len(times) - 1)
    return kept
