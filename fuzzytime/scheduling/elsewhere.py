"""What if a skill started at another time? The skills near by are scheduled anew around it.

What stands far off stays where it is, so that an answer costs the same in a long schedule; what another time
costs is then never understated.
"""

import math
from dataclasses import dataclass, replace

from fuzzytime.satisfaction import Interval, Rectangle
from fuzzytime.scheduling.auto import LocalSearch
from fuzzytime.scheduling.limits import Limits, Stopwatch
from fuzzytime.scheduling.problem import Job, problem_of
from fuzzytime.scheduling.schedule import Schedule
from fuzzytime.scheduling.solve import solve
from fuzzytime.scheduling.solver import Solver
from fuzzytime.skills import Busy, FuzzyTask

NEAR = 12
"""How many other skills are scheduled anew."""


@dataclass(frozen=True, slots=True)
class Alternative:
    """The best schedule that was found in which one skill starts at another time.

    Parameters
    ----------
    start
        When it starts there, in seconds.
    satisfactions
        Those of all skills of the task.
    product
        ∏ max(ψ, ε), as in `Schedule.satisfaction`.
    cost
        Σ −priority · log max(ψ, ε), as in `Schedule.weighted_cost`.
    """

    start: float
    satisfactions: tuple[float, ...]
    product: float
    cost: float


def elsewhere(
    schedule: Schedule,
    position: int,
    within: Interval,
    *,
    solver: Solver | None = None,
    limits: Limits | None = None,
) -> Alternative | None:
    """Find the best schedule in which a skill starts within an interval, at the cost of those near by.

    None where no agent is free for it then, or the interval lies before now.

    Parameters
    ----------
    schedule, position
        The skill.
    within
        Starts in seconds; a single one, such as a minute later than now, gives the price of that minute.
    solver, limits
        As in `explain`.
    """
    watch = Stopwatch(limits or Limits(seconds=3.0))
    members = [position, *_near(schedule, position, within)]
    found = solve(
        _around(schedule, members, within),
        solver=solver or LocalSearch(),
        threshold=schedule.threshold,
        limits=replace(watch.limits, seconds=watch.remaining),
    )
    if found.start_times[0] not in within:
        return None
    starts = list(schedule.start_times)
    for member, start in zip(members, found.start_times, strict=False):
        starts[member] = start
    whole = replace(schedule, start_times=tuple(starts))
    return Alternative(starts[position], whole.satisfactions, whole.satisfaction, whole.weighted_cost)


def _near(schedule: Schedule, position: int, within: Interval) -> list[int]:
    """Give the skills near where one is or would be, without those that are as well done at any late time."""
    skills, own = schedule.skills, schedule.skills[position]
    wanted = min(max(own.start, within.low), within.high)
    low, high = min(own.start, wanted), max(own.start, wanted) + own.duration

    def distance(job: Job) -> tuple[float, float]:
        start, end = skills[job.position].start, skills[job.position].end
        if schedule.rejected[job.position]:
            start, end = job.earliest, job.latest + job.duration
        return max(start - high, low - end, 0.0), abs(start - wanted)

    jobs = problem_of(schedule.task, schedule.threshold).jobs
    others = sorted((job for job in jobs if job.position != position), key=distance)
    return [job.position for job in others[:NEAR]]


def _around(schedule: Schedule, members: list[int], within: Interval) -> FuzzyTask:
    """Give the task of some skills, the first of them at given times, while the others stay where they are.

    Those others that come before or after a member by a precedence are in the task too, each at its time.
    """
    task, specific = schedule.task, schedule.skills
    fixed = {position for position, rejected in enumerate(schedule.rejected) if not rejected} - set(members)
    linked: set[int] = set()
    for entry in task.precedences:
        linked |= {entry.first, entry.second} if {entry.first, entry.second} & set(members) else set()
    # Rejecting one of these must cost more than anything else can.
    firm = 1.0 + math.fsum(skill.priority for skill in task.skills)
    pinned = sorted(fixed & linked)
    skills = [
        replace(task.skills[members[0]], satisfaction=Rectangle(within.low, within.high), priority=firm),
        *(task.skills[member] for member in members[1:]),
        *(
            replace(
                task.skills[position],
                satisfaction=Rectangle(specific[position].start, specific[position].start),
                priority=firm,
                agent=specific[position].agent,
            )
            for position in pinned
        ),
    ]
    place = {position: index for index, position in enumerate([*members, *pinned])}
    precedences = tuple(
        replace(entry, first=place[entry.first], second=place[entry.second])
        for entry in task.precedences
        if entry.first in place and entry.second in place
    )
    busy = [
        Busy(specific[position].start, specific[position].end, agent=specific[position].agent)
        for position in sorted(fixed - linked)
    ]
    return FuzzyTask(tuple(skills), task.agents, precedences, (*task.busy, *busy))
