"""What must hold of a solver's answer beside that of an independent optimiser."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

from fuzzytime.scheduling import (
    THRESHOLD,
    Labels,
    Limits,
    Milp,
    Pauses,
    Schedule,
    Shares,
    Solver,
    Status,
    solve,
)
from fuzzytime.scheduling.schedule import OPTIMAL_GAP, TINY
from fuzzytime.skills import FuzzyTask
from scheduling.oracle import best_cost, best_shared_cost, best_whole_cost
from scheduling.random_closeness import random_close_task, random_endless_task, random_event_task
from scheduling.random_tasks import (
    LAST,
    faults,
    random_bound_task,
    random_either_task,
    random_ready_task,
    random_shared_task,
    random_task,
)


@dataclass(frozen=True)
class Family:
    """Random tasks, the optimiser for them, a solver, and whether it must prove every optimum."""

    draw: Callable[[int], FuzzyTask]
    best: Callable[[FuzzyTask], float]
    solver: Solver | None
    proves: bool = True


def _whole(task: FuzzyTask) -> float:
    return best_whole_cost(task, THRESHOLD, LAST)


def _alone(task: FuzzyTask) -> float:
    return best_cost(task, THRESHOLD)


def _shared(task: FuzzyTask) -> float:
    return best_shared_cost(task, THRESHOLD)


def _endless(task: FuzzyTask) -> float:
    return best_whole_cost(task, THRESHOLD, 40)


FAMILIES = {
    "one agent": Family(random_task, _alone, None),
    "one agent, labels": Family(random_task, _alone, Labels(), proves=False),
    "one agent, all ready": Family(random_ready_task, _alone, Labels(), proves=False),
    "one agent, several times offered": Family(random_either_task, _alone, None, proves=False),
    "several agents": Family(random_shared_task, _shared, None),
    "several agents, shares": Family(random_shared_task, _shared, Shares(), proves=False),
    "several agents, program": Family(random_shared_task, _shared, Milp(), proves=False),
    "lags": Family(random_bound_task, _whole, None, proves=False),
    "lags, pauses": Family(random_bound_task, _whole, Pauses(), proves=False),
    "lags, program": Family(random_bound_task, _whole, Milp(), proves=False),
    "curves and lags": Family(random_close_task, _whole, None, proves=False),
    "events": Family(random_event_task, _endless, None, proves=False),
    "steps without end": Family(random_endless_task, _endless, None, proves=False),
}


def cost_of(schedule: Schedule) -> float:
    """Give what a schedule's start times cost: by ψ, and for all that it costs to follow too late."""
    task, starts = schedule.task, schedule.start_times
    got = [float(skill.satisfaction(start)) for skill, start in zip(task.skills, starts, strict=True)]
    for _ in task.skills:
        for entry in task.precedences:
            pause = starts[entry.second] - starts[entry.first] - task.skills[entry.first].time_until_done
            in_vain = entry.maximum_lag < math.inf and got[entry.first] <= THRESHOLD
            if in_vain or pause > entry.maximum_lag + 1e-6:
                got[entry.second] = 0.0
    return -math.fsum(
        skill.priority * math.log(max(value, THRESHOLD))
        for skill, value in zip(task.skills, got, strict=True)
    )


def wrong_if_strict(task: FuzzyTask, last: int) -> Iterator[str]:
    """Solve a task of whole seconds by the strict product, and say what is wrong with what is said of it."""
    schedule = solve(task, threshold=0)
    possible, clash = _can_be_had(task, last), schedule.clash
    if possible == (schedule.certificate.status is Status.INFEASIBLE):
        yield f"{schedule.certificate.status} is said of a task that can{'' if possible else 'not'} be had"
    if possible and any(schedule.rejected):
        yield f"{schedule.rejected} are rejected of a task that can be had"
    if possible and schedule.certificate.lower_cost > best_whole_cost(task, TINY, last) + 1e-6:
        yield "the bound lies above the best cost"
    if clash and _can_be_had(task.select(clash), last):
        yield f"the clash {clash} can be had"
    for member in clash if len(clash) > 1 else ():
        if not _can_be_had(task.select([other for other in clash if other != member]), last):
            yield f"{member} is superfluous in the clash {clash}"


def _can_be_had(task: FuzzyTask, last: int) -> bool:
    least = min(skill.priority for skill in task.skills)
    return best_whole_cost(task, TINY, last) < -0.5 * least * math.log(TINY)


def wrong(family: Family, seed: int) -> Iterator[str]:
    """Solve one random task, and say what is wrong with the answer."""
    task = family.draw(seed)
    schedule = solve(task, solver=family.solver, limits=Limits(seconds=math.inf if family.proves else 10.0))
    best, certificate = family.best(task), schedule.certificate
    weight = math.fsum(skill.priority for skill in task.skills)
    yield from (f"seed {seed}: {fault}" for fault in faults(schedule))
    if certificate.lower_cost > best + 1e-6:
        yield f"seed {seed}: the bound {certificate.lower_cost} lies above the best cost {best}"
    if abs(schedule.weighted_cost - cost_of(schedule)) > 1e-9:
        yield f"seed {seed}: {schedule.weighted_cost} is said of a schedule that costs {cost_of(schedule)}"
    if certificate.status is Status.OPTIMAL and schedule.weighted_cost > best + OPTIMAL_GAP * weight + 1e-6:
        yield f"seed {seed}: {schedule.weighted_cost} is called optimal beside {best}"
    if family.proves and certificate.status is not Status.OPTIMAL:
        yield f"seed {seed}: {certificate.status}, not optimal"
