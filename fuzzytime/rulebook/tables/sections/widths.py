"""Reading leniency: widths over time, factors for actors, clock times and round numbers."""

import math
from collections.abc import Callable, Mapping
from enum import StrEnum
from types import MappingProxyType
from typing import TypeVar

from fuzzytime.documents.nodes import Node
from fuzzytime.requirement import Unit
from fuzzytime.rulebook.tables.profile import Actor
from fuzzytime.rulebook.tables.sections.scope import Scope
from fuzzytime.rulebook.tables.width import Points, Roundness, Softness
from fuzzytime.times import DAY, HOUR, parse_duration

_E = TypeVar("_E", bound=StrEnum)
_T = TypeVar("_T")

MAX_FACTOR = 1000.0
LONGEST = 366 * DAY
"""The longest time that a table may speak of, but for validity."""


def read_factor(scope: Scope, node: Node, key: str) -> float:
    """Read a factor of width or of time."""
    return scope.reader.number(node, key, 1 / MAX_FACTOR, MAX_FACTOR)


def read_positive_duration(scope: Scope, node: Node, key: str) -> float:
    """Read a duration of at least a millisecond."""
    return scope.reader.duration(node, key, 1e-3, LONGEST)


def read_width(scope: Scope, node: Node, key: str) -> Points:
    """Read ``{base: 112.9 s, growth: 0.03406}`` or ``{points: {0 s: 4 min, 10 min: 10.7 min}}``."""
    found = scope.row(node, key, ("base", "growth", "points"))
    if "points" in found:
        scope.reader.refuse_keys(node, key, ("base", "growth"), "must not stand beside 'points'")
        return _points(scope, found["points"], f"{key}.points", read_positive_duration, extended=True)
    for name in ("base", "growth"):
        if name not in found:
            scope.reader.missing(node, key, (name, "points"))
    base = read_positive_duration(scope, found["base"], f"{key}.base") if "base" in found else 1.0
    growth = scope.reader.number(found["growth"], f"{key}.growth", 0.0, 10.0) if "growth" in found else 0.0
    return Points((0.0, HOUR), (base, base + growth * HOUR), extended=True, source=scope.reader.place(node))


def read_actors(scope: Scope, node: Node, key: str) -> Mapping[Actor, Points]:
    """Read factors of width over the time named, by actor."""
    read: dict[Actor, Points] = {}
    for name, value in scope.reader.mapping(node, key, tuple(Actor)).items():
        path = f"{key}.{name}"
        found = scope.row(value, path, ("width",), ("width",))
        if "width" in found:
            read[Actor(name)] = _points(scope, found["width"], f"{path}.width", read_factor, extended=False)
    return MappingProxyType(read)


def _points(
    scope: Scope, node: Node, key: str, read: Callable[[Scope, Node, str], float], *, extended: bool
) -> Points:
    keys = scope.reader.keys(node)
    points: dict[float, float] = {}
    last = -math.inf
    for text, child in scope.reader.mapping(node, key).items():
        path = f"{key}.{text}"
        time = scope.reader.read(keys[text], path, parse_duration)
        value = read(scope, child, path)
        if time is not None and not max(last, -1e-9) < time <= LONGEST:
            scope.reader.mistake(keys[text], path, f"times must be at least 0 and increase, got {text!r}")
        elif time is not None:
            points[time], last = value, time
    if not points:
        if not keys:
            scope.reader.missing(node, key, (), "must have at least one point")
        return Points((0.0,), (1.0,))
    return Points(tuple(points), tuple(points.values()), extended, scope.reader.place(node))


def read_plateau(scope: Scope, node: Node, key: str) -> float:
    """Read the plateau's share of the half-base."""
    return scope.reader.number(node, key, 0.0, 1.0)


def read_clock(scope: Scope, node: Node, key: str) -> Mapping[Unit, float]:
    """Read the largest half-base of a wall-clock time by its grain."""
    found = scope.row(node, key, tuple(Unit))
    read = {
        name: read_positive_duration(scope, found[name], f"{key}.{name}") for name in Unit if name in found
    }
    return MappingProxyType(read)


def read_repetition(scope: Scope, node: Node, key: str) -> float:
    """Read the share of a series' interval that the half-base of an occurrence may have at most."""
    found = scope.row(node, key, ("share",), ("share",))
    return scope.reader.number(found["share"], f"{key}.share", 1e-3, 1.0) if "share" in found else 1.0


def read_thresholds(scope: Scope, node: Node, key: str) -> Softness:
    """Read the share of a number that its softness is."""
    found = scope.row(node, key, ("share",), ("share",))
    share = scope.reader.number(found["share"], f"{key}.share", 0.0, 1.0) if "share" in found else 0.0
    return Softness(share, scope.reader.place(node))


def read_roundness(scope: Scope, node: Node, key: str) -> Roundness:
    """Read when a number is round, by unit, and the factor where it is not."""
    found = scope.row(node, key, ("steps", "factor"), ("steps", "factor"))
    steps: Mapping[Unit, float] = {}
    if "steps" in found:
        path = f"{key}.steps"
        steps = by_member(
            scope, found["steps"], path, Unit, lambda child, path: scope.reader.number(child, path, 1e-6, 1e6)
        )
    factor = read_factor(scope, found["factor"], f"{key}.factor") if "factor" in found else 1.0
    return Roundness(tuple(steps.items()), factor, scope.reader.place(node))


def by_member(
    scope: Scope, node: Node, key: str, members: type[_E], read: Callable[[Node, str], _T]
) -> Mapping[_E, _T]:
    """Read a mapping whose keys form a closed set."""
    found = scope.reader.mapping(node, key, tuple(members))
    return MappingProxyType({members(name): read(child, f"{key}.{name}") for name, child in found.items()})
