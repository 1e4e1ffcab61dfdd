"""What is solved: costs, windows, lanes and lags.

A skill costs f(t) = −priority · log ψ(t) where it starts in one of its *windows*: closed intervals with t ≥ 0
and ψ > ε, outside the agents' busy times. Elsewhere it may as well be *rejected*, at cost −priority · log ε,
and done after what matters. Where ψ stays above ε for ever, as for an instruction without time words, being
late costs −priority · log ψ(∞) only. A skill that must come after a rejected one is rejected too.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.satisfaction import Floats, Interval, SatisfactionFunction


@dataclass(frozen=True, slots=True)
class Job:
    """A skill as the solvers see it.

    Parameters
    ----------
    position
        Where it stands in the task.
    function, weight
        ψ and the priority.
    duration, elapsed
        Seconds for which the agent is taken, and until the result is there.
    worst
        −weight · log ε: no start costs more.
    rejection
        The cost of not placing it in a window.
    over
        The time after which it never satisfies; infinity where it may be late.
    windows
        Intervals of starts, ascending and disjoint, for each of the problem's lanes.
    """

    position: int
    function: SatisfactionFunction
    weight: float
    duration: float
    elapsed: float
    worst: float
    rejection: float
    over: float
    windows: tuple[tuple[Interval, ...], ...]

    def costs(self, times: ArrayLike) -> Floats:
        """Give f at start times of any shape."""
        return np.asarray(np.minimum(-self.weight * self.function.log(times) + 0.0, self.worst))

    @property
    def least(self) -> float:
        """The least cost that it could have if it were the only job.

        Between kinks ψ is a line, or has its one peak at its best: the least is there, or at a window's end.
        """
        function = self.function
        marks = [mark for mark in (*function.kinks, function.best.low, function.best.high) if mark < math.inf]
        times = [
            min(max(mark, window.low), window.high)
            for lane in self.windows
            for window in lane
            for mark in (*marks, window.low, window.high)
        ]
        return min(self.rejection, float(self.costs(times).min())) if times else self.rejection

    @property
    def earliest(self) -> float:
        """The first moment of any window; infinity where there is none."""
        return min((windows[0].low for windows in self.windows if windows), default=math.inf)

    @property
    def latest(self) -> float:
        """The last moment of any window; minus infinity where there is none."""
        return max((windows[-1].high for windows in self.windows if windows), default=-math.inf)


@dataclass(frozen=True, slots=True)
class Lane:
    """Agents who can stand in for each other: they have the same busy times, and no skill asks for one."""

    agents: tuple[int, ...]
    busy: tuple[Interval, ...]

    @property
    def is_free_at_last(self) -> bool:
        """Whether there is time after all appointments."""
        return all(taken.high < math.inf for taken in self.busy)


@dataclass(frozen=True, slots=True)
class Lag:
    """start(second) − start(first) lies in [low, high], by positions in the problem's jobs."""

    first: int
    second: int
    low: float
    high: float


@dataclass(frozen=True, slots=True)
class Problem:
    """The jobs that have a window, where they can be done, and what binds them.

    ``apart`` are the jobs without a window: rejected, or as well done at any late time. ``free`` are those
    that happen by themselves, as they would if they were alone, and take no agent.
    """

    jobs: tuple[Job, ...]
    lanes: tuple[Lane, ...]
    lags: tuple[Lag, ...]
    apart: tuple[Job, ...] = ()
    free: tuple[Job, ...] = ()

    @property
    def rejection_of_all(self) -> float:
        """The cost of doing nothing."""
        return math.fsum(job.rejection for job in self.jobs)

    @property
    def weight(self) -> float:
        """Σ priority: what the gap per skill is measured by."""
        return math.fsum(job.weight for job in self.jobs)

    @property
    def least_cost(self) -> float:
        """A bound on the cost of any schedule: every job as if it were the only one."""
        return math.fsum(job.least for job in self.jobs)

    def select(self, members: list[int]) -> "Problem":
        """Give the problem of some of the jobs; lags to others are dropped."""
        place = {member: index for index, member in enumerate(members)}
        lags = [
            replace(lag, first=place[lag.first], second=place[lag.second])
            for lag in self.lags
            if lag.first in place and lag.second in place
        ]
        return Problem(tuple(self.jobs[member] for member in members), self.lanes, tuple(lags))

    @property
    def agents(self) -> int:
        """How many there are."""
        return sum(len(lane.agents) for lane in self.lanes)

    @property
    def kept_by_order(self) -> bool:
        """Whether lags only say which of two jobs comes first, on one agent."""
        return not self.lags or (
            self.agents == 1
            and all(
                -self.jobs[lag.second].duration < lag.low <= self.jobs[lag.first].duration
                and lag.high == math.inf
                for lag in self.lags
            )
        )

    def before(self) -> list[list[int]]:
        """Give for each job those that lags put before it on one agent; none where there are several."""
        firsts: list[list[int]] = [[] for _ in self.jobs]
        for lag in self.lags if self.agents == 1 else ():
            if lag.low > -self.jobs[lag.second].duration:
                firsts[lag.second].append(lag.first)
        return firsts

    def groups(self) -> Iterator[list[int]]:
        """Give sets of jobs that cannot meet: their windows do not touch, and no lag joins them."""
        spans = [(job.earliest, job.latest + job.duration) for job in self.jobs]
        for lag in self.lags:
            low = min(spans[lag.first][0], spans[lag.second][0])
            high = max(spans[lag.first][1], spans[lag.second][1])
            spans[lag.first] = spans[lag.second] = (low, high)
        group: list[int] = []
        reach = -math.inf
        for member in sorted(range(len(spans)), key=lambda index: spans[index]):
            if group and spans[member][0] >= reach:
                yield group
                group = []
            group.append(member)
            reach = max(reach, spans[member][1])
        if group:
            yield group
