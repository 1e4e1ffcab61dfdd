"""Lines of text, or of JSON, to what was understood of them: what `fuzzytime parse` answers."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from datetime import datetime, tzinfo
from itertools import islice
from typing import Any, BinaryIO

from fuzzytime.errors import FuzzytimeError, InstructionError
from fuzzytime.language import NAMED, Language, Reading, RemarkKind, answer
from fuzzytime.spelling import nearest
from fuzzytime.times import format_duration, parse_instant
from fuzzytime_cli.faults import underlined

BATCH = 256
"""Lines read together: the model is faster on many, and memory stays bounded."""

MAX_LINE = 1 << 20
"""Bytes of a line; what is longer is refused, and not kept."""

KEYS = ("text", "now")
"""What is read of an object."""

LEFT = frozenset({RemarkKind.NOT_UNDERSTOOD, RemarkKind.UNRESOLVED})
"""Remarks on words that mean something which is not in the answer."""

Answer = dict[str, Any]


@dataclass(frozen=True, slots=True)
class Asked:
    """A line: its text, its moment, what is wrong with it if anything, and keys that nothing is read of."""

    text: str
    now: datetime
    error: str = ""
    ignored: tuple[str, ...] = ()


def lines_of(stream: BinaryIO) -> Iterator[bytes]:
    """Give a stream's lines without their ends, each at most one byte longer than `MAX_LINE`."""
    while line := stream.readline(MAX_LINE + 1):
        rest = line
        while not rest.endswith(b"\n") and len(rest) > MAX_LINE:
            rest = stream.readline(MAX_LINE + 1)
        yield line.rstrip(b"\r\n") if len(line) <= MAX_LINE or line.endswith(b"\n") else line


def asked_of(line: bytes, now: datetime, *, objects: bool, zone: tzinfo | None = None) -> Asked:
    """Read a line as text; with ``objects``, one that starts with a brace as ``{"text": …, "now": …}``.

    A now of its own without a zone is of the given one; where none is given, it stays without.
    """
    if len(line) > MAX_LINE:
        return Asked(
            line[:200].decode("utf-8", "replace") + "…", now, f"a line must not exceed {MAX_LINE:,} bytes"
        )
    try:
        text = line.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        rule = f"text must be UTF-8, got byte 0x{line[error.start]:02x} at column {error.start + 1}"
        return Asked(line.decode("utf-8", "replace"), now, rule)
    if not (objects and text.lstrip().startswith("{")):
        return Asked(text, now)
    from fuzzytime.context import parse_fields

    try:
        said = parse_fields(text, longest=MAX_LINE)
    except FuzzytimeError as error:
        return Asked(text, now, str(error))
    others = tuple(name for name in said if name not in KEYS)
    missing = [key for key in KEYS if key not in said]
    for name in others:
        meant = nearest(name, missing)
        if meant is not None:
            return Asked(text, now, f"unknown key {name!r} (did you mean {meant!r}?)")
    words, moment = said.get("text"), said.get("now")
    if not isinstance(words, str) or not (moment is None or isinstance(moment, str)):
        return Asked(text, now, 'an object must have a "text", and may have a "now", both texts')
    try:
        return Asked(words, parse_instant(moment, zone) if moment else now, ignored=others)
    except FuzzytimeError as error:
        return Asked(words, now, str(error))


@dataclass(frozen=True, slots=True)
class Reply:
    """What is answered to a text: for programs, and what its operations are called, for people."""

    answer: Answer
    names: tuple[str, ...] = ()


def answers(asked: Iterable[Asked], language: Language) -> Iterator[Reply]:
    """Answer lines in their order; one that cannot be read gets an ``error``, and the rest go on."""
    stream = iter(asked)
    while batch := list(islice(stream, BATCH)):
        good = [(line.text, line.now) for line in batch if not line.error]
        replies = iter(_together(good, language))
        for line in batch:
            if line.error:
                yield _failed(line.text, line.now, line.error)
                continue
            reply = next(replies)
            if line.ignored:
                reply = replace(reply, answer={**reply.answer, "ignored": list(line.ignored)})
            yield reply


def _together(asked: list[tuple[str, datetime]], language: Language) -> list[Reply]:
    """Read texts together; where one of them is refused, one by one."""
    try:
        return [_reply(reading) for reading in language.read_independent(asked)]
    except InstructionError:
        return [_alone(text, now, language) for text, now in asked]


def _alone(text: str, now: datetime, language: Language) -> Reply:
    try:
        return _reply(language.read(text, now=now))
    except InstructionError as error:
        return _failed(text, now, error.message)


def _reply(reading: Reading) -> Reply:
    operations = (instruction.operation for instruction in reading.instructions)
    return Reply(answer(reading), tuple("" if one is None else one.name for one in operations))


def _failed(text: str, now: datetime, error: str) -> Reply:
    return Reply(
        {
            "text": text,
            "now": now.isoformat(),
            "operation": None,
            "operations": [],
            "requirements": [],
            "duration_s": None,
            "repeats": None,
            "instructions": 0,
            "error": error,
        }
    )


@dataclass(slots=True)
class Tally:
    """How many texts were answered, could not be read, and were read but hold words not understood."""

    answered: int = 0
    unread: int = 0
    not_understood: int = 0

    def count(self, reply: Reply) -> None:
        """Count an answer."""
        self.answered += 1
        if reply.answer["error"]:
            self.unread += 1
        elif any(remark["kind"] in LEFT for remark in reply.answer.get("remarks", ())):
            self.not_understood += 1

    @property
    def nothing_read(self) -> bool:
        """Whether there were texts and none could be read."""
        return 0 < self.answered == self.unread

    @property
    def doubtful(self) -> bool:
        """Whether a text could not be read, or not all of its words were understood."""
        return self.unread + self.not_understood > 0


def readable(reply: Reply, width: int | None) -> list[str]:
    """Give an answer as lines for a person: what is asked for, when, and what was not understood."""
    said = reply.answer
    lines = [f"{said['text']}"]
    if said["error"]:
        return [*lines, f"  error: {said['error']}"]
    operations = said.get("operations", [said["operation"]])
    for position, (operation, name) in enumerate(zip(operations, reply.names, strict=False)):
        if operation is not None:
            told = "tells" if operation.get("stated") else "do   "
            lines.append(f"  {told} {'not ' if operation.get('negated') else ''}{name}")
        for requirement in said["requirements"]:
            if requirement.get("instruction", 0) == position:
                kind = "named" if requirement["reference"] == NAMED else "time "
                lines.append(f"  {kind} {requirement['text']!r}: {_bounds(requirement)}")
    if said["duration_s"] is not None:
        lines.append(f"  takes {format_duration(said['duration_s'])}")
    for remark in said.get("remarks", ()):
        marked = underlined(said["text"], tuple(remark["span"]), width and width - 4).split("\n")
        lines += [f"  note  {remark['message']}", *(f"    {line}" for line in marked)]
    return lines


def _bounds(requirement: Answer) -> str:
    """Say how a time binds: "at …", "before …", "between … and …"."""
    constraint, low, high = (requirement[name] for name in ("constraint", "earliest", "latest"))
    if constraint == "between" and low and high:
        return f"between {low} and {high}"
    if constraint == "every" and low != high:
        return f"every {low} to {high}"
    named = low if constraint in {"at", "after", "every"} else high
    return f"{constraint} {named}" if named else constraint
