"""YAML task files: instructions with durations and priorities, direct skills, context, busy times.

Every mistake is found in one run, with file, line and column.
"""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime, tzinfo
from functools import partial
from typing import Required, TypedDict, TypeVar

from fuzzytime.context import Context, Signal, read_context_node
from fuzzytime.documents.nodes import Node, Reader, Scalar
from fuzzytime.documents.tree import Sequence as Listed
from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import MAX_HORIZON, DirectWish, Request, SpokenWish, Wish
from fuzzytime.spelling import suggestion
from fuzzytime.times import WEEK, in_zone, parse_instant, parse_zone
from fuzzytime_cli.bounds import MAX_AGENTS, MAX_INSTRUCTIONS, PRIORITIES
from fuzzytime_cli.inputs.functions import read_function
from fuzzytime_cli.inputs.source import Source
from fuzzytime_cli.inputs.surroundings import CalendarReader, Taken, read_busy

Value = TypeVar("Value")
KEYS = ("now", "zone", "agents", "horizon", "in_order", "context", "busy", "instructions", "skills")
_WISH_KEYS = ("id", "hands_on", "elapsed", "duration", "priority", "agent", "after")
_FIRST_KEY = re.compile(r"(?:[ \t]*(?:#[^\n]*)?\n|---[ \t]*\n)*(?:" + "|".join(KEYS) + r")[ \t]*:(?:\s|$)")


def is_task_file(source: Source) -> bool:
    """Say whether a text is meant as a task file: by its name, or because it starts with one of its keys."""
    named = source.path is not None and source.path.suffix.lower() in {".yaml", ".yml"}
    return named or _FIRST_KEY.match(source.text) is not None


@dataclass(frozen=True, slots=True)
class Given:
    """What is said of a plan outside its file; None where nothing is."""

    zone: tzinfo | None = None
    agents: int | None = None
    horizon: float | None = None
    in_order: bool | None = None


@dataclass(frozen=True, slots=True)
class Surroundings:
    """What is so outside a task file.

    Parameters
    ----------
    now, asked
        What is said for this call, which wins over the file; now without a zone is of the file's.
    usual
        What is so for every call, which gives way to the file.
    fallback_now
        The moment where nobody says one.
    calendar, signals
        What reads calendars, and what can be read of.
    """

    now: datetime | None
    asked: Given
    usual: Given
    fallback_now: datetime
    calendar: CalendarReader
    signals: Mapping[str, Signal]


def _first(*choices: Value | None) -> Value:
    """Give the first that is said; the last always is."""
    return next(choice for choice in choices if choice is not None)


def read_task_file(source: Source, surroundings: Surroundings) -> Request:
    """Read a task file.

    Raises
    ------
    DocumentError
        With every mistake in it.
    """
    return _TaskFile(source, surroundings).request()


class _Shared(TypedDict, total=False):
    """The fields that every kind of wish may have."""

    given: Required[datetime]
    hands_on: float | None
    elapsed: float | None
    priority: float
    agent: int
    after: tuple[str, ...]
    identifier: str


class _TaskFile:
    """One file being read: the reader that collects mistakes, and what later parts need from earlier ones."""

    def __init__(self, source: Source, surroundings: Surroundings) -> None:
        self.reader = Reader(source.name, source.text)
        self.surroundings = surroundings
        self.now = surroundings.now or surroundings.fallback_now
        self.agents = 1
        self.identifiers: dict[str, int] = {}
        self.afters: list[tuple[Scalar, str]] = []

    def request(self) -> Request:
        reader = self.reader
        root = reader.root()
        # A list alone is of what is to be done.
        alone: dict[str, Node] = {"instructions": root}
        top = alone if isinstance(root, Listed) else reader.mapping(root, "", KEYS)
        self.now = self._now(top)
        asked, usual = self.surroundings.asked, self.surroundings.usual
        agents = reader.whole(top["agents"], "agents", 1, MAX_AGENTS) if "agents" in top else None
        self.agents = max(1, _first(asked.agents, agents, usual.agents, 1))
        own = reader.duration(top["horizon"], "horizon", 1.0, MAX_HORIZON) if "horizon" in top else None
        horizon = asked.horizon or own or usual.horizon
        in_order = reader.boolean(top["in_order"], "in_order") if "in_order" in top else None
        context = self._context(top["context"]) if "context" in top else Context()
        taken = self._busy(top["busy"], horizon) if "busy" in top else Taken()
        wishes = self._wishes(root, top)
        reader.finish()
        return Request(
            now=self.now,
            wishes=wishes,
            agents=self.agents,
            context=context,
            busy=taken.busy,
            unread=taken.unread,
            horizon=horizon,
            in_order=_first(asked.in_order, in_order, usual.in_order is True),
        )

    def _context(self, node: Node) -> Context:
        return read_context_node(self.reader, node, "context", self.surroundings.signals)

    def _busy(self, node: Node, horizon: float | None) -> Taken:
        calendar = self.surroundings.calendar
        return read_busy(self.reader, node, self.now, self.agents, horizon or 0.0, calendar)

    def _check_afters(self, wishes: Sequence[Wish]) -> None:
        """Note what is to come after what is not there; of a line's skills any may be meant (s1.2)."""
        named = Request(now=self.now, wishes=tuple(wishes)).named()
        known = {wish.identifier for wish in named.wishes}
        for name, key in self.afters:
            if not {name.text, name.text.partition(".")[0]} & known:
                meant = suggestion(name.text, known)
                self.reader.mistake(name, key, f"must name the id of a skill, got {name.text!r}{meant}")

    def _now(self, top: dict[str, Node]) -> datetime:
        surroundings = self.surroundings
        own_zone = None
        if "zone" in top and isinstance(top["zone"], Scalar):
            own_zone = self.reader.read(top["zone"], "zone", parse_zone)
        zone = surroundings.asked.zone or own_zone or surroundings.usual.zone
        said = top.get("now")
        own = None
        if isinstance(said, Scalar):
            own = self.reader.read(said, "now", lambda text: parse_instant(text, zone))
        elif said is not None:
            self.reader.mistake(said, "now", "must be a date and time such as 2026-03-04T09:00")
        return in_zone(surroundings.now or own or surroundings.fallback_now, zone)

    # -- wishes ---------------------------------------------------------------------------------------------

    def _wishes(self, root: Node, top: dict[str, Node]) -> tuple[Wish, ...]:
        wishes = (
            *(self._instructions(top["instructions"]) if "instructions" in top else ()),
            *(self._skills(top["skills"]) if "skills" in top else ()),
        )
        if not self.reader.mistakes and not wishes:
            self.reader.mistake(root, "", "a task file must hold instructions or skills")
        if len(wishes) > MAX_INSTRUCTIONS:
            message = f"a plan must hold at most {MAX_INSTRUCTIONS:,} skills, got {len(wishes):,}"
            self.reader.mistake(root, "", message)
        self._check_afters(wishes)
        return wishes

    def _instructions(self, node: Node) -> list[Wish]:
        wishes: list[Wish] = []
        for index, item in enumerate(self.reader.sequence(node, "instructions")):
            key = f"instructions[{index}]"
            fields: dict[str, Node] = {"say": item}
            if not isinstance(item, Scalar):
                fields = self.reader.mapping(item, key, ("say", *_WISH_KEYS), ("say",))
            if "say" in fields:
                self._add(wishes, item, key, partial(self._spoken, key, fields))
        return wishes

    def _skills(self, node: Node) -> list[Wish]:
        wishes: list[Wish] = []
        required = ("name", "satisfaction")
        for index, item in enumerate(self.reader.sequence(node, "skills")):
            key = f"skills[{index}]"
            fields = self.reader.mapping(item, key, (*required, *_WISH_KEYS), required)
            if fields.keys() >= set(required):
                self._add(wishes, item, key, partial(self._direct, key, fields))
        return wishes

    def _add(self, wishes: list[Wish], node: Node, key: str, build: Callable[[], Wish]) -> None:
        """Build a wish; what its parts cannot see, the wish itself refuses."""
        try:
            wishes.append(build())
        except FuzzytimeError as error:
            self.reader.mistake(node, key, str(error))

    def _spoken(self, key: str, fields: dict[str, Node]) -> SpokenWish:
        say = fields["say"]
        text = self.reader.string(say, key).strip()
        if not text:
            self.reader.mistake(say, key, "an instruction must not be empty")
        return SpokenWish(text=text, line=say.line + 1, **self._shared(key, fields))

    def _direct(self, key: str, fields: dict[str, Node]) -> DirectWish:
        name = self.reader.string(fields["name"], f"{key}.name").strip()
        if not name:
            self.reader.mistake(fields["name"], f"{key}.name", "a name must not be empty")
        if not {"duration", "hands_on"} & fields.keys():
            self.reader.mistake(fields["name"], key, "a skill needs a duration or hands_on time")
        satisfaction = read_function(self.reader, fields["satisfaction"], f"{key}.satisfaction")
        line = fields["name"].line + 1
        return DirectWish(name=name, satisfaction=satisfaction, line=line, **self._shared(key, fields))

    def _shared(self, key: str, fields: dict[str, Node]) -> "_Shared":
        reader = self.reader
        durations = {
            name: reader.duration(fields[name], f"{key}.{name}", 0.0, 52 * WEEK)
            for name in ("hands_on", "elapsed", "duration")
            if name in fields
        }
        both = durations.get("duration")
        shared: _Shared = {
            "given": self.now,
            "hands_on": durations.get("hands_on", both),
            "elapsed": durations.get("elapsed", both),
        }
        if "duration" in fields and len(durations) > 1:
            reader.mistake(
                fields["duration"], f"{key}.duration", "a duration sets hands_on and elapsed: give it alone"
            )
        if "priority" in fields:
            shared["priority"] = reader.number(fields["priority"], f"{key}.priority", *PRIORITIES) or 1.0
        if "agent" in fields:
            shared["agent"] = max(1, reader.whole(fields["agent"], f"{key}.agent", 1, self.agents))
        if "after" in fields:
            shared["after"] = reader.strings(fields["after"], f"{key}.after")
            named = fields["after"].items if isinstance(fields["after"], Listed) else (fields["after"],)
            self.afters += [(node, f"{key}.after") for node in named if isinstance(node, Scalar)]
        if "id" in fields:
            shared["identifier"] = self._identifier(fields["id"], f"{key}.id")
        return shared

    def _identifier(self, node: Node, key: str) -> str:
        text = self.reader.string(node, key).strip()
        if not re.fullmatch(r"[A-Za-z_][\w.-]{0,63}", text):
            self.reader.mistake(
                node, key, f"an id must start with a letter and hold letters, digits, '_.-', got {text!r}"
            )
        elif text in self.identifiers:
            self.reader.mistake(
                node, key, f"ids must differ, got {text!r} as on line {self.identifiers[text] + 1}"
            )
        self.identifiers.setdefault(text, node.line)
        return text
