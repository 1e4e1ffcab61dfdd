"""The exact method for one agent and many skills: a Lagrangian bound, and labels where it leaves room.

On each grid the relaxation finds prices and a bound, and deletes the starts that no better schedule uses. A
label program below a threshold just above the bound then either finds the best schedule of the grid, or
proves that none is below, and the threshold rises. Where that takes too much room, a local search around the
relaxation's path and labels in a beam look for a better schedule. The grid's costs lie below those in
continuous time (`fuzzytime.scheduling.grid`), so all its bounds hold there; the next grid is finer, over the
few starts that labels leave, until the gap closes.
"""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from fuzzytime.errors import RefusedError
from fuzzytime.satisfaction import Floats, cell_chord_errors
from fuzzytime.scheduling.grid import Grid, Ints, grid_of, step_for
from fuzzytime.scheduling.labels import Found
from fuzzytime.scheduling.labels import Labels as LabelProgram
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.local_search import LocalSearch
from fuzzytime.scheduling.problem import Problem
from fuzzytime.scheduling.relaxation import Relaxation, prices_from
from fuzzytime.scheduling.schedule import OPTIMAL_GAP
from fuzzytime.scheduling.settle import settled
from fuzzytime.scheduling.solver import Draft

FIRST_SLOTS = 1500
"""Slots of the first grid, at least."""

FINER = 20
"""How much finer than that it may be, so that all durations are whole numbers of slots."""

REFINEMENT = 4
"""How much finer the next grid is, where the gap is too large."""

FASTEST_REFINEMENT = 8
"""How much finer at most: what one grid deletes, the next need not have."""

MOST_SLOTS = 1 << 18
"""Slots of the finest grid."""

BYTES_PER_START = 200
"""Memory that a start takes, in the bound's two directions."""

STEPS = 40
"""Evaluations of the bound between two deletions of starts."""

ENOUGH = 0.035
"""The gap in cost, by the largest weight, that is left to labels."""

CLOSED = 1e-7
"""The gap in cost, by weight, at which nothing is left to prove."""

BEAM = 50
"""Sets a block in the first, narrowest beam."""


@dataclass(frozen=True, slots=True)
class Labels:
    """Exact for one agent and many skills, as far as time and memory go; always with a bound.

    Of lags it knows only which skill comes first: the rest is relaxed for the bound.
    """

    name: ClassVar[str] = "labels"

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Bound and solve grid after grid.

        Raises
        ------
        RefusedError
            If there are several agents.
        """
        if problem.agents > 1:
            raise RefusedError(f"the label program schedules one agent, got {problem.agents}")
        begin = warm or LocalSearch().search(problem, watch.share(0.3))
        search = _Search(problem, watch, begin)
        try:
            search.run()
        except KeyboardInterrupt:
            watch.stop()
        best = search.best
        return Draft(best.starts, best.agents, best.cost, min(search.lower, best.cost))


def fine_enough(problem: Problem, draft: Draft, step: float, error: float) -> float:
    """Refine a step until the grid's costs at a draft's starts are not too far below the real ones.

    It stays above a share of the horizon: at a jump no grid helps.
    """
    placed = [
        (job, start)
        for job, start in zip(problem.jobs, draft.starts.tolist(), strict=True)
        if not math.isnan(start)
    ]
    smallest = max(job.latest + job.duration for job in problem.jobs) / MOST_SLOTS
    while step > smallest:
        off = 0.0
        for job, start in placed:
            low = math.floor(start / step) * step
            (lost,) = cell_chord_errors(job.function, [low, low + step])
            off += min(job.weight * float(lost), job.worst)
        if off <= error:
            break
        step /= 2
    return step


def bytes_for(problem: Problem, step: float) -> float:
    """Give the memory that the starts of a problem take on a grid."""
    lengths = [window.length for job in problem.jobs for lane in job.windows for window in lane]
    return BYTES_PER_START * math.fsum(lengths) / step


class _Search:
    """The best schedule so far, and what is proved."""

    def __init__(self, problem: Problem, watch: Stopwatch, best: Draft) -> None:
        self.problem, self.watch = problem, watch
        self.best, self.lower = best, 0.0
        self.goal = OPTIMAL_GAP * problem.weight
        self._repaired: Floats | None = None

    def run(self) -> None:
        """Bound and solve grid after grid until the gap closes or a limit is met."""
        problem, watch = self.problem, self.watch
        # Labels relax what takes no time, and what binds jobs otherwise than by order.
        closable = problem.kept_by_order and all(job.duration > 0 for job in problem.jobs)
        step, enough = step_for(problem, FIRST_SLOTS, FINER), ENOUGH * max(job.weight for job in problem.jobs)
        if bytes_for(problem, step) > watch.limits.memory:
            return
        left, grid = problem, grid_of(problem, step)
        relaxation = Relaxation(problem, grid, self.best.cost, prices_from(problem, grid, self.best))
        relaxation.improve(self.best.cost, STEPS, enough, watch)
        self.lower = relaxation.lower
        while self.best.cost - self.lower > self.goal and not watch.is_over():
            solved = self._close(relaxation)
            if self.best.cost - self.lower <= self.goal:
                break
            left = relaxation.narrowed(left)
            finest = fine_enough(problem, self.best, step / REFINEMENT, self.goal / 2)
            step = max(finest, step / FASTEST_REFINEMENT)
            if not solved or not closable or bytes_for(left, step) > watch.limits.memory:
                break
            relaxation = Relaxation(left, grid_of(left, step), self.best.cost, relaxation.prices)
            relaxation.improve(self.best.cost, STEPS // 4, enough, watch)

    def _close(self, relaxation: Relaxation) -> bool:
        """Solve a grid, or prove that none of its schedules is better; tell whether that was done."""
        cells = self.watch.limits.memory // 16
        self.lower = max(self.lower, relaxation.lower)
        delta = 0.1 * (self.best.cost - self.lower) + ENOUGH * max(job.weight for job in self.problem.jobs)
        budget, width = cells // 16, BEAM
        while not self._is_over():
            threshold = min(self.best.cost, self.lower + delta)
            program, found = self._labels(relaxation, threshold, budget, None)
            if self.best.cost - self.lower <= self.goal:
                return True
            if found.exact and self.best.cost <= threshold:
                relaxation.keep([program.used_below(self.best.cost)])
                return True
            if found.exact:
                delta = 2 * delta if found.starts is None else np.inf
            elif budget < cells:
                budget, width = 4 * budget, 6 * width
                self._repair(relaxation)
                self._labels(relaxation, min(self.best.cost, self.lower + 4 * delta), cells, width)
            else:
                return False
        return self.best.cost - self.lower <= CLOSED * self.problem.weight

    def _repair(self, relaxation: Relaxation) -> None:
        """Search around the cheapest path of the relaxation, once for the same prices."""
        if relaxation.prices is self._repaired:
            return
        self._repaired = relaxation.prices
        begin = self._timed(relaxation.grid, relaxation.visited())
        found = LocalSearch().search(self.problem, self.watch.share(0.3), begin)
        if found.cost < self.best.cost:
            self.best = found
            relaxation.fix(found.cost)
            relaxation.improve(found.cost, STEPS, self.goal, self.watch)
            self.lower = max(self.lower, relaxation.lower)

    def _is_over(self) -> bool:
        return self.best.cost - self.lower <= CLOSED * self.problem.weight or self.watch.is_over()

    def _labels(
        self, relaxation: Relaxation, threshold: float, cells: int, width: int | None
    ) -> tuple[LabelProgram, Found]:
        """Run labels below a threshold once, and learn from what they find."""
        grid, prices = relaxation.grid, relaxation.prices
        (arcs,) = relaxation.arcs_below(threshold)
        base = relaxation.base - float(prices.sum())
        # Jobs shorter than a slot are no part of the program, and so cannot be waited for.
        before = [[first for first in firsts if grid.durations[first]] for firsts in self.problem.before()]
        program = LabelProgram(arcs, grid.durations, grid.slots, prices, base, before)
        found = program.run(threshold, self.watch, cells, width)
        if found.starts is not None:
            draft = self._timed(grid, found.starts)
            self.best = draft if draft.cost < self.best.cost else self.best
        if found.exact:
            self.lower = max(self.lower, min(found.cost, threshold))
        return program, found

    def _timed(self, grid: Grid, slots: Ints) -> Draft:
        """Time the order of some starts, with what takes no slot where it was."""
        hints = np.where(slots >= 0, grid.times(slots), np.nan)
        instant = grid.durations == 0
        hints[instant] = self.best.starts[instant]
        agents = np.full(slots.size, self.problem.lanes[0].agents[0], np.int64)
        return settled(self.problem, hints, agents, 2 * grid.step)
