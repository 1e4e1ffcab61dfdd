"""YAML read safely: texts with their places, and every mistake found in one run.

PyYAML's objects lose the places of keys and values, turn ``on`` into true and ``1:30`` into ninety, and
follow aliases into bombs. So a document is read into a tree in which every scalar is still text (see
`fuzzytime.documents.tree`); converting is the caller's, through a `Reader`, which collects mistakes
instead of stopping at the first. Aliases, anchors, tags and merge keys are refused.
"""

import math
import re
from collections.abc import Callable, Collection, Iterable
from typing import TypeVar

from fuzzytime.documents.document import MAX_BYTES, Document
from fuzzytime.documents.tree import MAX_DEPTH, Mapping, Node, Scalar, Sequence
from fuzzytime.errors import FuzzytimeError
from fuzzytime.spelling import nearest, suggestion
from fuzzytime.times import format_duration, parse_duration

__all__ = ["MAX_BYTES", "MAX_DEPTH", "Mapping", "Node", "Reader", "Scalar", "Sequence"]

_NUMBER = re.compile(r"[-+]?(\d+(\.\d*)?|\.\d+)([eE][-+]?\d+)?")
_T = TypeVar("_T")


class Reader(Document):
    """One document, and the conversions of its nodes.

    A conversion that fails notes a mistake and gives a neutral value (0, an empty text, an empty list), so
    that reading goes on.
    """

    def mapping(
        self,
        node: Node,
        key: str,
        allowed: Collection[str] | None = None,
        required: Iterable[str] = (),
    ) -> dict[str, Node]:
        """Give a mapping's values by key; unknown, missing and duplicate keys are mistakes."""
        if not isinstance(node, Mapping):
            self.mistake(node, key, f"must be a mapping (key: value), got {_kind(node)}")
            return {}
        found: dict[str, Node] = {}
        first: dict[str, int] = {}
        for name, value in node.entries:
            if name.refused:
                continue
            path = f"{key}.{name.text}" if key else name.text
            if name.text in first:
                self.mistake(
                    name, path, f"keys must differ, got {name.text!r} as on line {first[name.text] + 1}"
                )
                continue
            first[name.text] = name.line
            if allowed is not None and name.text not in allowed:
                self.mistake(name, path, f"unknown key {name.text!r}{suggestion(name.text, allowed)}")
                continue
            found[name.text] = value
        for name_required in required:
            if name_required not in first:
                self.missing(node, key, (name_required,))
        return found

    def missing(self, node: Node, key: str, names: Collection[str], message: str = "") -> None:
        """Note that a mapping has none of these keys.

        Nothing is said where something was said already: of what is no mapping, of a key that was refused,
        and where one of these keys is there but misspelt.
        """
        if not isinstance(node, Mapping):
            return
        for name, _ in node.entries:
            if name.refused or (name.text not in names and nearest(name.text, names)):
                return
        self.mistake(node, key, message or f"missing key {' or '.join(map(repr, names))}")

    def one_of(self, node: Node, key: str, names: Collection[str], message: str) -> str | None:
        """Give the one key of these that a mapping has; none or several is a mistake."""
        keys = self.keys(node)
        given = [name for name in keys if name in names]
        if not given:
            self.missing(node, key, names, message)
        for name in given[1:]:
            self.mistake(keys[name], f"{key}.{name}", f"{message}, got {given[0]!r} as well")
        return given[0] if len(given) == 1 else None

    def keys(self, node: Node) -> dict[str, Scalar]:
        """Give the places of a mapping's keys."""
        if not isinstance(node, Mapping):
            return {}
        return {name.text: name for name, _ in node.entries if not name.refused}

    def refuse_keys(self, node: Node, key: str, names: Iterable[str], message: str) -> None:
        """Note a mistake at each of these keys that a mapping has."""
        keys = self.keys(node)
        for name in names:
            if name in keys:
                self.mistake(keys[name], f"{key}.{name}", message)

    def sequence(self, node: Node, key: str, length: int | None = None) -> tuple[Node, ...]:
        """Give a list's nodes, of one length if given."""
        if not isinstance(node, Sequence):
            self.mistake(node, key, f"must be a list, got {_kind(node)}")
            return ()
        if length is not None and len(node.items) != length:
            self.mistake(node, key, f"must hold {length} items, got {len(node.items)}")
            return ()
        return node.items

    def string(self, node: Node, key: str) -> str:
        """Give a scalar's text."""
        if not isinstance(node, Scalar):
            self.mistake(node, key, f"must be a text, got {_kind(node)}")
            return ""
        return node.text

    def phrase(self, node: Node, key: str) -> str:
        """Give a scalar's text, which must say something."""
        text = self.string(node, key)
        if isinstance(node, Scalar) and not text.strip():
            self.mistake(node, key, "must not be empty")
        return text

    def choice(self, node: Node, key: str, known: Collection[str], *, lower: bool = False) -> str:
        """Give a scalar's text that must be one of the known ones, in lower case if asked for."""
        text = self.string(node, key)
        text = text.lower() if lower else text
        if isinstance(node, Scalar) and text not in known:
            self.mistake(node, key, f"must be one of the known words, got {text!r}{suggestion(text, known)}")
            return ""
        return text

    def strings(self, node: Node, key: str) -> tuple[str, ...]:
        """Give one text, or a list of texts; none may be empty."""
        if isinstance(node, Scalar):
            return (self.phrase(node, key),)
        # Word tables hold thousands: the path of one is made where it has a mistake.
        return tuple(
            item.text if isinstance(item, Scalar) and item.text.strip() else self.phrase(item, f"{key}[{i}]")
            for i, item in enumerate(self.sequence(node, key))
        )

    def choices(
        self, node: Node, key: str, known: Collection[str], *, lower: bool = False
    ) -> tuple[str, ...]:
        """Give one text, or a list of texts, that must all be known ones."""
        items = self.one_or_more(node, key)
        return tuple(self.choice(item, path, known, lower=lower) for item, path in items)

    def one_or_more(self, node: Node, key: str) -> list[tuple[Node, str]]:
        """Give one value, or those of a list, each with its path."""
        if isinstance(node, Scalar):
            return [(node, key)]
        return [(item, f"{key}[{i}]") for i, item in enumerate(self.sequence(node, key))]

    def boolean(self, node: Node, key: str) -> bool:
        """Give ``true`` or ``false``."""
        return self.choice(node, key, ("true", "false")) == "true"

    def number(self, node: Node, key: str, low: float = -math.inf, high: float = math.inf) -> float:
        """Give a finite number between two bounds."""
        return self._converted(node, key, _to_number, (low, high), "{:g}".format)

    def whole(self, node: Node, key: str, low: int, high: int) -> int:
        """Give a whole number between two bounds."""
        return int(self._converted(node, key, _to_whole, (low, high), "{:g}".format))

    def duration(self, node: Node, key: str, low: float = -math.inf, high: float = math.inf) -> float:
        """Give a duration in seconds between two bounds."""
        return self._converted(node, key, parse_duration, (low, high), format_duration)

    def _converted(
        self,
        node: Node,
        key: str,
        convert: Callable[[str], float],
        bounds: tuple[float, float],
        shown: Callable[[float], str],
    ) -> float:
        if not isinstance(node, Scalar):
            self.mistake(node, key, f"must be a single value, got {_kind(node)}")
            return 0.0
        value = self.read(node, key, convert)
        if value is None:
            return 0.0
        low, high = bounds
        if low <= value <= high and math.isfinite(value):
            return value
        limits = (
            f"between {shown(low)} and {shown(high)}" if math.isfinite(high) else f"at least {shown(low)}"
        )
        self.mistake(node, key, f"must be {limits if math.isfinite(value) else 'finite'}, got {node.text!r}")
        return 0.0

    def read(self, node: Scalar, key: str, convert: Callable[[str], _T]) -> _T | None:
        """Convert a scalar's text by a function whose `FuzzytimeError` becomes a mistake here."""
        try:
            return convert(node.text)
        except FuzzytimeError as error:
            self.mistake(node, key, str(error))
            return None


def _kind(node: Node) -> str:
    if isinstance(node, Scalar):
        return repr(node.text)
    return "a list" if isinstance(node, Sequence) else "a mapping"


def _to_number(text: str) -> float:
    if not _NUMBER.fullmatch(text) or not math.isfinite(float(text)):
        raise FuzzytimeError(f"must be a number, got {text!r}")
    return float(text)


def _to_whole(text: str) -> float:
    if not re.fullmatch(r"[-+]?\d{1,15}", text):
        raise FuzzytimeError(f"must be a whole number, got {text!r}")
    return int(text)
