"""Where waiting never helps only the order counts: dynasearch over it.

If all jobs are ready at once, on one agent, and their costs never fall with time, the best schedule in an
order starts each job when the one before is done. To swap two jobs of the order, or to put one elsewhere,
changes the start times between them only; so what several such moves gain in different parts of the order
adds up, and a small dynamic program picks the best set of them out of all. Where no move gains anything, a
few jobs change places at random and the search goes on, from there if that led to something as good.

Congram, Potts and van de Velde, An iterated dynasearch algorithm for the single-machine total weighted
tardiness scheduling problem, INFORMS J. Comput. 14 (2002) 52-67.
"""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from fuzzytime.errors import RefusedError
from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import Ints, step_for
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.solver import Draft, nothing
from fuzzytime.scheduling.timing.settle import settled

MOST_JOBS = 300
"""Up to so many all pairs of an order fit into memory and time at once."""

REACH = 50
"""Places between two jobs that are swapped, at most."""

MOST_SWAPPED = 6
"""Pairs that a kick swaps, at most."""

NEAR = 40
"""Places between two of them, at most."""

LEAST_PATIENCE = 10
"""Kicks in vain after which a search of few jobs ends."""

IMPROVEMENT = 1e-9
"""A set of moves must gain more than this."""


def only_order_counts(problem: Problem) -> bool:
    """Tell whether waiting never helps: one agent, all ready at once, costs that never fall with time."""
    if problem.agents > 1 or problem.lags:
        return False
    ready = problem.jobs[0].earliest
    return all(
        len(job.windows[0]) == 1
        and job.earliest == ready
        and job.function.log_concave
        and job.function.best.low <= ready
        for job in problem.jobs
    )


@dataclass(frozen=True, slots=True)
class Dynasearch:
    """Iterated dynasearch for problems in which only the order counts; no bound.

    Parameters
    ----------
    seed
        Of the kicks.
    slots
        Slots of the grid on which costs are looked up, at least.
    kicks
        How many at most; fewer where a share of n² of them found nothing.
    """

    name: ClassVar[str] = "dynasearch"

    seed: int = 0
    slots: int = 1500
    kicks: int = 300

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Improve the order until the kicks are used up.

        Raises
        ------
        RefusedError
            If waiting may help.
        """
        if not only_order_counts(problem):
            raise RefusedError("dynasearch takes jobs of one agent whose costs never fall with time")
        begin = warm or nothing(problem)
        orders = _Sequences(problem, step_for(problem, self.slots))
        best = first = np.lexsort((orders.deadlines, begin.starts))
        generator = np.random.default_rng(self.seed)
        # A warm start was searched before.
        patience = LEAST_PATIENCE + first.size**2 // (8 if warm is None else 32)
        try:
            best, least = orders.descended(first, watch)
            improved = 0
            for kick in range(self.kicks):
                satisfied = least <= problem.least_cost + IMPROVEMENT
                if satisfied or kick - improved > patience or watch.is_over():
                    break
                order, cost = orders.descended(_kicked(best, generator), watch)
                if cost < least - IMPROVEMENT:
                    improved = kick
                if cost <= least + IMPROVEMENT:
                    best, least = order, cost
        except KeyboardInterrupt:
            watch.stop()
        draft = settled(
            problem, orders.hints(best), np.full(best.size, problem.lanes[0].agents[0]), orders.step
        )
        return draft if draft.cost < begin.cost else begin


def _kicked(order: Ints, generator: np.random.Generator) -> Ints:
    """Swap a few pairs of jobs that are near each other."""
    order = order.copy()
    for _ in range(int(generator.integers(2, MOST_SWAPPED + 1))):
        first = int(generator.integers(order.size))
        second = min(first + int(generator.integers(1, NEAR + 1)), order.size - 1)
        order[[first, second]] = order[[second, first]]
    return order


class _Sequences:
    """What orders of a problem's jobs cost, and what moves in them gain."""

    def __init__(self, problem: Problem, step: float) -> None:
        jobs = problem.jobs
        self.step = step
        self.ready = jobs[0].earliest
        self.durations = np.array([max(round(job.duration / step), 0) for job in jobs], np.int64)
        self.deadlines = np.array([job.latest for job in jobs])
        self._width = int(self.durations.sum()) + 1
        times = self.ready + step * np.arange(self._width)
        self._latest = np.searchsorted(times, self.deadlines, "right") - 1
        rows = [np.where(times <= job.latest, job.costs(times), job.rejection) for job in jobs]
        self._costs: Floats = np.concatenate(rows)
        count = len(jobs)
        self._places = np.arange(count)
        self._above = np.triu(np.ones((count, count), bool), 1)
        first, second = np.nonzero(self._above & (self._places <= self._places[:, None] + REACH))
        between = second - first - 1
        self._pairs = first, second
        # Every job between every pair, pair after pair, and where each pair's begin.
        self._filled = np.flatnonzero(between)
        sizes = between[self._filled]
        self._heads = np.cumsum(sizes) - sizes
        self._of_pair = np.repeat(self._filled, sizes)
        self._middle = np.arange(sizes.sum()) - np.repeat(self._heads - first[self._filled] - 1, sizes)

    def hints(self, order: Ints) -> Floats:
        """Give start times in seconds, NaN for what comes too late."""
        starts = self._starts(order)
        hints = np.full(order.size, np.nan)
        hints[order] = np.where(starts <= self._latest[order], self.ready + self.step * starts, np.nan)
        return hints

    def _starts(self, order: Ints) -> Ints:
        durations = self.durations[order]
        return np.asarray(np.cumsum(durations) - durations)

    def descended(self, order: Ints, watch: Stopwatch) -> tuple[Ints, float]:
        """Improve an order by the best sets of moves until none gains anything; also give its cost."""
        while not watch.is_over():
            gains, kinds = self._moves(order)
            gain, chosen = _best_set(gains)
            if gain >= -IMPROVEMENT:
                break
            order = order.copy()
            for first, last in chosen:
                part = slice(first, last + 1)
                order[part] = _moved(order[part], int(kinds[first, last]))
        return order, float(self._costs[order * self._width + self._starts(order)].sum())

    def _moves(self, order: Ints) -> tuple[Floats, Ints]:
        """Give for each two places the change in cost by the best move of the jobs there, and which it is."""
        durations, starts = self.durations[order], self._starts(order)
        base, above, costs = order * self._width, self._above, self._costs
        now = costs[base + starts]
        ends = starts + durations
        length = durations[:, None]
        # Rows: the job that moves; columns: the others, or the place where it goes.
        earlier = np.where(above, costs.take(base + np.maximum(starts - length, 0)) - now, 0.0)
        later = np.where(above.T, costs.take(base + np.minimum(starts + length, self._width - 1)) - now, 0.0)
        last_start = costs.take(base[:, None] + np.maximum(ends - length, 0)) - now[:, None]
        first_start = costs.take(base[:, None] + starts) - now[:, None]
        moves = np.full((3, order.size, order.size), np.inf)
        moves[0] = np.where(above, np.cumsum(earlier, axis=1) + last_start, np.inf)
        back = np.cumsum(later[:, ::-1], axis=1)[:, ::-1] + first_start
        moves[1] = np.where(above, back.T, np.inf)
        first, second = self._pairs
        pair, middle = self._of_pair, self._middle
        shift = durations[second] - durations[first]
        swapped = last_start[first, second] + first_start[second, first]
        changed = costs.take(base[middle] + starts[middle] + shift[pair]) - now[middle]
        if changed.size:
            swapped[self._filled] += np.add.reduceat(changed, self._heads)
        moves[2, first, second] = swapped
        kinds = moves.argmin(axis=0)
        return np.take_along_axis(moves, kinds[None], axis=0)[0], kinds


def _moved(jobs: Ints, kind: int) -> Ints:
    """Put the first job last, the last one first, or swap them."""
    if kind == 0:
        return np.append(jobs[1:], jobs[0])
    if kind == 1:
        return np.append(jobs[-1], jobs[:-1])
    return np.concatenate([jobs[-1:], jobs[1:-1], jobs[:1]])


def _best_set(gains: Floats) -> tuple[float, list[tuple[int, int]]]:
    """Give the set of moves between disjoint pairs of places that gains most, and what it gains."""
    count = len(gains)
    best, begin = np.zeros(count + 1), np.full(count + 1, -1)
    for last in range(1, count):
        totals = best[:last] + gains[:last, last]
        first = int(totals.argmin())
        best[last + 1] = best[last]
        if totals[first] < best[last]:
            best[last + 1], begin[last + 1] = totals[first], first
    chosen, place = [], count
    while place > 1:
        if begin[place] < 0:
            place -= 1
        else:
            chosen.append((int(begin[place]), place - 1))
            place = int(begin[place])
    return float(best[-1]), chosen
