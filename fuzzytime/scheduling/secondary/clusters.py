"""Jobs that are tied to each other, moved as one: out of an arrangement, and back in where it costs least.

Of "let it drip for ten minutes, then fit the filter" neither can go through the others without the other.
Such a cluster is taken out, and put back into the room that all others leave, at the earliest or next to a
time that one of it wishes for, if that costs less. What lags say is kept, and nothing else moves.
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, product

import numpy as np

from fuzzytime.satisfaction import Floats, Interval
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import Ints
from fuzzytime.scheduling.problem.jobs import Job, Lag, Problem
from fuzzytime.scheduling.problem.windows import free_of, in_common
from fuzzytime.scheduling.solver import Draft, draft_of
from fuzzytime.scheduling.timing.settle import lanes_of_agents, settled

MOST = 6
"""Jobs of a cluster that moves."""

SHARINGS = 8
"""Up to so many ways to share a cluster out to agents are tried; else each job stays with its own."""

ORDERS = 64
"""How many orders of a cluster are looked into at most, for each time that it may begin at."""

SWEEPS = 8
"""How often all clusters are tried at most, with all the jobs settled in between."""

NEXT = 1e-6
"""Seconds: a job that starts so near to another's end follows it without a pause."""

GAIN = 1e-9
"""A cluster moves for a cost that is less by more than this."""

EXACT = 1e-13
"""Share of a time by which sums of floats may miss a bound."""


def with_clusters_moved(problem: Problem, draft: Draft, watch: Stopwatch) -> Draft:
    """Move clusters of jobs while that makes a draft, in which nothing is rejected, cost less."""
    reach = max(job.latest - job.earliest for job in problem.jobs) + 1.0
    try:
        for _ in range(SWEEPS):
            before = draft.cost
            for cluster in _clusters(problem):
                for members in (cluster, _with_those_before(problem, draft, cluster)):
                    if watch.is_over():
                        return draft
                    draft = _moved(problem, draft, members, watch) if len(members) <= MOST else draft
            if draft.cost >= before - GAIN or watch.is_over():
                return draft
            # Where others went away there is room to close up.
            again = settled(problem, draft.starts, draft.agents, reach)
            draft = min(draft, again, key=lambda found: found.cost)
    except KeyboardInterrupt:
        watch.stop()
    return draft


def _clusters(problem: Problem) -> Iterator[list[int]]:
    """Give each job with those that a longest lag ties it to, and that with what any lag joins to these."""
    tied = {job: {job} for job in range(len(problem.jobs))}
    joined = {job: {job} for job in tied}
    for lag in problem.lags:
        joined[lag.first].add(lag.second)
        joined[lag.second].add(lag.first)
        if lag.high < math.inf and tied[lag.first] is not tied[lag.second]:
            union = tied[lag.first] | tied[lag.second]
            tied |= dict.fromkeys(union, union)
    for job, cluster in tied.items():
        if job == min(cluster):
            wider = {member for one in cluster for other in joined[one] for member in tied[other]}
            yield sorted(cluster)
            if wider != cluster:
                yield sorted(wider)


def _with_those_before(problem: Problem, draft: Draft, cluster: Sequence[int]) -> list[int]:
    """Give a cluster with the job that each of it follows without a pause, so that they may change places."""
    starts, ends = draft.starts, draft.starts + [job.duration for job in problem.jobs]
    before = {
        other
        for member in cluster
        for other in np.flatnonzero(
            (draft.agents == draft.agents[member]) & (starts <= starts[member])
        ).tolist()
        if other not in cluster and abs(ends[other] - starts[member]) <= NEXT
    }
    return [*cluster, *sorted(before)]


def _moved(problem: Problem, draft: Draft, members: Sequence[int], watch: Stopwatch) -> Draft:
    """Give the draft with some jobs where they cost least while all others stand still."""
    jobs = [problem.jobs[member] for member in members]
    cost = _cost(jobs, draft.starts[[*members]].tolist()) - GAIN
    if cost <= math.fsum(job.least for job in jobs):
        return draft
    room = _Room(problem, draft.starts, draft.agents, members)
    starts, agents = draft.starts.copy(), draft.agents.copy()
    for part in filter(None, map(room.part, _sharings(problem, draft.agents, members))):
        for found in part.timings():
            if _cost(jobs, found) < cost:
                cost = _cost(jobs, found)
                starts[[*members]], agents[[*members]] = found, part.agents
            if watch.is_over():
                break
    return min(draft, draft_of(problem, starts, agents), key=lambda found: found.cost)


def _cost(jobs: Sequence[Job], starts: Sequence[float]) -> float:
    return math.fsum(float(job.costs(start)) for job, start in zip(jobs, starts, strict=True))


def _sharings(problem: Problem, agents: Ints, members: Sequence[int]) -> Iterable[tuple[int, ...]]:
    """Give ways to share jobs out to agents, the one that is first."""
    own = tuple(int(agents[member]) for member in members)
    lanes = lanes_of_agents(problem)
    able = [
        [agent for agent, lane in lanes.items() if problem.jobs[member].windows[lane]] for member in members
    ]
    if math.prod(map(len, able)) > SHARINGS:
        return [own]
    return [own, *(other for other in product(*able) if other != own)]


@dataclass(frozen=True, slots=True)
class _Part:
    """Some jobs with their agents, the windows that others leave, and the lags among them by places."""

    jobs: Sequence[Job]
    agents: Sequence[int]
    windows: Sequence[Sequence[Interval]]
    lags: Sequence[Lag]

    def _beginnings(self) -> Iterator[Mapping[int, float]]:
        """Give times before which a job, by its place, may be kept from starting: where its wish turns."""
        yield {}
        for place, (job, windows) in enumerate(zip(self.jobs, self.windows, strict=True)):
            function = job.function
            turns = {*function.kinks, function.best.low, function.best.high}
            yield from ({place: turn} for turn in sorted(turns) if windows[0].low < turn <= windows[-1].high)

    def timings(self) -> Iterator[list[float]]:
        """Give the earliest starts after each beginning."""
        for late in self._beginnings():
            yield from self._timings(late)

    def _timings(self, late: Mapping[int, float]) -> Iterator[list[float]]:
        """Give the earliest starts in each order that matters, those of the likeliest order first."""
        lows = [late.get(place, -math.inf) for place in range(len(self.jobs))]
        pending: list[list[Lag]] = [[]]
        for _ in range(ORDERS):
            if not pending:
                return
            order = pending.pop()
            starts = _earliest(self.windows, [*self.lags, *order], lows)
            clash = None if starts is None else self._clash(starts)
            if clash is not None:
                first, second = clash
                pending.append([*order, Lag(second, first, self.jobs[second].duration, math.inf)])
                pending.append([*order, Lag(first, second, self.jobs[first].duration, math.inf)])
            elif starts is not None:
                yield starts

    def _clash(self, starts: Sequence[float]) -> tuple[int, int] | None:
        """Give two jobs that one agent would do at once, the earlier one first."""
        turns = sorted(range(len(starts)), key=lambda place: (starts[place], self.jobs[place].duration))
        for first, second in combinations(turns, 2):
            end = starts[first] + self.jobs[first].duration
            if self.agents[first] == self.agents[second] and starts[second] < end - _slack(end):
                return first, second
        return None


class _Room:
    """What jobs that stand still leave to those that move."""

    def __init__(self, problem: Problem, starts: Floats, agents: Ints, members: Sequence[int]) -> None:
        self._problem, self._members = problem, members
        self._lanes = lanes_of_agents(problem)
        self._taken: dict[int, list[Interval]] = {agent: [] for agent in self._lanes}
        for other, (start, agent) in enumerate(zip(starts.tolist(), agents.tolist(), strict=True)):
            if other not in members:
                self._taken[agent].append(Interval(start, start + problem.jobs[other].duration))
        place = {member: index for index, member in enumerate(members)}
        self._among: list[Lag] = []
        self._bounds = [Interval(-math.inf, math.inf) for _ in members]
        for lag in problem.lags:
            first, second = place.get(lag.first), place.get(lag.second)
            if first is not None and second is not None:
                self._among.append(replace(lag, first=first, second=second))
            elif second is not None:
                start = float(starts[lag.first])
                self._bind(second, Interval(start + lag.low, start + lag.high))
            elif first is not None:
                start = float(starts[lag.second])
                self._bind(first, Interval(start - lag.high, start - lag.low))

    def _bind(self, place: int, span: Interval) -> None:
        self._bounds[place] = self._bounds[place].intersection(span)

    def part(self, agents: Sequence[int]) -> _Part | None:
        """Give what is to be put back, by some agents; None where one of it has no room."""
        jobs = [self._problem.jobs[member] for member in self._members]
        windows = []
        for job, agent, bound in zip(jobs, agents, self._bounds, strict=True):
            wanted = in_common(job.windows[self._lanes[agent]], [] if bound.empty else [bound])
            windows.append(free_of(wanted, tuple(self._taken[agent]), job.duration))
        return _Part(jobs, agents, windows, self._among) if all(windows) else None


def _earliest(
    windows: Sequence[Sequence[Interval]], lags: Sequence[Lag], lows: Sequence[float]
) -> list[float] | None:
    """Give the starts that keep all lags, each the least that it can be in any that do; None if none do.

    If two rows of starts keep lags and windows, so does the earlier start of each: one row is the least.
    """
    found: list[float] = []
    for spans, low in zip(windows, lows, strict=True):
        start = _next(spans, low)
        if start is None:
            return None
        found.append(start)
    # Each round moves one past a window, or along a chain of lags, or the lags contradict each other.
    for _ in range(sum(map(len, windows)) * (len(windows) + 1)):
        pushed = False
        for lag in lags:
            for place, least in (
                (lag.second, found[lag.first] + lag.low),
                (lag.first, found[lag.second] - lag.high),
            ):
                if least > found[place] + _slack(least):
                    start = _next(windows[place], least)
                    if start is None:
                        return None
                    found[place], pushed = start, True
        if not pushed:
            return found
    return None


def _next(windows: Sequence[Interval], least: float) -> float | None:
    """Give the first time in any window that is no earlier than another, but for rounding."""
    for window in windows:
        if least <= window.high + _slack(window.high):
            return min(max(window.low, least), window.high)
    return None


def _slack(time: float) -> float:
    return EXACT * max(1.0, abs(time)) if math.isfinite(time) else 0.0
