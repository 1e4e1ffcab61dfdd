"""A bound by relaxing "each job at most once": every agent takes the cheapest path, and visits have prices.

For prices 0 ≤ λ_i ≤ L_i every schedule costs at least

    D(λ) = Σ_i (L_i − λ_i) + Σ over lanes of agents · V(last slot),

with V the cheapest path over time on that lane that does no job twice in succession
(`fuzzytime.scheduling.bound.paths`). With U_i the cheapest path from the beginning whose last job is not i,
and B_i that to the end whose first job is not i, a schedule with an arc of job i from slot t costs at least D
− V(last slot) + U_i[t] + c_i(t) + λ_i + B_i[t + d_i]: an arc for which that is no less than a known
schedule's cost can be deleted.
"""

import math
from dataclasses import replace

import numpy as np

from fuzzytime.satisfaction import Floats, Interval
from fuzzytime.scheduling.bound.multipliers import LITTLE_RISE, RISE, Multipliers
from fuzzytime.scheduling.bound.paths import Arcs, Paths, arcs_of, instants_of, ways_to_end
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import ROUNDING, Grid, Ints
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.problem.windows import in_common
from fuzzytime.scheduling.solver import Draft
from fuzzytime.scheduling.timing.orders import Order
from fuzzytime.scheduling.timing.settle import lanes_of_agents, sequences

QUICK = 0.9
"""The bound rises slowly where the gap does not fall to this share of itself between two deletions."""


TOGETHER, BESIDE = 100, 50
"""Jobs of an order that are timed at once for their prices, and those before and behind that give way.

All at once would take room for each of them at every slot.
"""


class Relaxation:
    """The bound for one grid, its prices, and the arcs that are left.

    Parameters
    ----------
    problem, grid
        What is bounded.
    upper
        The cost of a known schedule.
    prices : array of shape (jobs,)
        Where to begin, as from another grid.
    """

    def __init__(self, problem: Problem, grid: Grid, upper: float, prices: Floats) -> None:
        self.grid = grid
        self.agents = [len(lane.agents) for lane in problem.lanes]
        self.ceiling = np.where(grid.durations > 0, grid.rejections, 0.0)
        # What takes no slot is done at its best moment whatever else is done.
        instant = np.flatnonzero(grid.durations == 0).tolist()
        self._instant = math.fsum(_best_gain(grid, job) for job in instant)
        self.base = float(grid.rejections.sum()) + self._instant
        lanes = [[curves[lane] for curves in grid.curves] for lane in range(len(self.agents))]
        self.arcs = [arcs_of(curves, grid.durations) for curves in lanes]
        self.instants = [instants_of(curves, grid.durations) for curves in lanes]
        self._paths = [Paths(arcs, grid.durations, grid.slots) for arcs in self.arcs]
        self._multipliers = Multipliers(self, np.clip(prices, 0.0, self.ceiling), upper)

    @property
    def lower(self) -> float:
        """What is proved."""
        return max(self._multipliers.lower, 0.0)

    @property
    def prices(self) -> Floats:
        """λ of the best bound."""
        return self._multipliers.prices

    def evaluate(self, prices: Floats) -> tuple[float, Floats]:
        """Give D and a gradient."""
        value, gradient = self.base - float(prices.sum()), np.full(prices.size, -1.0)
        for agents, paths in zip(self.agents, self._paths, strict=True):
            value += agents * float(paths.run(prices).cost[-1])
            visited = [job for job, _ in paths.path()]
            gradient += agents * np.bincount(visited, minlength=prices.size)
        return value, gradient

    def cheapest(self) -> list[float]:
        """Give what the best bound's path costs on each lane."""
        return [float(paths.run(self.prices).cost[-1]) for paths in self._paths]

    def improve(
        self,
        upper: float,
        steps: int,
        enough: float,
        watch: Stopwatch,
        rounds: float = math.inf,
        worth: float = 0.9,
    ) -> None:
        """Search better prices, and delete the arcs that no schedule below a known cost uses.

        Parameters
        ----------
        upper
            That cost.
        steps
            Evaluations between two deletions.
        enough
            The gap at which to end.
        watch
            Asked before each evaluation.
        rounds
            Deletions at most.
        worth
            To what share of itself the gap must fall between two deletions, or the search ends.
        """
        left, is_highest, rise = np.inf, False, RISE
        while enough < upper - self.lower < worth * left and rounds > 0 and not watch.is_over():
            rounds -= 1
            left = upper - self.lower
            if is_highest:
                # What the search for prices remembers is about arcs that are gone: it begins again.
                self._multipliers = Multipliers(self, self.prices, upper)
            is_highest = self._multipliers.improve(upper, steps, watch, rise)
            rise = RISE if upper - self.lower < QUICK * left else LITTLE_RISE
            if not watch.is_over():
                self.fix(upper)

    def reduced_costs(self) -> list[Floats]:
        """Give for each lane, for each arc, what a schedule with it costs at least."""
        found, prices = [], self.prices
        value, _ = self.evaluate(prices)
        for arcs, paths in zip(self.arcs, self._paths, strict=True):
            forward = paths.run(prices)
            backward = ways_to_end(arcs, self.grid.durations, self.grid.slots, prices)
            through = forward.without(arcs.start, arcs.job) + backward.without(arcs.end, arcs.job)
            found.append(value - forward.cost[-1] + through + arcs.gain + prices[arcs.job])
        return found

    def everything_below(self, limit: float) -> list[Arcs]:
        """Give the same, and all starts of the jobs that are shorter than a slot."""
        pairs = zip(self.arcs_below(limit), self.instants, strict=True)
        return [Arcs.together(*pair) for pair in pairs]

    def arcs_below(self, limit: float) -> list[Arcs]:
        """Give for each lane the arcs that a schedule which costs less than a limit may use."""
        pairs = zip(self.arcs, self.reduced_costs(), strict=True)
        return [arcs.select(reduced < limit) for arcs, reduced in pairs]

    def visited(self) -> Ints:
        """Give the starts of the jobs that the best bound's paths visit, −1 for others.

        Of several visits of one job that which satisfies most counts.
        """
        self.evaluate(self.prices)
        starts, least = np.full(self.prices.size, -1), np.full(self.prices.size, np.inf)
        for lane, paths in enumerate(self._paths):
            for job, slot in paths.path():
                curve = self.grid.curves[job][lane]
                gain = curve.gains[slot - curve.first]
                if gain < least[job]:
                    starts[job], least[job] = slot, gain
        return starts

    def fix(self, upper: float) -> None:
        """Delete the arcs that no schedule better than a known one uses."""
        self.keep(self.arcs_below(upper))

    def keep(self, arcs: list[Arcs]) -> None:
        """Go on with these arcs only, for each lane."""
        self.arcs = arcs
        self._paths = [Paths(arcs, self.grid.durations, self.grid.slots) for arcs in self.arcs]

    def restrict(self, problem: Problem) -> None:
        """Delete the arcs that are not next to a problem's windows."""
        kept = []
        for lane, arcs in enumerate(self.arcs):
            times = self.grid.times(arcs.start)
            near = np.zeros(times.size, bool)
            first = np.searchsorted(arcs.job, np.arange(len(problem.jobs) + 1)).tolist()
            for job, mine in zip(problem.jobs, map(slice, first[:-1], first[1:]), strict=True):
                for window in job.windows[lane]:
                    low, high = window.low - self.grid.step, window.high + self.grid.step
                    near[mine] |= (low < times[mine]) & (times[mine] < high)
            kept.append(arcs.select(near))
        self.keep(kept)

    def narrowed(self, problem: Problem) -> Problem:
        """Give the problem with windows cut to the cells next to arcs that are left.

        A start inside a cell stands for starts at its two ends: where neither is left, no schedule better
        than the known one starts in the cell, in continuous time.
        """
        jobs = []
        for index, job in enumerate(problem.jobs):
            if self.grid.durations[index]:
                lanes = zip(job.windows, self.arcs, strict=True)
                windows = tuple(self._cut(mine, arcs.start[arcs.job == index]) for mine, arcs in lanes)
                jobs.append(replace(job, windows=windows))
            else:
                jobs.append(job)
        return replace(problem, jobs=tuple(jobs))

    def _cut(self, windows: tuple[Interval, ...], starts: Ints) -> tuple[Interval, ...]:
        """Give what windows have in common with the cells next to some slots, which ascend."""
        edges = np.flatnonzero(np.diff(starts, prepend=-2, append=np.iinfo(np.int64).max) > 1)
        lows, highs = self.grid.times(starts[edges[:-1]] - 1), self.grid.times(starts[edges[1:] - 1] + 1)
        return in_common(windows, map(Interval, lows.tolist(), highs.tolist()))


def _best_gain(grid: Grid, job: int) -> float:
    return min(0.0, *(float(curve.gains.min(initial=0.0)) for curve in grid.curves[job]))


def prices_from(problem: Problem, grid: Grid, draft: Draft) -> Floats:
    """Give for each job what a schedule loses without it: near the best prices where the schedule is good.

    The order of each agent is timed on the grid, a long one part by part, each with what stands beside it.
    A job that is rejected is worth nothing.
    """
    prices = np.zeros(len(problem.jobs))
    for agent, row in sequences(problem, draft.starts, draft.agents).items():
        lane = lanes_of_agents(problem)[agent]
        slots = (np.floor(draft.starts[row] / grid.step + ROUNDING).astype(np.int64) - grid.origin).tolist()
        for first in range(0, len(row), TOGETHER):
            low, high = max(first - BESIDE, 0), first + TOGETHER + BESIDE
            begin = slots[low - 1] + int(grid.durations[row[low - 1]]) if low else 0
            end = slots[high] if high < len(row) else grid.slots
            found = _prices_between(grid, lane, begin, max(begin, end), row[low:high])
            for job in row[first : first + TOGETHER]:
                prices[job] = found[job]
    return prices


def _prices_between(grid: Grid, lane: int, begin: int, end: int, row: list[int]) -> dict[int, float]:
    durations = {job: int(grid.durations[job]) for job in row}
    curves = {job: grid.curves[job][lane].between(begin, end - durations[job], begin) for job in row}
    return Order(curves, durations, 0, end - begin, row).prices()
