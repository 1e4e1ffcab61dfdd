"""Several agents, and lags of any kind: a mixed-integer program over the starts that the bound leaves.

The relaxation gives a bound at once, and with a good schedule deletes most starts. What is left goes to HiGHS
as a flow through time (`fuzzytime.scheduling.exact.flow`). Where too many starts are left, only those with a
low reduced cost go: the program then proves the least cost of all schedules below their threshold. As every
bound is one on the grid's costs, which lie below those in continuous time, it holds there.

Huangfu and Hall, Parallelizing the dual revised simplex method, Math. Program. Comput. 10 (2018) 119-142.
"""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from fuzzytime.scheduling.bound.refinement import bytes_for
from fuzzytime.scheduling.bound.relaxation import Relaxation, prices_from
from fuzzytime.scheduling.exact.flow import Flow
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import Grid, Ints, grid_of, step_for
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.schedule import OPTIMAL_GAP
from fuzzytime.scheduling.search.local_search import LocalSearch
from fuzzytime.scheduling.solver import Draft
from fuzzytime.scheduling.timing.settle import manned, settled

FIRST_SLOTS = 200
"""Slots of the first grid, at least."""

REFINEMENT = 2
"""How much finer the next grid is, where the gap is too large."""

STEPS = 40
"""Evaluations of the bound between two deletions of starts."""

MOST_ARCS = 20_000
"""Starts in one program."""


@dataclass(slots=True)
class _State:
    """The best schedule so far, and what is proved."""

    best: Draft
    lower: float = 0.0


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
        state = _State(best)
        try:
            self._run(problem, state, watch)
        except KeyboardInterrupt:
            watch.stop()
        best = state.best
        return Draft(best.starts, best.agents, best.cost, min(state.lower, best.cost))

    def _run(self, problem: Problem, state: _State, watch: Stopwatch) -> None:
        """Bound and solve grid after grid until the gap closes or a limit is met."""
        goal, step = OPTIMAL_GAP * problem.weight, step_for(problem, FIRST_SLOTS)
        if bytes_for(problem, step) > watch.limits.memory:
            return
        grid = grid_of(problem, step)
        relaxation = Relaxation(problem, grid, state.best.cost, prices_from(problem, grid, state.best))
        relaxation.improve(state.best.cost, STEPS, goal, watch)
        left = relaxation.narrowed(problem)
        state.lower = relaxation.lower
        while state.best.cost - state.lower > goal and not watch.is_over():
            solved = self._solve(problem, relaxation, state, watch)
            relaxation.fix(state.best.cost)
            left, step = relaxation.narrowed(left), step / REFINEMENT
            too_much = bytes_for(left, step) > watch.limits.memory
            if not solved or too_much or state.best.cost - state.lower <= goal:
                break
            relaxation = Relaxation(left, grid_of(left, step), state.best.cost, relaxation.prices)
            relaxation.improve(state.best.cost, STEPS // 4, goal, watch)
            state.lower = max(state.lower, relaxation.lower)

    def _solve(self, problem: Problem, relaxation: Relaxation, state: _State, watch: Stopwatch) -> bool:
        """Solve one program; tell whether this grid has nothing more to give."""
        grid, upper = relaxation.grid, state.best.cost
        reduced = np.sort(np.concatenate(relaxation.reduced_costs()))
        threshold = upper if reduced.size <= self.arcs else min(upper, float(reduced[self.arcs]))
        program = Flow(grid, relaxation.everything_below(threshold), relaxation.agents)
        solved = program.solve(watch)
        proved = min(threshold, float(grid.rejections.sum()) + solved.bound)
        state.lower = max(state.lower, proved)
        if solved.chosen is not None:
            draft = self._timed(problem, grid, program, solved.chosen)
            state.best = draft if draft.cost < state.best.cost else state.best
        return solved.best and (proved < threshold or threshold >= upper)

    def _timed(self, problem: Problem, grid: Grid, program: Flow, chosen: Ints) -> Draft:
        """Give each start an agent of its lane that is free, and the whole its best timing."""
        slots, lanes = np.full(len(problem.jobs), -1), np.zeros(len(problem.jobs), np.int64)
        slots[program.arcs.job[chosen]], lanes[program.arcs.job[chosen]] = (
            program.arcs.start[chosen],
            program.lane[chosen],
        )
        agents = manned(problem, lanes, slots, slots + grid.durations)
        return settled(problem, np.where(slots >= 0, grid.times(slots), np.nan), agents, 2 * grid.step)
