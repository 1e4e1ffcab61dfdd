"""Real start times for the skills that are not placed where they satisfy, after what matters.

A rejected skill starts as soon as an agent is free for it once its windows are over. A skill that is as well
done at any late time, as an instruction without time words, takes the first free time that is good enough, or
the nearest to what was named.
"""

import bisect
import math
from collections.abc import Iterable, Sequence

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Interval
from fuzzytime.scheduling.problem.jobs import Job
from fuzzytime.scheduling.problem.windows import free_of, good_enough, in_common
from fuzzytime.skills import FuzzyTask

ROOM = 1e-10
"""Seconds by which a gap may be too short, for rounding."""


class Rota:
    """What each agent is taken by."""

    def __init__(self, agents: Iterable[int]) -> None:
        self._taken: dict[int, list[tuple[float, float]]] = {agent: [] for agent in agents}

    def take(self, agent: int, start: float, end: float) -> None:
        """Note that an agent is taken for a time."""
        bisect.insort(self._taken[agent], (start, end))

    def earliest(self, agent: int, duration: float, wanted: Sequence[Interval]) -> float:
        """Give the first start in one of some ascending intervals at which an agent is free, or infinity."""
        for interval in wanted:
            start = interval.low
            for low, high in self._taken[agent]:
                if low - start >= duration - ROOM:
                    break
                if high > start:
                    start = high
            if start <= interval.high and start < math.inf:
                return start
        return math.inf

    def nearest(
        self, agent: int, duration: float, wanted: Sequence[Interval], named: Sequence[float]
    ) -> tuple[float, int, float]:
        """Give how far an agent is free from what named time, by its place, and when; infinity if never.

        Of times that are as far the first named one counts.
        """
        taken = tuple(Interval(low, high) for low, high in self._taken[agent])
        free = free_of(tuple(wanted), taken, duration)
        starts = (
            (rank, time, min(max(time, span.low), span.high))
            for rank, time in enumerate(named)
            for span in free
        )
        found = ((abs(start - time), rank, start) for rank, time, start in starts)
        return min(found, default=(math.inf, 0, math.inf))


def place_rest(task: FuzzyTask, jobs: Sequence[Job], starts: list[float], agents: list[int]) -> None:
    """Fill in start times and agents, in place, where a start is NaN.

    Raises
    ------
    FuzzytimeError
        If no agent ever has time for a skill.
    """
    everybody = range(1, task.agents + 1)
    rota = Rota(everybody)
    for busy in task.busy:
        for agent in everybody if busy.agent is None else [busy.agent]:
            rota.take(agent, busy.start, busy.end)
    for skill, start, agent in zip(task.skills, starts, agents, strict=True):
        if not math.isnan(start) and not skill.needs_nobody:
            rota.take(agent, start, start + skill.duration)
    pairs = zip(task.skills, starts, strict=True)
    end_of_all = max((start + skill.duration for skill, start in pairs if not math.isnan(start)), default=0.0)
    for job in _in_order(task, [job for job in jobs if math.isnan(starts[job.position])]):
        skill = task.skills[job.position]
        release = 0.0
        for precedence in task.precedences:
            if precedence.second == job.position:
                first = task.skills[precedence.first]
                done = starts[precedence.first] + first.time_until_done
                release = max(release, done + precedence.minimum_lag)
        if job.over == math.inf:
            wanted = in_common(good_enough(job), [Interval(release, math.inf)])
        else:
            # What has no time at all waits for everything that has.
            wanted = (Interval(max(release, job.over or end_of_all), math.inf),)
        allowed = [skill.agent] if skill.agent is not None else everybody
        if skill.named and job.over == math.inf:
            *_, start, agent = min(
                (*rota.nearest(agent, job.duration, wanted, skill.named), agent) for agent in allowed
            )
        else:
            start, agent = min((rota.earliest(agent, job.duration, wanted), agent) for agent in allowed)
        if start == math.inf:
            raise FuzzytimeError(
                f"every skill needs a time when an agent is free for it, got none for {skill.name!r}"
            )
        starts[job.position], agents[job.position] = start, agent
        if not skill.needs_nobody:
            rota.take(agent, start, start + job.duration)


def _in_order(task: FuzzyTask, jobs: list[Job]) -> list[Job]:
    """Sort jobs by when their windows are over, each after what must come before it.

    What was named has its time before what may be at any.
    """
    waiting = sorted(
        jobs, key=lambda job: (job.over or math.inf, not task.skills[job.position].named, job.position)
    )
    ordered: list[Job] = []
    while waiting:
        missing = {job.position for job in waiting}
        blocked = {entry.second for entry in task.precedences if entry.first in missing}
        job = next(job for job in waiting if job.position not in blocked)
        waiting.remove(job)
        ordered.append(job)
    return ordered
