"""A reading from one line of JSON, and from fields that were read elsewhere."""

import json
import math
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from datetime import datetime
from typing import Any

from fuzzytime.context.readings import Reading, admitted
from fuzzytime.context.signals import Signal
from fuzzytime.context.units import parse_quantity
from fuzzytime.errors import FuzzytimeError
from fuzzytime.spelling import suggestion
from fuzzytime.times import parse_instant, seconds_between

LONGEST_LINE = 4096
"""Bytes, or characters, that a line may have."""

KEYS = ("signal", "at_s", "at", "value", "unit")
"""What a reading's fields are called."""


class LineError(FuzzytimeError):
    """A line that is no reading: what is wrong, and the key, the value of the key, or the column that is.

    Columns count from 1.
    """

    def __init__(self, message: str, column: int = 1, *, key: str = "", value_of: str = "") -> None:
        super().__init__(message)
        self.key = key
        self.value_of = value_of
        self._column = column

    def column_in(self, line: str) -> int:
        """Give the column in a line of JSON."""
        name = self.key or self.value_of
        key = re.escape(json.dumps(name, ensure_ascii=False))
        found = re.search(key + r"\s*:\s*", line) if name else None
        if found is None:
            return self._column
        return (found.start() if self.key else found.end()) + 1


@contextmanager
def about(field: str) -> Iterator[None]:
    """Let what is wrong be about the value of a field, where nothing says it better."""
    try:
        yield
    except LineError:
        raise
    except FuzzytimeError as error:
        raise LineError(str(error), value_of=field) from error


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
        if name not in KEYS:
            raise LineError(f"unknown key {name!r}{suggestion(name, KEYS)}", key=name)
    signal = fields.get("signal")
    if not isinstance(signal, str) or not signal:
        raise LineError(f"'signal' must be a name, got {signal!r}", value_of="signal")
    unit = fields.get("unit")
    if unit is not None and not isinstance(unit, str):
        raise LineError(f"'unit' must be a text, got {unit!r}", value_of="unit")
    value = fields.get("value")
    if isinstance(value, str):
        with about("value"):
            value, said = parse_quantity(value)
        unit = said if unit is None else unit
    elif value is not None:
        value = _number(value, "value")
    field = "at" if "at" in fields else "at_s"
    with about(field):
        reading = Reading(signal, time_of(fields, now), value, unit)
    if reading.at > latest and value is not None:
        raise LineError(f"a reading must not lie in the future, got {reading.at:g} s", value_of=field)
    if signals is None:
        return reading
    with about("value" if signal in signals else "signal"):
        return admitted(reading, signals)


def parse_fields(line: bytes | str, longest: int = LONGEST_LINE) -> dict[str, Any]:
    """Give the fields of a line that is a JSON object, with distinct keys and finite numbers.

    A line may have ``longest`` bytes, or characters.

    Raises
    ------
    FuzzytimeError
        If it is none.
    """
    if len(line) > longest:
        raise LineError(f"a line must not be longer than {longest} bytes, got {len(line)}")
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
        raise LineError(f"keys must differ, got {twice!r} twice", key=twice)
    return fields


def _no_constant(name: str) -> float:
    raise LineError(f"numbers must be finite, got {name}")


def _number(value: object, name: str) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise LineError(f"{name!r} must be a number, got {str(value)[:40]!r}", value_of=name)
    try:
        number = float(value)
    except OverflowError:
        number = math.inf
    if not math.isfinite(number):
        raise LineError(f"{name!r} must be finite, got {str(value)[:40]}", value_of=name)
    return number


def time_of(fields: Mapping[str, Any], now: datetime | None) -> float:
    """Give the time that ``at`` or ``at_s`` says, in seconds from now; 0 where none is said.

    Raises
    ------
    FuzzytimeError
        If it is no time.
    """
    if "at" in fields and "at_s" in fields:
        raise LineError("a time must be given by 'at' or by 'at_s', not both", key="at")
    if "at_s" in fields:
        return _number(fields["at_s"], "at_s")
    at = fields.get("at")
    if at is None:
        return 0.0
    if not isinstance(at, str):
        raise LineError(f"'at' must be a date and time, got {str(at)[:40]!r}", value_of="at")
    if now is None:
        raise LineError(f"'at' needs a moment to count from; use 'at_s', got {at!r}", value_of="at")
    return seconds_between(now, parse_instant(at, now.tzinfo))
