"""Solve a task: its problem, group by group, then real start times for all, with the certificate."""

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from fuzzytime.errors import FuzzytimeError
from fuzzytime.scheduling.auto import Auto
from fuzzytime.scheduling.limits import Limits, Stopwatch
from fuzzytime.scheduling.problem.alone import best_alone
from fuzzytime.scheduling.problem.clash import clash_of
from fuzzytime.scheduling.problem.placement import place_rest
from fuzzytime.scheduling.problem.posing import problem_of
from fuzzytime.scheduling.schedule import OPTIMAL_GAP, THRESHOLD, TINY, Certificate, Schedule, Status
from fuzzytime.scheduling.search.expected import expected_starts
from fuzzytime.scheduling.search.local_search import LocalSearch
from fuzzytime.scheduling.search.warm import remembered
from fuzzytime.scheduling.secondary.lexicographic import rearranged
from fuzzytime.scheduling.secondary.objectives import DEFAULT, Objective
from fuzzytime.scheduling.solver import Solver, nothing
from fuzzytime.skills import FuzzyTask


def solve(
    task: FuzzyTask,
    *,
    solver: Solver | None = None,
    threshold: float = THRESHOLD,
    limits: Limits | None = None,
    objectives: Sequence[Objective] = DEFAULT,
    hints: Sequence[float] = (),
) -> Schedule:
    """Find start times that satisfy most, and prove how good they are.

    Maximises ∏ max(ψ_i(t_i), ε)^priority over start times t_i ≥ 0 at which no agent does two things at once
    (the paper's eqs. 4 and 5).

    Parameters
    ----------
    task
        Skills, agents, precedences and busy times.
    solver
        How; None picks by the task.
    threshold
        ε: a skill is placed where ψ > ε, or rejected and counted as ε; 0 for the paper's strict product.
    limits
        Time and memory; out of either the best schedule so far comes back, with its gap.
    objectives
        What counts among schedules that satisfy equally, the first most.
    hints
        Starts to begin the search with, such as those of a schedule for nearly the same task; NaN where none
        is known.

    Raises
    ------
    FuzzytimeError
        If the threshold is not in [0, 1), hints are not one a skill, or no agent ever has time for one.
    RefusedError
        If the solver cannot solve such a task at all.

    >>> from fuzzytime.satisfaction import Triangle
    >>> from fuzzytime.skills import FuzzySkill
    >>> flip = FuzzySkill("flip the pancakes", Triangle(60, 120, 180), duration=30)
    >>> pour = FuzzySkill("pour the coffee", Triangle(60, 120, 180), duration=30)
    >>> schedule = solve(FuzzyTask((flip, pour)))
    >>> schedule.start_times, schedule.satisfactions, str(schedule.certificate.status)
    ((105.0, 135.0), (0.75, 0.75), 'optimal')
    """
    if hints and len(hints) != len(task.skills):
        raise FuzzytimeError(f"hints must be one for each of {len(task.skills)} skills, got {len(hints)}")
    watch = Stopwatch(limits or Limits())
    hints = hints or expected_starts(task)
    if threshold == 0:
        quick = _scheduled(task, LocalSearch(), threshold, watch.share(0.3), objectives, hints)
        if any(quick.rejected):
            clash = clash_of(task, partial(_is_impossible, task, watch.share(0.5)), watch.share(0.5))
            if clash:
                return replace(quick, clash=clash, certificate=_infeasible(quick.certificate))
        else:
            hints = hints or quick.start_times
    return _scheduled(task, solver or Auto(), threshold, watch, objectives, hints)


def _is_impossible(task: FuzzyTask, watch: Stopwatch, members: tuple[int, ...]) -> bool:
    """Tell whether it is proved that some skills cannot all be satisfied."""
    schedule = _scheduled(task.select(members), Auto(), 0.0, watch, ())
    return schedule.certificate.status is Status.INFEASIBLE


def _scheduled(
    task: FuzzyTask,
    solver: Solver,
    threshold: float,
    watch: Stopwatch,
    objectives: Sequence[Objective],
    hints: Sequence[float] = (),
) -> Schedule:
    """Solve group by group, go by what counts among equals, and place the rest."""
    problem = problem_of(task, threshold)
    lower = math.fsum(job.rejection for job in problem.apart) + math.fsum(job.least for job in problem.free)
    draft = nothing(problem)
    methods: dict[str, None] = {}  # in the order of their first use
    left = len(problem.jobs)
    for members in sorted(problem.groups(), key=len):  # What is small leaves time to what is large.
        group = problem.select(members)
        share, left = watch.share(len(members) / left), left - len(members)
        found = solver.search(group, share, remembered(group, hints) if hints else None)
        lower += found.lower_cost
        methods[found.method or solver.name] = None
        draft.starts[members], draft.agents[members] = found.starts, found.agents
    draft = rearranged(problem, task, draft, objectives, watch)
    starts, agents = [math.nan] * len(task.skills), [1] * len(task.skills)
    for job, start, agent in zip(problem.jobs, draft.starts.tolist(), draft.agents.tolist(), strict=True):
        starts[job.position] = start
        # What happens by itself is nobody's.
        agents[job.position] = agent if agent <= task.agents else task.skills[job.position].agent or 1
    for job in problem.free:
        skill = task.skills[job.position]
        wanted = 0.0 if skill.preferred is None else skill.preferred
        best = best_alone(task, job.position, wanted).nearest(wanted)
        starts[job.position] = min(max(best, job.earliest), job.latest)
        agents[job.position] = skill.agent or 1
    place_rest(task, (*problem.jobs, *problem.apart), starts, agents)
    method = " + ".join(methods) or solver.name
    open_end = Certificate(Status.HEURISTIC, -math.inf, math.inf, method, watch.seconds)
    schedule = Schedule(task, tuple(starts), tuple(agents), open_end, threshold)
    return replace(schedule, certificate=_certificate(schedule, lower, open_end))


def _certificate(schedule: Schedule, lower: float, plain: Certificate) -> Certificate:
    """Say what a lower bound proves about a schedule."""
    if lower == -math.inf:
        return plain
    worst = -math.log(TINY) * math.fsum(skill.priority for skill in schedule.task.skills)
    if schedule.threshold == 0 and any(schedule.rejected):
        # Every schedule without a rejection costs at most this, so that a bound above it leaves none.
        if lower > worst:
            return _infeasible(plain)
        return replace(plain, status=Status.BOUNDED, lower_cost=lower)
    cost = schedule.weighted_cost
    weight = math.fsum(skill.priority for skill in schedule.task.skills)
    lower = min(lower, cost)
    gap = math.expm1((cost - lower) / weight) if weight else 0.0
    return replace(
        plain, status=Status.OPTIMAL if gap <= OPTIMAL_GAP else Status.BOUNDED, lower_cost=lower, gap=gap
    )


def _infeasible(plain: Certificate) -> Certificate:
    """Say that the strict product of every schedule is 0."""
    return replace(plain, status=Status.INFEASIBLE, lower_cost=math.inf, gap=0.0)
