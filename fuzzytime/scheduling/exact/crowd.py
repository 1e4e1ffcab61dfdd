"""Several hundred skills of one agent: prices part by part, and a search with kicks; no labels.

A search for the prices of a thousand skills at once learns from each path one plane in a thousand dimensions,
and takes its time. But what a skill costs others is settled near it: a hundred skills next to each other,
with those around them that give way, have nearly the prices that they have among all. So the searches for
the prices of parts begin that for all, which has to mend the seams only.
"""

import math
from typing import ClassVar, NamedTuple

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.bound.refinement import STEPS, GridSearch
from fuzzytime.scheduling.bound.relaxation import Relaxation
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import Grid, grid_of
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.search.local_search import LocalSearch
from fuzzytime.scheduling.search.parts import part_of
from fuzzytime.scheduling.solver import Draft, draft_of
from fuzzytime.scheduling.timing.settle import in_turn

TOGETHER, BESIDE = 100, 30
"""Skills of a part whose prices are kept, and those before and behind that give way."""

ROUNDS = 4
"""Deletions of starts in a part, at most."""

ENOUGH = 0.01
"""The gap in cost at which a part's search ends, as a share of what the whole schedule costs."""

KICKING, IN_PARTS, AT_ONCE = 0.3, 0.7, 0.5
"""Of the time left, for a search with kicks, for prices in parts, and for those of all in one turn."""

KICKS_A_SKILL = 10
"""Of one such search, at most: mostly it cools down in the time that is left."""


class Crowd(GridSearch):
    """A bound and a schedule, made better in turn."""

    first_slots: ClassVar[int] = 1500
    enough: ClassVar[float] = 0.3

    def first_prices(self, problem: Problem, grid: Grid) -> Floats:
        """Search a better schedule, and make its prices better part by part."""
        self._kick()
        prices = super().first_prices(problem, grid)
        return improved_part_by_part(problem, grid, self.best, prices, self.watch.share(IN_PARTS))

    def close(self, relaxation: Relaxation) -> bool:
        """Go on in turn as long as that is of use."""
        left = math.inf
        while not self.is_over() and self.best.cost - self.lower < left:
            left = self.best.cost - self.lower
            self._kick()
            relaxation.improve(self.best.cost, STEPS, self.left_over, self.watch.share(AT_ONCE), worth=1.0)
            self.lower = max(self.lower, relaxation.lower)
        return False

    def _kick(self) -> None:
        kicks = KICKS_A_SKILL * len(self.problem.jobs)
        self.take(LocalSearch(kicks=kicks).search(self.problem, self.watch.share(KICKING), self.best))


def improved_part_by_part(
    problem: Problem, grid: Grid, draft: Draft, prices: Floats, watch: Stopwatch
) -> Floats:
    """Make prices better that begin a search for those of all.

    Parameters
    ----------
    problem, grid
        For one agent.
    draft
        A good schedule: what it does next to each other is a part, while the rest stands still.
    prices : array of shape (jobs,)
        λ to begin with.
    watch
        For all parts; those that are left when it is over keep their prices.
    """
    found, row = prices.copy(), in_turn(problem, draft.starts)
    parts = [_part(problem, draft, row, first) for first in range(0, len(row), TOGETHER)]
    # Most is to be found, and so most time goes, where most is lost.
    parts.sort(key=lambda part: part.warm.cost, reverse=True)
    left, priced = math.fsum(part.warm.cost for part in parts), set[int]()
    for members, kept, part, warm in parts:
        if watch.is_over() or warm.cost <= ENOUGH * draft.cost:
            break
        relaxation = Relaxation(part, grid_of(part, grid.step), warm.cost, prices[members])
        mine = watch.share(warm.cost / left)
        relaxation.improve(warm.cost, STEPS, ENOUGH * draft.cost, mine, rounds=ROUNDS)
        left -= warm.cost
        for job, price in zip(members, relaxation.prices.tolist(), strict=True):
            if job in kept:
                found[job] = price
            elif math.isnan(draft.starts[job]):
                # Of the places where a rejected job might come in, the one where it is worth most counts.
                found[job] = max(found[job], price) if job in priced else price
                priced.add(job)
    return found


class _Part(NamedTuple):
    """Jobs that move together, those whose prices are kept, their problem, and what they do now."""

    members: list[int]
    kept: set[int]
    problem: Problem
    warm: Draft


def _part(problem: Problem, draft: Draft, row: list[int], first: int) -> _Part:
    moving = row[max(first - BESIDE, 0) : first + TOGETHER + BESIDE]
    members, part = part_of(problem, draft, moving, len(problem.jobs))
    warm = draft_of(part, draft.starts[members], draft.agents[members])
    return _Part(members, {*row[first : first + TOGETHER]}, part, warm)
