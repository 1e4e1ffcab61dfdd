"""What a conversation knows: its kept state, the plan that it leads to, and what has started.

Nothing here reads a clock, or a keyboard, or prints: the moment is passed in, and answers are values.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from datetime import datetime

from fuzzytime.context import Context, Reading
from fuzzytime.interpreter import (
    Interpretation,
    Interpreter,
    Moved,
    Plan,
    Request,
    SpokenWish,
    scheduled,
    understood,
)
from fuzzytime.interpreter import Started as StartedSkill
from fuzzytime.scheduling import Limits, Solver
from fuzzytime.skills import Busy
from fuzzytime.times import instant_after, seconds_between
from fuzzytime_cli.personal import personal_rulebook
from fuzzytime_cli.session import Entry, KeptRating, KeptReading, SessionStore, Started, State

MAY_BE_EITHER = (10, 12)
"""The first and the last hour of the clock of 24 hours that may be one of another half of the day."""


@dataclass(frozen=True, slots=True)
class Conversation:
    """One session in its store, with what understands and schedules it.

    ``interpreter`` is the population's; where ``personal`` is set, plans follow the person's ratings too.
    ``agents`` and ``in_order`` hold as long as the conversation says nothing else, ``horizon`` always (None
    is as far as the last wish); ``given`` are readings from outside, which the session does not keep.
    """

    store: SessionStore
    name: str
    interpreter: Interpreter
    solver_of: Callable[[str], Solver]
    limits: Limits
    threshold: float
    personal: bool = True
    in_order: bool = False
    agents: int = 1
    horizon: float | None = None
    given: tuple[KeptReading, ...] = ()

    # -- the state ------------------------------------------------------------------------------------------

    @property
    def state(self) -> State:
        """Where the conversation stands."""
        return self.store.state(self.name)

    def change(self, what: str, step: Callable[[State], State]) -> State:
        """Take a step, keep it, and give the new state.

        Raises
        ------
        FuzzytimeError
            From the step, which then changes nothing.
        """
        return self.store.change(self.name, what, step)

    # -- the person ----------------------------------------------------------------------------------------

    @property
    def ratings(self) -> tuple[KeptRating, ...]:
        """The person's ratings, of all sessions."""
        return self.store.ratings()

    @property
    def understanding(self) -> Interpreter:
        """The interpreter with the person's own table on top."""
        if not self.personal:
            return self.interpreter
        return replace(self.interpreter, rulebook=personal_rulebook(self.interpreter.rulebook, self.ratings))

    # -- the plan -------------------------------------------------------------------------------------------

    def request(self, now: datetime, state: State | None = None) -> Request:
        """Give what is asked for as seen from a moment."""
        current = state if state is not None else self.state
        known = {entry.identifier for entry in current.entries}
        started = [one for one in self.store.started(self.name) if one.identifier.partition(".")[0] in known]
        agents = self.agents if current.agents is None else current.agents
        return Request(
            now=now,
            wishes=tuple(wish_of(entry) for entry in current.entries),
            agents=agents,
            horizon=self.horizon,
            in_order=self.in_order if current.in_order is None else current.in_order,
            context=context_of(self.given, now, ahead=True).merged(context_of(current.readings, now)),
            busy=tuple(
                Busy(max(0.0, seconds_between(now, kept.start)), seconds_between(now, kept.end), kept.what)
                for kept in current.busy
                if seconds_between(now, kept.end) > 0
            ),
            started=tuple(_as_seen(one, now) for one in started if one.agent <= agents),
        )

    def plan(self, now: datetime, state: State | None = None, previous: Plan | None = None) -> Plan:
        """Plan from a moment on; the search begins from an earlier plan where there is one.

        Raises
        ------
        FuzzytimeError
            If a reading is of no signal that the tables know.
        """
        current = state if state is not None else self.state
        request, interpretation = understood(self.request(now, current), self.understanding)
        if state is None and self._note_happened(interpretation, now):
            request, interpretation = understood(self.request(now, current), self.understanding)
        return scheduled(
            request,
            interpretation,
            solver=self.solver_of(current.solver),
            threshold=self.threshold,
            limits=self.limits,
            previous=previous,
        )

    def _note_happened(self, interpretation: Interpretation, now: datetime) -> bool:
        """Note what has happened since it was told, while nobody looked; say whether anything did."""
        found = False
        for one in interpretation.skills:
            moment = one.skill.preferred
            if (
                not one.skill.happens
                or moment is None
                or not seconds_between(now, one.wish.given) <= moment < 0
            ):
                continue
            start = instant_after(now, moment)
            done = instant_after(start, one.skill.time_until_done)
            begun = Started(one.identifier, one.skill.name, start, start, done, happens=True)
            found |= self.store.note_started(self.name, begun)
        return found

    def understood(self, now: datetime, state: State) -> Interpretation:
        """Give what is understood of all that is asked for, without a schedule.

        Raises
        ------
        FuzzytimeError
            As `plan`.
        """
        return understood(self.request(now, state), self.understanding)[1]

    def note_started(self, made: Plan, now: datetime) -> list[Started]:
        """Note the skills whose start has come by a moment, and give those that are news."""
        news = []
        for position, specific in enumerate(made.schedule.skills):
            start = made.instant(specific.start)
            if made.schedule.rejected[position] or seconds_between(start, now) < 0:
                continue
            started = Started(
                made.skills[position].identifier,
                specific.name,
                start,
                made.instant(specific.end),
                made.instant(specific.done),
                specific.agent,
                made.schedule.satisfactions[position],
                made.skills[position].skill.happens,
            )
            if self.store.note_started(self.name, started):
                news.append(started)
        return news

    def running(self, now: datetime) -> list[Started]:
        """Give the skills that have started and are not done at a moment."""
        known = {entry.identifier for entry in self.state.entries}
        return [
            one
            for one in self.store.started(self.name)
            if seconds_between(now, one.done) > 0 and one.identifier.partition(".")[0] in known
        ]


def wish_of(entry: Entry) -> SpokenWish:
    """Give an entry as a wish; its number names its skills."""
    return SpokenWish(
        text=entry.text,
        given=entry.given,
        identifier=entry.identifier,
        hands_on=entry.hands_on,
        elapsed=entry.elapsed,
        priority=entry.priority,
        moved=Moved(entry.moved_by, entry.moved_to) if entry.moved_by else None,
        parts=entry.parts,
    )


def context_of(readings: tuple[KeptReading, ...], now: datetime, *, ahead: bool = False) -> Context:
    """Give kept readings as a context seen from a moment.

    The future of another terminal's clock is now, unless what lies ahead is announced.
    """
    latest = math.inf if ahead else 0.0
    return Context(
        tuple(
            Reading(kept.signal, min(latest, seconds_between(now, kept.at)), kept.value, kept.unit)
            for kept in readings
        )
    )


def _as_seen(one: Started, now: datetime) -> StartedSkill:
    start, end, done = (seconds_between(now, instant) for instant in (one.start, one.end, one.done))
    return StartedSkill(identifier=one.identifier, start=start, end=end, done=done, agent=one.agent)


def answered(entry: Entry, span: tuple[int, int], instant: datetime) -> Entry:
    """Give an entry with ambiguous words of time replaced by an explicit instant."""
    return replace(entry, text=entry.text[: span[0]] + exactly(instant) + entry.text[span[1] :])


def exactly(instant: datetime) -> str:
    """Give an instant in words that mean no other: "at 06:00 on 2026-03-04", "at 10:00 am on 2026-03-04"."""
    # "06:00" is in the morning, and "10:00" may be in the evening.
    half = f" {instant:%p}".lower() if MAY_BE_EITHER[0] <= instant.hour <= MAY_BE_EITHER[1] else ""
    return f"at {instant:%H:%M}{half} on {instant:%Y-%m-%d}"
