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
from fuzzytime.scheduling.problem.grid import ROUNDING, Ints
from fuzzytime.scheduling.problem.jobs import Lag, Problem
from fuzzytime.scheduling.problem.windows import in_common

WORTHWHILE = 0.02
"""The share of orders that a round over all pairs must find, for another one."""

MOST_JOBS = 120
"""Up to so many all pairs are worth comparing."""

STRICTLY = 1e-8
"""By so much, as a share of costs, an equally long job with a higher index must gain to come first."""


class Dominance:
    """What is known to come before what, and in which cells between slots each job may start.

    Parameters
    ----------
    problem
        One agent's, in which only the order counts (`fuzzytime.scheduling.search.dynasearch`) and nothing is
        rejected.
    step
        Seconds between the moments at which costs are compared.
    """

    def __init__(self, problem: Problem, step: float) -> None:
        jobs = problem.jobs
        self.ready, self.step = jobs[0].earliest, step
        durations = np.array([job.duration for job in jobs]) / step
        self.durations: Ints = np.rint(durations).astype(np.int64)
        self.end = int(self.durations.sum())
        self.before = np.zeros((durations.size, durations.size), bool)
        self.possible = np.ones((durations.size, self.end), bool)
        off = np.abs(durations - self.durations) > ROUNDING * np.maximum(1.0, durations)
        # Where the step does not divide all durations nothing is deduced.
        self.knows = bool(self.durations.all()) and not off.any()
        if self.knows:
            self._work_out_costs(problem)

    def _work_out_costs(self, problem: Problem) -> None:
        """Work out what each job costs at slots, and how much more or less between them."""
        times, jobs = self.ready + self.step * np.arange(self.end + 1), problem.jobs
        costs = np.array([np.where((c := job.costs(times)) < job.worst, c, job.rejection) for job in jobs])
        errors = np.array([job.weight * cell_chord_errors(job.function, times) for job in jobs])
        self.costs, self.errors = costs, np.minimum(errors, np.diff(costs))
        # In a cell the cost is at most what its chord says, but where it jumps to that of rejection.
        jump = costs[:, 1:] >= np.array([[job.rejection] for job in jobs])
        self.most = np.hstack([np.where(jump, costs[:, 1:], costs[:, :-1]), costs[:, -1:]])

    def tightened(self, problem: Problem) -> Problem:
        """Give the problem, whose windows may be narrowed already, with orders as lags and fewer starts."""
        # Where nothing is left of a window no schedule is better than the known one; the bound finds that.
        if not self.knows or not all(any(job.windows) for job in problem.jobs):
            return problem
        self._narrow(problem)
        while self._deduce() > WORTHWHILE * np.count_nonzero(self.before):
            pass
        return self._applied(problem)

    def _narrow(self, problem: Problem) -> None:
        for index, job in enumerate(problem.jobs):
            left = np.zeros(self.end, bool)
            for window in job.windows[0]:
                low = math.floor((window.low - self.ready) / self.step + ROUNDING)
                high = math.ceil((window.high - self.ready) / self.step - ROUNDING)
                left[max(low, 0) : max(high, low + 1)] = True
            self.possible[index] &= left

    def _deduce(self) -> int:
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

    def _applied(self, problem: Problem) -> Problem:
        """Give the problem with the orders as lags, and windows of the cells."""
        jobs = []
        last = self.end - self.durations - (self.before * self.durations).sum(axis=1)
        latest = (self.ready + self.step * last).tolist()
        for job, possible, high in zip(problem.jobs, self.possible, latest, strict=True):
            edges = np.flatnonzero(np.diff(possible, prepend=False, append=False)).reshape(-1, 2)
            times = (self.ready + self.step * edges).tolist()
            runs = [Interval(first, min(end, high)) for first, end in times]
            jobs.append(replace(job, windows=(in_common(job.windows[0], runs) or job.windows[0],)))
        lags = tuple(
            Lag(first, second, problem.jobs[first].duration, math.inf)
            for first, second in np.argwhere(self.before).tolist()
        )
        return replace(problem, jobs=tuple(jobs), lags=lags)
