"""Jobs for which nothing names a time, in the order in which they were said, where lags bind them.

What weighs the starts of jobs against each other does well by those behind which others wait, and would have
what was said later done first: "vacuum, mop the floor, let it dry for an hour, then put the rugs back".
"""

import math
from collections.abc import Collection, Iterator, Sequence

import numpy as np

from fuzzytime.satisfaction import Floats, Interval
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.problem.windows import free_of, in_common
from fuzzytime.scheduling.solver import Draft, draft_of
from fuzzytime.scheduling.timing.settle import lanes_of_agents


def in_order_said(problem: Problem, draft: Draft, fixed: Collection[int]) -> Draft:
    """Give a draft in which each job starts as early as those let it that were said before it.

    ``fixed`` are the jobs that stay where they are. The draft itself is given where one would find no room.
    """
    starts = np.full(len(problem.jobs), np.nan)
    starts[[*fixed]] = draft.starts[[*fixed]]
    lanes = lanes_of_agents(problem)
    taken: dict[int, list[Interval]] = {agent: [] for agent in lanes}
    for job in fixed:
        _take(problem, draft, taken, job, float(starts[job]))
    for job in _in_turn(problem, fixed):
        agent = int(draft.agents[job])
        windows = problem.jobs[job].windows[lanes[agent]]
        start = _earliest(problem, windows, starts, taken[agent], job)
        if start is None:
            return draft
        starts[job] = start
        _take(problem, draft, taken, job, start)
    return draft_of(problem, starts, draft.agents)


def _in_turn(problem: Problem, fixed: Collection[int]) -> Iterator[int]:
    """Give the jobs that may move in the order said, each behind those that it may not start before."""
    said = sorted(range(len(problem.jobs)), key=lambda job: problem.jobs[job].position)
    waiting = dict.fromkeys(job for job in said if job not in fixed)
    while waiting:
        blocked = {lag.second for lag in problem.lags if lag.low >= 0 and lag.first in waiting}
        job = next((one for one in waiting if one not in blocked), next(iter(waiting)))
        del waiting[job]
        yield job


def _earliest(
    problem: Problem, windows: Sequence[Interval], starts: Floats, taken: Sequence[Interval], job: int
) -> float | None:
    """Give when a job can start at the earliest in its windows, beside what is taken; None if never."""
    bound = Interval(-math.inf, math.inf)
    for lag in problem.lags:
        if lag.second == job and not math.isnan(starts[lag.first]):
            start = float(starts[lag.first])
            bound = bound.intersection(Interval(start + lag.low, start + lag.high))
        elif lag.first == job and not math.isnan(starts[lag.second]):
            start = float(starts[lag.second])
            bound = bound.intersection(Interval(start - lag.high, start - lag.low))
    if bound.empty:
        return None
    free = free_of(in_common(windows, [bound]), tuple(taken), problem.jobs[job].duration)
    return free[0].low if free else None


def _take(problem: Problem, draft: Draft, taken: dict[int, list[Interval]], job: int, start: float) -> None:
    taken[int(draft.agents[job])].append(Interval(start, start + problem.jobs[job].duration))
