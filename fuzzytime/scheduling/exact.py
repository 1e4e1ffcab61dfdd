"""The exact method for one agent and many skills: a Lagrangian bound, and labels where it leaves room.

On each grid the relaxation finds prices and a bound, and deletes the starts that no better schedule uses. A
label program below a threshold just above the bound then either finds the best schedule of the grid, or
proves that none is below, and the threshold rises. Where that takes too much room, labels in beams look for
a better schedule, so that more starts can be deleted. The grid's costs lie below those in continuous time
(`fuzzytime.scheduling.grid`), so all its bounds hold there; the next grid is finer, until the gap closes.
"""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from fuzzytime.errors import RefusedError
from fuzzytime.satisfaction import cell_chord_errors
from fuzzytime.scheduling.grid import Grid, Ints, grid_of, step_for
from fuzzytime.scheduling.labels import Labels as LabelProgram
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.local_search import LocalSearch
from fuzzytime.scheduling.problem import Problem
from fuzzytime.scheduling.relaxation import Relaxation
from fuzzytime.scheduling.schedule import OPTIMAL_GAP
from fuzzytime.scheduling.settle import settled
from fuzzytime.scheduling.solver import Draft

FIRST_SLOTS = 3000
"""Slots of the first grid, at least."""

REFINEMENT = 4
"""How much finer the next grid is, where the gap is too large."""

MOST_SLOTS = 200
"""The shortest job takes no more slots than this."""

STEPS = 40
"""Evaluations of the bound between two deletions of starts."""

ENOUGH = 0.005
"""The gap, as a share of a rejection, that is left to labels."""

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
        best = warm or LocalSearch().search(problem, watch.share(0.3))
        step, enough = step_for(problem, FIRST_SLOTS), ENOUGH * max(job.rejection for job in problem.jobs)
        relaxation = Relaxation(problem, grid_of(problem, step), best.cost)
        relaxation.improve(best.cost, STEPS, enough, watch)
        lower, left = relaxation.lower, relaxation.narrowed(problem)
        while best.cost - lower > OPTIMAL_GAP * problem.weight and not watch.is_over():
            step = fine_enough(problem, best, step, OPTIMAL_GAP * problem.weight / 2)
            if step < relaxation.grid.step:
                relaxation = Relaxation(left, grid_of(left, step), best.cost, relaxation.prices)
                relaxation.improve(best.cost, STEPS // 4, enough, watch)
            attempt = _Attempt(problem, relaxation, best, watch)
            attempt.close()
            best, lower = attempt.best, max(lower, attempt.lower)
            left = relaxation.narrowed(left)
            if not attempt.solved or not problem.kept_by_order:
                break
            step /= REFINEMENT
        return Draft(best.starts, best.agents, best.cost, min(lower, best.cost))


def fine_enough(problem: Problem, draft: Draft, step: float, error: float) -> float:
    """Refine a step until the grid's costs at a draft's starts are not too far below the real ones."""
    placed = [
        (job, start)
        for job, start in zip(problem.jobs, draft.starts.tolist(), strict=True)
        if not math.isnan(start)
    ]
    while True:
        off = 0.0
        for job, start in placed:
            low = math.floor(start / step) * step
            (lost,) = cell_chord_errors(job.function, [low, low + step])
            off += min(job.weight * float(lost), job.worst)
        if off <= error or step < min(job.duration for job, _ in placed) / MOST_SLOTS:
            return step
        step /= 2


class _Attempt:
    """One grid: the best schedule so far, and what is proved."""

    def __init__(self, problem: Problem, relaxation: Relaxation, best: Draft, watch: Stopwatch) -> None:
        self.problem, self.relaxation, self.watch = problem, relaxation, watch
        self.grid: Grid = relaxation.grid
        self.best, self.lower, self.solved = best, -math.inf, False
        # Jobs shorter than a slot are no part of the program, and so cannot be waited for.
        durations = self.grid.durations
        self.before = [[first for first in firsts if durations[first]] for firsts in problem.before()]

    def close(self) -> None:
        """Raise the bound and better the schedule until they meet on this grid, or a limit is met."""
        relaxation, cells = self.relaxation, self.watch.limits.memory // 16
        self.lower = relaxation.lower
        delta = 0.01 * self.lower + 0.005 * float(np.median(self.grid.rejections))
        budget, width = cells // 16, BEAM
        while not self._is_over():
            if self._labels(min(self.best.cost, self.lower + delta), budget, None):
                delta *= 2
                continue
            if budget >= cells:
                break
            budget, width = 4 * budget, 6 * width
            if not self._is_over():
                self._labels(self.best.cost, cells, width)

    def _is_over(self) -> bool:
        closed = self.best.cost - self.lower <= CLOSED * self.problem.weight
        self.solved = self.solved or closed
        return self.solved or self.watch.is_over()

    def _labels(self, threshold: float, cells: int, width: int | None) -> bool:
        """One run of labels below a threshold; tell whether it was exact, and learn from it."""
        relaxation, grid = self.relaxation, self.grid
        (arcs,) = relaxation.arcs_below(threshold)
        base = relaxation.base - float(relaxation.prices.sum())
        program = LabelProgram(arcs, grid.durations, grid.slots, relaxation.prices, base, self.before)
        found = program.run(threshold, self.watch, cells, width)
        if found.starts is not None:
            self._learn(found.starts)
        if found.exact:
            self.solved = found.starts is not None or threshold >= self.best.cost
            self.lower = max(self.lower, min(found.cost, threshold))
        return found.exact

    def _learn(self, slots: Ints) -> None:
        """Time the order that labels found, with what they leave out where it was."""
        hints = np.where(slots >= 0, self.grid.times(slots), np.nan)
        instant = self.grid.durations == 0
        hints[instant] = self.best.starts[instant]
        agents = np.full(len(self.problem.jobs), self.problem.lanes[0].agents[0], np.int64)
        draft = settled(self.problem, hints, agents, 2 * self.grid.step)
        if draft.cost < self.best.cost:
            self.best = draft
