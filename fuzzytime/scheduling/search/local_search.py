"""Local search over who does what in which order: a rough plan on a grid, then times in continuous time."""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import grid_of, step_for
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.search.dynasearch import MOST_JOBS, Dynasearch, only_order_counts
from fuzzytime.scheduling.search.kicks import kick
from fuzzytime.scheduling.search.rough import Rough
from fuzzytime.scheduling.search.warm import one_by_one
from fuzzytime.scheduling.solver import Draft, nothing
from fuzzytime.scheduling.timing.settle import settled


@dataclass(frozen=True, slots=True)
class LocalSearch:
    """Reinsertion local search on a grid, timed in continuous time; no bound.

    Parameters
    ----------
    seed
        Of the order in which jobs are tried.
    slots
        Slots of the grid, at least.
    kicks
        How many.
    sweeps
        How often all jobs are tried at most: fewer than it takes is quick, and leaves work to do.
    """

    name: ClassVar[str] = "local-search"

    seed: int = 0
    slots: int = 1500
    kicks: int = 0
    sweeps: float = math.inf

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Improve until no job is better elsewhere; where only the order counts, by dynasearch."""
        if len(problem.jobs) <= MOST_JOBS and only_order_counts(problem):
            return Dynasearch(self.seed, self.slots).search(problem, watch, warm)
        begin = warm or nothing(problem)
        if not problem.lags:
            return self._improved(problem, watch, begin)
        # Where each waits for another, few can be put in at a time; but the best begin may lead nowhere.
        in_turn, urgent = one_by_one(problem), one_by_one(problem, urgent=True)
        if all(lag.high == math.inf for lag in problem.lags) and in_turn.cost < begin.cost:
            begin = in_turn
        other = min(in_turn, urgent, key=lambda draft: draft.cost)
        begins = [begin] if other is begin else sorted((begin, other), key=lambda draft: draft.cost)
        return min((self._improved(problem, watch, one) for one in begins), key=lambda draft: draft.cost)

    def _improved(self, problem: Problem, watch: Stopwatch, begin: Draft) -> Draft:
        grid = grid_of(problem, step_for(problem, self.slots)).fairly_rounded(problem)
        plan = Rough(problem, grid, begin)
        try:
            generator = np.random.default_rng(self.seed)
            plan.improve(watch, generator, self.sweeps)
            kick(plan, self.kicks, watch, generator)
        except KeyboardInterrupt:
            watch.stop()
        hints = np.where(plan.placed, grid.times(np.array(plan.slots, np.int64)), np.nan)
        draft = settled(problem, hints, np.array(plan.agents, np.int64), 4 * grid.step)
        return draft if draft.cost < begin.cost else begin
