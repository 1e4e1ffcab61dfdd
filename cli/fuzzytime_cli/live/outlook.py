"""What lies ahead of a run: skills that wait for their start or are rejected as things stand, and sensors."""

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import IN_THE_PLAN, Interpreted, Plan, Problem, ProblemKind
from fuzzytime_cli.live import events as told
from fuzzytime_cli.live.events import Event
from fuzzytime_cli.live.ledger import Ledger
from fuzzytime_cli.live.messages import Read
from fuzzytime_cli.live.pace import JUST, Pace
from fuzzytime_cli.live.planning import Planning

NOTICEABLE = 20.0
"""Seconds by which a planned start must move, since it was last told, to be told again."""

NOTICEABLE_SHARE = 0.1
"""A start further ahead must move by so much of the time until then."""


@dataclass(frozen=True, slots=True)
class Waiting:
    """A skill of the plan that has not started; times in seconds of the run."""

    interpreted: Interpreted
    position: int
    start: float
    end: float
    agent: int
    satisfaction: float
    signals: frozenset[str]

    @property
    def identifier(self) -> str:
        """The skill's identifier."""
        return self.interpreted.identifier

    @property
    def name(self) -> str:
        """What is done."""
        return self.interpreted.skill.name

    @property
    def happens(self) -> bool:
        """Whether it happens by itself, so that there is nothing to do."""
        return self.interpreted.skill.happens

    @property
    def awaits_readings(self) -> bool:
        """Whether its time is a matter of what is read: "when the pan is hot"."""
        return any(
            requirement.condition is not None
            or (requirement.anchor is not None and requirement.anchor.target is None)
            for requirement in self.interpreted.requirements
        )

    def upcoming(self) -> told.Upcoming:
        """Give it as events tell it."""
        return told.Upcoming(
            id=self.identifier,
            name=self.name,
            start_s=self.start,
            end_s=self.end,
            agent=self.agent,
            satisfaction=self.satisfaction,
        )


@dataclass(slots=True)
class Outlook:
    """The current plan, seen from the run, and what may change it.

    ``waiting`` is what waits for its time, ``untold`` what has none as nobody has told yet what it waits for.
    ``reasons`` are those for which a new plan is needed; `Progress` adds to them as well.
    """

    planning: Planning
    pace: Pace
    reasons: list[str]
    waiting: list[Waiting] = field(default_factory=list)
    rejected: dict[str, Waiting] = field(default_factory=dict)
    untold: dict[str, Waiting] = field(default_factory=dict)
    announced: dict[str, float | None] = field(default_factory=dict)
    silent: set[str] = field(default_factory=set)
    told: set[Problem] = field(default_factory=set)
    look_at: float = math.inf
    looked: float = -math.inf

    def next_time(self) -> float:
        """Give when to look at readings, or to miss one."""
        return min((self.look_at, *(self._falls_silent(name) for name in self.relevant - self.silent)))

    @property
    def relevant(self) -> frozenset[str]:
        """The signals that skills depend on which have not started, read or not."""
        if self.planning.plan is None:
            return self.planning.relevant_at_first
        everything = (*self.waiting, *self.without_time)
        return frozenset[str]().union(*(one.signals for one in everything))

    @property
    def without_time(self) -> tuple[Waiting, ...]:
        """What has no time as things stand."""
        return (*self.rejected.values(), *self.untold.values())

    @property
    def has_hope(self) -> bool:
        """Whether something that has no time now depends on what may still be told or read."""
        return bool(self.untold) or any(one.awaits_readings for one in self.rejected.values())

    def find(self, identifier: str) -> Waiting | None:
        """Find a skill that has not started."""
        everything = (*self.waiting, *self.without_time)
        return next((one for one in everything if one.identifier == identifier), None)

    # -- readings -------------------------------------------------------------------------------------------

    def read(self, message: Read, now: float) -> Event:
        """Take a reading."""
        reading = message.reading
        self.planning.note(reading)
        matters = reading.signal in self.relevant
        if matters:
            self.look_at = min(self.look_at, max(now, self.looked + self.pace.patience))
            if now < self._falls_silent(reading.signal):
                self.silent.discard(reading.signal)
        return told.ContextRead(
            at=now,
            signal=reading.signal,
            value=reading.value,
            unit=reading.unit,
            read_s=reading.at,
            matters=matters,
        )

    def look(self, now: float, ledger: Ledger) -> Iterator[Event]:
        """See, where it is time to, whether what was read since the plan was made means something else."""
        if now < self.look_at:
            return
        self.look_at, self.looked = math.inf, now
        try:
            changed = self.planning.changed(now, ledger.as_seen(now))
            if changed:
                self.reasons.append(f"readings changed the time for {', '.join(changed)}")
        except FuzzytimeError as error:
            yield told.Trouble(at=now, message=str(error))

    def tell_silent(self, now: float) -> Iterator[Event]:
        """Tell which sensors that matter were read too long ago."""
        for name in sorted(self.relevant - self.silent):
            if now < self._falls_silent(name):
                continue
            self.silent.add(name)
            self.reasons.append(f"{name} is silent")
            yield told.Silent(
                at=now,
                signal=name,
                read_s=self.planning.last_read(name),
                max_age_s=self.planning.signal(name).max_age,
            )

    def _falls_silent(self, name: str) -> float:
        last = self.planning.last_read(name)
        if last == -math.inf or self.planning.signal(name).event:
            return math.inf  # one that never spoke is told of where a skill is rejected for it
        return last + self.planning.signal(name).max_age + JUST

    # -- problems -------------------------------------------------------------------------------------------

    def troubles(self, problems: Iterable[Problem], now: float) -> Iterator[Event]:
        """Tell problems of understanding, each once; what is rejected is told by an event of its own."""
        for problem in problems:
            if problem.kind in IN_THE_PLAN or problem in self.told:
                continue
            self.told.add(problem)
            place = f"line {problem.line}" if problem.line is not None else None
            yield told.Trouble(
                at=now, message=problem.message, place=place, text=problem.text or None, span=problem.span
            )

    # -- the plan -------------------------------------------------------------------------------------------

    def replan(self, now: float, ledger: Ledger) -> Iterator[Event]:
        """Plan from a moment on, and tell what has changed."""
        because = tuple(dict.fromkeys(self.reasons))
        self.reasons.clear()
        self.look_at, self.looked = math.inf, now
        try:
            plan = self.planning.make(now, ledger.as_seen(now))
        except FuzzytimeError as error:
            yield told.Trouble(at=now, message=str(error))
            return
        before = (*self.waiting, *self.without_time)
        self._adopt(plan, now)
        yield from self.troubles(plan.problems, now)
        yield told.Planned(
            at=now,
            because=because,
            status=plan.schedule.certificate.status.value,
            skills=tuple(one.upcoming() for one in self.waiting),
            plan=plan,
        )
        yield from self._changes(plan, now)
        yield from self._gone(before, ledger, now)

    def _gone(self, before: Iterable[Waiting], ledger: Ledger, now: float) -> Iterator[Event]:
        """Tell what will not happen after all: it has not started, and is not planned any more."""
        for one in before:
            if self.find(one.identifier) is None and one.identifier not in ledger.tasks:
                self.announced.pop(one.identifier, None)
                reason = "it was told not to happen"
                yield told.Dropped(at=now, id=one.identifier, name=one.name, reason=reason)

    def _adopt(self, plan: Plan, now: float) -> None:
        schedule = plan.schedule
        everything = [
            Waiting(
                interpreted,
                position,
                now + specific.start,
                now + specific.worked_until,
                specific.agent,
                schedule.satisfactions[position],
                self.planning.signals_of(interpreted),
            )
            for position, (interpreted, specific) in enumerate(zip(plan.skills, schedule.skills, strict=True))
        ]
        self.untold = {one.identifier: self._untold(one, len(everything)) for one in plan.waiting}
        self.rejected = {one.identifier: one for one in everything if schedule.rejected[one.position]}
        kept = [one for one in everything if one.identifier not in self.rejected]
        while lost := [one for one in kept if self._missing(one)]:
            self.rejected |= {one.identifier: one for one in lost}
            kept = [one for one in kept if one.identifier not in self.rejected]
        self.waiting = sorted(kept, key=lambda one: (one.start, one.position))

    def _untold(self, one: Interpreted, position: int) -> Waiting:
        never = math.inf
        return Waiting(one, position, never, never, 1, 0.0, self.planning.signals_of(one))

    def _missing(self, waiting: Waiting) -> str:
        """Give what a skill asked to come after and is rejected itself; empty where nothing is."""
        return next((name for name in waiting.interpreted.follows if name in self.rejected), "")

    def _changes(self, plan: Plan, now: float) -> Iterator[Event]:
        """Tell which starts moved since they were last told, and which skills lost or won their place."""
        lost = [problem for problem in plan.problems if problem.kind is ProblemKind.REJECTED]
        reasons = {problem.identifier: problem.message for problem in lost}
        for one in sorted((*self.waiting, *self.without_time), key=lambda one: one.position):
            known = one.identifier in self.announced
            before = self.announced.get(one.identifier)
            after = one.start if one in self.waiting else None
            if known and not _is_news(before, after, now):
                continue
            self.announced[one.identifier] = after
            if one.identifier in self.untold:
                reason = one.interpreted.reason
                yield told.Waits(at=now, id=one.identifier, name=one.name, reason=reason)
            elif after is None:
                reason = reasons.get(one.identifier, "").removeprefix(f"{one.name}: ")
                if not reason:
                    reason = f"must come after {self._missing(one)}, which has no time"
                yield told.Rejected(at=now, id=one.identifier, name=one.name, reason=reason)
            elif known:
                yield told.Moved(at=now, id=one.identifier, name=one.name, before_s=before, after_s=after)


def _is_news(before: float | None, after: float | None, now: float) -> bool:
    if before is None or after is None:
        return before is not after
    return abs(after - before) >= max(NOTICEABLE, NOTICEABLE_SHARE * (min(before, after) - now))
