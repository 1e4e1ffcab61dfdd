"""A part of a problem: what some skills may do while everything else stands still."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from fuzzytime.satisfaction import Interval
from fuzzytime.scheduling.problem.jobs import Job, Lag, Problem
from fuzzytime.scheduling.problem.windows import in_common
from fuzzytime.scheduling.solver import Draft
from fuzzytime.scheduling.timing.settle import in_turn, lanes_of_agents


def part_of(
    problem: Problem, draft: Draft, moving: Sequence[int], rejected: int, agents: Sequence[int] | None = None
) -> tuple[list[int], Problem]:
    """Give the problem of some skills while everything else stands still.

    Parameters
    ----------
    problem, draft
        All skills, and where they are.
    moving
        Skills that are done, next to each other in time.
    rejected
        How many rejected skills may come in, with those elsewhere whose lags alone keep them out: what must
        come before a skill that is wished for now may be planned for tonight, though it could be done now.
    agents
        Who takes part, and does all that moves now; everybody unless given.

    Returns
    -------
    members : list of int
        The problem's jobs in the part, those that move first; none if nothing can be moved.
    part : Problem
        Each agent for itself, with windows cut to where the others leave room and lags to them are kept.
    """
    team = [*lanes_of_agents(problem)] if agents is None else agents
    others = _others(_Space(problem, draft, team, moving), rejected)
    space = _Space(problem, draft, team, moving, others)
    cuts = {job: space.cut(job) for job in [*moving, *others]}
    members = [job for job in cuts if any(cuts[job].windows)]
    if any(not math.isnan(draft.starts[job]) for job in {*cuts} - {*members}):
        return [], problem.select([])
    # What must come after a rejected skill comes in with it, or not at all.
    while followers := [job for job in members if not space.leaders(job) <= {*members}]:
        members = [job for job in members if job not in followers]
    part = problem.select(members)
    return members, replace(part, jobs=tuple(cuts[job] for job in members), lanes=tuple(space.lanes))


def _others(space: "_Space", most: int) -> list[int]:
    """Give the rejected jobs that gain most for their time, with what keeps them out."""
    others: list[int] = []
    rooms = {job: space.cut(job, lags=False) for job in np.flatnonzero(np.isnan(space.draft.starts)).tolist()}
    outside = [job for job, room in rooms.items() if any(room.windows)]
    for job in sorted(outside, key=lambda job: (_gain_for_time(rooms[job]), job), reverse=True):
        come = [job] if any(space.cut(job).windows) else [job, *space.bound_to(job)]
        come = [one for one in come if one not in others]
        if len(others) + len(come) <= most and all(map(space.takes_part, come)):
            others += come
    return others


def _gain_for_time(job: Job) -> float:
    return (job.rejection - job.least) / max(job.duration, 1.0)


class _Space:
    """Where jobs that move may go, and others that move with them."""

    def __init__(
        self,
        problem: Problem,
        draft: Draft,
        team: Sequence[int],
        moving: Sequence[int],
        others: Sequence[int] = (),
    ) -> None:
        self.problem, self.draft, self._moving = problem, draft, {*moving, *others}
        lane_of = lanes_of_agents(problem)
        self._lane_of = [lane_of[agent] for agent in team]
        self.lanes = [replace(problem.lanes[lane_of[agent]], agents=(agent,)) for agent in team]
        starts = draft.starts[[*moving]].tolist() or [-math.inf, math.inf]
        spots = [float(draft.starts[job]) for job in others]
        self._gaps: dict[int, list[Interval]] = {agent: [] for agent in team}
        for agent, gap in self._all_gaps():
            here = gap.low <= max(starts) and min(starts) <= gap.high
            if here or any(spot in gap for spot in spots):
                self._gaps[agent].append(gap)

    def _all_gaps(self) -> Iterator[tuple[int, Interval]]:
        """Give the time that each agent has between jobs that stand still, in turn."""
        free = dict.fromkeys(self._gaps, -math.inf)
        for job in in_turn(self.problem, self.draft.starts):
            agent = int(self.draft.agents[job])
            if job not in self._moving and agent in free:
                start = float(self.draft.starts[job])
                yield agent, Interval(free[agent], start)
                free[agent] = start + self.problem.jobs[job].duration
        yield from ((agent, Interval(end, math.inf)) for agent, end in free.items())

    def takes_part(self, job: int) -> bool:
        """Whether a job is rejected, or done by one of the team."""
        return math.isnan(self.draft.starts[job]) or int(self.draft.agents[job]) in self._gaps

    def cut(self, job: int, *, lags: bool = True) -> Job:
        """Cut a job's windows to the room of each agent, and to where it keeps lags to what stands still."""
        old = self.problem.jobs[job]
        least, most = -math.inf, math.inf
        for lag in self._still(job) if lags else ():
            if lag.second == job:
                start = float(self.draft.starts[lag.first])
                least, most = max(least, start + lag.low), min(most, start + lag.high)
            else:
                start = float(self.draft.starts[lag.second])
                least, most = max(least, start - lag.high), min(most, start - lag.low)
        windows = []
        for lane, gaps in zip(self._lane_of, self._gaps.values(), strict=True):
            room = [Interval(max(gap.low, least), min(gap.high - old.duration, most)) for gap in gaps]
            windows.append(in_common(old.windows[lane], room))
        return replace(old, windows=tuple(windows))

    def _still(self, job: int) -> Iterator[Lag]:
        """Give the lags to what stands still."""
        for lag in self.problem.lags:
            if job in {lag.first, lag.second}:
                other = lag.first if lag.second == job else lag.second
                if other not in self._moving and not math.isnan(self.draft.starts[other]):
                    yield lag

    def bound_to(self, job: int) -> list[int]:
        """Give the jobs that stand still to which one keeps lags."""
        return list(dict.fromkeys(lag.first if lag.second == job else lag.second for lag in self._still(job)))

    def leaders(self, job: int) -> set[int]:
        """Give the rejected jobs without which one is rejected, too."""
        lags = (lag for lag in self.problem.lags if lag.second == job)
        return {lag.first for lag in lags if math.isnan(self.draft.starts[lag.first])}
