"""Readings from outside: files of JSON lines or CSV, assignments, the context of a task file."""

import codecs
from collections.abc import Mapping
from dataclasses import replace
from datetime import datetime
from pathlib import Path

from fuzzytime.context.lines import LONGEST_LINE, LineError, parse_context_line
from fuzzytime.context.readings import MAX_READINGS, Context, Reading, admitted
from fuzzytime.context.signals import Signal
from fuzzytime.context.spreadsheet import is_head, read_rows
from fuzzytime.documents.nodes import Mapping as MappingNode
from fuzzytime.documents.nodes import Node, Reader, Scalar
from fuzzytime.errors import DocumentError, FuzzytimeError, Mistake
from fuzzytime.spelling import suggestion

LARGEST_FILE = 64 << 20

_NOTHING = ("", "~", "null")
"""How YAML writes that an event has no value."""


def parse_assignment(text: str, signals: Mapping[str, Signal] | None = None) -> Reading:
    """Read ``pan_temp=180 degC``, ``queue=3``, or ``timer`` for an event that happens now.

    Parameters
    ----------
    text
        A signal's name, and after ``=`` its value.
    signals
        The signals that there are, where the reading is to be checked against them.

    Raises
    ------
    FuzzytimeError
        If the text is no assignment, or the signal cannot have the value.

    >>> parse_assignment("pan_temp=180 degC")
    Reading(signal='pan_temp', at=0.0, value=180.0, unit='degC')
    """
    name, equals, value = (part.strip() for part in text.partition("="))
    if not name or (equals and not value):
        raise FuzzytimeError(f"a reading must look like pan_temp=180, got {text!r}")
    reading = Reading.of(name, value if equals else None)
    if signals is not None:
        admitted(reading, signals)
    return reading


def read_context_file(
    path: Path, now: datetime | None = None, signals: Mapping[str, Signal] | None = None
) -> Context:
    """Read a file of JSON lines or of comma-separated values, UTF-8 or UTF-16 with its mark.

    Parameters and mistakes are those of `read_context_lines`.

    Raises
    ------
    DocumentError
        With every mistake and its line, or because the file cannot be read.
    """
    try:
        with path.open("rb") as stream:
            source = stream.read(LARGEST_FILE + 1)
    except OSError as error:
        reason = error.strerror or type(error).__name__
        raise DocumentError((Mistake(str(path), 1, 1, "", f"the file cannot be read: {reason}"),)) from error
    return read_context_lines(source, str(path), now, signals)


def read_context_lines(
    source: bytes | str,
    shown: str,
    now: datetime | None = None,
    signals: Mapping[str, Signal] | None = None,
) -> Context:
    """Read one reading a line, as JSON, or a table whose first line is a head; empty lines are passed over.

    A line of JSON is ``{"signal": "pan_temp", "at_s": -30, "value": 120, "unit": "degC"}``; of a table see
    `fuzzytime.context.spreadsheet`.

    Parameters
    ----------
    source, shown
        The lines, and how messages call them.
    now
        The instant that ``at`` counts from; without it only ``at_s``, in seconds, may stand.
    signals
        The signals that there are, where readings are to be checked against them.

    Raises
    ------
    DocumentError
        With every mistake and its line.
    """
    raw = source.encode("utf-8", "surrogatepass") if isinstance(source, str) else source
    if len(raw) > LARGEST_FILE:
        message = f"readings must not be more than {LARGEST_FILE:,} bytes"
        raise DocumentError((Mistake(shown, 1, 1, "", message),))
    raw = _as_utf8(raw, shown)
    first, _, _ = raw.partition(b"\n")
    if is_head(first.decode("utf-8", "replace").strip()):
        return read_rows(_text_of(raw, shown), shown, now, signals)
    readings: list[Reading] = []
    mistakes: list[Mistake] = []
    for number, line in enumerate(raw.split(b"\n"), 1):
        if not line.strip():
            continue
        try:
            readings.append(parse_context_line(line, now, signals))
        except FuzzytimeError as error:
            text = line[:LONGEST_LINE].decode("utf-8", "replace").rstrip("\r")
            column = error.column_in(text) if isinstance(error, LineError) else 1
            mistakes.append(Mistake(shown, number, column, "", str(error), text))
        if max(len(readings), len(mistakes)) > MAX_READINGS:
            message = f"a context must hold at most {MAX_READINGS:,} readings"
            raise DocumentError((*mistakes, Mistake(shown, number, 1, "", message)))
    if mistakes:
        raise DocumentError(tuple(mistakes))
    return Context(tuple(readings))


def _as_utf8(raw: bytes, shown: str) -> bytes:
    """Take a mark of UTF-8 away, and turn UTF-16 with its mark into UTF-8."""
    if raw[:2] not in {codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE}:
        return raw.removeprefix(codecs.BOM_UTF8)
    try:
        return raw.decode("utf-16").encode()
    except UnicodeDecodeError as error:
        message = f"text that begins as UTF-16 must be UTF-16: {error.reason}"
        raise DocumentError((Mistake(shown, 1, 1, "", message),)) from error


def _text_of(raw: bytes, shown: str) -> str:
    try:
        return raw.decode("utf-8")
    except UnicodeDecodeError as error:
        before = raw[: error.start].decode("utf-8")
        line, column = before.count("\n") + 1, len(before) - before.rfind("\n")
        message = f"text must be UTF-8, got byte 0x{raw[error.start]:02x}"
        raise DocumentError((Mistake(shown, line, column, "", message),)) from error


def read_context_node(
    reader: Reader, node: Node, key: str, signals: Mapping[str, Signal] | None = None
) -> Context:
    """Read the ``context:`` of a YAML file, noting mistakes at the reader.

    A signal has one value, now (``pan_temp: 180 degC``), or a list of readings
    (``[{at: -60 s, value: 120}, {at: 0 s, value: 150}]``); an event's value is left out.
    """
    readings: list[Reading] = []
    keys = reader.keys(node)
    for name, value in reader.mapping(node, key).items():
        path = f"{key}.{name}"
        if signals is not None and name not in signals:
            reader.mistake(keys[name], path, f"unknown signal {name!r}{suggestion(name, signals)}")
            continue
        if isinstance(value, Scalar | MappingNode):
            readings += _reading(reader, value, path, name, signals)
        else:
            for i, item in enumerate(reader.sequence(value, path)):
                readings += _reading(reader, item, f"{path}[{i}]", name, signals)
    return Context(tuple(readings[:MAX_READINGS]))


def _reading(
    reader: Reader, node: Node, key: str, name: str, signals: Mapping[str, Signal] | None
) -> list[Reading]:
    """Read one value, or a mapping with its time; nothing where it is none."""
    at, unit, value = 0.0, None, node
    if isinstance(node, MappingNode):
        found = reader.mapping(node, key, ("at", "value", "unit"))
        at = reader.duration(found["at"], f"{key}.at") if "at" in found else 0.0
        unit = reader.string(found["unit"], f"{key}.unit") if "unit" in found else None
        value = found.get("value", Scalar("", node.line, node.column, node.index))
    if not isinstance(value, Scalar):
        reader.string(value, f"{key}.value")
        return []

    def converted(text: str) -> Reading:
        made = Reading.of(name, None if text in _NOTHING else text, at)
        if unit is not None:
            made = replace(made, unit=unit)
        if made.at > 0 and made.value is not None:
            raise FuzzytimeError(f"a reading must not lie in the future, got {made.at:g} s")
        return made if signals is None else admitted(made, signals)

    made = reader.read(value, key, converted)
    return [] if made is None else [made]
