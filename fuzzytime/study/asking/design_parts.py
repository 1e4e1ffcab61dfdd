"""Reading the parts of a design's YAML."""

import re
from collections.abc import Mapping
from types import MappingProxyType

from fuzzytime.documents.nodes import Node, Reader
from fuzzytime.study.asking.placeholders import check_places
from fuzzytime.study.asking.questions import ControlQuestion, Question, StudyInstruction, Timeline
from fuzzytime.times import DAY

MOST_SAMPLES = 10_000
LONGEST_TEXT = 500
LONGEST_KEY = 60

_KEY = re.compile(r"\w[\w.-]*")


def named(reader: Reader, node: Node, key: str) -> dict[str, Node]:
    """Read a mapping whose keys become names of files, columns and fields: words, hyphens and full stops."""
    names = reader.keys(node)
    entries = reader.mapping(node, key)
    rule = f"a key must be at most {LONGEST_KEY} letters, digits, hyphens, full stops"
    for name in entries:
        if len(name) > LONGEST_KEY or not _KEY.fullmatch(name):
            reader.mistake(names[name], key, f"{rule}, got {name[:LONGEST_KEY]!r}")
    return entries


def wording(reader: Reader, node: Node, key: str) -> str:
    """Read a text for participants, in which ``{actor}`` may stand for the word of their group."""
    text = reader.phrase(node, key)
    check_places(reader, node, key, text, ("actor",))
    return text


def read_timeline(reader: Reader, node: Node) -> Timeline:
    """Read the timeline."""
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


def read_groups(reader: Reader, node: Node) -> Mapping[str, str]:
    """Read the groups and the word for each."""
    entries = reader.mapping(node, "groups")
    if not entries:
        reader.mistake(node, "groups", "there must be at least one group")
    for key, name in reader.keys(node).items():
        if not key.strip():
            reader.mistake(name, "groups", "a group must have a name")
    return MappingProxyType({name: reader.phrase(word, f"groups.{name}") for name, word in entries.items()})


def read_instructions(reader: Reader, node: Node, timeline: Timeline) -> tuple[StudyInstruction, ...]:
    """Read the instructions, in their order."""
    entries = named(reader, node, "instructions")
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
        found.append(
            StudyInstruction(
                key=key,
                text=wording(reader, parts["say"], f"{path}.say"),
                preposition=reader.phrase(parts["preposition"], f"{path}.preposition"),
                t_spec=reader.duration(parts["t"], f"{path}.t", timeline.start, timeline.end),
                fuzziness=_phrase(reader, parts, path, "fuzziness"),
                word=_phrase(reader, parts, path, "word"),
            )
        )
    return tuple(found)


def _phrase(reader: Reader, parts: Mapping[str, Node], path: str, name: str) -> str | None:
    """Read a part that may be left out."""
    return reader.phrase(parts[name], f"{path}.{name}") if name in parts else None


def read_demographics(reader: Reader, node: Node) -> tuple[Question, ...]:
    """Read the questions about the participant."""
    found = []
    for key, entry in named(reader, node, "demographics").items():
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
            if whole[1] < whole[0]:
                reader.mistake(parts["whole"], f"{path}.whole", f"must not decrease, got {whole}")
        choices = reader.strings(parts["choices"], f"{path}.choices") if "choices" in parts else ()
        if "choices" in parts and len({*choices}) < max(len(choices), 2):
            reader.mistake(parts["choices"], f"{path}.choices", "must be two choices or more, which differ")
        found.append(
            Question(
                key=key,
                ask=reader.phrase(parts["ask"], f"{path}.ask") if "ask" in parts else "",
                choices=choices,
                whole=whole,
                length=reader.whole(parts["text"], f"{path}.text", 1, LONGEST_TEXT) if "text" in parts else 0,
            )
        )
    return tuple(found)


def read_control(reader: Reader, node: Node, timeline: Timeline) -> ControlQuestion | None:
    """Read the control question; None where it is incomplete."""
    keys = ("say", "t", "late", "points", "lowest", "highest")
    parts = reader.mapping(node, "control", keys, keys)
    if any(key not in parts for key in keys):
        return None
    return ControlQuestion(
        text=wording(reader, parts["say"], "control.say"),
        t_spec=reader.duration(parts["t"], "control.t", timeline.start, timeline.end),
        late=reader.duration(parts["late"], "control.late", -DAY, DAY),
        points=reader.whole(parts["points"], "control.points", 2, 11),
        lowest=reader.string(parts["lowest"], "control.lowest"),
        highest=reader.string(parts["highest"], "control.highest"),
    )
