"""Orders that some best schedule keeps, where waiting never helps: what they exclude need not be searched.

Let no job's cost fall with time, and i take no longer than j. If j starts at s and i later, at e, swap them:
i starts at s, j at e + dᵢ − dⱼ, and what lies between comes no later. That costs no more if

    cᵢ(s) + cⱼ(e + dᵢ − dⱼ) ≤ cⱼ(s) + cᵢ(e).

Where this holds for all s and e that are left, i comes before j in some best schedule. Where it holds for one
s and all e, i comes before j if j starts at s; so that s needs time for all such i. All that holds at once
for one schedule: among the best ones the one with the least sum of start times and, of equally long jobs, the
lower index first. What must come before takes its time, which leaves fewer starts, and fewer starts give more
orders.

Rinnooy Kan, Lageweg and Lenstra, Minimizing total costs in one-machine scheduling, Oper. Res. 23 (1975)
908-927, after Emmons, Oper. Res. 17 (1969) 701-715.
"""

import math
from dataclasses import replace

import numpy as np

from fuzzytime.satisfaction import Interval, cell_chord_errors
from fuzzytime.scheduling.grid import ROUNDING, Ints
from fuzzytime.scheduling.problem import Lag, Problem

WORTHWHILE = 0.02
"""The share of orders that a round over all pairs must find, for another one."""

STRICTLY = 1e-8
"""By so much, as a share of costs, an equally long job with a higher index must gain to come first."""


def ordered(problem: Problem, ready: float, step: float) -> Problem:
    """Give a problem with the orders that some best schedule keeps as lags, and windows cut by them.

    Parameters
    ----------
    problem
        One agent's, in which only the order counts (`fuzzytime.scheduling.dynasearch`) and nothing is
        rejected; windows may be narrowed already, and orders known.
    ready
        When all jobs are ready, in seconds.
    step
        Seconds between the moments at which costs are compared. Where it does not divide all durations, or
        nothing is left of a window, the problem is given back as it is.
    """
    if not all(any(job.windows) for job in problem.jobs):
        return problem
    durations = np.array([job.duration for job in problem.jobs]) / step
    slots = np.rint(durations).astype(np.int64)
    if not slots.all() or (np.abs(durations - slots) > ROUNDING * np.maximum(1.0, durations)).any():
        return problem
    orders = _Orders(problem, ready, step, slots)
    while orders.deduce() > WORTHWHILE * np.count_nonzero(orders.before):
        pass
    return orders.applied(problem)


class _Orders:
    """What is known to come before what, and in which cells between slots each job may start."""

    def __init__(self, problem: Problem, ready: float, step: float, durations: Ints) -> None:
        self.ready, self.step, self.durations = ready, step, durations
        self.before = np.zeros((durations.size, durations.size), bool)
        for lag in problem.lags:
            self.before[lag.first, lag.second] = True
        self.end = int(durations.sum())
        self.possible = np.zeros((durations.size, self.end), bool)
        for row, job in zip(self.possible, problem.jobs, strict=True):
            for window in job.windows[0]:
                low = math.floor((window.low - ready) / step + ROUNDING)
                high = math.ceil((window.high - ready) / step - ROUNDING)
                row[max(low, 0) : max(high, low + 1)] = True
        times = ready + step * np.arange(self.end + 1)
        jobs = problem.jobs
        costs = np.array([np.where((c := job.costs(times)) < job.worst, c, job.rejection) for job in jobs])
        errors = np.array([job.weight * cell_chord_errors(job.function, times) for job in jobs])
        self.costs, self.errors = costs, np.minimum(errors, np.diff(costs))
        # In a cell the cost is at most what its chord says, but where it jumps to that of rejection.
        jump = costs[:, 1:] >= np.array([[job.rejection] for job in jobs])
        self.most = np.hstack([np.where(jump, costs[:, 1:], costs[:, :-1]), costs[:, -1:]])

    def deduce(self) -> int:
        """Go once over all pairs; tell how many orders were found."""
        known, durations = int(np.count_nonzero(self.before)), self.durations
        # For each job and cell: the work that must come before a start there, and after it.
        earlier = np.repeat((self.before * durations[:, None]).sum(axis=0)[:, None], self.end, axis=1)
        later = np.repeat((self.before * durations).sum(axis=1)[:, None], self.end, axis=1)
        longer = durations[:, None] <= durations
        for first, second in np.argwhere(longer & ~self.before & ~self.before.T).tolist():
            if first == second or self.before[second, first]:
                continue
            needed, needing = self._compared(first, second)
            if needed[self.possible[second]].all():
                self.before[first, second] = True
            earlier[second] += needed * durations[first]
            later[first] += needing * durations[second]
        for middle in range(durations.size):
            self.before |= np.outer(self.before[:, middle], self.before[middle])
        cells = np.arange(self.end)
        self.possible &= (earlier <= cells) & (cells + durations[:, None] + later <= self.end)
        return int(np.count_nonzero(self.before)) - known

    def _compared(self, first: int, second: int) -> tuple[np.ndarray, np.ndarray]:
        """Tell of a job and one that is no shorter where the first must come before the second.

        Gives for each cell whether that is so if the second starts there, and if the first does.
        """
        own, other = int(self.durations[first]), int(self.durations[second])
        equal = own == other and first > second
        costs, errors, most = self.costs, self.errors, self.most
        # In a cell both differences lie between those at its ends, but for how far costs bend.
        paid = most[first] - costs[second]
        paid = np.maximum(paid[:-1], paid[1:]) + errors[second]
        paid += (STRICTLY if equal else -ROUNDING) * (1.0 + np.abs(paid))
        saved = costs[first, other:] - most[second, own : self.end + 1 + own - other]
        saved = np.minimum(saved[:-1], saved[1:]) - errors[first, other:]
        paid[~self.possible[second]] = -np.inf
        saved[~self.possible[first, other:]] = np.inf
        least = np.minimum.accumulate(saved[::-1])[::-1]
        largest = np.maximum.accumulate(paid)
        # A start in a cell leaves those of the other job that begin in the cell a duration further, or later.
        needed, needing = np.ones(self.end, bool), np.ones(self.end, bool)
        needed[: least.size] = least >= paid[: least.size]
        needing[other:] = saved >= largest[: saved.size]
        return needed, needing

    def applied(self, problem: Problem) -> Problem:
        """Give the problem with these orders as lags, and windows of these cells."""
        jobs = []
        last = self.end - self.durations - (self.before * self.durations).sum(axis=1)
        latest = (self.ready + self.step * last).tolist()
        for job, possible, high in zip(problem.jobs, self.possible, latest, strict=True):
            edges = np.flatnonzero(np.diff(possible, prepend=False, append=False)).reshape(-1, 2)
            times = (self.ready + self.step * edges).tolist()
            runs = [Interval(first, min(end, high)) for first, end in times]
            pieces = [window.intersection(run) for window in job.windows[0] for run in runs]
            left = tuple(piece for piece in pieces if not piece.empty)
            # Where nothing is left no schedule is better than the known one; the bound finds that, too.
            jobs.append(replace(job, windows=(left or job.windows[0],)))
        lags = tuple(
            Lag(first, second, problem.jobs[first].duration, math.inf)
            for first, second in np.argwhere(self.before).tolist()
        )
        return replace(problem, jobs=tuple(jobs), lags=lags)
