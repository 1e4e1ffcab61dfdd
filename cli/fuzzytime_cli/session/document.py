"""The state of a conversation as JSON: saved sessions are handed on, so that nothing is taken as it comes."""

import json
import math
from collections.abc import Mapping
from dataclasses import asdict, is_dataclass
from datetime import datetime
from functools import cache, lru_cache
from types import UnionType
from typing import Any, get_args, get_origin, get_type_hints

from fuzzytime.errors import FuzzytimeError
from fuzzytime_cli.bounds import MAX_AGENTS, MAX_INSTRUCTIONS, PRIORITIES
from fuzzytime_cli.session.state import Started, State

SCHEMA = "fuzzytime-session/1"

NEEDED = ("entries", "next_number", "readings", "busy", "finished")
"""What every version of a session has."""


def state_text(state: State) -> str:
    """Write a state as JSON."""
    return json.dumps({"schema": SCHEMA, **asdict(state)}, default=instant_text)


def instant_text(value: object) -> str:
    """Write an instant with its zone, as JSON is asked to write what it does not know."""
    if isinstance(value, datetime):
        zone = getattr(value.tzinfo, "key", "")
        return value.isoformat() + (f"[{zone}]" if zone else "")
    raise TypeError(type(value).__name__)


def instant_of(text: str) -> datetime:
    """Read an instant with its zone."""
    from fuzzytime.times import parse_instant, parse_zone

    plain, _, zone = text.partition("[")
    return parse_instant(plain, parse_zone(zone.rstrip("]")) if zone else None)


@lru_cache(maxsize=8)
def state_of(text: str) -> State:
    """Read a state from JSON; what earlier versions did not have is as where nothing is said.

    A turn of a conversation looks at its state many times: those read last are kept.

    Raises
    ------
    FuzzytimeError
        If it is not one.
    """
    try:
        data = json.loads(text)
        if data.pop("schema") != SCHEMA:
            raise FuzzytimeError(f"a session must be of the form {SCHEMA}")
        missing = [name for name in NEEDED if name not in data]
        if missing:
            raise FuzzytimeError(f"a session must have {missing[0]!r} (form {SCHEMA})")
        state: State = _of(State, data)
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError) as error:
        raise FuzzytimeError(f"a session must be JSON of the form {SCHEMA}: {error}") from error
    _check(state)
    return state


def started_of(text: str) -> Started:
    """Read a started skill from JSON."""
    started: Started = _of(Started, json.loads(text))
    return started


def _check(state: State) -> None:
    """Refuse what no conversation leads to.

    Raises
    ------
    FuzzytimeError
        If there is such a thing.
    """
    numbers = [entry.number for entry in state.entries]
    low, high = PRIORITIES
    lengths = [length for entry in state.entries for length in (entry.hands_on, entry.elapsed)]
    rules = (
        (1 <= (1 if state.agents is None else state.agents) <= MAX_AGENTS, f"at most {MAX_AGENTS} agents"),
        (len(numbers) <= MAX_INSTRUCTIONS, f"at most {MAX_INSTRUCTIONS:,} instructions"),
        (len({*numbers}) == len(numbers), "instructions with distinct numbers"),
        (all(0 < number < state.next_number for number in numbers), "numbers below the next one"),
        (all(low <= entry.priority <= high for entry in state.entries), f"priorities from {low} to {high:g}"),
        (all(length is None or length >= 0 for length in lengths), "lengths of at least 0"),
        (all(kept.start <= kept.end for kept in state.busy), "busy times that end after they start"),
    )
    for kept, rule in rules:
        if not kept:
            raise FuzzytimeError(f"a session must have {rule} (form {SCHEMA})")


def _of(kind: Any, data: object) -> Any:  # noqa: ANN401 - an object of the kind
    """Make a value of a dataclass from JSON's."""
    hints = _hints(kind)
    if not isinstance(data, dict) or not data.keys() <= hints.keys():
        raise TypeError(f"what is no {kind.__name__.lower()}: {str(data)[:40]}")
    return kind(**{name: _value(name, hints[name], value) for name, value in data.items()})


@cache
def _hints(kind: Any) -> Mapping[str, Any]:  # noqa: ANN401 - a dataclass
    return get_type_hints(kind)


def _value(name: str, hint: Any, value: object) -> Any:  # noqa: ANN401 - of the type that is hinted at
    """Read a field's value by its type."""
    kinds = get_args(hint) if isinstance(hint, UnionType) else (hint,)
    for kind in kinds:
        if get_origin(kind) is tuple and isinstance(value, list):
            return tuple(_value(name, get_args(kind)[0], item) for item in value)
        if is_dataclass(kind):
            return _of(kind, value)
        if kind is datetime and isinstance(value, str):
            return instant_of(value)
        if kind is float and type(value) in {int, float} and math.isfinite(value):  # type: ignore[arg-type]
            return value
        if type(value) is kind:
            return value
    raise TypeError(f"{name!r} cannot be {str(value)[:40]}")
