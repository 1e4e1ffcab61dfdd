"""Several agents, and lags of any kind: a mixed-integer program over the starts that the bound leaves.

The relaxation gives a bound at once, and with a good schedule deletes most starts. What is left goes to HiGHS
as a flow through time (`fuzzytime.scheduling.flow`). Where too many starts are left, only those with a low
reduced cost go: the program then proves the least cost of all schedules below their threshold. As every bound
is one on the grid's costs, which lie below those in continuous time, it holds there.

Huangfu and Hall, Parallelizing the dual revised simplex method, Math. Program. Comput. 10 (2018) 119-142.
"""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from fuzzytime.scheduling.flow import Flow
from fuzzytime.scheduling.grid import Grid, Ints, grid_of, step_for
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.local_search import LocalSearch
from fuzzytime.scheduling.paths import Arcs
from fuzzytime.scheduling.problem import Problem
from fuzzytime.scheduling.relaxation import Relaxation
from fuzzytime.scheduling.schedule import OPTIMAL_GAP
from fuzzytime.scheduling.settle import settled
from fuzzytime.scheduling.solver import Draft

FIRST_SLOTS = 1000
"""Slots of the first grid, at least."""

REFINEMENT = 2
"""How much finer the next grid is, where the gap is too large."""

STEPS = 40
"""Evaluations of the bound between two deletions of starts."""

MOST_ARCS = 20_000
"""Starts in one program."""


@dataclass(frozen=True, slots=True)
class Milp:
    """Exact for any task, as far as time goes; always with a bound.

    Parameters
    ----------
    arcs
        Starts in one program, at most.
    """

    name: ClassVar[str] = "milp"

    arcs: int = MOST_ARCS

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Bound and solve grid after grid."""
        best = warm or LocalSearch().search(problem, watch.share(0.3))
        goal, step = OPTIMAL_GAP * problem.weight, step_for(problem, FIRST_SLOTS)
        relaxation = Relaxation(problem, grid_of(problem, step), best.cost)
        relaxation.improve(best.cost, STEPS, goal, watch)
        lower, left = relaxation.lower, relaxation.narrowed(problem)
        while best.cost - lower > goal and not watch.is_over():
            best, proved, solved = self._solve(problem, relaxation, best, watch)
            lower = max(lower, proved)
            if not solved or best.cost - lower <= goal:
                break
            relaxation.fix(best.cost)
            left, step = relaxation.narrowed(left), step / REFINEMENT
            relaxation = Relaxation(left, grid_of(left, step), best.cost, relaxation.prices)
            relaxation.improve(best.cost, STEPS // 4, goal, watch)
            lower = max(lower, relaxation.lower)
        return Draft(best.starts, best.agents, best.cost, min(lower, best.cost))

    def _solve(
        self, problem: Problem, relaxation: Relaxation, best: Draft, watch: Stopwatch
    ) -> tuple[Draft, float, bool]:
        """Give the best schedule, a bound, and whether this grid has nothing more to give."""
        grid = relaxation.grid
        reduced = np.sort(np.concatenate(relaxation.reduced_costs()))
        threshold = best.cost if reduced.size <= self.arcs else min(best.cost, float(reduced[self.arcs]))
        lanes = [
            _joined(arcs, _instants(grid, lane)) for lane, arcs in enumerate(relaxation.arcs_below(threshold))
        ]
        program = Flow(grid, lanes, relaxation.agents, problem.lags)
        solved = program.solve(watch)
        proved = min(threshold, float(grid.rejections.sum()) + solved.bound)
        if solved.chosen is not None:
            draft = self._timed(problem, grid, program, solved.chosen)
            best = draft if draft.cost < best.cost else best
        return best, proved, solved.best and (proved < threshold or threshold >= best.cost)

    def _timed(self, problem: Problem, grid: Grid, program: Flow, chosen: Ints) -> Draft:
        """Give each start an agent of its lane that is free, and the whole its best timing."""
        hints, agents = np.full(len(problem.jobs), np.nan), np.ones(len(problem.jobs), np.int64)
        free = {agent: -math.inf for lane in problem.lanes for agent in lane.agents}
        arcs = program.arcs
        for arc in chosen[np.lexsort((arcs.end[chosen], arcs.start[chosen]))].tolist():
            team = problem.lanes[int(program.lane[arc])].agents
            # The one who has waited least leaves the longest rest to the others.
            ready = [agent for agent in team if free[agent] <= arcs.start[arc]] or list(team)
            agent = max(ready, key=lambda name: free[name])
            free[agent] = float(arcs.end[arc])
            job = int(arcs.job[arc])
            hints[job], agents[job] = grid.times(arcs.start[arc]), agent
        return settled(problem, hints, agents, 2 * grid.step)


def _instants(grid: Grid, lane: int) -> Arcs:
    """Give the arcs of the jobs shorter than a slot, which take no time."""
    parts = [
        (job, curves[lane].first + np.flatnonzero(np.isfinite(curves[lane].gains)), curves[lane])
        for job, curves in enumerate(grid.curves)
        if not grid.durations[job]
    ]
    job = np.concatenate([np.empty(0, np.int64), *(np.full(slots.size, job) for job, slots, _ in parts)])
    start = np.concatenate([np.empty(0, np.int64), *(slots for _, slots, _ in parts)])
    gain = np.concatenate([np.empty(0), *(curve.gains[slots - curve.first] for _, slots, curve in parts)])
    return Arcs(job, start, start, gain)


def _joined(first: Arcs, second: Arcs) -> Arcs:
    return Arcs(*(np.concatenate(columns) for columns in zip(first, second, strict=True)))
