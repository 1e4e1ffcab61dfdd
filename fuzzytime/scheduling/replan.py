"""Planning on: what has started stays, what is done is dropped, the rest is scheduled anew."""

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import NEVER, Clipped, Interval
from fuzzytime.scheduling.limits import Limits
from fuzzytime.scheduling.schedule import Schedule
from fuzzytime.scheduling.secondary.objectives import DEFAULT, Objective
from fuzzytime.scheduling.solve import solve
from fuzzytime.scheduling.solver import Solver
from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask, Precedence, SpecificSkill

NOTICEABLE = 0.5
"""Seconds: a start that differs by less has not moved."""


@dataclass(frozen=True, slots=True)
class Move:
    """A skill of both schedules whose start, or whose rejection, is another.

    Parameters
    ----------
    position
        Where it stands in the new task.
    before, after
        Its starts, in seconds from the new now.
    was_rejected, is_rejected
        Whether it was, and is.
    """

    position: int
    before: float
    after: float
    was_rejected: bool
    is_rejected: bool

    @property
    def by(self) -> float:
        """Seconds by which it now starts later."""
        return self.after - self.before

    @property
    def is_noticeable(self) -> bool:
        """Whether anybody would see that the skill moved."""
        return abs(self.by) > NOTICEABLE or self.was_rejected != self.is_rejected


@dataclass(frozen=True, slots=True)
class Replan:
    """A schedule for what is left, on the timeline of a later now.

    Parameters
    ----------
    schedule
        Its task has the skills that have not started, in their order, then those that were added.
    kept
        For each skill that was there before, its position in the previous task.
    running
        Skills that have started and are not done; times from the new now.
    moves
        What moved noticeably, in the new task's order.
    """

    schedule: Schedule
    kept: tuple[int, ...]
    running: tuple[SpecificSkill, ...]
    moves: tuple[Move, ...]


def replan(
    previous: Schedule,
    now: float,
    *,
    added: Sequence[FuzzySkill] = (),
    dropped: Collection[int] = (),
    solver: Solver | None = None,
    limits: Limits | None = None,
    objectives: Sequence[Objective] = DEFAULT,
) -> Replan:
    """Schedule what is left at a later moment.

    A skill that started before now keeps its agent until its hands-on time is over; what must come after it
    waits for it. What has not started moves by ``now`` to the new timeline, and is scheduled anew from the
    start that it had. What was rejected has never started, and may find its place now.

    Parameters
    ----------
    previous
        What was planned so far, and has been kept to.
    now
        The new moment zero, in seconds of the previous timeline.
    added
        New skills; their satisfaction is over times from the new now.
    dropped
        Positions of previous skills that are no longer wanted.
    solver, limits, objectives
        As in `solve`; the threshold is the previous one.

    Raises
    ------
    FuzzytimeError
        If now is not finite or before the previous one, or a dropped position is not there.

    >>> from fuzzytime.satisfaction import Triangle
    >>> soup = FuzzySkill("stir the soup", Triangle(60, 120, 180), duration=30)
    >>> salad = FuzzySkill("dress the salad", Triangle(200, 300, 400), duration=60)
    >>> before = solve(FuzzyTask((soup, salad)))
    >>> later = replan(before, 130, added=[FuzzySkill("ring the bell", Triangle(165, 170, 175), duration=20)])
    >>> [skill.name for skill in later.running], later.schedule.start_times
    (['stir the soup'], (190.0, 170.0))
    >>> later.moves
    (Move(position=0, before=170.0, after=190.0, was_rejected=False, is_rejected=False),)
    """
    if not 0 <= now < math.inf:
        raise FuzzytimeError(f"the new now must be finite and not before the previous one, got {now}")
    for position in dropped:
        if not 0 <= position < len(previous.start_times):
            raise FuzzytimeError(
                f"a dropped skill must be one of 0 to {len(previous.start_times) - 1}, got {position}"
            )
    planned = tuple(zip(previous.start_times, previous.rejected, strict=True))
    started = [place for place, (start, rejected) in enumerate(planned) if start < now and not rejected]
    kept = tuple(place for place in range(len(planned)) if place not in dropped and place not in started)
    begun = {position: _shifted(previous.skills[position], now) for position in started}
    task = _remaining(previous.task, now, kept, begun, added)
    hints = [previous.start_times[position] - now for position in kept]
    schedule = solve(
        task,
        solver=solver,
        threshold=previous.threshold,
        limits=limits,
        objectives=objectives,
        hints=[*hints, *(math.nan for _ in added)],
    )
    moves = (
        Move(place, before, schedule.start_times[place], previous.rejected[old], schedule.rejected[place])
        for place, (old, before) in enumerate(zip(kept, hints, strict=True))
    )
    running = tuple(skill for skill in begun.values() if max(skill.done, skill.end) > 0)
    return Replan(schedule, kept, running, tuple(move for move in moves if move.is_noticeable))


def _shifted(skill: SpecificSkill, by: float) -> SpecificSkill:
    return replace(skill, start=skill.start - by, until=_earlier(skill.until, by))


def _earlier(time: float | None, by: float) -> float | None:
    return None if time is None else time - by


def _remaining(
    task: FuzzyTask,
    now: float,
    kept: Sequence[int],
    begun: dict[int, SpecificSkill],
    added: Sequence[FuzzySkill],
) -> FuzzyTask:
    """Give the task of what has not started, on the new timeline."""
    skills = []
    for position in kept:
        skill = task.skills[position]
        skill = replace(
            skill, satisfaction=skill.satisfaction.shifted(-now), until=_earlier(skill.until, now)
        )
        skill = skill.starting_near(*(time - now for time in skill.named))
        for entry in task.precedences:
            if entry.second == position and entry.first in begun:
                done = begun[entry.first].start + task.skills[entry.first].time_until_done
                skill = _released(skill, done, entry)
        skills.append(skill)
    taken = [(entry.start - now, entry.end - now, entry.what, entry.agent) for entry in task.busy]
    taken += [(one.start, one.end, one.name, one.agent) for one in begun.values()]
    busy = tuple(Busy(max(start, 0.0), end, what, agent) for start, end, what, agent in taken if end > 0)
    left = task.select(kept)
    return replace(left, skills=(*skills, *added), busy=busy)


def _released(skill: FuzzySkill, done: float, entry: Precedence) -> FuzzySkill:
    """Give a skill that waits for one that has started, and is done at a time that is known now.

    A wish whose last moment has passed is late, not lost: it may start as soon as it can.
    """
    if skill.preferred is None and entry.wished_lag is not None:
        skill = replace(skill, preferred=done + entry.wished_lag)
    earliest = done + entry.minimum_lag
    latest = max(done + entry.maximum_lag, earliest, 0.0)
    window = Interval(earliest if earliest > 0 else -math.inf, latest)
    if window.low == -math.inf and latest == math.inf:
        return skill
    if window.intersection(skill.satisfaction.support).empty:
        return replace(skill, satisfaction=NEVER)
    return replace(skill, satisfaction=Clipped(skill.satisfaction, window))
