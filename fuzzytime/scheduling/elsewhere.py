"""What if a skill started at another time? The skills near by are scheduled anew around it.

What stands far off stays where it is, so that an answer costs the same in a long schedule; what another time
costs is then never understated.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from fuzzytime.satisfaction import Interval, Rectangle
from fuzzytime.scheduling.limits import Limits, Stopwatch
from fuzzytime.scheduling.problem.jobs import Job
from fuzzytime.scheduling.problem.posing import problem_of
from fuzzytime.scheduling.schedule import Schedule
from fuzzytime.scheduling.search.local_search import LocalSearch
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

    None where no agent is free for it then, the interval is over, what must come first is rejected, or it
    would come too late behind another.

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
    around = _around(schedule, members, within)
    found = solve(
        around,
        solver=solver or LocalSearch(),
        threshold=schedule.threshold,
        limits=replace(watch.limits, seconds=watch.remaining),
        objectives=(),
        hints=_as_now(schedule, members, around, within),
    )
    waits_in_vain = any(entry.second == 0 and found.rejected[entry.first] for entry in found.task.precedences)
    if found.start_times[0] not in within or waits_in_vain:
        return None
    starts = list(schedule.start_times)
    for member, start in zip(members, found.start_times, strict=False):
        starts[member] = start
    whole = replace(schedule, start_times=tuple(starts))
    if whole.satisfactions[position] < float(schedule.task.skills[position].satisfaction(starts[position])):
        return None
    return Alternative(starts[position], whole.satisfactions, whole.satisfaction, whole.weighted_cost)


def _near(schedule: Schedule, position: int, within: Interval) -> list[int]:
    """Give the skills near where one is or would be, without those that are as well done at any late time.

    A rejected skill comes with what precedences bind to it, as it may be rejected for their sake.
    """
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
    chosen = {job.position for job in others[:NEAR]}
    while True:
        lost = [
            member for member in _bound_to(schedule.task, {position, *chosen}) if schedule.rejected[member]
        ]
        more = _bound_to(schedule.task, lost) - chosen - {position}
        if not more:
            return sorted(chosen)
        chosen |= more


def _around(schedule: Schedule, members: list[int], within: Interval) -> FuzzyTask:
    """Give the task of some skills, the first of them at given times, while the others stay where they are.

    Those others that precedences bind to a member follow the members, each at its time.
    """
    task, specific = schedule.task, schedule.skills
    pinned = sorted(_bound_to(task, members) - set(members))
    # Rejecting one of these must cost more than anything else can.
    firm = 1.0 + math.fsum(skill.priority for skill in task.skills)
    skills = [task.skills[member] for member in members]
    skills[0] = replace(skills[0], satisfaction=Rectangle(within.low, within.high), priority=firm)
    for position in pinned:
        then = Rectangle(specific[position].start, specific[position].start)
        agent = specific[position].agent
        skills.append(replace(task.skills[position], satisfaction=then, priority=firm, agent=agent))
    busy = [
        Busy(specific[position].start, specific[position].end, agent=specific[position].agent)
        for position in sorted(set(range(len(specific))) - {*members, *pinned})
        if not schedule.rejected[position] and not task.skills[position].needs_nobody
    ]
    part = task.select([*members, *pinned])
    return replace(part, skills=tuple(skills), busy=(*task.busy, *busy))


def _as_now(schedule: Schedule, members: Sequence[int], around: FuzzyTask, within: Interval) -> list[float]:
    """Give starts from which a search may go on: all others as they are, the first as near as may be."""
    starts = [math.nan if schedule.rejected[member] else schedule.skills[member].start for member in members]
    pinned = [skill.satisfaction.best.low for skill in around.skills[len(members) :]]
    own = schedule.skills[members[0]].start
    return [min(max(own, within.low), within.high), *starts[1:], *pinned]


def _bound_to(task: FuzzyTask, members: Iterable[int]) -> set[int]:
    """Give some skills with those that a precedence binds to one of them."""
    inside = set(members)
    pairs = [{entry.first, entry.second} for entry in task.precedences]
    return inside.union(*(pair for pair in pairs if pair & inside))
