"""Orders that some best schedule keeps, where waiting never helps: what they exclude need not be searched.

Let no job's cost fall with time, and i take no longer than j. If j starts at s and i later, at e, swap them:
i starts at s, j at e + dᵢ − dⱼ, and what lies between comes no later. That costs no more if

    cᵢ(s) + cⱼ(e + dᵢ − dⱼ) ≤ cⱼ(s) + cᵢ(e).

Where this holds for all s and e that are left, i comes before j in some best schedule. All such orders hold
at once in one of them: among the best schedules the one with the least sum of start times and, of equally
long jobs, the lower index first. Orders narrow windows, as whatever comes before takes its time, and narrower
windows give more orders.

Rinnooy Kan, Lageweg and Lenstra, Minimizing total costs in one-machine scheduling, Oper. Res. 23 (1975)
908-927, after Emmons, Oper. Res. 17 (1969) 701-715.
"""

import math
from dataclasses import replace

import numpy as np

from fuzzytime.satisfaction import Interval, cell_chord_errors
from fuzzytime.scheduling.grid import ROUNDING, Ints
from fuzzytime.scheduling.problem import Lag, Problem

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
    while orders.deduce():
        pass
    return orders.applied(problem)


class _Orders:
    """What is known to come before what, and from which slot to which each job may start."""

    def __init__(self, problem: Problem, ready: float, step: float, durations: Ints) -> None:
        self.ready, self.step, self.durations = ready, step, durations
        self.before = np.zeros((durations.size, durations.size), bool)
        for lag in problem.lags:
            self.before[lag.first, lag.second] = True
        self.end = int(durations.sum())
        lows = np.array([job.earliest for job in problem.jobs])
        highs = np.array([job.latest for job in problem.jobs])
        self.low = np.maximum(np.floor((lows - ready) / step + ROUNDING), 0).astype(np.int64)
        highest = np.ceil((highs - ready) / step - ROUNDING)
        self.high = np.minimum(highest, self.end - durations).astype(np.int64)
        times = ready + step * np.arange(self.end + 1)
        jobs = problem.jobs
        costs = np.array([np.where((c := job.costs(times)) < job.worst, c, job.rejection) for job in jobs])
        errors = np.array([job.weight * cell_chord_errors(job.function, times) for job in jobs])
        self.costs, self.errors = costs, np.minimum(errors, np.diff(costs))
        # In a cell the cost is at most what its chord says, but where it jumps to that of rejection.
        jump = costs[:, 1:] >= np.array([[job.rejection] for job in jobs])
        self.most = np.hstack([np.where(jump, costs[:, 1:], costs[:, :-1]), costs[:, -1:]])

    def deduce(self) -> bool:
        """Go once over all pairs; tell whether an order was found."""
        known = int(np.count_nonzero(self.before))
        work = self.before * self.durations[:, None]
        self.low = np.maximum(self.low, work.sum(axis=0))
        after = (self.before * self.durations).sum(axis=1)
        self.high = np.minimum(self.high, self.end - self.durations - after)
        longer = self.durations[:, None] <= self.durations
        for first, second in np.argwhere(longer & ~self.before & ~self.before.T).tolist():
            if first != second and not self.before[second, first] and self._suffices(first, second):
                self.before[first, second] = True
        for middle in range(self.durations.size):
            self.before |= np.outer(self.before[:, middle], self.before[middle])
        return int(np.count_nonzero(self.before)) > known

    def _suffices(self, first: int, second: int) -> bool:
        """Tell whether schedules are enough in which a job comes before another one that is no shorter."""
        own, other = self.durations[first], self.durations[second]
        begin, stop = int(self.low[second]), int(min(self.high[second], self.high[first] - other))
        if begin > stop or self.low[first] > self.high[first]:
            return True
        equal = own == other and first > second
        late = np.arange(max(int(self.low[first]), begin + int(other)), int(self.high[first]) + 1)
        soon = np.arange(begin, stop + 1)
        costs, errors, most = self.costs, self.errors, self.most
        # In a cell both differences lie between those at its ends, but for how far costs bend.
        saved = costs[first, late] - most[second, late + own - other]
        saved[:-1] = np.minimum(saved[:-1], saved[1:]) - errors[first, late[:-1]]
        paid = most[first, soon] - costs[second, soon]
        paid[:-1] = np.maximum(paid[:-1], paid[1:]) + errors[second, soon[:-1]]
        least = np.minimum.accumulate(saved[::-1])[::-1]
        least = least[np.maximum(soon + other - late[0], 0)]
        slack = STRICTLY if equal else -ROUNDING
        return bool((least >= paid + slack * (1.0 + np.abs(paid))).all())

    def applied(self, problem: Problem) -> Problem:
        """Give the problem with these orders as lags, and windows between these slots."""
        lows = (self.ready + self.step * self.low).tolist()
        highs = (self.ready + self.step * self.high).tolist()
        jobs = []
        for job, low, high in zip(problem.jobs, lows, highs, strict=True):
            pieces = (
                [window.intersection(Interval(low, high)) for window in job.windows[0]] if low <= high else []
            )
            left = tuple(piece for piece in pieces if not piece.empty)
            # Where nothing is left no schedule is better than the known one; the bound finds that, too.
            jobs.append(replace(job, windows=(left or job.windows[0],)))
        lags = tuple(
            Lag(first, second, problem.jobs[first].duration, math.inf)
            for first, second in np.argwhere(self.before).tolist()
        )
        return replace(problem, jobs=tuple(jobs), lags=lags)
