"""Why here? What each skill could have had alone, what it lost, to whom, and what another time would cost.

A loss is explained by its *alternative*: the skill is given its best time, the skills near by are scheduled
anew around it, and those that are then worse off are the ones it lost to.
"""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from enum import StrEnum

from fuzzytime.satisfaction import Interval
from fuzzytime.scheduling.elsewhere import Alternative, elsewhere
from fuzzytime.scheduling.limits import Limits, Stopwatch
from fuzzytime.scheduling.problem.alone import Best, best_alone, best_beside
from fuzzytime.scheduling.schedule import Schedule
from fuzzytime.scheduling.solver import Solver
from fuzzytime.skills import Busy, FuzzyTask

ALTERNATIVES = 0.8
"""The share of the time in which alternatives are looked for; then only those in the way are."""

LOSS = 1e-4
"""A satisfaction that differs by less is not worth a word."""


class Bond(StrEnum):
    """How a neighbour keeps a skill from its best time."""

    OVERLAP = "overlap"
    """It is at work in the minutes that the skill wants."""
    CHAIN = "chain"
    """It would have to make room for what is at work in those minutes."""
    ORDER = "order"
    """One of the two must come after the other."""


@dataclass(frozen=True, slots=True)
class Neighbour:
    """A skill that another one lost to.

    Parameters
    ----------
    position
        Where it stands in the task.
    bond
        How it binds the other.
    satisfaction
        What it has.
    instead
        What it would have if the other had its best time; None where the two cannot be had together, or time
        was over.
    """

    position: int
    bond: Bond
    satisfaction: float
    instead: float | None

    @property
    def loss(self) -> float:
        """What the other's best time would cost it, 0 where that is not known."""
        return 0.0 if self.instead is None else self.satisfaction - self.instead


@dataclass(frozen=True, slots=True)
class Why:
    """Why a skill of a schedule starts when it does.

    Parameters
    ----------
    position
        Where it stands in the task.
    start, satisfaction
        What it got.
    best
        What it could have had alone, from now on and beside appointments.
    lost
        What it lost to others, at least 0: nothing where alone it would be rejected as well.
    ideal
        The largest ψ of all times: larger than what it could have had where its best time is over or taken.
    appointments
        Busy times without which it could have had more.
    neighbours
        To whom it lost, the one that would lose most first.
    alternative
        The schedule in which it has its best time; None where it has, where there is none, or time was over.
    sought
        Whether those that it lost to were looked for: not where time was over.
    """

    position: int
    start: float
    satisfaction: float
    best: Best
    lost: float
    ideal: float
    appointments: tuple[Busy, ...]
    neighbours: tuple[Neighbour, ...]
    alternative: Alternative | None
    sought: bool = True

    @property
    def alone(self) -> float:
        """The satisfaction that it could have had alone."""
        return self.best.satisfaction


def explain(
    schedule: Schedule,
    positions: Iterable[int] | None = None,
    *,
    solver: Solver | None = None,
    limits: Limits | None = None,
) -> tuple[Why, ...]:
    """Say for skills of a schedule what they lost, and to whom.

    Parameters
    ----------
    schedule
        What is explained.
    positions
        Skills, by position in the task; None for all.
    solver
        Finds the alternatives; None takes a local search.
    limits
        For all together; of skills that are left when most of the time is over no alternative is given, and
        when it is over not whom they lost to.

    >>> from fuzzytime.satisfaction import Triangle
    >>> from fuzzytime.scheduling.solve import solve
    >>> from fuzzytime.skills import FuzzySkill
    >>> flip = FuzzySkill("flip the pancakes", Triangle(60, 120, 180), duration=30, priority=2)
    >>> pour = FuzzySkill("pour the coffee", Triangle(60, 120, 180), duration=30)
    >>> _, why = explain(solve(FuzzyTask((flip, pour))))
    >>> round(why.alone, 2), round(why.lost, 2), why.neighbours[0].position, str(why.neighbours[0].bond)
    (1.0, 0.5, 0, 'overlap')
    """
    whole = Stopwatch(limits or Limits(seconds=3.0))
    watch = whole.share(ALTERNATIVES)
    chosen = range(len(schedule.start_times)) if positions is None else positions
    return tuple(_why(schedule, position, solver, watch, whole) for position in chosen)


def _why(schedule: Schedule, position: int, solver: Solver | None, watch: Stopwatch, whole: Stopwatch) -> Why:
    skill, start = schedule.task.skills[position], schedule.start_times[position]
    best = best_alone(schedule.task, position, start)
    alternative: Alternative | None = None
    neighbours: tuple[Neighbour, ...] = ()
    lost = max(0.0, best.satisfaction - schedule.satisfactions[position])
    if best.satisfaction <= schedule.threshold:
        lost = 0.0
    sought = not (lost > LOSS and whole.is_over())
    if lost > LOSS and sought:
        limits = replace(watch.limits, seconds=watch.remaining)
        if not watch.is_over():
            alternative = elsewhere(schedule, position, best.starts, solver=solver, limits=limits)
        neighbours = _neighbours(schedule, position, best, alternative)
    ideal = skill.satisfaction.best
    return Why(
        position,
        start,
        schedule.satisfactions[position],
        best,
        lost,
        0.0 if ideal.empty else float(skill.satisfaction(min(max(0.0, ideal.low), ideal.high))),
        _appointments(schedule.task, position, best, start),
        neighbours,
        alternative,
        sought,
    )


def _neighbours(
    schedule: Schedule, position: int, best: Best, alternative: Alternative | None
) -> tuple[Neighbour, ...]:
    """Give those that would pay for a skill's best time; where nobody would, those that are in its way."""
    others = [other for other in range(len(schedule.start_times)) if other != position]
    if alternative is not None:
        found = [
            Neighbour(
                other,
                _bond(schedule, position, other, best.starts),
                schedule.satisfactions[other],
                alternative.satisfactions[other],
            )
            for other in others
        ]
        paying = [neighbour for neighbour in found if neighbour.loss > LOSS]
        if paying:
            return tuple(sorted(paying, key=lambda neighbour: -neighbour.loss))
    time = best.nearest(schedule.start_times[position]) if alternative is None else alternative.start
    bonds = {other: _bond(schedule, position, other, Interval(time, time)) for other in others}
    return tuple(
        Neighbour(
            other,
            bond,
            schedule.satisfactions[other],
            None if alternative is None else alternative.satisfactions[other],
        )
        for other, bond in bonds.items()
        if bond is not Bond.CHAIN
    )


def _bond(schedule: Schedule, position: int, other: int, starts: Interval) -> Bond:
    """Say how a skill, where it is now, binds another that would rather start within some interval."""
    mine, its = schedule.task.skills[position], schedule.skills[other]
    for entry in schedule.task.precedences:
        if (entry.first, entry.second) == (other, position):
            if schedule.rejected[other]:
                return Bond.ORDER
            allowed = Interval(its.done + entry.minimum_lag, its.done + entry.maximum_lag)
        elif (entry.first, entry.second) == (position, other):
            last = its.start - mine.time_until_done
            allowed = Interval(last - entry.maximum_lag, last - entry.minimum_lag)
        else:
            continue
        if starts.intersection(allowed).empty:
            return Bond.ORDER
    both_work = not (mine.needs_nobody or schedule.task.skills[other].needs_nobody)
    same = both_work and mine.agent in {None, its.agent} and not schedule.rejected[other]
    if same and its.start < starts.high + mine.duration and starts.low < its.end:
        return Bond.OVERLAP
    return Bond.CHAIN


def _appointments(task: FuzzyTask, position: int, best: Best, near: float) -> tuple[Busy, ...]:
    """Give the busy times in which a skill could have had more."""
    skill = task.skills[position]
    free = best_beside(skill, [], near)
    if free.satisfaction - best.satisfaction <= LOSS:
        return ()
    return tuple(
        busy
        for busy in task.busy
        if busy.start < free.starts.high + skill.duration
        and free.starts.low < busy.end
        and (skill.agent is None or busy.agent in {None, skill.agent})
    )
