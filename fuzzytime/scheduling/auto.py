"""The solver that picks: exact where it can be, else a sound heuristic."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from fuzzytime.scheduling.grid import grid_of, step_for
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.local_search import Rough
from fuzzytime.scheduling.problem import Problem
from fuzzytime.scheduling.settle import settled
from fuzzytime.scheduling.small import HeldKarp, why_not
from fuzzytime.scheduling.solver import Draft, nothing

EXACT_JOBS = 12
"""Up to so many skills Held-Karp is fast."""


@dataclass(frozen=True, slots=True)
class LocalSearch:
    """Reinsertion local search on a grid, timed in continuous time; no bound.

    Parameters
    ----------
    seed
        Of the order in which jobs are tried.
    slots
        Slots of the grid, at least.
    """

    name: ClassVar[str] = "local-search"

    seed: int = 0
    slots: int = 1500

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Improve until no job is better elsewhere."""
        begin = warm or nothing(problem)
        grid = grid_of(problem, step_for(problem, self.slots))
        plan = Rough(problem, grid, begin)
        plan.improve(watch, np.random.default_rng(self.seed))
        hints = np.where(plan.placed, grid.times(np.array(plan.slots, np.int64)), np.nan)
        draft = settled(problem, hints, np.array(plan.agents, np.int64), 4 * grid.step)
        return draft if draft.cost < begin.cost else begin


@dataclass(frozen=True, slots=True)
class Auto:
    """Held-Karp for few skills, else local search."""

    name: ClassVar[str] = "auto"

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Solve by the best method for the problem."""
        quick = LocalSearch().search(problem, watch.share(0.5), warm)
        if len(problem.jobs) <= EXACT_JOBS and not why_not(problem, watch.limits.memory):
            return HeldKarp().search(problem, watch, quick)
        return quick
