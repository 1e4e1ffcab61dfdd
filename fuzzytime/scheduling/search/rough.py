"""A rough plan in slots, improved stretch by stretch: take a job out, put it back where it is best.

Each agent's order has the tables of `fuzzytime.scheduling.timing.orders`, so that one job is tried at every
place of every agent at once, with the best slots for all others. Jobs that start next to each other are
improved together, a stretch of them after the other, while the rest stands still. Lags cut a job's curve by
where the other job is; where both move, at a moment drawn between them, which neither crosses. Where no
single job is better elsewhere, kicks go on (`fuzzytime.scheduling.search.kicks`).
"""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import ROUNDING, Curve, Grid
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.solver import Draft
from fuzzytime.scheduling.timing.orders import Order
from fuzzytime.scheduling.timing.settle import lanes_of_agents

STRETCH = 40
"""Jobs that are improved together."""

IMPROVEMENT = 1e-7
"""A change of order must gain more than this."""


class State(NamedTuple):
    """Which jobs of a plan are placed, in which slots, by whom."""

    placed: tuple[bool, ...]
    slots: tuple[int, ...]
    agents: tuple[int, ...]


class _Split(NamedTuple):
    """Where the first of two jobs with a lag may start: from the first slot to the last."""

    early: float
    late: float


class Rough:
    """A plan in slots: for every job an agent and a start, or the time where it would like to start.

    Parameters
    ----------
    problem, grid
        What is planned.
    warm
        Where to begin; jobs that it rejects are left out at first.
    """

    def __init__(self, problem: Problem, grid: Grid, warm: Draft) -> None:
        self.problem = problem
        self.grid = grid
        self.lanes = lanes_of_agents(problem)
        self.agents = list(warm.agents.tolist())
        self.placed = [not math.isnan(start) for start in warm.starts.tolist()]
        self.slots = [_favourite(grid, job) for job in range(len(self.placed))]
        for job, start in enumerate(warm.starts.tolist()):
            if self.placed[job]:
                self.slots[job] = round(start / grid.step) - grid.origin
        self._lags_of: dict[int, list[int]] = {}
        for index, lag in enumerate(grid.lags):
            self._lags_of.setdefault(lag.first, []).append(index)
            self._lags_of.setdefault(lag.second, []).append(index)

    def improve(self, watch: Stopwatch, generator: np.random.Generator, sweeps: float) -> None:
        """Improve stretch after stretch until nothing more is gained, or the stopwatch is over."""
        count = len(self.placed)
        better, done = True, 0
        while better and done < sweeps and not (done and watch.is_over()):
            better, done = False, done + 1
            for first in range(0, max(count - STRETCH // 2, 1), STRETCH // 2):
                members = self.in_turn()[first : first + STRETCH]
                better |= self._improve_stretch(members, watch, generator, sweeps)
                # In the first sweep what was left out is put in, which takes no time to speak of.
                if done > 1 and watch.is_over():
                    break
            # A second look sees more only where jobs stood still, or waited for some not placed before.
            if count <= STRETCH and not self.grid.lags:
                break

    def in_turn(self) -> list[int]:
        """Give the jobs as they follow each other, the others by where they would like to start."""
        return sorted(range(len(self.placed)), key=lambda job: (self.slots[job], job))

    def state(self) -> State:
        """Give what moves, to go back to."""
        return State(tuple(self.placed), tuple(self.slots), tuple(self.agents))

    def restore(self, state: State) -> None:
        """Go back to an earlier state."""
        self.placed, self.slots, self.agents = list(state.placed), list(state.slots), list(state.agents)

    def _improve_stretch(
        self, members: Sequence[int], watch: Stopwatch, generator: np.random.Generator, sweeps: float
    ) -> bool:
        """Take out and put back each of some jobs until nothing more is gained; tell whether anything was."""
        stretch = Stretch(self, members, generator)
        better, done = True, 0
        while better and done < sweeps and not watch.is_over():
            better, done = False, done + 1
            for job in generator.permutation(members).tolist():
                better |= stretch.reinsert(job)
        stretch.settle()
        return stretch.gain < stretch.begun - IMPROVEMENT

    def splits(self, members: Sequence[int], generator: np.random.Generator) -> dict[int, _Split]:
        """Draw for each lag between jobs that both move from where on and up to where the first may start.

        Whatever the second does within what these leave it, the lag is kept.
        """
        moving, drawn = set(members), {}
        for index, lag in enumerate(self.grid.lags):
            first, second, least, most = lag.first, lag.second, lag.low, lag.high
            if first in moving and second in moving and self.placed[first]:
                early, late = -math.inf, float(self.slots[first])
                if self.placed[second]:
                    room = max(self.slots[second] - int(least) - self.slots[first], 0)
                    late += float(generator.integers(room + 1))
                if most < math.inf:
                    early = self.slots[first]
                    if self.placed[second]:
                        room = max(self.slots[first] - self.slots[second] + int(most), 0)
                        early -= float(generator.integers(room + 1))
                drawn[index] = _Split(early, late)
        return drawn

    def span(self, job: int, splits: Mapping[int, _Split]) -> tuple[float, float]:
        """Give the first and last slot at which a job keeps its lags to jobs that are placed."""
        low, high = -math.inf, math.inf
        for index in self._lags_of.get(job, ()):
            lag = self.grid.lags[index]
            first, second, least, most = lag.first, lag.second, lag.low, lag.high
            if index in splits:
                early, late = splits[index]
            elif not self.placed[first if job == second else second]:
                if job == second:
                    return math.inf, -math.inf
                continue
            elif job == second:
                early = late = self.slots[first]
            else:
                early, late = self.slots[second] - most, self.slots[second] - least
            if job == first:
                low, high = max(low, early), min(high, late)
            else:
                low = max(low, late + least)
                high = min(high, early + most) if most < math.inf else high
        return low, high


class Stretch:
    """Some jobs of a rough plan that move while the others stand still."""

    def __init__(self, plan: Rough, members: Sequence[int], generator: np.random.Generator) -> None:
        self.plan = plan
        self.splits = plan.splits(members, generator)
        self.members = members
        grid, moving = plan.grid, set(members)
        durations = grid.durations.tolist()
        first = min(plan.slots[job] for job in members)
        possible = [
            (curve, durations[job]) for job in members for curve in grid.curves[job] if curve.gains.size
        ]
        earliest = min((curve.first for curve, _ in possible), default=0)
        latest = max((curve.stop - 1 + duration for curve, duration in possible), default=0)
        begins, ends = dict.fromkeys(plan.lanes, earliest), dict.fromkeys(plan.lanes, latest)
        for job, agent in enumerate(plan.agents):
            if job in moving or not plan.placed[job]:
                continue
            if plan.slots[job] <= first:
                begins[agent] = max(begins[agent], plan.slots[job] + durations[job])
            else:
                ends[agent] = min(ends[agent], plan.slots[job])
        self.origin = min(begins.values())
        self.durations = {job: durations[job] for job in members}
        placed = [job for job in members if plan.placed[job]]
        placed.sort(key=lambda job: (plan.slots[job], self.durations[job], job))
        self.agent_of = {job: plan.agents[job] for job in placed}
        self.orders = {}
        for agent, lane in plan.lanes.items():
            begin, end = begins[agent] - self.origin, ends[agent] - self.origin
            curves = {job: self._cut(grid.curves[job][lane], job, end) for job in members}
            mine = [job for job in placed if plan.agents[job] == agent]
            self.orders[agent] = Order(curves, self.durations, begin, max(end, begin), mine)
        # Putting in what was left out is an improvement, too.
        self.begun = self.gain
        for job in members:
            if job not in self.agent_of:
                self.reinsert(job)

    def _cut(self, curve: Curve, job: int, end: int) -> Curve:
        """Give a curve on the stretch's slots, where the job ends in time and keeps its lags."""
        low, high = self.plan.span(job, self.splits)
        last = self.origin + end - self.durations[job]
        return curve.between(max(self.origin, low), min(last, high), self.origin)

    @property
    def gain(self) -> float:
        """What the members cost less their rejection."""
        return math.fsum(order.gain for order in self.orders.values())

    def reinsert(self, job: int) -> bool:
        """Put a job where it is best, and tell whether that gained anything."""
        agent, now = self.agent_of.get(job), self.gain
        removed = self.orders[agent].remove(job) if agent is not None else None
        rest = self.gain
        best, target, where = min(
            (rest - order.gain + cost, name, where)
            for name, order in self.orders.items()
            for cost, where in [order.best_insertion(job)]
        )
        if best < now - IMPROVEMENT:
            self.agent_of[job] = target
            self.orders[target].insert(where, job)
            return True
        if agent is not None and removed is not None:
            self.orders[agent].put_back(removed)
        return False

    def settle(self) -> None:
        """Write the slots that were found into the plan."""
        plan = self.plan
        for job in self.members:
            plan.placed[job] = False
        for agent, order in self.orders.items():
            for job, slot in order.starts().items():
                plan.placed[job], plan.slots[job], plan.agents[job] = True, slot + self.origin, agent


def _favourite(grid: Grid, job: int) -> int:
    """Give the middle of the best slots of a job."""
    curve = min(grid.curves[job], key=lambda curve: curve.gains.min(initial=np.inf))
    best = np.flatnonzero(curve.gains <= curve.gains.min(initial=np.inf) + ROUNDING)
    return curve.first + int(best.mean()) if best.size else 0
