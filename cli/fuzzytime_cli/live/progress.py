"""What goes on in a run: skills from their start to their end, in time, late, failed, or said to be done."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Protocol

from fuzzytime.times import format_duration
from fuzzytime_cli.live import events as told
from fuzzytime_cli.live.events import Event
from fuzzytime_cli.live.inbox import Outcome
from fuzzytime_cli.live.ledger import Ledger, Phase, Task
from fuzzytime_cli.live.messages import Told, Word
from fuzzytime_cli.live.pace import JUST, Pace


class Ends(StrEnum):
    """How the end of a skill is known."""

    BY_PLAN = "plan"
    BY_COMMAND = "command"
    BY_WORD = "word"


class Executor(Protocol):
    """Whoever does the skills."""

    def command_for(self, start: told.Start) -> tuple[str, ...] | None:
        """Give the command that a start runs, None where there is none."""
        ...

    def begin(self, start: told.Start) -> None:
        """Do what starts; its outcome comes as an arrival."""
        ...

    def stop(self, identifier: str) -> None:
        """End what was begun, whether it wants to or not."""
        ...


class Nobody:
    """An executor that does nothing: events tell others what to do."""

    def command_for(self, start: told.Start) -> None:
        """Give no command."""

    def begin(self, start: told.Start) -> None:
        """Do nothing."""

    def stop(self, identifier: str) -> None:
        """Do nothing."""


def without_limit(planned: float) -> float:
    """Let a command take as long as it wants."""
    del planned
    return math.inf


@dataclass(slots=True)
class Progress:
    """The ledger of what was started, kept up to date.

    ``limit`` gives the seconds after which a command that was planned to take some seconds is killed.
    ``reasons`` are those for which a new plan is needed; `Outlook` adds to them as well.
    """

    executor: Executor
    ends: Ends
    pace: Pace
    reasons: list[str]
    limit: Callable[[float], float] = without_limit
    ledger: Ledger = field(default_factory=Ledger)

    def begin(self, start: told.Start, rest: float, *, in_passing: bool = False) -> Iterator[Event]:
        """Start a skill; ``rest`` are the seconds from its end until its result is there."""
        self.ledger.keep(
            Task(
                identifier=start.id,
                name=start.name,
                start=start.at,
                end=start.end_s,
                planned=start.end_s - start.at,
                rest=rest,
                agent=start.agent,
                satisfaction=start.satisfaction,
                in_passing=in_passing,
            )
        )
        yield start
        self.executor.begin(start)

    def happen(self, event: told.Happens) -> Event:
        """Take what happens by itself: nobody is at it, so that only time, or a word, ends it."""
        self.ledger.keep(
            Task(
                identifier=event.id,
                name=event.name,
                start=event.planned_s,
                end=event.planned_s,
                planned=0.0,
                rest=event.done_s - event.planned_s,
                satisfaction=event.satisfaction,
                phase=Phase.RESTING,
            )
        )
        return event

    def next_time(self) -> float:
        """Give when something that goes on should end, or is too late."""
        return min(map(self._next_of, self.ledger.in_phase(Phase.RUNNING, Phase.RESTING)), default=math.inf)

    def _next_of(self, task: Task) -> float:
        if task.phase is Phase.RESTING:
            return task.done
        if self.ends is Ends.BY_PLAN:
            return task.end
        return min(task.end + self.pace.tolerance + JUST, self._limit_of(task))

    def _limit_of(self, task: Task) -> float:
        return task.start + self.limit(task.planned) if self.ends is Ends.BY_COMMAND else math.inf

    # -- what time brings -----------------------------------------------------------------------------------

    def pass_ends(self, now: float) -> Iterator[Event]:
        """Tell, by time, what has ended and what is done by a moment."""
        moments = [
            (self._next_of(task), task.identifier) for task in self.ledger.tasks.values() if not task.is_over
        ]
        for _, identifier in sorted(moment for moment in moments if moment[0] <= now):
            task = self.ledger.tasks[identifier]
            if task.phase is Phase.RUNNING and self.ends is Ends.BY_PLAN:
                yield from self._end(task, task.end, now)
            elif task.phase is Phase.RESTING:
                yield self._complete(task, task.done, now)

    def _end(self, task: Task, at: float, now: float) -> Iterator[Event]:
        ended = self.ledger.keep(task.ended(at))
        yield told.End(at=now, id=task.identifier, name=task.name, agent=task.agent)
        if ended.done <= now:
            yield self._complete(ended, ended.done, now)

    def _complete(self, task: Task, at: float, now: float) -> Event:
        self.ledger.keep(task.completed(at))
        return told.Done(at=now, id=task.identifier, name=task.name)

    def tell_late(self, now: float) -> Iterator[Event]:
        """Tell what takes longer than planned; kill what takes longer than it may."""
        if self.ends is Ends.BY_PLAN:
            return
        for task in self.ledger.in_phase(Phase.RUNNING):
            if now >= self._limit_of(task):
                self.executor.stop(task.identifier)
                limit = format_duration(self.limit(task.planned))
                yield self._fail(task, f"did not end within {limit} and was killed", now)
            elif now > task.end + self.pace.tolerance:
                delayed = self.ledger.keep(task.delayed(now))
                self.reasons.append(f"{task.identifier} is late")
                planned, expected = task.start + task.planned, delayed.end
                yield told.Late(
                    at=now, id=task.identifier, name=task.name, planned_s=planned, expected_s=expected
                )

    def _fail(self, task: Task, reason: str, now: float, exit_code: int | None = None) -> Event:
        self.ledger.keep(task.lost(now, Phase.FAILED))
        self.reasons.append(f"{task.identifier} failed")
        return told.Failed(at=now, id=task.identifier, name=task.name, reason=reason, exit_code=exit_code)

    # -- what others tell -----------------------------------------------------------------------------------

    def take_outcome(self, outcome: Outcome, now: float) -> Iterator[Event]:
        """Take the end of a command."""
        task = self.ledger.tasks.get(outcome.identifier)
        if task is None or task.phase is not Phase.RUNNING:
            return  # killed, or said to be done before
        if outcome.trouble:
            yield self._fail(task, outcome.trouble, now, outcome.exit_code)
            return
        if abs(now - task.end) > self.pace.tolerance:
            self.reasons.append(f"{task.identifier} ended {'later' if now > task.end else 'sooner'}")
        yield from self._end(task, now, now)

    def take_word(self, message: Told, unstarted: str | None, now: float) -> Iterator[Event]:
        """Take somebody's word about a skill; ``unstarted`` is its name where it has not started."""
        identifier = message.identifier
        task = self.ledger.tasks.get(identifier)
        if task is None and unstarted is not None:
            # It is begun and over at one moment, so that nobody plans it any more.
            at = min(message.at, now)
            task = Task(identifier=identifier, name=unstarted, start=at, end=at, planned=0.0, rest=0.0)
        elif task is None or task.is_over:
            what = "there is no such skill" if task is None else f"it is {task.phase.value} already"
            yield told.Trouble(at=now, message=f"{message.word.value} {identifier}: {what}")
            return
        elif task.phase is Phase.RUNNING and self.ends is Ends.BY_COMMAND:
            self.executor.stop(identifier)
        at = min(max(message.at, task.start), now)
        match message.word:
            case Word.DONE:
                if task.phase is Phase.RUNNING and task.satisfaction is not None:
                    yield told.End(at=now, id=identifier, name=task.name, agent=task.agent)
                self.reasons.append(f"{identifier} is done")
                yield self._complete(task, at, now)
            case Word.FAILED:
                yield self._fail(task, message.reason or "somebody said so", now)
            case Word.DROP:
                self.ledger.keep(task.lost(at, Phase.DROPPED))
                self.reasons.append(f"{identifier} was dropped")
                yield told.Dropped(at=now, id=identifier, name=task.name, reason=message.reason)
