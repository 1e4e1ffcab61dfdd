"""What is solved: a task's costs, windows, lanes and lags, worked out once for every solver.

A skill costs f(t) = −priority · log ψ(t) where it starts in one of its *windows*: closed intervals with t ≥ 0
and ψ > ε, outside the agents' busy times. Elsewhere it may as well be *rejected*, at cost −priority · log ε,
and done after what matters. Where ψ stays above ε for ever, as for an instruction without time words, being
late costs −priority · log ψ(∞) only. A skill that must come after a rejected one is rejected too.
"""

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import EMPTY, Floats, Interval, SatisfactionFunction
from fuzzytime.scheduling.schedule import TINY
from fuzzytime.skills import FuzzyTask


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

    ``apart`` are the jobs without a window: rejected, or as well done at any late time.
    """

    jobs: tuple[Job, ...]
    lanes: tuple[Lane, ...]
    lags: tuple[Lag, ...]
    apart: tuple[Job, ...] = ()

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


def problem_of(task: FuzzyTask, threshold: float) -> Problem:
    """Work out a task for the solvers.

    Raises
    ------
    FuzzytimeError
        If the threshold is not in [0, 1).
    """
    if not 0 <= threshold < 1:
        raise FuzzytimeError(f"a threshold must be at least 0 and below 1, got {threshold}")
    floor = threshold or TINY
    lanes = _lanes(task)
    horizon = horizon_of(task, floor)
    leading = {precedence.first for precedence in task.precedences}
    bound = {precedence.second for precedence in task.precedences if precedence.maximum_lag < math.inf}
    # In the strict product any schedule without a rejection beats every one with: none may cost as much.
    strict = 1 - math.log(floor) * math.fsum(skill.priority for skill in task.skills)
    jobs: list[Job] = []
    for position, skill in enumerate(task.skills):
        mine = [lane if skill.agent in {None, *lane.agents} else None for lane in lanes]
        late = 0.0
        if position not in bound and any(lane is not None and lane.is_free_at_last for lane in mine):
            late = float(skill.satisfaction(math.inf))
        wanted = above(skill.satisfaction, floor if position in leading else max(floor, late), horizon)
        windows = tuple(
            free_of(wanted, lane.busy, skill.duration) if lane is not None else () for lane in mine
        )
        worst = -skill.priority * math.log(floor)
        final = -skill.priority * math.log(max(late, floor)) + 0.0
        jobs.append(
            Job(
                position,
                skill.satisfaction,
                skill.priority,
                skill.duration,
                skill.time_until_done,
                worst,
                strict if threshold == 0 and late <= floor else final,
                math.inf if late > floor else _over(skill.satisfaction, wanted),
                windows,
            )
        )
    return _bound_by_lags(task, jobs, lanes)


def _lanes(task: FuzzyTask) -> tuple[Lane, ...]:
    named = {skill.agent for skill in task.skills}
    agents: dict[tuple[tuple[tuple[float, float], ...], int | None], list[int]] = {}
    for agent in range(1, task.agents + 1):
        busy = {(entry.start, entry.end) for entry in task.busy if entry.agent in {None, agent}}
        times = tuple(sorted(span for span in busy if span[0] < span[1]))
        agents.setdefault((times, agent if agent in named else None), []).append(agent)
    return tuple(
        Lane(tuple(members), tuple(Interval(low, high) for low, high in times))
        for (times, _), members in agents.items()
    )


def horizon_of(task: FuzzyTask, floor: float) -> float:
    """Give a time after which no start is needed.

    After the last kink, or the best times where there is one peak only, and the last appointment every ψ only
    falls, so that idle time can be closed by moving all that follows to an earlier time.
    """
    kinks = [0.0]
    for skill in task.skills:
        function = skill.satisfaction
        rises = (
            (function.best.low, function.best.high)
            if function.log_concave
            else (*function.kinks, *function.crossings(floor)[:1])
        )
        kinks.extend(time for time in rises if math.isfinite(time))
    kinks.extend(entry.end for entry in task.busy if math.isfinite(entry.end))
    lags = [abs(precedence.minimum_lag) for precedence in task.precedences]
    work = [max(skill.duration, skill.time_until_done) for skill in task.skills]
    return max(kinks) + math.fsum(work) + math.fsum(lags)


def above(function: SatisfactionFunction, floor: float, horizon: float) -> tuple[Interval, ...]:
    """Give the closed intervals of [0, horizon] with ψ > floor, by signs between kinks and crossings."""
    marks = np.array([0.0, horizon, *function.kinks, *function.crossings(floor)])
    marks = np.unique(marks[(marks >= 0) & (marks <= horizon)])
    inside = np.asarray(function((marks[:-1] + marks[1:]) / 2)) > floor
    points = np.asarray(function(marks)) > floor
    found: list[Interval] = []
    for index, mark in enumerate(marks.tolist()):
        if found and index and inside[index - 1]:
            found[-1] = Interval(found[-1].low, mark)
        elif points[index] or (index < inside.size and inside[index]):
            found.append(Interval(mark, mark))
    return tuple(found)


def _over(function: SatisfactionFunction, wanted: tuple[Interval, ...]) -> float:
    """Give a time from which on ψ does not exceed the floor."""
    if not wanted:
        return 0.0
    end = function.support.high
    if end == math.inf:
        return wanted[-1].high * (1 + 1e-9)
    # At a jump ψ keeps its larger value: the next whole second is beyond it.
    return end if float(function(end)) == 0 else math.floor(end) + 1.0


def good_enough(job: Job) -> tuple[Interval, ...]:
    """Give the times, the last without end, at which a job that may be late costs no more than if it is."""
    level = math.exp(-job.rejection / job.weight) * (1 - 1e-9)
    beyond = max(0.0, *job.function.kinks, *job.function.crossings(level)) + 1.0
    spans = above(job.function, level, beyond)
    return (*spans[:-1], Interval(spans[-1].low, math.inf))


def in_common(spans: Iterable[Interval], others: Iterable[Interval]) -> tuple[Interval, ...]:
    """Give what two rows of disjoint intervals, each ascending, have in common."""
    kept = [*others]
    parts = (span.intersection(other) for span in spans for other in kept)
    return tuple(part for part in parts if not part.empty)


def free_of(
    wanted: tuple[Interval, ...], busy: tuple[Interval, ...], duration: float
) -> tuple[Interval, ...]:
    """Cut busy times out of windows: a start may not lie in (busy start − duration, busy end)."""
    left = list(wanted)
    for taken in busy:
        low, high = taken.low - duration, taken.high
        before = [Interval(window.low, min(window.high, low)) for window in left]
        after = [Interval(max(window.low, high), window.high) for window in left]
        left = [piece for pair in zip(before, after, strict=True) for piece in pair if not piece.empty]
    return tuple(left)


def _bound_by_lags(task: FuzzyTask, jobs: list[Job], lanes: tuple[Lane, ...]) -> Problem:
    """Narrow windows by what must come before, and set the jobs apart that have none."""
    waiting = [0] * len(jobs)
    for precedence in task.precedences:
        waiting[precedence.second] += 1
    ready = [position for position, count in enumerate(waiting) if not count]
    lags: list[Lag] = []
    for first in ready:
        before = jobs[first]
        for precedence in task.precedences:
            if precedence.first != first:
                continue
            second = precedence.second
            low, high = before.elapsed + precedence.minimum_lag, before.elapsed + precedence.maximum_lag
            lags.append(Lag(first, second, low, high))
            within = Interval(before.earliest + low, before.latest + high) if any(before.windows) else EMPTY
            jobs[second] = _clipped(jobs[second], within)
            waiting[second] -= 1
            if not waiting[second]:
                ready.append(second)
    everything = Problem(tuple(jobs), lanes, tuple(lags))
    kept = everything.select([index for index, job in enumerate(jobs) if any(job.windows)])
    return replace(kept, apart=tuple(job for job in jobs if not any(job.windows)))


def _clipped(job: Job, within: Interval) -> Job:
    return replace(job, windows=tuple(in_common(lane, [within]) for lane in job.windows))
