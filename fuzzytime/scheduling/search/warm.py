"""A draft to begin with, from start times that were good for a similar problem."""

import math
from collections.abc import Sequence

import numpy as np

from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.solver import Draft, draft_of

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


def _keeps_lags(problem: Problem, starts: np.ndarray, index: int, time: float) -> bool:
    """Tell whether all that must come before a job is there, and every lag is kept."""
    for lag in problem.lags:
        if lag.second == index and not lag.low <= time - starts[lag.first] <= lag.high:
            return False
        if lag.first == index and not math.isnan(starts[lag.second]):
            return False
    return True
