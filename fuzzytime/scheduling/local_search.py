"""Local search over who does what in which order: take a job out, put it back where it is best.

Each agent's order has the tables of `fuzzytime.scheduling.orders`, so that one job is tried at every place of
every agent at once, with the best slots for all others. Jobs that start next to each other are improved
together, a stretch of them after the other, while the rest stands still. Lags cut a job's curve by where the
other job is; where both move, at a moment drawn between them, which neither crosses.

Where no single job is better elsewhere, kicks go on: several jobs, neighbours or any, are taken out at once,
put back one by one, and that is kept unless it loses (ruin and recreate: Schrimpf, Schneider,
Stamm-Wilbrandt and Dueck, J. Comput. Phys. 159 (2000) 139-171).
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import ClassVar, NamedTuple

import numpy as np

from fuzzytime.scheduling.dynasearch import MOST_JOBS, Dynasearch, only_order_counts
from fuzzytime.scheduling.grid import ROUNDING, Curve, Grid, grid_of, step_for
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.orders import Order
from fuzzytime.scheduling.problem import Problem
from fuzzytime.scheduling.settle import lanes_of_agents, settled
from fuzzytime.scheduling.solver import Draft, nothing

STRETCH = 40
"""Jobs that are improved together."""

MOST_KICKED = 10
"""Jobs that a kick takes out, at most."""

KICKS_A_STRETCH = 20
"""Kicks before another stretch has its turn."""

IMPROVEMENT = 1e-7
"""A change of order must gain more than this."""


@dataclass(frozen=True, slots=True)
class LocalSearch:
    """Reinsertion local search on a grid, timed in continuous time; no bound.

    Parameters
    ----------
    seed
        Of the order in which jobs are tried.
    slots
        Slots of the grid, at least.
    kicks
        How many.
    patience
        How many of them may gain nothing in a row before the search ends.
    sweeps
        How often all jobs are tried at most: fewer than it takes is quick, and leaves work to do.
    """

    name: ClassVar[str] = "local-search"

    seed: int = 0
    slots: int = 1500
    kicks: int = 0
    patience: float = math.inf
    sweeps: float = math.inf

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Improve until no job is better elsewhere; where only the order counts, by dynasearch."""
        if len(problem.jobs) <= MOST_JOBS and only_order_counts(problem):
            return Dynasearch(self.seed, self.slots).search(problem, watch, warm)
        begin = warm or nothing(problem)
        grid = grid_of(problem, step_for(problem, self.slots))
        plan = Rough(problem, grid, begin)
        try:
            generator = np.random.default_rng(self.seed)
            plan.improve(watch, generator, self.sweeps)
            plan.kick(self.kicks, self.patience, watch, generator)
        except KeyboardInterrupt:
            watch.stop()
        hints = np.where(plan.placed, grid.times(np.array(plan.slots, np.int64)), np.nan)
        draft = settled(problem, hints, np.array(plan.agents, np.int64), 4 * grid.step)
        return draft if draft.cost < begin.cost else begin


class _SlotLag(NamedTuple):
    """slot(second) − slot(first) lies in [low, high]."""

    first: int
    second: int
    low: float
    high: float


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
        self._lags: list[_SlotLag] = []
        for lag in problem.lags:
            low = math.floor(lag.low / grid.step + ROUNDING)
            high = math.ceil(lag.high / grid.step - ROUNDING) if lag.high < math.inf else math.inf
            self._lags.append(_SlotLag(lag.first, lag.second, low, high))
        self._lags_of: dict[int, list[int]] = {}
        for index, bound in enumerate(self._lags):
            self._lags_of.setdefault(bound.first, []).append(index)
            self._lags_of.setdefault(bound.second, []).append(index)

    def improve(self, watch: Stopwatch, generator: np.random.Generator, sweeps: float) -> None:
        """Improve stretch after stretch until nothing more is gained, or the stopwatch is over."""
        count = len(self.placed)
        better, done = True, 0
        while better and done < sweeps and not watch.is_over():
            better, done = False, done + 1
            for first in range(0, max(count - STRETCH // 2, 1), STRETCH // 2):
                ranking = sorted(range(count), key=lambda job: (self.slots[job], job))
                members = ranking[first : first + STRETCH]
                better |= self._improve_stretch(members, watch, generator, sweeps)
                if watch.is_over():
                    break
            # A second look sees more only where jobs stood still, or waited for some not placed before.
            if count <= STRETCH and not self._lags:
                break

    def kick(self, kicks: int, patience: float, watch: Stopwatch, generator: np.random.Generator) -> None:
        """Kick stretches drawn at random, all jobs where they are few, until nothing is gained any more."""
        count = len(self.placed)
        together = KICKS_A_STRETCH if count > STRETCH else max(kicks, 1)
        done = fruitless = 0
        while done < kicks and fruitless < patience and not watch.is_over():
            ranking = sorted(range(count), key=lambda job: (self.slots[job], job))
            first = int(generator.integers(max(count - STRETCH, 0) + 1))
            stretch = _Stretch(self, ranking[first : first + STRETCH], generator)
            for _ in range(min(kicks - done, together)):
                if watch.is_over():
                    break
                stretch.kick(generator)
            stretch.settle()
            done += together
            fruitless = 0 if stretch.gain < stretch.begun - IMPROVEMENT else fruitless + together

    def _improve_stretch(
        self, members: Sequence[int], watch: Stopwatch, generator: np.random.Generator, sweeps: float
    ) -> bool:
        """Take out and put back each of some jobs until nothing more is gained; tell whether anything was."""
        stretch = _Stretch(self, members, generator)
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
        for index, (first, second, least, most) in enumerate(self._lags):
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
            first, second, least, most = self._lags[index]
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


class _Stretch:
    """Some jobs of a rough plan that move while the others stand still."""

    def __init__(self, plan: Rough, members: Sequence[int], generator: np.random.Generator) -> None:
        self.plan = plan
        self.splits = plan.splits(members, generator)
        self.members = members
        grid, moving = plan.grid, set(members)
        durations = grid.durations.tolist()
        first = min(plan.slots[job] for job in members)
        begins, ends = dict.fromkeys(plan.lanes, 0), dict.fromkeys(plan.lanes, grid.slots)
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
        first = int(max(curve.first, self.origin, low)) if low < math.inf else curve.stop
        last = min(curve.stop - 1, self.origin + end - self.durations[job], high)
        stop = int(last) + 1 if last > -math.inf else first
        gains = curve.gains[first - curve.first : max(stop, first) - curve.first]
        return Curve(first - self.origin, gains) if gains.size else Curve(0, gains)

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

    def kick(self, generator: np.random.Generator) -> None:
        """Take several jobs out at once and put them back; undo that where it loses."""
        gain, agent_of = self.gain, dict(self.agent_of)
        sequences = {agent: list(order.sequence) for agent, order in self.orders.items()}
        ranking = [job for sequence in sequences.values() for job in sequence]
        ranking += [job for job in self.members if job not in agent_of]
        size = min(int(generator.integers(2, MOST_KICKED + 1)), len(ranking))
        if generator.random() < 0.5:
            middle = int(generator.integers(len(ranking)))
            near = ranking[max(middle - size, 0) : middle + size + 1]
        else:
            near = generator.permutation(ranking)[: 2 * size].tolist()
        out = generator.permutation(near)[:size].tolist()
        for job in out:
            if job in self.agent_of:
                self.orders[self.agent_of.pop(job)].remove(job)
        for job in [*out, *generator.permutation(near).tolist()]:
            self.reinsert(job)
        if self.gain > gain + IMPROVEMENT:
            self.agent_of = agent_of
            for agent, order in self.orders.items():
                order.rearrange(sequences[agent])

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
