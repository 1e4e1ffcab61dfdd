"""Frozen values written as JSON, and made again of it: what tables became, in a form that can hold no code.

All that a value consists of stands in one row, each part before what is made of it: first texts and numbers,
as they are, then rows of places: of a kind, among the names of kinds, and of the parts. What is shared is
written once.
"""

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields, is_dataclass
from datetime import time
from enum import Enum
from importlib import import_module
from types import MappingProxyType
from typing import Any

LIBRARY = "fuzzytime"
"""Whose classes are written and made: those of other modules are not."""

_Maker = Callable[[Sequence[Any]], object]

_ATOMS = frozenset({str, int, float, bool})


def _mapping(parts: Sequence[Any]) -> dict[Any, Any]:
    return dict(zip(parts[::2], parts[1::2], strict=True))


_BUILT_IN: Mapping[str, _Maker] = {
    "tuple": tuple,
    "set": frozenset,
    "dict": _mapping,
    "mapping": lambda parts: MappingProxyType(_mapping(parts)),
    "time": lambda parts: time.fromisoformat(parts[0]),
}


def written(value: object) -> str:
    """Give a value as JSON.

    Raises
    ------
    TypeError
        If it, or a part of it, is no text, number, tuple, frozenset, mapping, time of day, or dataclass,
        enumeration or mapping of this library.
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
    values: list[Any] = said["atoms"]
    for kind, *parts in said["made"]:
        values.append(makers[kind]([values[part] for part in parts]))
    return values[said["whole"]]


class _Writer:
    """The atoms and rows so far, and where each value already has its place.

    Until it is known how many atoms there are, theirs are counted down from -1.
    """

    def __init__(self) -> None:
        self._kinds: dict[str, int] = {}
        self._atoms: dict[tuple[type, str], object] = {}
        self._places: dict[object, int] = {}
        self._rows: list[list[int]] = []

    def place(self, value: object) -> int:
        """Give the place of a value, writing what is not written yet."""
        atom = (type(value), repr(value)) if value is None or type(value) in _ATOMS else None
        key = atom or id(value)
        if key not in self._places:
            if atom:
                self._atoms[atom] = value
                self._places[key] = -len(self._atoms)
            else:
                name, parts = _parted(value)
                row = [self._kinds.setdefault(name, len(self._kinds)), *map(self.place, parts)]
                self._places[key] = len(self._rows)
                self._rows.append(row)
        return self._places[key]

    def said(self, whole: int) -> dict[str, object]:
        """Give all that is written, and the place of the whole among it."""
        count = len(self._atoms)

        def final(place: int) -> int:
            return -place - 1 if place < 0 else place + count

        rows = [[kind, *map(final, parts)] for kind, *parts in self._rows]
        return {
            "kinds": [*self._kinds],
            "atoms": [*self._atoms.values()],
            "made": rows,
            "whole": final(whole),
        }


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
    if issubclass(kind, Enum):
        return lambda parts: kind(parts[0])
    if issubclass(kind, dict):
        return lambda parts: kind(_mapping(parts))
    # Of what is no dataclass this is a TypeError.
    given = [field for field in fields(kind) if field.init]
    if not any(field.kw_only for field in given):
        return lambda parts: kind(*parts)
    names = [field.name for field in given]
    return lambda parts: kind(**dict(zip(names, parts, strict=True)))
