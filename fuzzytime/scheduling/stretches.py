"""Improve a long schedule stretch by stretch, each solved exactly while the rest stands still.

A stretch is some skills that are done next to each other in time, together with those rejected that might fit
there. Where many crowd, no single skill may be better elsewhere though a rearrangement of two dozen gains
much, and a problem of two dozen is what exact methods are fast at. Taillard and Voss, POPMUSIC: Partial
optimization metaheuristic under special intensification conditions, Essays and Surveys in Metaheuristics
(2002) 613-629.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from fuzzytime.satisfaction import Interval
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem import Job, Problem, in_common
from fuzzytime.scheduling.settle import in_turn, settled
from fuzzytime.scheduling.solver import Draft, draft_of

LARGEST_SHARE = 0.2
"""Of the time left for one stretch, at most."""

NEAR = 1.0
"""Seconds around its place in which a skill that is not log-concave is timed anew."""

IMPROVEMENT = 1e-7
"""A new stretch must gain more than this."""

SolvePart = Callable[[Problem, list[int], Stopwatch, Draft], Draft]
"""Solves the problem of a stretch, of which the second argument names the members, from a warm draft on."""


@dataclass(frozen=True, slots=True)
class Stretches:
    """Solve stretches in turn.

    Parameters
    ----------
    solve
        For one stretch.
    length
        Skills of a stretch that are done.
    rejected
        Skills that may come in, at most: those that would gain most for their time.
    """

    solve: SolvePart
    length: int
    rejected: int

    def improve(self, problem: Problem, watch: Stopwatch, best: Draft) -> Draft:
        """Improve until no stretch is better, half a stretch further in every other round."""
        number, since = 0, 0
        # Two rounds see every place that one cuts.
        while since < 2 and not watch.is_over():
            known = best.cost
            best = self._round(problem, watch, best, self.length // 2 * (number % 2))
            number, since = number + 1, since + 1 if best.cost == known else 0
        return best

    def _round(self, problem: Problem, watch: Stopwatch, best: Draft, offset: int) -> Draft:
        count = int(np.count_nonzero(~np.isnan(best.starts)))
        firsts = range(offset - self.length if offset else 0, count, self.length)
        for done, first in enumerate(firsts):
            if watch.is_over():
                break
            share = min(LARGEST_SHARE, 1 / (len(firsts) - done))
            stretch = in_turn(problem, best.starts)[max(first, 0) : first + self.length]
            try:
                best = self._improved(problem, watch.share(share), best, stretch)
            except KeyboardInterrupt:
                watch.stop()
        return best

    def _improved(self, problem: Problem, watch: Stopwatch, best: Draft, stretch: list[int]) -> Draft:
        """Solve a stretch, and give the better draft."""
        members, part = part_of(problem, best, stretch, self.rejected)
        if not members:
            return best
        warm = draft_of(part, best.starts[members], best.agents[members])
        found = self.solve(part, members, watch, warm)
        if found.cost > warm.cost - IMPROVEMENT:
            return best
        starts, agents = best.starts.copy(), best.agents.copy()
        starts[members], agents[members] = found.starts, found.agents
        after = draft_of(problem, starts, agents)
        if any(math.isnan(starts[lag.first]) > math.isnan(starts[lag.second]) for lag in problem.lags):
            # What stood still must not come after a skill that is rejected now.
            after = settled(problem, starts, agents, NEAR)
        return after if after.cost < best.cost else best


def part_of(
    problem: Problem, draft: Draft, stretch: Sequence[int], rejected: int
) -> tuple[list[int], Problem]:
    """Give the problem of a stretch while everything else stands still.

    Parameters
    ----------
    problem, draft
        All skills, and where they are.
    stretch
        Skills that are done next to each other: a piece of all, in turn.
    rejected
        How many rejected skills may come in.

    Returns
    -------
    members : list of int
        The problem's jobs in the part, those of the stretch first; none if nothing can be moved.
    part : Problem
        Each agent for itself, with windows cut to where the others leave room and lags to them are kept.
    """
    space = _Space(problem, draft, stretch)
    cuts = {job: space.cut(job) for job in [*stretch, *np.flatnonzero(np.isnan(draft.starts)).tolist()]}
    if not all(any(cuts[job].windows) for job in stretch):
        return [], problem.select([])
    outside = [job for job, cut in cuts.items() if math.isnan(draft.starts[job]) and any(cut.windows)]
    outside.sort(key=lambda job: (_gain_for_time(cuts[job]), job), reverse=True)
    members = [*stretch, *outside[:rejected]]
    # What must come after a rejected skill comes in with it, or not at all.
    while followers := [job for job in members if not space.leaders(job) <= {*members}]:
        members = [job for job in members if job not in followers]
    part = problem.select(members)
    return members, replace(part, jobs=tuple(cuts[job] for job in members), lanes=tuple(space.lanes))


class _Space:
    """Where the jobs of a stretch may go."""

    def __init__(self, problem: Problem, draft: Draft, stretch: Sequence[int]) -> None:
        self._problem, self._draft, self._moving = problem, draft, set(stretch)
        self._lane_of = [number for number, lane in enumerate(problem.lanes) for _ in lane.agents]
        self.lanes = [replace(lane, agents=(agent,)) for lane in problem.lanes for agent in lane.agents]
        self._free = {lane.agents[0]: [-math.inf, math.inf] for lane in self.lanes}
        before = True
        for job in in_turn(problem, draft.starts):
            before &= job not in self._moving
            start, duration = float(draft.starts[job]), problem.jobs[job].duration
            free = self._free[int(draft.agents[job])]
            if before:
                free[0] = max(free[0], start + duration)
            elif job not in self._moving:
                free[1] = min(free[1], start)

    def cut(self, job: int) -> Job:
        """Cut a job's windows to the room of each agent, and to where it keeps lags to what stands still."""
        old = self._problem.jobs[job]
        least, most = -math.inf, math.inf
        for lag in self._problem.lags:
            other = lag.first if lag.second == job else lag.second
            start = self._draft.starts[other]
            if job not in {lag.first, lag.second} or other in self._moving or math.isnan(start):
                continue
            low, high = (lag.low, lag.high) if lag.second == job else (-lag.high, -lag.low)
            least, most = max(least, start + low), min(most, start + high)
        windows = []
        for lane, number in zip(self.lanes, self._lane_of, strict=True):
            low, high = self._free[lane.agents[0]]
            room = Interval(max(low, least), min(high - old.duration, most))
            windows.append(in_common(old.windows[number], [room]))
        return replace(old, windows=tuple(windows))

    def leaders(self, job: int) -> set[int]:
        """Give the rejected jobs without which one is rejected, too."""
        lags = (lag for lag in self._problem.lags if lag.second == job)
        return {lag.first for lag in lags if math.isnan(self._draft.starts[lag.first])}


def _gain_for_time(job: Job) -> float:
    return (job.rejection - job.least) / max(job.duration, 1.0)
