"""Lines that come in during a run, understood: readings, instructions, and word that something is done.

One JSON object a line::

    {"signal": "pan_temp", "value": 150, "unit": "degC"}    a reading; an event has no value
    {"say": "stir the soup soon", "duration": "4 min"}      an instruction, as a task file has them
    {"done": "s1"}   {"failed": "s1", "reason": "…"}   {"drop": "s2"}

``at`` (an ISO instant) or ``at_s`` (seconds since the run's now) say when; without them a line is about the
moment at which it comes. A line about a time ahead is held until then, so that a recording can be played; an
event that lies ahead and is known now says ``"announced": true``.
"""

import json
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import datetime
from enum import StrEnum
from typing import Any

from fuzzytime.context import Reading, Signal, parse_fields, reading_of, time_of
from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import SpokenWish
from fuzzytime.spelling import suggestion
from fuzzytime.times import instant_after, parse_duration
from fuzzytime_cli.bounds import MAX_AGENTS, PRIORITIES

_TIMES = ("at", "at_s")
_READING = ("signal", "value", "unit", "announced", *_TIMES)
_SAYING = ("say", "id", "duration", "hands_on", "elapsed", "priority", "agent", "after", *_TIMES)
_IDENTIFIER = re.compile(r"[A-Za-z_][\w.-]{0,63}")


class Word(StrEnum):
    """What can be told of a skill."""

    DONE = "done"
    FAILED = "failed"
    DROP = "drop"


@dataclass(frozen=True, slots=True, kw_only=True)
class Message:
    """A line understood: the time that it is about and the time at which it comes, in seconds of the run."""

    at: float
    comes: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Read(Message):
    """A reading, at a time of the run."""

    reading: Reading


@dataclass(frozen=True, slots=True, kw_only=True)
class Said(Message):
    """An instruction."""

    wish: SpokenWish


@dataclass(frozen=True, slots=True, kw_only=True)
class Told(Message):
    """Word about a skill."""

    word: Word
    identifier: str
    reason: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Unreadable(Message):
    """A line that is none of these, where it stands, and why."""

    place: str
    message: str


MOST_SHOWN = 60
"""Bytes of words that are shown as the line that says them."""


def _how_to_say(line: bytes) -> str:
    """Show how words that somebody types are said as a line; nothing for what was meant as one."""
    words = line.strip()
    typed = words[:1].isalpha() and len(words) <= MOST_SHOWN
    return f"; words are said so: {json.dumps({'say': words.decode(errors='replace')})}" if typed else ""


@dataclass(frozen=True, slots=True)
class Listener:
    """Understands lines, given when the run began and which signals there are."""

    origin: datetime
    signals: Mapping[str, Signal]

    def heard(self, line: bytes, place: str, now: float) -> Message | None:
        """Understand a line that comes at a moment of the run; None where it is empty."""
        if not line.strip():
            return None
        try:
            return self._understood(parse_fields(line.removeprefix(b"\xef\xbb\xbf")), now)
        except FuzzytimeError as error:
            message = f"{error}{_how_to_say(line)}"
            return Unreadable(at=now, comes=now, place=place, message=message)

    def _understood(self, fields: dict[str, Any], now: float) -> Message:
        kinds: dict[str, Callable[[dict[str, Any], float], Message]] = {
            "signal": self._reading,
            "say": self._instruction,
            **dict.fromkeys(Word, self._told),
        }
        found = [name for name in kinds if name in fields]
        if len(found) != 1:
            raise FuzzytimeError(
                f"a line must hold one of {', '.join(kinds)}, got {', '.join(fields) or 'nothing'}"
            )
        return kinds[found[0]](fields, now)

    def _time(self, fields: Mapping[str, Any], now: float) -> float:
        said = any(fields.get(name) is not None for name in _TIMES)
        return time_of(fields, self.origin) if said else now

    def _reading(self, fields: dict[str, Any], now: float) -> Read:
        _known(fields, _READING)
        announced = fields.pop("announced", False)
        at = self._time(fields, now)
        plain = {name: value for name, value in fields.items() if name not in _TIMES}
        reading = reading_of({**plain, "at_s": at}, self.signals, latest=float("inf"))
        if announced is not False and (announced is not True or reading.value is not None):
            raise FuzzytimeError("'announced' must be true, and of an event, which has no value")
        return Read(at=at, comes=now if announced else max(at, now), reading=reading)

    def _instruction(self, fields: dict[str, Any], now: float) -> Said:
        _known(fields, _SAYING)
        at = self._time(fields, now)
        text = _text(fields, "say").strip()
        if not text:
            raise FuzzytimeError("an instruction must not be empty")
        if "duration" in fields and {"hands_on", "elapsed"} & fields.keys():
            raise FuzzytimeError("a duration sets hands_on and elapsed: give it alone")
        both = _duration(fields, "duration")
        wish = SpokenWish(
            text=text,
            given=instant_after(self.origin, at),
            identifier=_identifier(fields, "id") if "id" in fields else "",
            hands_on=_duration(fields, "hands_on") if "hands_on" in fields else both,
            elapsed=_duration(fields, "elapsed") if "elapsed" in fields else both,
            priority=_number(fields, "priority", *PRIORITIES) if "priority" in fields else 1.0,
            agent=int(_number(fields, "agent", 1, MAX_AGENTS)) if "agent" in fields else None,
            after=_names(fields, "after"),
        )
        return Said(at=at, comes=max(at, now), wish=wish)

    def _told(self, fields: dict[str, Any], now: float) -> Told:
        word = next(word for word in Word if word in fields)
        _known(fields, (word, *_TIMES, *(["reason"] if word is not Word.DONE else [])))
        at = self._time(fields, now)
        reason = _text(fields, "reason") if "reason" in fields else ""
        return Told(at=at, comes=max(at, now), word=word, identifier=_identifier(fields, word), reason=reason)


def _known(fields: Mapping[str, Any], names: tuple[str, ...]) -> None:
    for name in fields:
        if name not in names:
            raise FuzzytimeError(f"unknown key {name!r}{suggestion(name, names)}")


def _text(fields: Mapping[str, Any], name: str) -> str:
    value = fields[name]
    if not isinstance(value, str):
        raise FuzzytimeError(f"{name!r} must be a text, got {str(value)[:40]!r}")
    return value


def _identifier(fields: Mapping[str, Any], name: str) -> str:
    text = _text(fields, name)
    if not _IDENTIFIER.fullmatch(text):
        raise FuzzytimeError(f"{name!r} must be an id such as s1, got {text[:70]!r}")
    return text


def _duration(fields: Mapping[str, Any], name: str) -> float | None:
    if name not in fields:
        return None
    duration = parse_duration(_text(fields, name))
    if duration < 0:
        raise FuzzytimeError(f"{name!r} must be at least 0, got {fields[name]!r}")
    return duration


def _number(fields: Mapping[str, Any], name: str, low: float, high: float) -> float:
    value = fields[name]
    if isinstance(value, bool) or not isinstance(value, int | float) or not low <= value <= high:
        raise FuzzytimeError(f"{name!r} must be a number from {low:g} to {high:g}, got {str(value)[:40]!r}")
    return float(value)


def _names(fields: Mapping[str, Any], name: str) -> tuple[str, ...]:
    value = fields.get(name, [])
    names = [value] if isinstance(value, str) else value
    if not isinstance(names, list) or not all(isinstance(one, str) for one in names):
        raise FuzzytimeError(f"{name!r} must be an id or a list of ids, got {str(value)[:40]!r}")
    return tuple(names)
