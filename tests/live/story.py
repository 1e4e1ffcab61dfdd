"""Runs told to tests: instructions and lines in, events out, with a clock that the test holds."""

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from functools import cache
from typing import Any, TypeVar

import jsonschema

from console import ROOT
from fuzzytime.context import Context
from fuzzytime.interpreter import Interpreter, Request, SpokenWish, Wish
from fuzzytime.scheduling import THRESHOLD, Auto, Limits, Solver
from fuzzytime_cli.live import events
from fuzzytime_cli.live.clock import Clock, SimulatedClock
from fuzzytime_cli.live.dispatcher import Dispatcher
from fuzzytime_cli.live.events import Event, Happens, Planned, Start, document_of
from fuzzytime_cli.live.inbox import Arrival, Inbox, Outcome
from fuzzytime_cli.live.loop import carry_out
from fuzzytime_cli.live.messages import Listener
from fuzzytime_cli.live.outlook import Outlook
from fuzzytime_cli.live.pace import Pace
from fuzzytime_cli.live.planning import Planning, Solving
from fuzzytime_cli.live.progress import Ends, Executor, Nobody, Progress, without_limit

SIX = datetime(2026, 3, 4, 18)  # noqa: DTZ001 - the stories are of no zone
Kind = TypeVar("Kind", bound=Event)
Json = dict[str, Any]
DOCUMENT: Json = json.loads((ROOT / "cli" / "fuzzytime_cli" / "schema" / "run-1.json").read_text())
SCHEMA = jsonschema.Draft202012Validator(DOCUMENT)
OF_TYPE = {
    name: jsonschema.Draft202012Validator({"$ref": f"#/$defs/{name}", "$defs": DOCUMENT["$defs"]})
    for name in (reference["$ref"].rpartition("/")[2] for reference in DOCUMENT["oneOf"])
}


@cache
def shipped() -> Interpreter:
    return Interpreter.shipped()


@dataclass
class Hands:
    """An executor whose skills take so many seconds, and end with so much trouble; others never end."""

    inbox: Inbox
    takes: Mapping[str, float | tuple[float, str]]
    stopped: list[str] = field(default_factory=list)

    def command_for(self, start: Start) -> tuple[str, ...]:
        return ("do", start.id)

    def begin(self, start: Start) -> None:
        took = self.takes.get(start.id)
        if took is not None:
            seconds, trouble = took if isinstance(took, tuple) else (took, "")
            self.inbox.hold(start.at + seconds, Outcome(start.id, 1 if trouble else 0, trouble))

    def stop(self, identifier: str) -> None:
        self.stopped.append(identifier)


@dataclass
class NappingClock(SimulatedClock):
    """A clock of a machine that sleeps from one moment to another."""

    asleep: tuple[float, float] = (0.0, 0.0)

    def wait(self, until: float, inbox: Inbox) -> None:
        super().wait(until, inbox)
        if self.asleep[0] <= self.now < self.asleep[1]:
            self.now = self.asleep[1]


@dataclass
class Story:
    """What happened."""

    events: list[Event]
    dispatcher: Dispatcher
    hands: Hands | None = None

    def all(self, kind: type[Kind]) -> list[Kind]:
        return [event for event in self.events if isinstance(event, kind)]

    def of(self, kind: type[Kind], identifier: str) -> list[Kind]:
        return [event for event in self.all(kind) if getattr(event, "id", None) == identifier]

    def one(self, kind: type[Kind], identifier: str = "") -> Kind:
        found = self.of(kind, identifier) if identifier else self.all(kind)
        assert len(found) == 1, found
        return found[0]

    @property
    def begun(self) -> list[Start | Happens]:
        return [*self.all(Start), *self.all(Happens)]

    @property
    def starts(self) -> dict[str, float]:
        return {one.id: one.at for one in self.begun}

    @property
    def reasons(self) -> list[str]:
        return [reason for planned in self.all(Planned) for reason in planned.because]

    @property
    def documents(self) -> list[Json]:
        return [json.loads(json.dumps(document_of(event, SIX))) for event in self.events]


def wish(text: str, identifier: str = "", **given: Any) -> SpokenWish:  # noqa: ANN401 - any of a wish's fields
    duration = given.pop("duration", None)
    return SpokenWish(
        text=text,
        given=SIX,
        identifier=identifier,
        **{"hands_on": duration, "elapsed": duration, **given},
    )


def told(
    wishes: Sequence[Wish | str],
    lines: Sequence[Json] = (),
    *,
    context: Context = Context.empty,
    agents: int = 1,
    takes: Mapping[str, float | tuple[float, str]] | None = None,
    by_word: bool = False,
    limit: Callable[[float], float] = without_limit,
    clock: Clock | None = None,
    arrivals: Sequence[tuple[float, Arrival]] = (),
    solver: Solver | None = None,
) -> Story:
    """Carry out wishes in simulated time, with lines that come at theirs; check what every run must be."""
    request = Request(
        now=SIX,
        wishes=tuple(wish(one) if isinstance(one, str) else one for one in wishes),
        agents=agents,
        context=context,
    )
    inbox, pace, reasons = Inbox(), Pace(), ["the run begins"]
    listener = Listener(SIX, shipped().rulebook.signals)
    for line in lines:
        message = listener.heard(json.dumps(line).encode(), "story", 0.0)
        assert message is not None
        inbox.hold(message.comes, message)
    for at, arrival in arrivals:
        inbox.hold(at, arrival)
    hands = Hands(inbox, takes) if takes is not None else None
    executor: Executor = hands or Nobody()
    ends = Ends.BY_COMMAND if hands else Ends.BY_WORD if by_word else Ends.BY_PLAN
    dispatcher = Dispatcher(
        Outlook(Planning(request, shipped(), Solving(solver or Auto(), THRESHOLD, Limits())), pace, reasons),
        Progress(executor, ends, pace, reasons, limit),
    )
    events: list[Event] = []
    carry_out(dispatcher, clock or SimulatedClock(), inbox, listener, events.append)
    story = Story(events, dispatcher, hands)
    check(story)
    return story


def check(story: Story) -> None:
    """Every event is as its schema says, times do not run back, and no agent does two things at once.

    What is done in passing is done beside another.
    """
    busy: dict[int, str] = {}
    passing = {task.identifier for task in story.dispatcher.ledger.tasks.values() if task.in_passing}
    last = 0.0
    for event, document in zip(story.events, story.documents, strict=True):
        OF_TYPE[event.type].validate(document)
        assert event.at >= last, document
        last = event.at
        identifier = document.get("id", "")
        if event.type == "start":
            agent = document["agent"]
            if identifier not in passing:
                assert agent not in busy, f"{identifier} starts while {busy[agent]} goes on"
                busy[agent] = identifier
        if event.type in {"end", "failed", "dropped"}:
            busy = {agent: other for agent, other in busy.items() if other != identifier}
    started = [one.id for one in story.begun]
    assert len(started) == len(set(started)), "a skill starts once"


def kinds_of_events() -> dict[str, type[Event]]:
    """Give the events that a run may tell, by their types."""
    types = [value for value in vars(events).values() if isinstance(value, type)]
    return {kind.type: kind for kind in types if issubclass(kind, Event) and hasattr(kind, "type")}
