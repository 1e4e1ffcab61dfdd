"""From who does what in which order to start times in continuous time."""

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np

from fuzzytime.satisfaction import Floats, Interval
from fuzzytime.scheduling.problem.grid import Ints
from fuzzytime.scheduling.problem.jobs import Job, Lag, Problem
from fuzzytime.scheduling.schedule import ROUNDING
from fuzzytime.scheduling.solver import Draft, draft_of
from fuzzytime.scheduling.timing.candidates import searched
from fuzzytime.scheduling.timing.chains import pooled
from fuzzytime.scheduling.timing.coupled import coupled


def lanes_of_agents(problem: Problem) -> dict[int, int]:
    """Give the lane of each agent."""
    return {agent: index for index, lane in enumerate(problem.lanes) for agent in lane.agents}


def in_turn(problem: Problem, starts: Floats) -> list[int]:
    """Give the jobs that are done in the order of their starts; what starts together, the shorter first."""
    placed = [index for index in range(len(problem.jobs)) if not math.isnan(starts[index])]
    return sorted(placed, key=lambda index: (starts[index], problem.jobs[index].duration, index))


def sequences(problem: Problem, starts: Floats, agents: Ints) -> dict[int, list[int]]:
    """Give the jobs of each agent in turn."""
    placed = in_turn(problem, starts)
    return {agent: [i for i in placed if agents[i] == agent] for agent in lanes_of_agents(problem)}


def manned(problem: Problem, lanes: Ints, starts: Ints, ends: Ints) -> Ints:
    """Give each job an agent of its lane that is free from its start to its end.

    Parameters
    ----------
    problem
        Whose lanes are meant.
    lanes, starts, ends : arrays of shape (jobs,)
        A lane by its place; slots of a grid, below 0 where a job is rejected.
    """
    agents = np.ones(starts.size, np.int64)
    free = {agent: -math.inf for lane in problem.lanes for agent in lane.agents}
    for job in np.lexsort((ends, starts)).tolist():
        if starts[job] < 0:
            continue
        team = problem.lanes[int(lanes[job])].agents
        # The one who has waited least leaves the longest rest to the others.
        ready = [agent for agent in team if free[agent] <= starts[job]] or list(team)
        agents[job] = max(ready, key=lambda name: free[name])
        free[int(agents[job])] = float(ends[job])
    return agents


def settled(problem: Problem, hints: Floats, agents: Ints, radius: float) -> Draft:
    """Give the best timing of an order, in continuous time.

    Where the jobs do not fit in their order, those that come too late are rejected.

    Parameters
    ----------
    problem
        The jobs and what binds them.
    hints : array of shape (jobs,)
        Start times, good to the radius, that give each agent's order; NaN where a job is rejected.
    agents : array of shape (jobs,)
        Who does it, from 1.
    radius
        Seconds.
    """
    hints = hints.copy()
    _reject_followers(problem, hints)
    while True:
        rows = sequences(problem, hints, agents)
        bound = [lag for lag in problem.lags if not math.isnan(hints[lag.first] + hints[lag.second])]
        starts = _by_agent(problem, rows, bound, hints, radius)
        if starts is not None and not all(_is_kept(lag, starts) for lag in bound):
            starts = _together(problem, rows, bound, hints, radius)
        if starts is not None:
            return draft_of(problem, starts, agents)
        _give_up_one(problem, rows, hints)


def _is_kept(lag: Lag, starts: Floats) -> bool:
    gap = float(starts[lag.second] - starts[lag.first])
    slack = ROUNDING * max(1.0, abs(float(starts[lag.second])))
    return lag.low - slack <= gap <= lag.high + slack


def _by_agent(
    problem: Problem, rows: dict[int, list[int]], bound: Sequence[Lag], hints: Floats, radius: float
) -> Floats | None:
    """Time each agent's jobs on their own; of lags only those from one job to the next are heeded."""
    starts = np.full(len(problem.jobs), np.nan)
    least = {(lag.first, lag.second): lag.low for lag in bound}
    lanes = lanes_of_agents(problem)
    for agent, row in rows.items():
        if not row:
            continue
        jobs = [problem.jobs[index] for index in row]
        for index, pair in enumerate(pairwise(row)):
            if least.get(pair, 0.0) > jobs[index].duration:
                jobs[index] = replace(jobs[index], duration=least[pair])
        windows = [job.windows[lanes[agent]] for job in jobs]
        found = None
        if all(job.function.log_concave for job in jobs):
            found = pooled(jobs, nearest(windows, hints[row]))
        if found is None or any(len(mine) > 1 for mine in windows):
            other = searched(jobs, windows, hints[row], radius)
            found = _better(jobs, found, other)
        if found is None:
            return None
        starts[row] = found
    return starts


def _together(
    problem: Problem, rows: dict[int, list[int]], bound: Sequence[Lag], hints: Floats, radius: float
) -> Floats | None:
    """Time all agents' jobs at once, as lags couple them."""
    lanes = lanes_of_agents(problem)
    placed = [index for row in rows.values() for index in row]
    place = {index: position for position, index in enumerate(placed)}
    lags = [Lag(place[lag.first], place[lag.second], lag.low, lag.high) for lag in bound]
    for row in rows.values():
        for first, second in pairwise(row):
            lags.append(Lag(place[first], place[second], problem.jobs[first].duration, math.inf))
    jobs = [problem.jobs[index] for index in placed]
    windows = [problem.jobs[index].windows[lanes[agent]] for agent, row in rows.items() for index in row]
    near = nearest(windows, hints[placed])
    reach = max((window.length for window in near), default=0.0)
    tries = [coupled(jobs, near, lags, hints[placed], within) for within in (radius, max(radius, reach))]
    found = _better(jobs, *tries)
    if found is None:
        return None
    starts = np.full(len(problem.jobs), np.nan)
    starts[placed] = found
    return starts


def _better(jobs: Sequence[Job], first: Floats | None, second: Floats | None) -> Floats | None:
    """Give the timing that costs less."""
    if first is None or second is None:
        return second if first is None else first
    before, after = (
        sum(float(job.costs(start)) for job, start in zip(jobs, starts, strict=True))
        for starts in (first, second)
    )
    return second if after < before else first


def nearest(windows: Sequence[Sequence[Interval]], hints: Floats) -> list[Interval]:
    """Give for each job the window next to its hint."""
    return [
        min(mine, key=lambda window: max(window.low - hint, hint - window.high, 0.0))
        for mine, hint in zip(windows, hints.tolist(), strict=True)
    ]


def _give_up_one(problem: Problem, rows: dict[int, list[int]], hints: Floats) -> None:
    """Reject the first job that cannot start in time after those before it, and what must come after it."""
    hints[_too_late(problem, rows)] = np.nan
    _reject_followers(problem, hints)


def _reject_followers(problem: Problem, hints: Floats) -> None:
    """Reject, in place, what must come after a rejected job."""
    followers = [True]
    while any(followers):
        followers = [
            bool(np.isnan(hints[lag.first]) and not np.isnan(hints[lag.second])) for lag in problem.lags
        ]
        for lag, follows in zip(problem.lags, followers, strict=True):
            if follows:
                hints[lag.second] = np.nan


def _too_late(problem: Problem, rows: dict[int, list[int]]) -> int:
    """Give what is cheapest to reject of a job that comes too late and those without a pause before it."""
    lanes = lanes_of_agents(problem)
    for agent, row in rows.items():
        free = -math.inf
        chain: list[int] = []
        for index in row:
            windows = [window for window in problem.jobs[index].windows[lanes[agent]] if window.high >= free]
            if not windows:
                return min([index, *chain], key=lambda member: problem.jobs[member].rejection)
            chain = [*chain, index] if windows[0].low <= free else [index]
            free = max(free, windows[0].low) + problem.jobs[index].duration
    placed = [index for row in rows.values() for index in row]
    return min(placed, key=lambda index: problem.jobs[index].rejection)
