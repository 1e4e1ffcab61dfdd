"""Good start times for a fixed order on one agent, whatever the curves: dynamic programming over candidates.

With s_k = t_k − D_k, D_k the durations before k, the s_k of a schedule must not decrease. Over a common list
of candidate values of s,

    F_k(s) = f_k(s + D_k) + min over s' ≤ s of F_k−1(s')

finds the best ones in one sweep; jobs without idle time between them share one s exactly. Candidates are
samples about a given timing, corners of curves and ends of windows; then samples about the new timing, closer
and closer.
"""

from collections.abc import Sequence

import numpy as np

from fuzzytime.satisfaction import Floats, Interval
from fuzzytime.scheduling.problem.jobs import Job

SAMPLES = 17
"""Candidates that each job adds in a round."""

SHRINK = 0.25
"""From one round to the next, how much closer the samples come."""

PRECISION = 1e-9
"""The distance of samples at which the search ends, relative to the times' size."""


def searched(
    jobs: Sequence[Job], windows: Sequence[Sequence[Interval]], hints: Floats, radius: float
) -> Floats | None:
    """Give start times that no near ones better, or None where the jobs do not fit near the hints.

    Parameters
    ----------
    jobs, windows
        In their order, each with the windows in which it may start.
    hints : array of shape (jobs,)
        Start times to begin with; they need not fit.
    radius
        How far from them to look, in seconds.
    """
    before = np.concatenate([[0.0], np.cumsum([job.duration for job in jobs])])[:-1]
    ends = [np.array([(window.low, window.high) for window in mine]) for mine in windows]
    corners = [
        np.unique(np.concatenate([span.ravel(), np.asarray(job.function.kinks)]))
        for job, span in zip(jobs, ends, strict=True)
    ]
    centres, best = hints - before, None
    smallest = PRECISION * max(1.0, float(np.abs(hints).max(initial=0.0)))
    while True:
        found = _round(jobs, ends, corners, before, centres, radius)
        if found is None and best is None:
            return None
        if found is not None:
            best = centres = found
        if radius <= smallest:
            if best is None:
                return None
            return np.array([_at_corner(*pair)[()] for pair in zip(best + before, corners, strict=True)])
        radius *= SHRINK


def _round(
    jobs: Sequence[Job],
    ends: Sequence[Floats],
    corners: Sequence[Floats],
    before: Floats,
    centres: Floats,
    radius: float,
) -> Floats | None:
    """One sweep over all candidates within the radius of each job's centre."""
    samples = [centres + share * radius for share in np.linspace(-1, 1, SAMPLES)]
    shifted = [corner - offset for corner, offset in zip(corners, before, strict=True)]
    near = [
        corner[np.abs(corner - centre) <= radius] for corner, centre in zip(shifted, centres, strict=True)
    ]
    values = np.unique(np.concatenate([*samples, *near]))
    tables, choices = [], []
    so_far = np.zeros(values.size)
    for job, spans, corner, offset, centre in zip(jobs, ends, corners, before, centres, strict=True):
        low = np.searchsorted(values, centre - 1.01 * radius)
        high = np.searchsorted(values, centre + 1.01 * radius, "right")
        times = _at_corner(values[low:high] + offset, corner)
        window = np.maximum(np.searchsorted(spans[:, 0], times, "right") - 1, 0)
        inside = (times >= spans[window, 0]) & (times <= spans[window, 1])
        cost = np.full(values.size, np.inf)
        cost[low:high] = np.where(inside, job.costs(times) + so_far[low:high], np.inf)
        tables.append(cost)
        so_far = np.minimum.accumulate(cost)
        choices.append(so_far)
    if not np.isfinite(so_far[-1]):
        return None
    found, last = np.empty(len(jobs)), values.size - 1
    for index in range(len(jobs) - 1, -1, -1):
        last = int(np.argmax(tables[index][: last + 1] <= choices[index][last]))
        found[index] = values[last]
    return found


def _at_corner(times: Floats, corners: Floats) -> Floats:
    """Put times that differ from a corner by rounding only on it: beyond it a curve may jump."""
    following = np.minimum(np.searchsorted(corners, times), corners.size - 1)
    nearest = np.where(
        np.abs(corners[following] - times) < np.abs(corners[np.maximum(following - 1, 0)] - times),
        corners[following],
        corners[np.maximum(following - 1, 0)],
    )
    return np.where(np.abs(nearest - times) <= 1e-12 * np.maximum(1.0, np.abs(times)), nearest, times)
