"""The grid: time in slots, and costs on it that bound continuous time from below.

Every start time t lies in a cell [x_k, x_k+1] of the grid x_k = k·step. For a fixed order of the skills and a
fixed cell for each, "the next starts no sooner than the last is done" is a system of differences, which is
totally unimodular: where durations are whole numbers of slots, a linear function on these start times has its
least value at grid points. So if g_i, linear between grid points, lies below f_i, then for every schedule in
continuous time there is one on the grid that costs no more by g: the optimum of g on the grid is a bound in
continuous time. Durations that are no whole number of slots are rounded down, which only lowers the bound.

In each cell g is a line below f: the chord of f lowered by its chord error, or the least f of the cell. Where
a window ends inside a cell, the line must hold on the window only, and the cell's outer end becomes a start.
"""

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from fuzzytime.satisfaction import Floats, Interval, cell_chord_errors
from fuzzytime.scheduling.problem.jobs import Job, Lag, Problem

Ints = NDArray[np.int64]

ROUNDING = 1e-9
"""Shares of a slot that are rounding errors."""

JUMP = 1e-6
"""A cost that changes by more from a time to the next one jumps."""

SLOTS_A_JOB = 8
"""Slots of a grid for each job, at least."""

FINER = 20
"""How much finer than that it may be, so that all durations are whole numbers of slots."""

MOST_STARTS = 2_000_000
"""Starts of all jobs on a grid that is finer than it need be, at most."""


@dataclass(frozen=True, slots=True)
class Curve:
    """What a job costs by g in slots from ``first`` on, less its rejection; inf where it cannot start."""

    first: int
    gains: Floats

    @property
    def stop(self) -> int:
        """One past the last slot."""
        return self.first + self.gains.size

    def between(self, low: float, high: float, origin: int) -> "Curve":
        """Give the part from a slot to another, both included, in slots since an origin."""
        if not low <= high:
            return Curve(0, self.gains[:0])
        first = int(max(self.first, low))
        gains = self.gains[first - self.first : int(max(min(self.stop - 1, high) + 1, first)) - self.first]
        return Curve(first - origin, gains) if gains.size else Curve(0, gains)


@dataclass(frozen=True, slots=True)
class Grid:
    """A problem in slots.

    Parameters
    ----------
    step
        Seconds a slot.
    origin
        The first slot's time in slots since time 0.
    durations : array of shape (jobs,)
        Slots for which each job takes its agent, rounded down.
    rejections : array of shape (jobs,)
        Cost of rejecting each.
    curves
        For each job, for each lane, its curve, which may be empty.
    slots
        The horizon: no job ends later.
    lags
        The problem's in whole slots, wider where they are not: what keeps them in time keeps them here.
    """

    step: float
    origin: int
    durations: Ints
    rejections: Floats
    curves: tuple[tuple[Curve, ...], ...]
    slots: int
    lags: tuple[Lag, ...]

    def fairly_rounded(self, problem: Problem) -> "Grid":
        """Give the grid with durations rounded to the nearest: no bound's, but that of a plan which fits.

        Many skills that are each a little too short for the grid would crowd where not all of them have room.
        """
        exact = np.array([job.duration for job in problem.jobs]) / self.step
        durations = np.rint(exact).astype(np.int64)
        longer = int((durations - self.durations).max(initial=0))
        return replace(self, durations=durations, slots=self.slots + longer)

    def times(self, slots: Ints) -> Floats:
        """Give the start times of slots in seconds."""
        return np.asarray((slots + self.origin) * self.step)


ROUND_STEPS = tuple(
    figure * scale
    for scale in (3600.0, 60.0, 1.0, 1e-2, 1e-4, 1e-6)
    for figure in (30, 20, 10, 5, 2, 1, 0.5, 0.2)
)
"""Steps that people's times are whole numbers of, from long to short."""


def step_for(problem: Problem, slots: int, finer: float = FINER, starts: float = MOST_STARTS) -> float:
    """Give a round step that lays at least so many slots over a problem's horizon, and some for each job.

    Of the steps down to so much finer than the longest such one, as far as they lay no more than some starts,
    the longest that divides all durations is taken; where none does, the longest.
    """
    first = min(job.earliest for job in problem.jobs)
    last = max(job.latest + job.duration for job in problem.jobs)
    span = max(last - first, 1e-4)
    durations = np.array([job.duration for job in problem.jobs])
    slots = max(slots, SLOTS_A_JOB * len(problem.jobs))
    fine = [step for step in sorted(ROUND_STEPS, reverse=True) if step * slots <= span] or [span / slots]
    shortest = max(fine[0] / finer * (1 - ROUNDING), room_of(problem) / starts)
    for step in fine:
        shares = durations / step
        if step < shortest:
            break
        if (np.abs(shares - np.rint(shares)) <= ROUNDING * np.maximum(1.0, shares)).all():
            return step
    return fine[0]


def room_of(problem: Problem) -> float:
    """Give the seconds in which each job can start, on each lane, in all."""
    return math.fsum(window.length for job in problem.jobs for lane in job.windows for window in lane)


def grid_of(problem: Problem, step: float) -> Grid:
    """Lay a grid over a problem."""
    first = min((job.earliest for job in problem.jobs), default=math.inf)
    origin = _cell(first, step) if first < math.inf else 0
    durations = np.array([math.floor(job.duration / step + ROUNDING) for job in problem.jobs], np.int64)
    leading = {lag.first for lag in problem.lags}
    curves = tuple(
        tuple(_curve(job, windows, step, origin, needed=index in leading) for windows in job.windows)
        for index, job in enumerate(problem.jobs)
    )
    ends = [
        curve.stop - 1 + int(duration)
        for lanes, duration in zip(curves, durations, strict=True)
        for curve in lanes
    ]
    rejections = np.array([job.rejection for job in problem.jobs])
    lags = tuple(_in_slots(lag, step) for lag in problem.lags)
    return Grid(step, origin, durations, rejections, curves, max([0, *ends]), lags)


def _curve(job: Job, windows: tuple[Interval, ...], step: float, begin: int, *, needed: bool) -> Curve:
    """Give g on the slots next to windows, where it is below rejection or another job waits for this one."""
    if not windows:
        return Curve(0, np.empty(0))
    origin = _cell(windows[0].low, step)
    # An instant on the grid has no cell before it.
    last = max(_last_cell(windows[-1].high, step), _cell(windows[-1].low, step))
    cells = last + 1 - origin
    left, right = np.full(cells, np.inf), np.full(cells, np.inf)
    for window in windows:
        first, at_start, at_end = _lines(job, window, step)
        here = slice(first - origin, first - origin + at_start.size)
        np.minimum(left[here], at_start, out=left[here])
        np.minimum(right[here], at_end, out=right[here])
    gains = np.minimum(np.append(left, np.inf), np.insert(right, 0, np.inf)) - job.rejection
    if not needed:
        gains[gains >= 0] = np.inf
    kept = np.flatnonzero(np.isfinite(gains))
    if not kept.size:
        return Curve(0, np.empty(0))
    return Curve(origin - begin + int(kept[0]), gains[kept[0] : kept[-1] + 1])


def _cell(time: float, step: float) -> int:
    return math.floor(time / step + ROUNDING)


def _last_cell(time: float, step: float) -> int:
    return math.ceil(time / step - ROUNDING) - 1


def _in_slots(lag: Lag, step: float) -> Lag:
    high = math.inf if lag.high == math.inf else _last_cell(lag.high, step) + 1
    return replace(lag, low=_cell(lag.low, step), high=high)


def _lines(job: Job, window: Interval, step: float) -> tuple[int, Floats, Floats]:
    """Give a window's first cell, and for each of its cells the values of a line below f at both ends."""
    first = _cell(window.low, step)
    last = max(_last_cell(window.high, step), first)
    edges = step * np.arange(first, last + 2)
    nodes = edges.copy()
    nodes[0], nodes[-1] = window.low, window.high
    if window.low == window.high:
        level = job.costs(nodes[:1])
        return first, level, level
    cost = job.costs(nodes)
    kinks = np.asarray(job.function.kinks)
    kinks = kinks[(kinks > window.low) & (kinks < window.high)]
    least = np.minimum(cost[:-1], cost[1:])
    np.minimum.at(least, np.searchsorted(nodes, kinks, "right") - 1, job.costs(kinks))
    # The chord through the ends of the window's part, drawn on to the ends of the cell.
    with np.errstate(invalid="ignore"):  # A window may end where rounding takes an edge to be.
        slope = np.diff(cost) / np.diff(nodes)
    error = job.weight * cell_chord_errors(job.function, nodes)
    start = cost[:-1] + slope * (edges[:-1] - nodes[:-1]) - error
    end = cost[1:] + slope * (edges[1:] - nodes[1:]) - error
    # What is lost at an end matters as much as somebody would want to start there.
    want = np.exp(-cost / job.weight)
    loss_of_least = want[:-1] * (cost[:-1] - least) + want[1:] * (cost[1:] - least)
    loss_of_chord = want[:-1] * (cost[:-1] - start) + want[1:] * (cost[1:] - end)
    flat = ~(loss_of_chord < loss_of_least)
    # At a jump no chord comes near to both ends, however fine the grid.
    sides = np.stack([np.nextafter(kinks, -np.inf), np.nextafter(kinks, np.inf)])
    jumps = np.ptp(np.vstack([job.costs(kinks), job.costs(sides)]), axis=0) > JUMP
    flat[np.searchsorted(nodes, kinks[jumps], "right") - 1] = True
    return first, np.where(flat, least, start), np.where(flat, least, end)
