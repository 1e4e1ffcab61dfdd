"""A draft to begin with: start times that were good for a similar problem, or one job after the other."""

import heapq
import math
from collections.abc import Sequence

import numpy as np

from fuzzytime.satisfaction import Interval
from fuzzytime.scheduling.problem.jobs import Lag, Problem
from fuzzytime.scheduling.problem.placement import Rota
from fuzzytime.scheduling.problem.windows import in_common
from fuzzytime.scheduling.solver import Draft, draft_of
from fuzzytime.scheduling.timing.settle import lanes_of_agents

NEXT_TO = 1e-6
"""Seconds by which a hint may miss a window or overlap, for rounding."""


def remembered(problem: Problem, hints: Sequence[float]) -> Draft | None:
    """Give the draft in which jobs start at given times where they still can, None where none can.

    Parameters
    ----------
    problem
        What is to be solved.
    hints
        A start for each skill of the task, by the jobs' positions; NaN where none is known.
    """
    count = len(problem.jobs)
    starts, agents = np.full(count, np.nan), np.ones(count, np.int64)
    free = {agent: -math.inf for lane in problem.lanes for agent in lane.agents}
    wanted = [(hints[job.position], index) for index, job in enumerate(problem.jobs)]
    for hint, index in sorted(pair for pair in wanted if not math.isnan(pair[0])):
        job = problem.jobs[index]
        for lane, windows in zip(problem.lanes, job.windows, strict=True):
            agent = min(lane.agents, key=lambda agent: (free[agent] > hint, agent))
            times = (min(max(hint, free[agent], window.low), window.high) for window in windows)
            time = min(times, key=lambda time: abs(time - hint), default=math.inf)
            if abs(time - hint) > NEXT_TO or time < free[agent]:
                continue
            if _keeps_lags(problem, starts, index, time):
                starts[index], agents[index] = time, agent
                free[agent] = time + job.duration
                break
    return None if np.isnan(starts).all() else draft_of(problem, starts, agents)


def one_by_one(problem: Problem, *, urgent: bool = False) -> Draft:
    """Give the draft in which each job in turn starts as soon as it is best, or as it can.

    Who must come before it had its turn: where each waits for another, all are planned at once. Of those that
    may come next, the one that may begin first does, or the most ``urgent``, that may begin no later.
    """
    count = len(problem.jobs)
    starts, agents = np.full(count, np.nan), np.ones(count, np.int64)
    leading: list[list[Lag]] = [[] for _ in problem.jobs]
    following: list[list[int]] = [[] for _ in problem.jobs]
    for lag in problem.lags:
        leading[lag.second].append(lag)
        following[lag.first].append(lag.second)
    waiting = [len(lags) for lags in leading]
    lane_of = lanes_of_agents(problem)
    rota = Rota(lane_of)
    turn = [job.latest if urgent else job.earliest for job in problem.jobs]
    ready = [(turn[index], index) for index in range(count) if not waiting[index]]
    heapq.heapify(ready)
    while ready:
        _, index = heapq.heappop(ready)
        job = problem.jobs[index]
        low = float(np.max([starts[lag.first] + lag.low for lag in leading[index]], initial=-math.inf))
        high = float(np.min([starts[lag.first] + lag.high for lag in leading[index]], initial=math.inf))
        # What must follow a job that found no place finds none either.
        for soonest in () if math.isnan(low) else (max(low, job.function.best.low), low):
            found = [
                (
                    rota.earliest(
                        agent, job.duration, in_common(job.windows[lane], [Interval(soonest, high)])
                    ),
                    agent,
                )
                for agent, lane in lane_of.items()
            ]
            start, agent = min(found)
            if start < math.inf:
                starts[index], agents[index] = start, agent
                rota.take(agent, start, start + job.duration)
                break
        for second in following[index]:
            waiting[second] -= 1
            if not waiting[second]:
                heapq.heappush(ready, (turn[second], second))
    return draft_of(problem, starts, agents)


def _keeps_lags(problem: Problem, starts: np.ndarray, index: int, time: float) -> bool:
    """Tell whether all that must come before a job is there, and every lag is kept."""
    for lag in problem.lags:
        if lag.second == index and not lag.low <= time - starts[lag.first] <= lag.high:
            return False
        if lag.first == index and not math.isnan(starts[lag.second]):
            return False
    return True
