"""A dynamic program over sets of jobs that knows the starts on which later ones still depend.

A state is a set S of jobs done, the slots from which on agents are free, and the starts of the open jobs
(`fuzzytime.scheduling.exact.open_jobs`): whether lags can be kept is told by these alone. Jobs are added one
by one, the first of a lag before the second unless that may start sooner, at every slot at which an agent is
free and all lags are kept. A start on which nothing depends any more is forgotten, so that states become
equal; and of states that differ in one moment only, those that cost more and leave less room are dropped.
With prices λ, and V the cheapest path of an agent to the end (`fuzzytime.scheduling.bound.paths`), a schedule
that continues a state costs at least

    base + Σ of (c + λ) over S + Σ of λ over the jobs that are lost by now + Σ of V[free] over the agents,

and also at least what each job outside S costs for itself in the room that is left to it
(`fuzzytime.scheduling.exact.leeway`). States for which that reaches a threshold are dropped, too. So what is
found is the best of the grid, and where nothing is found every schedule costs at least the threshold.
"""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.bound.paths import Arcs, ways_to_end
from fuzzytime.scheduling.exact.leeway import Leeway
from fuzzytime.scheduling.exact.open_jobs import JobSet, States, needed
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import Grid, Ints

TOGETHER = 1 << 19
"""Starts that are tried at once, or those of one state."""


class _Front(NamedTuple):
    """The states of a set to go on with, and bounds on what a schedule costs besides.

    One is λ of what is ``lost`` and V of each agent ``ahead``; the other is the ``least``, job by job.
    """

    inside: JobSet
    states: States
    lost: Floats
    ahead: Floats
    least: Floats

    @property
    def total(self) -> Floats:
        """What a schedule that continues a state costs at least, less the base."""
        total: Floats = self.states.cost + np.maximum(self.lost + self.ahead.sum(axis=1), self.least)
        return total

    def select(self, keep: Ints) -> "_Front":
        """Give some of the states."""
        return _Front(
            self.inside, self.states.select(keep), self.lost[keep], self.ahead[keep], self.least[keep]
        )


class _Starts(NamedTuple):
    """Where a job may start on an agent: for each state so many slots from a first one on."""

    job: int
    agent: int
    first: Ints
    slots: Ints


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """The cost of the best schedule below the threshold, its starts, −1 for what is rejected, and lanes.

    ``exact`` says that no schedule below the threshold was cut off.
    """

    exact: bool
    cost: float = np.inf
    starts: Ints | None = None
    lanes: Ints | None = None


class Waiting:
    """The program over the arcs of all lanes.

    Parameters
    ----------
    grid
        Durations, lags and horizon.
    lanes
        For each lane its arcs, those of jobs shorter than a slot included.
    agents
        How many each lane has.
    prices : array of shape (jobs,)
        λ; of a job shorter than a slot the most that it can gain.
    """

    def __init__(self, grid: Grid, lanes: Sequence[Arcs], agents: Sequence[int], prices: Floats) -> None:
        self._durations, self._lags, self._prices = grid.durations.tolist(), grid.lags, prices
        self._base = float((grid.rejections - prices).sum())
        self._lane_of = np.repeat(np.arange(len(agents)), agents).tolist()
        self._leeway = Leeway(lanes, agents, grid.lags, prices)
        self._beyond = [
            ways_to_end(arcs.select(arcs.end > arcs.start), grid.durations, grid.slots, prices)
            for arcs in lanes
        ]
        self._sets: dict[int, JobSet] = {}
        self._states: dict[int, States] = {}
        self._used: dict[tuple[int, int], list[Ints]] = {}

    def run(self, threshold: float, watch: Stopwatch, cells: int, width: int | None = None) -> Found:
        """Search the best schedule that costs less than a threshold.

        Parameters
        ----------
        threshold
            For the cost.
        watch
            Asked before each job that is added to a set.
        cells
            Starts that are tried at most, the measure of time and memory.
        width
            States that sets of one size go on with at most; None for all.
        """
        limit, exact = threshold - self._base, True
        self._states, self._used = {}, defaultdict(list)
        free, none = np.zeros((1, len(self._lane_of)), np.int64), np.zeros(1, np.int64)
        last = States(free, free[:, :0], np.zeros(1), none, none, none, none)
        arriving, best, chosen = {0: [last]}, limit, 0
        while arriving:
            fronts: list[_Front] = []
            for done, pieces in arriving.items():
                fronts.append(self._front(done, States.together(pieces), limit))
                cost, row = self._finished(fronts[-1])
                if cost < best:
                    best, chosen, last = cost, done, fronts[-1].states.select(row)
                if watch.is_over():
                    return Found(exact=False)
            if width is not None:
                fronts, all_of_them = _cheapest(fronts, width)
                limit, exact = best, exact and all_of_them
            arriving = defaultdict(list)
            for front in fronts:
                self._states[front.inside.done] = front.states
                for job, tried, piece in self._added(front, limit):
                    arriving[front.inside.done | 1 << job].append(piece)
                    cells -= tried
                    if cells < 0 or watch.is_over():
                        return Found(exact=False)
        if best >= threshold - self._base:
            return Found(exact)
        return Found(exact, self._base + best, *self._traced(chosen, last))

    def used(self, lane: int, arcs: Arcs) -> Arcs:
        """Give those of a lane's arcs that schedules below the last threshold use."""
        keep = np.zeros(arcs.job.size, bool)
        for job in np.unique(arcs.job).tolist():
            starts = np.concatenate([np.empty(0, np.int64), *self._used[lane, job]])
            keep |= (arcs.job == job) & np.isin(arcs.start, starts)
        return arcs.select(keep)

    def _set(self, done: int) -> JobSet:
        if done not in self._sets:
            self._sets[done] = JobSet.of(done, self._durations, self._lags)
        return self._sets[done]

    def _front(self, done: int, states: States, limit: float) -> _Front:
        """Give the states of a set to go on with."""
        inside = self._set(done)
        room = self._leeway.room(inside, states)
        front = _Front(inside, states, self._prices @ room.lost, self._ahead(inside, states), room.least)
        keep = np.flatnonzero(~room.vain & (front.total < limit))
        front = front.select(keep)
        opened, pinned = self._leeway.opened(inside, front.states, room.select(keep))
        states = front.states._replace(opened=opened)
        return front._replace(states=states).select(needed(states, pinned))

    def _ahead(self, inside: JobSet, states: States) -> Floats:
        """Give V for each agent of each state; its first job is not done yet."""
        is_done = np.ones(self._prices.size + 1, bool)
        is_done[[*inside.outside, -1]] = False
        parts = []
        for agent, lane in enumerate(self._lane_of):
            free, ways = states.free[:, agent], self._beyond[lane]
            parts.append(np.where(is_done[ways.last[free]], ways.second[free], ways.cost[free]))
        return np.stack(parts, axis=1)

    def _finished(self, front: _Front) -> tuple[float, Ints]:
        """Give the least cost of a schedule with just these jobs, and the state that has it."""
        cost = front.states.cost
        if not cost.size or any(bond.must for bond in front.inside.bonds):
            return np.inf, np.empty(0, np.int64)
        row = np.array([int(cost.argmin())])
        return float(cost[row[0]] + self._prices[front.inside.outside].sum()), row

    def _added(self, front: _Front, limit: float) -> Iterator[tuple[int, int, States]]:
        """Add each job that may come next, at some starts at once: it, how many, and the states of these."""
        inside, states = front.inside, front.states
        for job in inside.ready if states.cost.size else ():
            for agent, lane in enumerate(self._lane_of):
                if job not in self._leeway.costs[lane]:
                    continue
                costs = self._leeway.costs[lane][job]
                low = np.maximum(states.free[:, agent], costs.first).astype(float)
                high = np.full(low.size, float(costs.last))
                if agent + 1 < self._leeway.team[lane][1]:
                    # Of a lane's agents that are free the one who has waited least does it.
                    high = np.minimum(high, states.free[:, agent + 1] - 1)
                for bond in inside.bonds:
                    if bond.job == job:
                        low = np.maximum(low, states.opened[:, bond.place] + bond.low)
                        high = np.minimum(high, states.opened[:, bond.place] + bond.high)
                count = np.maximum(high - low + 1, 0).astype(np.int64)
                starts, some = _Starts(job, agent, low.astype(np.int64), count), np.flatnonzero(count)
                parts = np.cumsum(count[some]) // TOGETHER
                for part in np.unique(parts).tolist():
                    rows = some[parts == part]
                    yield job, int(count[rows].sum()), self._started(front, starts, rows, limit)

    def _started(self, front: _Front, starts: _Starts, rows: Ints, limit: float) -> States:
        """Start a job wherever it may start, in some rows."""
        states, job, agent, count = front.states, starts.job, starts.agent, starts.slots[rows]
        lane = self._lane_of[agent]
        costs, first = self._leeway.costs[lane][job], starts.first
        row = np.repeat(rows, count)
        start = first[row] + np.arange(row.size) - np.repeat(np.cumsum(count) - count, count)
        cost, end = states.cost[row] + costs.gains[start - costs.first], start + self._durations[job]
        others = front.lost + front.ahead.sum(axis=1) - front.ahead[:, agent]
        keep = np.flatnonzero(cost + others[row] + self._beyond[lane].cost[end] < limit)
        self._used[lane, job].append(np.unique(start[keep]))
        if front.inside.had_better_start_soon(job, self._lags):
            keep = keep[costs.as_good[start[keep] - costs.first] < first[row[keep]]]
        row, start = row[keep], start[keep]
        free = states.free[row]
        free[:, agent] = end[keep]
        free[:, slice(*self._leeway.team[lane])].sort(axis=1)
        known = dict(zip(front.inside.opened, states.opened[row].T, strict=True)) | {job: start}
        opened = self._set(front.inside.done | 1 << job).opened
        moments = np.column_stack([known[one] for one in opened]) if opened else free[:, :0]
        return States(free, moments, cost[keep], np.full(row.size, job), start, np.full(row.size, lane), row)

    def _traced(self, done: int, last: States) -> tuple[Ints, Ints]:
        """Give start slots and lanes of a state of a set: back from set to set."""
        starts, lanes = np.full(self._prices.size, -1), np.zeros(self._prices.size, np.int64)
        while done:
            job = int(last.job[0])
            starts[job], lanes[job] = last.start[0], last.lane[0]
            done ^= 1 << job
            last = self._states[done].select(last.before)
        return starts, lanes


def _cheapest(fronts: list[_Front], width: int) -> tuple[list[_Front], bool]:
    """Give so many states of some sets that cost least, and tell whether these are all."""
    totals = np.concatenate([front.total for front in fronts])
    if totals.size <= width:
        return fronts, True
    keep = np.zeros(totals.size, bool)
    keep[np.argpartition(totals, width)[:width]] = True
    parts = np.split(keep, np.cumsum([front.lost.size for front in fronts])[:-1])
    return [front.select(np.flatnonzero(mine)) for front, mine in zip(fronts, parts, strict=True)], False
