"""What a run does at each moment: a machine of states that is told the time and the news, and tells events.

It knows no clock, no thread and no stream: the same moments and news give the same events.
"""

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import SpokenWish
from fuzzytime_cli.live import events as told
from fuzzytime_cli.live.events import Event
from fuzzytime_cli.live.hearsay import heard_about
from fuzzytime_cli.live.inbox import Arrival, Outcome, Output
from fuzzytime_cli.live.ledger import Ledger, Phase
from fuzzytime_cli.live.messages import Read, Said, Told, Unreadable
from fuzzytime_cli.live.outlook import Outlook, Waiting
from fuzzytime_cli.live.pace import JUST, Pace
from fuzzytime_cli.live.planning import Planning
from fuzzytime_cli.live.progress import Ends, Progress
from fuzzytime_cli.told_states import as_news, is_waited_for, tells_a_state

_SAME = 1e-6
"""Seconds between two moments that are one."""


@dataclass(slots=True)
class Dispatcher:
    """A run: what lies ahead, and what goes on."""

    outlook: Outlook
    progress: Progress
    _ready: float = field(default=-math.inf, init=False)

    @property
    def planning(self) -> Planning:
        """What makes the plans."""
        return self.outlook.planning

    @property
    def ledger(self) -> Ledger:
        """What was started."""
        return self.progress.ledger

    @property
    def pace(self) -> Pace:
        """What counts as being in time."""
        return self.outlook.pace

    def step(self, now: float, arrivals: Iterable[Arrival] = ()) -> Iterator[Event]:
        """Do what is to be done at a moment, and tell it as it is done; moments must not decrease."""
        yield from self.progress.pass_ends(now)
        yield from self._tell_happened(now)
        for arrival in arrivals:
            yield from self._take(arrival, now)
        yield from self.progress.tell_late(now)
        yield from self.outlook.tell_silent(now)
        yield from self._tell_missed(now)
        if not self.outlook.reasons:
            yield from self.outlook.look(now, self.ledger)
        if self.outlook.reasons:
            yield from self.outlook.replan(now, self.ledger)
        yield from self._start_due(now)

    def ready(self, now: float) -> None:
        """Note when a step is over: it takes time to plan, and nothing is missed by that."""
        self._ready = now

    def next_time(self) -> float:
        """Give the moment at which there is something to do, if nothing comes in before."""
        if self.outlook.reasons:
            return -math.inf
        starts = [one.start for one in self.outlook.waiting if not self._is_held_up(one)]
        return min((*starts, self.outlook.next_time(), self.progress.next_time()))

    @property
    def is_idle(self) -> bool:
        """Whether nothing goes on and nothing is to start."""
        going_on = self.ledger.in_phase(Phase.RUNNING, Phase.RESTING)
        return not (self.outlook.reasons or self.outlook.waiting or going_on)

    @property
    def needs_words(self) -> bool:
        """Whether something goes on that only a word can end."""
        return self.progress.ends is Ends.BY_WORD and bool(self.ledger.in_phase(Phase.RUNNING))

    def stopped(self, now: float) -> told.Stopped:
        """Tell what goes on, and what was not started."""
        waiting = (*self._not_started(), *self.outlook.rejected)
        return told.Stopped(at=now, running=self.ledger.names(Phase.RUNNING, Phase.RESTING), waiting=waiting)

    def _not_started(self) -> tuple[str, ...]:
        """Give what was still to come; of what was never planned only the wishes have names."""
        if self.planning.plan is None:
            return tuple(wish.identifier for wish in self.planning.request.wishes)
        return tuple(one.identifier for one in (*self.outlook.waiting, *self.outlook.untold.values()))

    def finished(self, now: float) -> told.Finished:
        """Tell what became of every skill."""
        done = self.ledger.in_phase(Phase.DONE, Phase.RUNNING, Phase.RESTING)
        reached = [task.satisfaction for task in done if task.satisfaction is not None]
        mean = math.prod(reached) ** (1 / len(reached)) if reached else 1.0
        return told.Finished(
            at=now,
            done=self.ledger.names(Phase.DONE),
            failed=self.ledger.names(Phase.FAILED),
            dropped=self.ledger.names(Phase.DROPPED),
            rejected=tuple(self.outlook.rejected),
            unfinished=(*self.ledger.names(Phase.RUNNING, Phase.RESTING), *self._not_started()),
            satisfaction={"geometric_mean": round(mean, 6), "least": round(min(reached, default=1.0), 6)},
        )

    # -- what comes in --------------------------------------------------------------------------------------

    def _take(self, arrival: Arrival, now: float) -> Iterator[Event]:
        match arrival:
            case Read():
                yield self.outlook.read(arrival, now)
            case Said():
                yield from self._said(arrival, now)
            case Told(identifier=identifier):
                waiting = self.outlook.find(identifier)
                if waiting is None and identifier not in self.ledger.tasks and self.outlook.reasons:
                    # What is asked for, and not planned yet, has no name yet.
                    yield from self.outlook.replan(now, self.ledger)
                    waiting = self.outlook.find(identifier)
                yield from self.progress.take_word(arrival, waiting.name if waiting else None, now)
            case Outcome():
                yield from self.progress.take_outcome(arrival, now)
            case Output(identifier, text):
                yield told.Wrote(at=now, id=identifier, text=text)
            case Unreadable(message=message, place=place):
                yield told.Trouble(at=now, message=message, place=place or None)
            case _:
                return

    def _said(self, said: Said, now: float) -> Iterator[Event]:
        if self.outlook.reasons:
            # What is asked for, and not planned yet, has no name yet.
            yield from self.outlook.replan(now, self.ledger)
        everything = (*self.outlook.waiting, *self.outlook.without_time)
        running = [(one.identifier, one.name) for one in self.ledger.in_phase(Phase.RUNNING, Phase.RESTING)]
        waiting = [(one.identifier, one.name) for one in everything]
        lexicon = self.planning.interpreter.language.lexicon
        try:
            word = heard_about(said, lexicon, running, waiting)
        except FuzzytimeError as error:
            yield told.Trouble(at=now, message=str(error), text=said.wish.text)
            return
        yield from self._instructed(self._told(said.wish), now) if word is None else self._take(word, now)

    def _told(self, wish: SpokenWish) -> SpokenWish:
        """Take what somebody tells to be so, and something waits for, as what happens now."""
        language = self.planning.interpreter.language
        waiting = (one.interpreted for one in self.outlook.without_time)
        if not is_waited_for(wish.text, waiting):
            return wish
        reading = language.read(wish.text, now=wish.given)
        tells = tells_a_state(wish.text, reading, language.lexicon)
        return replace(wish, text=as_news(wish.text)) if tells else wish

    def _instructed(self, wish: SpokenWish, now: float) -> Iterator[Event]:
        try:
            names, problems = self.planning.understands(wish, now, self.ledger.as_seen(now))
        except FuzzytimeError as error:
            yield told.Trouble(at=now, message=str(error), text=wish.text)
            return
        yield from self.outlook.troubles(problems, now)
        if names:
            yield told.Instructed(at=now, text=wish.text, ids=names)
            known = self.outlook.find(names[0]) is not None or names[0] in self.ledger.tasks
            self.outlook.reasons.append(f"{names[0]} was {'told anew' if known else 'asked for'}")

    # -- starting -------------------------------------------------------------------------------------------

    def _tell_happened(self, now: float) -> Iterator[Event]:
        """Tell what happened while nobody looked, before anything is planned from now on."""
        for waiting in list(self.outlook.waiting):
            slept = now - waiting.start > self.pace.tolerance
            if waiting.happens and slept and not self._is_held_up(waiting):
                self.outlook.waiting.remove(waiting)
                yield self._happen(waiting, now)

    def _tell_missed(self, now: float) -> Iterator[Event]:
        for waiting in self.outlook.waiting:
            if now - waiting.start <= self.pace.tolerance or self._is_held_up(waiting):
                continue
            slept = now - max(waiting.start, self._ready) > self.pace.tolerance
            if slept or self._satisfaction(waiting, now) <= self.outlook.planning.solving.threshold:
                self.outlook.reasons.append(f"the start of {waiting.identifier} was missed")
                yield told.Missed(at=now, id=waiting.identifier, name=waiting.name, planned_s=waiting.start)

    def _start_due(self, now: float) -> Iterator[Event]:
        for waiting in list(self.outlook.waiting):
            if waiting.start > now + _SAME:
                return
            late = now - waiting.start > self.pace.tolerance
            if self._is_held_up(waiting):
                if late:
                    self.outlook.reasons.append(f"{waiting.identifier} is held up")
                continue
            if late:
                self.outlook.reasons.append(f"{waiting.identifier} started late")
            self.outlook.waiting.remove(waiting)
            yield from self._start(waiting, now)
            yield from self.progress.pass_ends(now)

    def _is_held_up(self, waiting: Waiting) -> bool:
        """Say whether what should be over before a skill starts still goes on, or has not begun."""
        hands_off = waiting.interpreted.skill.needs_nobody
        running = () if hands_off else self.ledger.in_phase(Phase.RUNNING)
        if any(task.agent == waiting.agent and not task.in_passing for task in running):
            return True
        for name in waiting.interpreted.follows:
            task = self.ledger.tasks.get(name)
            # What may overlap was planned to.
            if task is not None and not task.is_over and task.planned_done <= waiting.start + JUST:
                return True
        return any(
            one.identifier in waiting.interpreted.follows and one.end <= waiting.start + JUST
            for one in self.outlook.waiting
        )

    def _satisfaction(self, waiting: Waiting, now: float) -> float:
        return float(waiting.interpreted.skill.satisfaction(now - self.planning.planned_at))

    def _start(self, waiting: Waiting, now: float) -> Iterator[Event]:
        if waiting.happens:
            yield self._happen(waiting, now)
            return
        skill = waiting.interpreted.skill
        start = told.Start(
            at=now,
            id=waiting.identifier,
            name=waiting.name,
            instruction=waiting.interpreted.words,
            planned_s=waiting.start,
            end_s=now + skill.time_at_work,
            done_s=skill.done_at(now),
            agent=waiting.agent,
            satisfaction=self._satisfaction(waiting, now),
            parameters=dict(skill.parameters),
            fuzzy_parameters=tuple(parameter.text for parameter in skill.fuzzy_parameters),
        )
        start = replace(start, command=self.progress.executor.command_for(start))
        rest = skill.done_at(now) - start.end_s
        yield from self.progress.begin(start, rest, in_passing=skill.in_passing)

    def _happen(self, waiting: Waiting, now: float) -> Event:
        """Tell what happens by itself; it does so at its time, though nobody looked then."""
        event = told.Happens(
            at=now,
            id=waiting.identifier,
            name=waiting.name,
            instruction=waiting.interpreted.words,
            planned_s=waiting.start,
            done_s=waiting.interpreted.skill.done_at(waiting.start),
            satisfaction=waiting.satisfaction,
        )
        return self.progress.happen(event)
