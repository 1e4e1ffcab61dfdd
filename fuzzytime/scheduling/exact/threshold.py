"""The exact method for one agent and many skills: a Lagrangian bound, and labels where it leaves room.

On each grid (`fuzzytime.scheduling.bound.refinement`) a label program below a threshold just above the bound
either finds the best schedule of the grid, or proves that none is below, and the threshold rises. Where that
takes too much room, a local search around the relaxation's path and labels in a beam look for a better
schedule, and the threshold falls to half its distance from the bound. The next grid is finer, over the few
starts that labels leave.
"""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from fuzzytime.errors import RefusedError
from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.bound.refinement import CLOSED, STEPS, GridSearch, bytes_for
from fuzzytime.scheduling.bound.relaxation import Relaxation, prices_from
from fuzzytime.scheduling.exact.backward import used_below
from fuzzytime.scheduling.exact.crowd import Crowd
from fuzzytime.scheduling.exact.dominance import MOST_JOBS, Dominance
from fuzzytime.scheduling.exact.labels import Found
from fuzzytime.scheduling.exact.labels import Labels as LabelProgram
from fuzzytime.scheduling.exact.reach import BYTES_PER_CELL, Reach
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import Grid, Ints, grid_of, step_for
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.search.dynasearch import only_order_counts
from fuzzytime.scheduling.search.local_search import LocalSearch
from fuzzytime.scheduling.search.stretches import Stretches
from fuzzytime.scheduling.solver import Draft

FIRST_SLOTS = 1500
"""Slots of the first grid, at least."""

BEAM, BROAD_BEAM = 50, 200
"""Sets a block in the first, narrowest beam; and where there are very many skills."""

FAST, SLOW = 0.6, 0.97
"""To what share the gap falls at least in a round of the search for a bound; and for the highest one."""

PATIENCE = 0.4
"""Of the time left, for a higher bound of very many skills, as long as it rises at all."""

FIRST = 0.1
"""Of the gap, the first threshold is above the bound, and what the exact program may be left besides."""

MOST_TOGETHER = 100
"""Up to so many skills a beam finds good schedules; more are improved in stretches."""

CROWD = 300
"""Up to so many all labels may be kept; more are bounded and improved only."""

STRETCH = 30
"""Skills that are done in a stretch."""

REJECTED = 25
"""Skills that may come into it."""

PART_ROUNDS = 2
"""Rounds in which the bound of a part is made better: what it began with is mostly good."""

KICKS_A_PAIR, MORE_KICKS_A_PAIR = 0.05, 0.2
"""Of a local search where a schedule is doubtful, at most, and where there are very many skills.

What may change places are pairs of skills, and where labels cannot hold all a beam finds little.
"""

PAYS = 0.1
"""Of the gap, a search closes at least, or labels are tried with more room before the next one."""

MANY = 60
"""From so many skills on a doubtful schedule is mended before labels."""


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
        search = Crowd if len(problem.jobs) > CROWD else _Search
        return search(problem, watch, best).run()


class _Search(GridSearch):
    """Labels below a rising threshold."""

    first_slots: ClassVar[int] = FIRST_SLOTS
    enough = 0.3

    def __init__(self, problem: Problem, watch: Stopwatch, best: Draft) -> None:
        super().__init__(problem, watch, best)
        self._dominance: Dominance | None = None
        self._followed: Floats | None = None
        self._kicked = np.inf
        self._known_on_grid = np.inf
        self._is_solved = False

    @property
    def worth(self) -> float:
        """Of few skills, or near the best, labels soon know more than a higher bound."""
        is_near = self.best.cost - self.lower <= self.enough * self.heaviest
        return FAST if is_near or len(self.problem.jobs) < MANY else super().worth

    def tightened(self, problem: Problem, step: float) -> Problem:
        """Add what some best schedule keeps, where waiting never helps and all is done."""
        jobs = self.problem.jobs
        if len(jobs) > MOST_JOBS or self.best.cost >= min(job.rejection for job in jobs):
            return problem
        if self._dominance is None and only_order_counts(self.problem):
            self._dominance = Dominance(self.problem, step)
        return problem if self._dominance is None else self._dominance.tightened(problem)

    def close(self, relaxation: Relaxation) -> bool:
        """Solve a grid, or prove that none of its schedules is better; tell whether that was done."""
        self.lower = max(self.lower, relaxation.lower)
        beam = BROAD_BEAM if self._are_very_many else BEAM
        reach = Reach.within(self.watch.limits.memory, beam, is_solved=self._is_solved)
        # Where only the order counts the schedule is hardly what is wrong.
        searching = self.left.lags == self.problem.lags
        pays = True
        self._known_on_grid = np.inf
        if searching and self._is_early_search_worth():
            pays = self._search_near(relaxation, reach.width)
        reach.delta = FIRST * (self.best.cost - self.lower) + self.left_over
        while not self.is_over():
            threshold = reach.threshold(self.lower, self.best.cost, self._known_on_grid)
            program, found = self.labels(relaxation, threshold, reach.cells, None)
            if self.is_closed():
                return True
            if found.exact and self.best.cost <= threshold:
                relaxation.keep([used_below(program, self.best.cost)])
                self._is_solved = True
                return True
            if found.exact:
                reach.prove(patiently=self._are_very_many)
            elif reach.widen():
                self._raise(relaxation)
                if searching and pays:
                    pays = self._search_near(relaxation, reach.width)
                if self.is_closed():
                    return True
            elif not reach.shorten(threshold, self.lower, self.best.cost, self._known_on_grid):
                known = self.best.cost
                if searching:
                    self._search_near(relaxation, reach.width)
                if self.best.cost >= known:
                    return False
        return self.best.cost - self.lower <= CLOSED * self.problem.weight

    def _raise(self, relaxation: Relaxation) -> None:
        """Make the bound as high as it goes, which takes less long than many more labels.

        Where labels have proved more than the bound already, they go on, unless there are very many skills:
        prices find their way slowly then, and labels need good ones.
        """
        if self._are_very_many and self.is_doubtful():
            patient = self.watch.share(PATIENCE)
            relaxation.improve(self.best.cost, STEPS, self.left_over, patient, worth=1.0)
        elif relaxation.lower >= self.lower:
            relaxation.improve(self.best.cost, STEPS, self.left_over, self.watch, worth=SLOW)
        self.lower = max(self.lower, relaxation.lower)

    @property
    def _are_very_many(self) -> bool:
        return len(self.problem.jobs) > MOST_TOGETHER

    def follow(self, relaxation: Relaxation) -> None:
        """Search around the bound's path where many skills are in doubt: a better schedule deletes starts."""
        if self._is_early_search_worth():
            self._follow_path(relaxation)

    def _is_early_search_worth(self) -> bool:
        return self.is_doubtful() and len(self.problem.jobs) >= MANY

    def _follow_path(self, relaxation: Relaxation) -> None:
        if relaxation.prices is not self._followed:
            self._followed = relaxation.prices
            path = self._timed(relaxation.grid, relaxation.visited())
            self.take(LocalSearch(sweeps=1).search(self.problem, self.watch.share(0.4), path))

    def _search_near(self, relaxation: Relaxation, width: int) -> bool:
        """Search around the bound's path, by labels in a beam, and where there are very many in stretches.

        Tells whether that paid.
        """
        known, left = self.best.cost, self.best.cost - self.lower
        self._follow_path(relaxation)
        if self._are_very_many:
            self._kick()
        if self.watch.is_over():
            return False
        self.labels(relaxation, self.best.cost, self.watch.limits.memory // BYTES_PER_CELL, width)
        if self._are_very_many:
            if self.is_doubtful():
                self._search_stretches(relaxation)
        elif known - self.best.cost < PAYS * left:
            # Below a good schedule, as a beam finds it, labels mostly take no longer than kicks.
            self._kick()
        if self.best.cost < known and not self.is_closed():
            relaxation.fix(self.best.cost)
        return known - self.best.cost >= PAYS * left

    def _kick(self) -> None:
        """Search anew with kicks around the best schedule, where it is doubtful and was not kicked yet."""
        if self._is_early_search_worth() and self.best.cost < self._kicked:
            a_pair = MORE_KICKS_A_PAIR if self._are_very_many else KICKS_A_PAIR
            kicks = round(a_pair * math.comb(len(self.problem.jobs), 2))
            search = LocalSearch(kicks=kicks)
            self.take(search.search(self.problem, self.watch.share(0.3), self.best))
            self._kicked = self.best.cost

    def _search_stretches(self, relaxation: Relaxation) -> None:
        """Search stretch by stretch on the same grid, by labels in a beam, at prices good for all."""

        def solve(part: Problem, members: list[int], watch: Stopwatch, warm: Draft) -> Draft:
            return search_part(part, watch, warm, relaxation.grid.step, relaxation.prices[members])

        self.take(Stretches(solve, STRETCH, REJECTED).improve(self.problem, self.watch.share(0.4), self.best))

    def labels(
        self, relaxation: Relaxation, threshold: float, cells: int, width: int | None
    ) -> tuple[LabelProgram, Found]:
        """Run labels below a threshold once, and learn from what they find."""
        grid, prices = relaxation.grid, relaxation.prices
        (arcs,) = relaxation.arcs_below(threshold)
        base = relaxation.base - float(prices.sum())
        # Jobs shorter than a slot are no part of the program, and so cannot be waited for.
        before = [[first for first in firsts if grid.durations[first]] for firsts in self.left.before()]
        program = LabelProgram(arcs, grid.durations, grid.slots, prices, base, before)
        found = program.run(threshold, self.watch, cells, width)
        if found.starts is not None:
            self._known_on_grid = min(self._known_on_grid, found.cost)
            self.take(self._timed(grid, found.starts))
        if found.exact:
            self.lower = max(self.lower, min(found.cost, threshold))
        return program, found

    def _timed(self, grid: Grid, slots: Ints) -> Draft:
        return self.timed(grid, slots, np.full(slots.size, self.problem.lanes[0].agents[0], np.int64))


def search_part(
    problem: Problem, watch: Stopwatch, warm: Draft, step: float | None = None, prices: Floats | None = None
) -> Draft:
    """Look on one grid for a better schedule of one agent, mostly of a part; no bound.

    Parameters
    ----------
    problem
        For one agent.
    watch
        For time and memory.
    warm
        A schedule to begin with.
    step
        Of the grid, in seconds.
    prices : array of shape (jobs,)
        λ, from where on to search better ones: what the schedule says unless given.
    """
    step = step_for(problem, FIRST_SLOTS) if step is None else step
    if bytes_for(problem, step) > watch.limits.memory:
        return warm
    grid, search = grid_of(problem, step), _Search(problem, watch, warm)
    prices = prices_from(problem, grid, warm) if prices is None else prices
    relaxation = Relaxation(problem, grid, warm.cost, prices)
    relaxation.improve(warm.cost, STEPS, search.left_over, watch, rounds=PART_ROUNDS)
    search.close(relaxation)
    return search.best
