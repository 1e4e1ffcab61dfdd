"""Start times under any lags between jobs: by linear programs on ever smaller neighbourhoods.

Within a neighbourhood of a timing each cost is replaced by the lower convex hull of its samples, so that the
best timing there is a linear program; the next neighbourhood is smaller, about the answer. Jobs that the lags
then hold together move as one, each such group to its best start, which takes away what a linear program
leaves to rounding.
"""

from collections.abc import Sequence

import numpy as np

from fuzzytime.satisfaction import Floats, Interval
from fuzzytime.scheduling.problem.jobs import Job, Lag
from fuzzytime.scheduling.timing.chains import Block, best_start

SAMPLES = 9
"""Times at which each cost is sampled in a round."""

SHRINK = 0.3
"""The radius of a neighbourhood over that of the one before."""

TIGHT = 1e-6
"""Lags that are this close to their bound, relative to the first radius, hold jobs together."""


def coupled(
    jobs: Sequence[Job], windows: Sequence[Interval], lags: Sequence[Lag], hints: Floats, radius: float
) -> Floats | None:
    """Give start times near hints that keep all lags, or None where there are none.

    Parameters
    ----------
    jobs, windows
        What to time, and the interval for each start.
    lags
        All that binds starts, the order on each agent included.
    hints : array of shape (jobs,)
        Times to begin with; they need not keep the lags.
    radius
        How far from them to look, in seconds.
    """
    smallest = TIGHT * radius
    best, least, centre = None, np.inf, hints
    while radius > smallest / 10:
        near = [
            Interval(max(window.low, time - radius), min(window.high, time + radius))
            for window, time in zip(windows, centre.tolist(), strict=True)
        ]
        found = None if any(span.empty for span in near) else _linear(jobs, near, lags)
        if found is None:
            break
        cost = _cost(jobs, found)
        if cost < least:
            best, least = found, cost
        centre = best if best is not None else found
        radius *= SHRINK
    return None if best is None else _settled(jobs, windows, lags, best, smallest)


def _cost(jobs: Sequence[Job], starts: Floats) -> float:
    return sum(float(job.costs(start)) for job, start in zip(jobs, starts, strict=True))


def _linear(jobs: Sequence[Job], near: Sequence[Interval], lags: Sequence[Lag]) -> Floats | None:
    """Minimise Σ z_k with z_k above the hull's lines at t_k, for t in the neighbourhood."""
    from scipy.optimize import Bounds, LinearConstraint, milp
    from scipy.sparse import csr_array

    count = len(jobs)
    entries: list[tuple[float, int, float, int, float]] = []  # a·x[i] + b·x[j] ≤ c
    for index, (job, span) in enumerate(zip(jobs, near, strict=True)):
        for slope, level in _hull(job, span):
            entries.append((slope, index, -1.0, count + index, -level))
    for lag in lags:
        entries.append((1.0, lag.first, -1.0, lag.second, -lag.low))
        if np.isfinite(lag.high):
            entries.append((1.0, lag.second, -1.0, lag.first, lag.high))
    rows = np.repeat(np.arange(len(entries)), 2)
    columns = np.array([(entry[1], entry[3]) for entry in entries]).ravel()
    values = np.array([(entry[0], entry[2]) for entry in entries]).ravel()
    matrix = csr_array((values, (rows, columns)), shape=(len(entries), 2 * count))
    limit = np.array([entry[4] for entry in entries])
    lows = np.concatenate([[span.low for span in near], np.full(count, -np.inf)])
    highs = np.concatenate([[span.high for span in near], np.full(count, np.inf)])
    answer = milp(
        np.repeat([0.0, 1.0], count),
        constraints=LinearConstraint(matrix, -np.inf, limit),
        bounds=Bounds(lows, highs),
    )
    return None if answer.x is None else np.asarray(answer.x[:count])


def _hull(job: Job, span: Interval) -> list[tuple[float, float]]:
    """Give the lower convex hull of a cost's samples as lines: slope, and level at time 0."""
    kinks = [kink for kink in job.function.kinks if span.low < kink < span.high]
    times = np.unique(np.concatenate([np.linspace(span.low, span.high, SAMPLES), kinks]))
    cost = job.costs(times)
    hull: list[int] = []
    for index in range(times.size):
        while len(hull) > 1:
            last, before = hull[-1], hull[-2]
            reach = (cost[index] - cost[before]) * (times[last] - times[before])
            if (cost[last] - cost[before]) * (times[index] - times[before]) < reach:
                break
            hull.pop()
        hull.append(index)
    if len(hull) == 1:
        return [(0.0, float(cost[0]))]
    slopes = np.diff(cost[hull]) / np.diff(times[hull])
    return [
        (float(slope), float(cost[place] - slope * times[place]))
        for slope, place in zip(slopes, hull, strict=False)
    ]


def _settled(
    jobs: Sequence[Job], windows: Sequence[Interval], lags: Sequence[Lag], starts: Floats, tight: float
) -> Floats:
    """Move each group that lags hold together to its best start, keeping lags to the others."""
    group = list(range(len(jobs)))
    offset = [0.0] * len(jobs)
    for lag in lags:
        gap = starts[lag.second] - starts[lag.first]
        held = lag.low if gap - lag.low <= tight else lag.high if lag.high - gap <= tight else None
        old, new = group[lag.second], group[lag.first]
        if held is not None and old != new:
            shift = offset[lag.first] + held - offset[lag.second]
            for member in range(len(jobs)):
                if group[member] == old:
                    group[member], offset[member] = new, offset[member] + shift
    settled = starts.copy()
    for _ in range(2):
        for root in sorted(set(group), key=lambda label: settled[group.index(label)]):
            members = [member for member in range(len(jobs)) if group[member] == root]
            low = max(windows[member].low - offset[member] for member in members)
            high = min(windows[member].high - offset[member] for member in members)
            for lag in lags:
                if group[lag.second] == root != group[lag.first]:
                    low = max(low, settled[lag.first] + lag.low - offset[lag.second])
                    high = min(high, settled[lag.first] + lag.high - offset[lag.second])
                if group[lag.first] == root != group[lag.second]:
                    low = max(low, settled[lag.second] - lag.high - offset[lag.first])
                    high = min(high, settled[lag.second] - lag.low - offset[lag.first])
            start = best_start(jobs, Block(members, [offset[member] for member in members], low, high))
            for member in members:
                settled[member] = start + offset[member]
    return settled
