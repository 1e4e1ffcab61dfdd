"""The plans of a run: made of everything known at a moment, and made anew only when something has changed."""

import math
from collections import deque
from dataclasses import dataclass, replace
from datetime import datetime

import numpy as np

from fuzzytime.context import Context, Reading, Signal
from fuzzytime.interpreter import (
    Interpretation,
    Interpreted,
    Interpreter,
    Plan,
    Problem,
    ProblemKind,
    Request,
    SpokenWish,
    Started,
    Wish,
    scheduled,
    understood,
)
from fuzzytime.scheduling import Limits, Solver
from fuzzytime.skills import Busy
from fuzzytime.times import instant_after

MOST_READINGS = 5_000
"""Readings of one signal that are remembered."""

CHANGE = 0.05
"""A wish has changed when its satisfaction differs by more than this at some start time."""

_POINTS = 256


@dataclass(frozen=True, slots=True)
class Solving:
    """How schedules are found."""

    solver: Solver
    threshold: float
    limits: Limits


class Planning:
    """What is asked for and what was read, on the timeline of the run; and the plan that it leads to."""

    def __init__(self, request: Request, interpreter: Interpreter, solving: Solving) -> None:
        self.interpreter, self.solving = interpreter, solving
        self.origin: datetime = request.now
        self.request = replace(request.named(), awaits_readings=True)
        skills = interpreter.interpret(self.request).skills
        self.relevant_at_first = frozenset[str]().union(*map(self.signals_of, skills))
        self.readings: dict[str, deque[Reading]] = {}
        self._last_read: dict[str, float] = {}
        for reading in request.context.readings:
            self.note(reading)
        self.plan: Plan | None = None
        self.planned_at = 0.0

    def note(self, reading: Reading) -> None:
        """Remember a reading, by a time of the run."""
        self.readings.setdefault(reading.signal, deque(maxlen=MOST_READINGS)).append(reading)
        self._last_read[reading.signal] = max(self.last_read(reading.signal), reading.at)

    def signal(self, name: str) -> Signal:
        """Give what is declared of a signal."""
        return self.interpreter.rulebook.signals[name]

    def last_read(self, signal: str) -> float:
        """Give when a signal was last read; −inf where it never was."""
        return self._last_read.get(signal, -math.inf)

    def seen_from(self, now: float, started: tuple[Started, ...], *more: Wish) -> Request:
        """Give the request as it is at a moment of the run."""
        known = [reading.shifted(-now) for kept in self.readings.values() for reading in kept]
        return replace(
            self.request,
            now=instant_after(self.origin, now),
            wishes=(*self.request.wishes, *more),
            context=Context(tuple(known)),
            busy=tuple(
                Busy(max(0.0, busy.start - now), busy.end - now, busy.what, busy.agent)
                for busy in self.request.busy
                if busy.end > now
            ),
            started=started,
        )

    def make(self, now: float, started: tuple[Started, ...]) -> Plan:
        """Plan from a moment of the run on.

        Raises
        ------
        FuzzytimeError
            If what is asked for contradicts itself.
        """
        request, interpretation = understood(self.seen_from(now, started), self.interpreter)
        self.plan = scheduled(
            request,
            interpretation,
            solver=self.solving.solver,
            threshold=self.solving.threshold,
            limits=self.solving.limits,
            previous=self.plan,
        )
        self.planned_at = now
        return self.plan

    def signals_of(self, interpreted: Interpreted) -> frozenset[str]:
        """Give the signals that a skill's wishes depend on, read or not."""
        operation = interpreted.instruction.operation if interpreted.instruction is not None else None
        verb = operation.going if operation is not None else None
        rulebook = self.interpreter.rulebook
        found = [rulebook.signals_for(requirement, verb) for requirement in interpreted.requirements]
        return frozenset[str]().union(*found)

    def changed(self, now: float, started: tuple[Started, ...]) -> tuple[str, ...]:
        """Give the skills whose wishes, by what is known now, are others than those that were planned.

        Raises
        ------
        FuzzytimeError
            As `make`.
        """
        if self.plan is None:
            return ()
        _, interpretation = understood(self.seen_from(now, started), self.interpreter)
        return differing(self.plan.interpretation, interpretation, now - self.planned_at)

    def understands(
        self, wish: SpokenWish, now: float, started: tuple[Started, ...]
    ) -> tuple[tuple[str, ...], list[Problem]]:
        """Keep an instruction that is understood; give the skills that it makes or changes, and its problems.

        Raises
        ------
        FuzzytimeError
            If it refers to an identifier that there is none of.
        """
        if wish.identifier in {other.identifier for other in self.request.wishes}:
            message = f"ids must differ, got {wish.identifier!r} again"
            return (), [_problem(message, wish)]
        if wish.agent is not None and wish.agent > self.request.agents:
            message = f"an agent must be one of 1 to {self.request.agents}, got {wish.agent}"
            return (), [_problem(message, wish)]
        together = replace(self.request, wishes=(*self.request.wishes, wish)).named()
        wish = replace(wish, identifier=together.wishes[-1].identifier)
        _, interpretation = understood(self.seen_from(now, started, wish), self.interpreter)
        own = tuple(
            one.identifier for one in interpretation.everything if one.wish.identifier == wish.identifier
        )
        if not own:
            # "The guests are late" moves what was said before, "it takes an hour" lengthens it.
            _, before = understood(self.seen_from(now, started), self.interpreter)
            own = _changed(before, interpretation)
        if own:
            self.request = replace(self.request, wishes=(*self.request.wishes, wish))
        return own, [problem for problem in interpretation.problems if problem.text == wish.text]


def _changed(before: Interpretation, after: Interpretation) -> tuple[str, ...]:
    """Give the skills that a wish which asks for none tells of."""
    skills = {one.identifier: one.skill for one in after.everything}
    return tuple(one.identifier for one in before.everything if skills.get(one.identifier) != one.skill)


def differing(before: Interpretation, after: Interpretation, passed: float) -> tuple[str, ...]:
    """Give the skills that a later interpretation wishes otherwise, beyond the time that has passed."""
    earlier = {interpreted.identifier: interpreted for interpreted in before.everything}
    # What is open is closed at the horizon, which is no wish of anybody's.
    until = min(after.horizon, before.horizon - passed)
    return tuple(
        interpreted.identifier
        for interpreted in after.everything
        if interpreted.identifier not in earlier
        or _differs(earlier[interpreted.identifier], interpreted, passed, until)
    )


def _differs(before: Interpreted, after: Interpreted, passed: float, until: float) -> bool:
    if bool(before.reason) != bool(after.reason):
        return True
    was, now = before.skill.satisfaction, after.skill.satisfaction
    kinks = [*now.kinks, *(kink - passed for kink in was.kinks)]
    inside = [time for time in kinks if 0 <= time < until]
    times = np.concatenate([np.linspace(0.0, max(until, 0.0), _POINTS, endpoint=False), inside])
    return bool(np.max(np.abs(was(times + passed) - now(times))) > CHANGE)


def _problem(message: str, wish: SpokenWish) -> Problem:
    return Problem(kind=ProblemKind.UNREADABLE, message=message, text=wish.text)
