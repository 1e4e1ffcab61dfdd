"""From a request to a plan: interpret, schedule, and say what needs saying."""

import math
from collections import Counter
from dataclasses import dataclass, replace
from datetime import datetime
from functools import cached_property

from fuzzytime.interpreter.binding.apart import apart
from fuzzytime.interpreter.binding.both_hands import behind_each_other
from fuzzytime.interpreter.binding.loosening import loosened, may_be_loosened
from fuzzytime.interpreter.happening import attended, clashes, happening
from fuzzytime.interpreter.interpretation import Interpretation, Interpreted, Problem, ProblemKind
from fuzzytime.interpreter.interpreter import Interpreter
from fuzzytime.interpreter.request import Request, Started
from fuzzytime.interpreter.started import without_started
from fuzzytime.scheduling import THRESHOLD, Limits, Schedule, Solver, solve
from fuzzytime.skills import FuzzyTask
from fuzzytime.times import instant_after, seconds_between

FIRST = 0.6
"""Share of the time for a schedule whose rejections may loosen the order: the looser task wants a search, and
a bound, of its own."""


@dataclass(frozen=True, kw_only=True)
class Plan:
    """A request, understood and scheduled."""

    request: Request
    interpretation: Interpretation
    schedule: Schedule
    problems: tuple[Problem, ...]

    @property
    def skills(self) -> tuple[Interpreted, ...]:
        """The skills in the order of the request, as in the schedule's task."""
        return self.interpretation.skills

    @property
    def waiting(self) -> tuple[Interpreted, ...]:
        """What has no time yet: nobody has told what it waits for."""
        return self.interpretation.waiting

    @property
    def everything(self) -> tuple[Interpreted, ...]:
        """The skills, and behind them what waits: a skill's place among them is its position."""
        return self.interpretation.everything

    def has_time(self, position: int) -> bool:
        """Say whether a skill has a time: it is neither rejected, nor waits."""
        return position < len(self.skills) and not self.schedule.rejected[position]

    @cached_property
    def shared_names(self) -> frozenset[str]:
        """The names that more than one skill has: they need an identifier to be told apart."""
        counted = Counter(interpreted.skill.name for interpreted in self.skills)
        return frozenset(name for name, count in counted.items() if count > 1)

    def instant(self, time: float) -> datetime:
        """Give the wall-clock instant of a time of the plan."""
        return instant_after(self.request.now, time)

    def rejected_before(self, position: int) -> int | None:
        """Give a rejected skill that another must come after, by their positions; None without one."""
        return rejected_before(self.schedule, position)


def task_of(interpretation: Interpretation, request: Request) -> FuzzyTask:
    """Give the scheduling task of an interpreted request, without busy times after all that it asks for."""
    skills = tuple(interpreted.skill for interpreted in interpretation.skills)
    over = max(
        (
            skill.satisfaction.support.high + skill.time_until_done
            for skill in skills
            if not skill.satisfaction.support.empty
        ),
        default=0.0,
    )
    return FuzzyTask(
        skills,
        request.agents,
        (*interpretation.precedences, *interpretation.order),
        tuple(busy for busy in request.busy if busy.start < over),
        past_hour=60.0 * request.now.minute + request.now.second + request.now.microsecond / 1e6,
    )


def plan(
    request: Request,
    interpreter: Interpreter,
    *,
    solver: Solver | None = None,
    threshold: float = THRESHOLD,
    limits: Limits | None = None,
    previous: Plan | None = None,
) -> Plan:
    """Interpret a request and schedule it.

    Parameters
    ----------
    request, interpreter
        What is asked, and what understands it.
    solver, threshold, limits
        As in `fuzzytime.scheduling.solve`.
    previous
        An earlier plan of nearly the same request: the search begins from its starts.

    Raises
    ------
    FuzzytimeError
        If the request contradicts itself: an unknown identifier, precedences in a circle.
    """
    return scheduled(
        *understood(request, interpreter),
        solver=solver,
        threshold=threshold,
        limits=limits,
        previous=previous,
    )


def understood(request: Request, interpreter: Interpreter) -> tuple[Request, Interpretation]:
    """Interpret a request and set apart what waits, and what has started: that is open no more.

    Raises
    ------
    FuzzytimeError
        If the request contradicts itself: an unknown identifier, precedences in a circle.
    """
    interpretation = happening(interpreter.interpret(request), request.started)
    appointments = attended(interpretation, request)
    busy = (*request.busy, *(taken for _, taken in appointments))
    unread = (Problem(kind=ProblemKind.UNREADABLE, message=sentence) for sentence in request.unread)
    problems = (*unread, *interpretation.problems, *clashes(appointments, request))
    interpretation = replace(interpretation, problems=problems)
    over = (
        Started(identifier=one.identifier, start=0, end=0, done=0)
        for one in interpretation.skills
        if one.cancelled
    )
    interpretation, held = without_started(interpretation, (*request.started, *over))
    return replace(request, busy=(*busy, *held)), apart(interpretation)


def scheduled(
    request: Request,
    interpretation: Interpretation,
    *,
    solver: Solver | None = None,
    threshold: float = THRESHOLD,
    limits: Limits | None = None,
    previous: Plan | None = None,
) -> Plan:
    """Schedule what is understood of a request; parameters and errors are those of `plan` and `solve`."""
    hints = () if previous is None else _starts_of(previous, interpretation, request.now)
    interpretation = loosened(interpretation)
    limits = limits or Limits()
    over = limits.clock() + limits.seconds
    share = FIRST if may_be_loosened(interpretation) else 1.0
    while True:
        task = task_of(interpretation, request)
        left = replace(limits, seconds=share * max(0.0, over - limits.clock()))
        until = limits.clock() + left.seconds
        schedule = solve(task, solver=solver, threshold=threshold, limits=left, hints=hints)
        # What was found under a stricter order holds under a looser one, where no time is left for more.
        hints = list(schedule.start_times)
        looser = loosened(interpretation, schedule.rejected)
        ran_out = share < 1 and until <= limits.clock() < over and not limits.stopped()
        # Without time, what is rejected says no more of the order than that time was short.
        in_vain = not left.seconds
        if in_vain or (looser is interpretation and not ran_out):
            break
        interpretation, share = looser, 1.0
    problems = (
        *interpretation.problems,
        *behind_each_other(interpretation, schedule),
        *_rejections(interpretation, schedule),
    )
    return Plan(request=request, interpretation=interpretation, schedule=schedule, problems=problems)


def _starts_of(previous: Plan, interpretation: Interpretation, now: datetime) -> list[float]:
    """Give where an earlier plan starts each skill, in seconds from a later now; NaN where it is new."""
    passed = seconds_between(previous.request.now, now)
    known = zip(previous.skills, previous.schedule.start_times, strict=True)
    starts = {interpreted.identifier: start - passed for interpreted, start in known}
    return [starts.get(interpreted.identifier, math.nan) for interpreted in interpretation.skills]


def rejected_before(schedule: Schedule, position: int) -> int | None:
    """Give a rejected skill that another must come after, by their positions; None where there is none."""
    firsts = (entry.first for entry in schedule.task.precedences if entry.second == position)
    return next((first for first in firsts if schedule.rejected[first]), None)


def _rejections(interpretation: Interpretation, schedule: Schedule) -> list[Problem]:
    """Say why each rejected skill is: its own reason, or that others matter more."""
    problems = []
    beside = "busy times and " if schedule.task.busy else ""
    for position, (interpreted, rejected) in enumerate(
        zip(interpretation.skills, schedule.rejected, strict=True)
    ):
        if not rejected:
            continue
        first = rejected_before(schedule, position)
        reason = interpreted.reason or (
            f"must come after {interpretation.skills[first].skill.name}, which is rejected"
            if first is not None
            else f"no start time that satisfies is left beside {beside}what else is planned"
            if not interpreted.skill.satisfaction.support.empty
            else "no start time satisfies"
        )
        problems.append(
            Problem(
                kind=ProblemKind.REJECTED,
                message=f"{interpreted.skill.name}: {reason}",
                line=interpreted.wish.line,
                text=interpreted.words or interpreted.skill.name,
                identifier=interpreted.identifier,
            )
        )
    return problems
