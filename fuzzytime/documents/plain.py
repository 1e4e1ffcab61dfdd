"""Frozen values written as JSON, and made again of it: what tables became, in a form that can hold no code.

All that a value consists of stands in one row, each part before what is made of it: first texts and numbers,
as they are, and the tuples and sets of nothing else, which most are; then rows of places: of a kind, among
the names of kinds, and of the parts. What is shared is written once, but for texts in such tuples and sets.
"""

import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import fields, is_dataclass
from datetime import time
from enum import Enum
from importlib import import_module
from itertools import accumulate
from types import MappingProxyType
from typing import Any

LIBRARY = "fuzzytime"
"""Whose classes are written and made: those of other modules are not."""

_Maker = Callable[[Iterable[Any]], object]

_ATOMS = frozenset({str, int, float, bool, type(None)})


def _mapping(parts: Iterable[Any]) -> dict[Any, Any]:
    each = iter(parts)
    return dict(zip(each, each, strict=True))


_BUILT_IN: Mapping[str, _Maker] = {
    "tuple": tuple,
    "set": frozenset,
    "dict": _mapping,
    "mapping": lambda parts: MappingProxyType(_mapping(parts)),
    "time": lambda parts: time.fromisoformat(*parts),
}


def written(value: object) -> str:
    """Give a value as JSON.

    Raises
    ------
    TypeError
        If it, or a part of it, is no text, number, tuple, frozenset, mapping, time of day, or dataclass,
        named tuple, enumeration or mapping of this library.
    """
    writer = _Writer()
    whole = writer.place(value)
    return json.dumps(writer.said(whole), ensure_ascii=False, separators=(",", ":"))


def made_again(text: str) -> Any:  # noqa: ANN401 - what was written
    """Give the value that was written.

    Raises
    ------
    ValueError, TypeError, LookupError, AttributeError, ImportError
        If that is not what was written.

    >>> made_again(written((1, "two", frozenset({3.0}))))
    (1, 'two', frozenset({3.0}))
    """
    said = json.loads(text)
    makers = [_BUILT_IN.get(name) or _maker(name) for name in said["kinds"]]
    values: list[Any] = [*said["atoms"], *map(tuple, said["tuples"]), *map(frozenset, said["sets"])]
    for kind, *parts in said["made"]:
        values.append(makers[kind](map(values.__getitem__, parts)))
    return values[said["whole"]]


class _Writer:
    """What is written so far, in groups that stand behind each other, and where each value has its place."""

    def __init__(self) -> None:
        self._kinds: dict[str, int] = {}
        self._groups: dict[str, list[Any]] = {"atoms": [], "tuples": [], "sets": [], "made": []}
        self._places: dict[object, tuple[str, int]] = {}

    def place(self, value: object) -> tuple[str, int]:
        """Give the group of a value and its place there, writing what is not written yet."""
        key = (type(value), repr(value)) if type(value) in _ATOMS else id(value)
        if key not in self._places:
            group, entry = self._grouped(value)
            self._places[key] = group, len(self._groups[group])
            self._groups[group].append(entry)
        return self._places[key]

    def _grouped(self, value: Any) -> tuple[str, object]:  # noqa: ANN401 - of any class
        """Give the group that a value stands in, and what is written there."""
        kind = type(value)
        if kind in _ATOMS:
            return "atoms", value
        if kind in {tuple, frozenset} and all(type(part) in _ATOMS for part in value):
            return "tuples" if kind is tuple else "sets", list(value)
        name, parts = _parted(value)
        return "made", [self._kinds.setdefault(name, len(self._kinds)), *map(self.place, parts)]

    def said(self, whole: tuple[str, int]) -> dict[str, object]:
        """Give all that is written, and the place of the whole among it."""
        sizes = accumulate(map(len, self._groups.values()), initial=0)
        starts = dict(zip(self._groups, sizes, strict=False))

        def final(place: tuple[str, int]) -> int:
            group, at = place
            return starts[group] + at

        rows = [[kind, *map(final, parts)] for kind, *parts in self._groups["made"]]
        return {"kinds": [*self._kinds], **self._groups, "made": rows, "whole": final(whole)}


def _parted(value: Any) -> tuple[str, Sequence[Any]]:  # noqa: ANN401 - of any class
    """Give what a value is, and its parts."""
    kind = type(value)
    if kind is tuple:
        return "tuple", value
    if kind is frozenset:
        return "set", tuple(value)
    if kind in {dict, MappingProxyType}:
        return "dict" if kind is dict else "mapping", _pairs(value)
    if kind is time:
        return "time", (value.isoformat(),)
    name = f"{kind.__module__}:{kind.__qualname__}"
    if kind.__module__.partition(".")[0] == LIBRARY:
        if issubclass(kind, Enum):
            return name, (value.value,)
        if issubclass(kind, dict):
            return name, _pairs(value)
        if issubclass(kind, tuple):
            return name, value
        if is_dataclass(kind):
            return name, [getattr(value, field.name) for field in fields(kind) if field.init]
    raise TypeError(f"a {name} cannot be written")


def _pairs(mapping: Mapping[Any, Any]) -> Sequence[Any]:
    return [part for pair in mapping.items() for part in pair]


def _maker(name: str) -> _Maker:
    """Give what makes a value of one of the library's classes of its parts."""
    module, _, named = name.partition(":")
    if module.partition(".")[0] != LIBRARY:
        raise ValueError(f"{name} is none of this library")
    kind: Any = getattr(import_module(module), named)
    if issubclass(kind, Enum | tuple):
        return lambda parts: kind(*parts)
    if issubclass(kind, dict):
        return lambda parts: kind(_mapping(parts))
    # Of what is no dataclass this is a TypeError.
    given = [field for field in fields(kind) if field.init]
    if not any(field.kw_only for field in given):
        return lambda parts: kind(*parts)
    names = [field.name for field in given]
    return lambda parts: kind(**dict(zip(names, parts, strict=True)))
