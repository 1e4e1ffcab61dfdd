"""Readings from outside: files of JSON lines, assignments on a command line, the context of a task file."""

import json
import math
from collections.abc import Mapping
from dataclasses import replace
from datetime import datetime
from pathlib import Path
from typing import Any

from fuzzytime.context.readings import MAX_READINGS, Context, Reading, admitted
from fuzzytime.context.signals import Signal
from fuzzytime.context.units import parse_quantity
from fuzzytime.errors import DocumentError, FuzzytimeError, Mistake
from fuzzytime.spelling import suggestion
from fuzzytime.times import parse_instant, seconds_between
from fuzzytime.yaml_nodes import Mapping as MappingNode
from fuzzytime.yaml_nodes import Node, Reader, Scalar

LONGEST_LINE = 4096
LARGEST_FILE = 64 << 20

_NOTHING = ("", "~", "null")
"""How YAML writes that an event has no value."""

_KEYS = ("signal", "at_s", "at", "value", "unit")


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
    """Read a file of JSON lines: ``{"signal": "pan_temp", "at_s": -30, "value": 120, "unit": "degC"}``.

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
    """Read one reading a line, as JSON; empty lines are passed over.

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
    readings: list[Reading] = []
    mistakes: list[Mistake] = []
    for number, line in enumerate(raw.removeprefix(b"\xef\xbb\xbf").split(b"\n"), 1):
        if not line.strip():
            continue
        try:
            readings.append(parse_context_line(line, now, signals))
        except FuzzytimeError as error:
            text = line[:LONGEST_LINE].decode("utf-8", "replace").rstrip("\r")
            column = error.column if isinstance(error, LineError) else 1
            mistakes.append(Mistake(shown, number, column, "", str(error), text))
        if max(len(readings), len(mistakes)) > MAX_READINGS:
            message = f"a context must hold at most {MAX_READINGS:,} readings"
            raise DocumentError((*mistakes, Mistake(shown, number, 1, "", message)))
    if mistakes:
        raise DocumentError(tuple(mistakes))
    return Context(tuple(readings))


class LineError(FuzzytimeError):
    """A line that is no reading, and the column from which on, from 1."""

    def __init__(self, message: str, column: int = 1) -> None:
        super().__init__(message)
        self.column = column


def parse_context_line(
    line: bytes | str, now: datetime | None = None, signals: Mapping[str, Signal] | None = None
) -> Reading:
    """Read one reading from one line of JSON.

    Raises
    ------
    FuzzytimeError
        If it is none, or not one that its signal can have.
    """
    return reading_of(parse_fields(line), signals, now)


def reading_of(
    fields: Mapping[str, Any],
    signals: Mapping[str, Signal] | None = None,
    now: datetime | None = None,
    latest: float = 0.0,
) -> Reading:
    """Make a reading of the fields of a JSON object.

    Parameters
    ----------
    fields
        ``signal``, and perhaps ``value``, ``unit``, and one of ``at`` and ``at_s``.
    signals, now
        As in `read_context_file`.
    latest
        The time, in seconds from now, after which no value may lie.

    Raises
    ------
    FuzzytimeError
        If they are none, or not one that its signal can have.
    """
    for name in fields:
        if name not in _KEYS:
            raise LineError(f"unknown key {name!r}{suggestion(name, _KEYS)}")
    signal = fields.get("signal")
    if not isinstance(signal, str) or not signal:
        raise LineError(f"'signal' must be a name, got {signal!r}")
    unit = fields.get("unit")
    if unit is not None and not isinstance(unit, str):
        raise LineError(f"'unit' must be a text, got {unit!r}")
    value = fields.get("value")
    if isinstance(value, str):
        value, said = parse_quantity(value)
        unit = said if unit is None else unit
    elif value is not None:
        value = _number(value, "value")
    reading = Reading(signal, time_of(fields, now), value, unit)
    if reading.at > latest and value is not None:
        raise LineError(f"a reading must not lie in the future, got {reading.at:g} s")
    return reading if signals is None else admitted(reading, signals)


def parse_fields(line: bytes | str) -> dict[str, Any]:
    """Give the fields of a line that is a JSON object, with distinct keys and finite numbers.

    Raises
    ------
    FuzzytimeError
        If it is none.
    """
    if len(line) > LONGEST_LINE:
        raise LineError(f"a line must not be longer than {LONGEST_LINE} bytes, got {len(line)}")
    try:
        text = line.decode("utf-8") if isinstance(line, bytes) else line
        fields = json.loads(text, object_pairs_hook=_distinct, parse_constant=_no_constant)
    except json.JSONDecodeError as error:
        raise LineError(f"a line must be a JSON object: {error.msg}", error.colno) from error
    except UnicodeDecodeError as error:
        raise LineError(
            f"text must be UTF-8, got byte 0x{error.object[error.start]:02x}", error.start + 1
        ) from error
    except (ValueError, RecursionError) as error:
        raise LineError("a line must be a flat JSON object of plain numbers") from error
    if not isinstance(fields, dict):
        raise LineError(f"a line must be a JSON object, got {str(fields)[:40]!r}")
    return fields


def _distinct(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    fields = dict(pairs)
    if len(fields) < len(pairs):
        twice = next(name for i, (name, _) in enumerate(pairs) if name in dict(pairs[:i]))
        raise LineError(f"keys must differ, got {twice!r} twice")
    return fields


def _no_constant(name: str) -> float:
    raise LineError(f"numbers must be finite, got {name}")


def _number(value: object, name: str) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise LineError(f"{name!r} must be a number, got {str(value)[:40]!r}")
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise LineError(f"{name!r} must be finite, got {str(value)[:40]}")
    return number


def time_of(fields: Mapping[str, Any], now: datetime | None) -> float:
    """Give the time that ``at`` or ``at_s`` says, in seconds from now; 0 where none is said.

    Raises
    ------
    FuzzytimeError
        If it is no time.
    """
    if "at" in fields and "at_s" in fields:
        raise LineError("a time must be given by 'at' or by 'at_s', not both")
    if "at_s" in fields:
        return _number(fields["at_s"], "at_s")
    at = fields.get("at")
    if at is None:
        return 0.0
    if not isinstance(at, str):
        raise LineError(f"'at' must be a date and time, got {str(at)[:40]!r}")
    if now is None:
        raise LineError(f"'at' needs a moment to count from; use 'at_s', got {at!r}")
    return seconds_between(now, parse_instant(at, now.tzinfo))


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
