"""The design of a study: who is asked what, on which timeline, and how answers are checked; read from YAML.

``rules/study/sucker2024.yaml`` is the paper's design, and shows the format.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.resources import rules_directory
from fuzzytime.satisfaction import Floats
from fuzzytime.study.page_texts import PageTexts, read_texts
from fuzzytime.times import DAY
from fuzzytime.yaml_nodes import Node, Reader

SHIPPED = "sucker2024"
MOST_SAMPLES = 10_000
LONGEST_TEXT = 500

_KEYS = (
    "fuzzytime-study",
    "name",
    "title",
    "source",
    "timeline",
    "default",
    "groups",
    "attention",
    "instructions",
    "demographics",
    "control",
    "texts",
)
_REQUIRED = ("fuzzytime-study", "name", "timeline", "groups", "instructions")


@dataclass(frozen=True, slots=True)
class Timeline:
    """The times over which people draw: ``samples`` of them from ``start``, one per ``step``, in seconds."""

    start: float
    end: float
    samples: int

    @property
    def step(self) -> float:
        """Seconds from one sample to the next; the last one stands a step before the end."""
        return (self.end - self.start) / self.samples

    @property
    def times(self) -> Floats:
        """The samples' times, of shape (samples,)."""
        return self.start + self.step * np.arange(self.samples, dtype=float)


@dataclass(frozen=True, slots=True, kw_only=True)
class StudyInstruction:
    """An instruction to draw for, and what it says about time: what the rulebook calls a requirement.

    ``t_spec`` is in seconds; ``word`` stands for preposition and number together ("now", "soon").
    """

    key: str
    text: str
    preposition: str
    t_spec: float
    fuzziness: str | None = None
    word: str | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Question:
    """A question about the participant: one of several answers, a whole number, or a short text."""

    key: str
    ask: str
    choices: tuple[str, ...] = ()
    whole: tuple[int, int] | None = None
    length: int = 0

    def checked(self, answer: str) -> str:
        """Give the answer without space around it; an empty one is no answer.

        Raises
        ------
        FuzzytimeError
            If it is none of the answers asked for.
        """
        bare = answer.strip()
        if not bare:
            return bare
        if self.choices and bare not in self.choices:
            raise FuzzytimeError(f"{self.key} must be one of {', '.join(self.choices)}, got {bare!r}")
        if self.whole is not None:
            low, high = self.whole
            if not (bare.isascii() and bare.isdigit() and len(bare) < 10 and low <= int(bare) <= high):
                raise FuzzytimeError(
                    f"{self.key} must be a whole number from {low} to {high}, got {bare[:40]!r}"
                )
        if self.length and len(bare) > self.length:
            raise FuzzytimeError(f"{self.key} must not be longer than {self.length} characters")
        return bare


@dataclass(frozen=True, slots=True, kw_only=True)
class ControlQuestion:
    """A direct question on a Likert scale from 1 to ``points``: a start ``late`` seconds after ``t_spec``."""

    text: str
    t_spec: float
    late: float
    points: int
    lowest: str
    highest: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Design:
    """A study's design.

    Parameters
    ----------
    name, title, source
        What it is called, for programs and for people, and where it comes from.
    timeline, default
        Where people draw, and the satisfaction before they do.
    groups
        The actors between which participants are divided, and the word for each.
    attention
        Seconds around t_spec in which a curve must be above 0 somewhere, None for no such check.
    instructions, demographics, control
        What is asked; ``control`` may be None.
    texts
        What the page says.
    yaml
        The file's text, which answers are stored with.
    """

    name: str
    title: str
    source: str
    timeline: Timeline
    default: float
    groups: Mapping[str, str]
    attention: float | None
    instructions: tuple[StudyInstruction, ...]
    demographics: tuple[Question, ...]
    control: ControlQuestion | None
    texts: PageTexts
    yaml: str = field(repr=False)

    @classmethod
    def shipped(cls, name: str = SHIPPED) -> "Design":
        """Read a design that comes with fuzzytime."""
        return cls.of_file(rules_directory() / "study" / f"{name}.yaml")

    @classmethod
    def of_file(cls, path: Path) -> "Design":
        """Read a design file.

        Raises
        ------
        OSError
            If it cannot be read.
        DocumentError
            If it breaks rules: all its mistakes, with their places.
        """
        return _read(Reader.of_file(path))

    @classmethod
    def of_text(cls, text: str, path: str = "design") -> "Design":
        """Read a design from its YAML text; ``path`` is what mistakes are said to be in.

        Raises
        ------
        DocumentError
            If it breaks rules.
        """
        return _read(Reader(path, text))

    def instruction(self, key: str) -> StudyInstruction:
        """Find an instruction by its key.

        Raises
        ------
        FuzzytimeError
            If there is none.
        """
        for instruction in self.instructions:
            if instruction.key == key:
                return instruction
        known = ", ".join(instruction.key for instruction in self.instructions)
        raise FuzzytimeError(f"an instruction must be one of {known}, got {key[:80]!r}")

    def question(self, key: str) -> Question:
        """Find a question about the participant by its key.

        Raises
        ------
        FuzzytimeError
            If there is none.
        """
        for question in self.demographics:
            if question.key == key:
                return question
        raise FuzzytimeError(f"there is no question {key[:80]!r}")


def _read(reader: Reader) -> Design:
    root = reader.mapping(reader.root(), "", _KEYS, _REQUIRED)
    if "fuzzytime-study" in root:
        reader.whole(root["fuzzytime-study"], "fuzzytime-study", 1, 1)

    def text(key: str, otherwise: str = "") -> str:
        return reader.string(root[key], key) if key in root else otherwise

    timeline = _timeline(reader, root["timeline"]) if "timeline" in root else Timeline(0.0, 1.0, 2)
    attention = None
    if "attention" in root:
        around = reader.mapping(root["attention"], "attention", ("around",), ("around",))
        if "around" in around:
            attention = reader.duration(around["around"], "attention.around", 0.0, DAY)
    control = _control(reader, root["control"], timeline) if "control" in root else None
    design = Design(
        name=text("name"),
        title=text("title", text("name")),
        source=text("source"),
        timeline=timeline,
        default=reader.number(root["default"], "default", 0.0, 1.0) if "default" in root else 0.0,
        groups=_groups(reader, root["groups"]) if "groups" in root else {},
        attention=attention,
        instructions=_instructions(reader, root["instructions"], timeline) if "instructions" in root else (),
        demographics=_demographics(reader, root["demographics"]) if "demographics" in root else (),
        control=control,
        texts=read_texts(reader, root.get("texts")),
        yaml=reader.text,
    )
    reader.finish()
    return design


def _timeline(reader: Reader, node: Node) -> Timeline:
    keys = ("start", "end", "samples")
    entries = reader.mapping(node, "timeline", keys, keys)
    if any(key not in entries for key in keys):
        return Timeline(0.0, 1.0, 2)
    start = reader.duration(entries["start"], "timeline.start", -DAY, DAY)
    end = reader.duration(entries["end"], "timeline.end", -DAY, DAY)
    if end <= start and not reader.mistakes:
        reader.mistake(
            entries["end"], "timeline.end", f"must lie after the start, got {end - start:g} s after"
        )
        end = start + 1.0
    return Timeline(
        start, end, max(2, reader.whole(entries["samples"], "timeline.samples", 10, MOST_SAMPLES))
    )


def _groups(reader: Reader, node: Node) -> Mapping[str, str]:
    entries = reader.mapping(node, "groups")
    if not entries:
        reader.mistake(node, "groups", "there must be at least one group")
    return MappingProxyType({name: reader.string(word, f"groups.{name}") for name, word in entries.items()})


def _instructions(reader: Reader, node: Node, timeline: Timeline) -> tuple[StudyInstruction, ...]:
    entries = reader.mapping(node, "instructions")
    if not entries:
        reader.mistake(node, "instructions", "there must be at least one instruction")
    found = []
    for key, entry in entries.items():
        path = f"instructions.{key}"
        parts = reader.mapping(
            entry, path, ("say", "preposition", "t", "fuzziness", "word"), ("say", "preposition", "t")
        )
        if not {"say", "preposition", "t"} <= parts.keys():
            continue

        def optional(name: str, parts: dict[str, Node] = parts, path: str = path) -> str | None:
            return reader.string(parts[name], f"{path}.{name}") if name in parts else None

        found.append(
            StudyInstruction(
                key=key,
                text=reader.string(parts["say"], f"{path}.say"),
                preposition=reader.string(parts["preposition"], f"{path}.preposition"),
                t_spec=reader.duration(parts["t"], f"{path}.t", timeline.start, timeline.end),
                fuzziness=optional("fuzziness"),
                word=optional("word"),
            )
        )
    return tuple(found)


def _demographics(reader: Reader, node: Node) -> tuple[Question, ...]:
    found = []
    for key, entry in reader.mapping(node, "demographics").items():
        path = f"demographics.{key}"
        parts = reader.mapping(entry, path, ("ask", "choices", "whole", "text"), ("ask",))
        if len(parts.keys() & {"choices", "whole", "text"}) != 1:
            reader.mistake(entry, path, "a question must have one of choices, whole and text")
            continue
        whole: tuple[int, int] | None = None
        if "whole" in parts:
            bounds = reader.sequence(parts["whole"], f"{path}.whole", 2)
            numbers = [reader.whole(bound, f"{path}.whole", 0, 10**6) for bound in bounds] or [0, 0]
            whole = (numbers[0], numbers[1])
        found.append(
            Question(
                key=key,
                ask=reader.string(parts["ask"], f"{path}.ask") if "ask" in parts else "",
                choices=reader.strings(parts["choices"], f"{path}.choices") if "choices" in parts else (),
                whole=whole,
                length=reader.whole(parts["text"], f"{path}.text", 1, LONGEST_TEXT) if "text" in parts else 0,
            )
        )
    return tuple(found)


def _control(reader: Reader, node: Node, timeline: Timeline) -> ControlQuestion | None:
    keys = ("say", "t", "late", "points", "lowest", "highest")
    parts = reader.mapping(node, "control", keys, keys)
    if any(key not in parts for key in keys):
        return None
    return ControlQuestion(
        text=reader.string(parts["say"], "control.say"),
        t_spec=reader.duration(parts["t"], "control.t", timeline.start, timeline.end),
        late=reader.duration(parts["late"], "control.late", -DAY, DAY),
        points=reader.whole(parts["points"], "control.points", 2, 11),
        lowest=reader.string(parts["lowest"], "control.lowest"),
        highest=reader.string(parts["highest"], "control.highest"),
    )
