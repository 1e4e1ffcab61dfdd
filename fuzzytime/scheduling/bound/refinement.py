"""Grid after grid, each finer and over fewer starts, until a bound meets the best schedule.

On each grid the relaxation finds prices and a bound, and deletes the starts that no better schedule uses.
What then closes the grid, an exact program over the starts that are left, differs from solver to solver. The
grid's costs lie below those in continuous time (`fuzzytime.scheduling.problem.grid`), so all its bounds hold
there.
"""

import math
from abc import ABC, abstractmethod
from typing import ClassVar

import numpy as np

from fuzzytime.satisfaction import Floats, cell_chord_errors
from fuzzytime.scheduling.bound.relaxation import Relaxation, prices_from
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import FINER, Grid, Ints, grid_of, room_of, step_for
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.schedule import OPTIMAL_GAP
from fuzzytime.scheduling.solver import Draft
from fuzzytime.scheduling.timing.settle import settled

REFINEMENT = 4
"""How much finer the next grid is, where the gap is too large."""

MOST_SLOTS = 1 << 18
"""Slots of the finest grid."""

BYTES_PER_START = 200
"""Memory that a start takes, in the bound's two directions."""

MOST_STARTS = 4_000_000
"""Starts of all jobs on the first grid, where it is finer than it need be, at most."""

STEPS = 40
"""Evaluations of the bound between two deletions of starts."""

ENOUGH_OF_ALL = 0.03
"""The gap in cost that is left to an exact program, as a share of what the best schedule costs, at most."""

DOUBTFUL = 0.01
"""The gap in cost, by weight, from which on the schedule may be what is wrong, rather than the bound."""

CLOSED = 1e-7
"""The gap in cost, by weight, at which nothing is left to prove."""


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
    return BYTES_PER_START * room_of(problem) / step


class GridSearch(ABC):
    """The best schedule so far, and what is proved.

    Parameters
    ----------
    problem
        To be solved.
    watch
        For time and memory.
    best
        A schedule to begin with.
    """

    @property
    @abstractmethod
    def first_slots(self) -> int:
        """Slots of the first grid, at least."""

    finer: ClassVar[float] = FINER
    """How much finer that grid may be, so that durations are whole numbers of slots."""

    fastest: ClassVar[float] = 8
    """How much finer the next grid is at most: what one deletes, the next need not have."""

    enough: ClassVar[float]
    """The gap in cost, by the largest weight, that is left to the exact program."""

    def __init__(self, problem: Problem, watch: Stopwatch, best: Draft) -> None:
        self.problem, self.watch = problem, watch
        self.left = problem  # Where schedules that are better than the best may be.
        self.best, self.lower = best, min(problem.least_cost, best.cost)
        self.goal = OPTIMAL_GAP * problem.weight
        self.heaviest = max(job.weight for job in problem.jobs)

    @property
    def worth(self) -> float:
        """To what share the gap falls at least in a round of the search for prices, before a program runs."""
        return 0.9

    @property
    def closable(self) -> bool:
        """Whether finer grids can close the gap.

        Exact programs relax what takes no time, and what binds jobs otherwise than by order.
        """
        return self.problem.kept_by_order and all(job.duration > 0 for job in self.problem.jobs)

    def is_doubtful(self) -> bool:
        """Tell whether the schedule may be what is wrong, rather than the bound."""
        return self.best.cost - self.lower > DOUBTFUL * self.problem.weight

    def tightened(self, problem: Problem, step: float) -> Problem:  # noqa: ARG002 - others need the step
        """Give a problem with what else is known of schedules better than the best: here nothing.

        Parameters
        ----------
        problem
            Its windows may be narrowed already.
        step
            Of the grid, in seconds.
        """
        return problem

    def first_prices(self, problem: Problem, grid: Grid) -> Floats:
        """Give prices to begin with: here those of the best schedule."""
        return prices_from(problem, grid, self.best)

    def follow(self, relaxation: Relaxation) -> None:  # noqa: B027 - not every search can
        """Look for a better schedule near a bound's path: here nothing."""

    @abstractmethod
    def close(self, relaxation: Relaxation) -> bool:
        """Solve a grid, or prove that none of its schedules is better; tell whether that was done."""

    def run(self) -> Draft:
        """Bound and solve grid after grid until the gap closes, a limit is met, or somebody interrupts."""
        try:
            self._refine()
        except KeyboardInterrupt:
            self.watch.stop()
        best = self.best
        return Draft(best.starts, best.agents, best.cost, min(self.lower, best.cost))

    def _refine(self) -> None:
        problem, watch = self.problem, self.watch
        if self.is_closed():
            return
        starts = min(MOST_STARTS, watch.limits.memory / BYTES_PER_START)
        step, enough = step_for(problem, self.first_slots, self.finer, starts), self.left_over
        if watch.is_over() or bytes_for(problem, step) > watch.limits.memory:
            return
        grid = grid_of(problem, step)
        prices = self.first_prices(problem, grid)
        relaxation = self._relaxation(problem, grid, prices)
        while not self.is_closed() and not watch.is_over():
            solved = self.close(relaxation)
            if self.is_closed():
                break
            self.left = relaxation.narrowed(self.left)
            finest = fine_enough(problem, self.best, step / REFINEMENT, self.goal / 2)
            step = max(finest, step / self.fastest)
            if not solved or not self.closable or bytes_for(self.left, step) > watch.limits.memory:
                break
            relaxation = Relaxation(self.left, grid_of(self.left, step), self.best.cost, relaxation.prices)
            relaxation.improve(self.best.cost, STEPS // 4, enough, watch)

    def _relaxation(self, problem: Problem, grid: Grid, prices: Floats) -> Relaxation:
        """Bound the problem on the first grid, in turn with what else is known."""
        best, watch, enough = self.best.cost, self.watch, self.left_over
        self.left = self.tightened(problem, grid.step)
        if self.left is problem:
            relaxation = Relaxation(problem, grid, best, prices)
            relaxation.improve(best, STEPS, enough, watch, rounds=1)
            self.lower = relaxation.lower
            if watch.is_over():
                return relaxation
            self.follow(relaxation)
            if self.best.cost < best:
                relaxation.fix(self.best.cost)
            relaxation.improve(self.best.cost, STEPS, enough, watch, worth=self.worth)
            self.lower = max(self.lower, relaxation.lower)
            return relaxation
        begun = -math.inf
        while True:
            relaxation = Relaxation(self.left, grid_of(self.left, grid.step), best, prices)
            known = -math.inf
            while enough < best - relaxation.lower < 0.9 * (best - known) and not watch.is_over():
                known = relaxation.lower
                relaxation.improve(best, STEPS, enough, watch, rounds=1)
                self.left = self.tightened(relaxation.narrowed(self.left), grid.step)
                relaxation.restrict(self.left)
            self.lower, prices = max(self.lower, relaxation.lower), relaxation.prices
            # What the search for prices remembers is about arcs that are gone: it is worth another beginning.
            if not enough < best - self.lower < 0.9 * (best - begun) or watch.is_over():
                return relaxation
            begun = self.lower

    @property
    def left_over(self) -> float:
        """The gap in cost that the relaxation need not close."""
        return min(self.enough * self.heaviest, ENOUGH_OF_ALL * self.best.cost)

    def is_closed(self) -> bool:
        """Tell whether the best schedule is proved to be as good as can be told."""
        return self.best.cost - self.lower <= self.goal

    def is_over(self) -> bool:
        """Tell whether nothing is left to prove on a grid, or no time to do so."""
        return self.best.cost - self.lower <= CLOSED * self.problem.weight or self.watch.is_over()

    def take(self, draft: Draft) -> None:
        """Keep a schedule if it is the best."""
        self.best = draft if draft.cost < self.best.cost else self.best

    def timed(self, grid: Grid, slots: Ints, agents: Ints) -> Draft:
        """Time the order of some starts, with what takes no slot where it was."""
        hints, agents = np.where(slots >= 0, grid.times(slots), np.nan), agents.copy()
        instant = grid.durations == 0
        hints[instant], agents[instant] = self.best.starts[instant], self.best.agents[instant]
        return settled(self.problem, hints, agents, 2 * grid.step)
