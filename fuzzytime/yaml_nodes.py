"""YAML read safely: texts with their places, and every mistake found in one run.

PyYAML's objects lose the places of keys and values, turn ``on`` into true and ``1:30`` into ninety, and
follow aliases into bombs. So a document is read into a tree in which every scalar is still text (see
`fuzzytime.yaml_tree`); converting is the caller's, through a `Reader`, which collects mistakes instead of
stopping at the first. Aliases, anchors, tags, merge keys, several documents, and what is too deep, too long
or above `MAX_BYTES` are refused.
"""

import math
import re
from collections.abc import Callable, Collection, Iterable
from pathlib import Path
from typing import NoReturn, TypeVar

from fuzzytime.errors import DocumentError, FuzzytimeError, Mistake
from fuzzytime.spelling import nearest, suggestion
from fuzzytime.times import format_duration, parse_duration
from fuzzytime.yaml_tree import MAX_DEPTH, Mapping, Node, Place, Scalar, Sequence, TreeError, parse_tree

__all__ = ["MAX_BYTES", "MAX_DEPTH", "Mapping", "Node", "Reader", "Scalar", "Sequence"]

MAX_BYTES = 1 << 20

_NUMBER = re.compile(r"[-+]?(\d+(\.\d*)?|\.\d+)([eE][-+]?\d+)?")
_T = TypeVar("_T")


class Reader:
    """One document's text, the conversions of its nodes, and the mistakes met so far.

    A conversion that fails notes a `Mistake` and gives a neutral value (0, an empty text, an empty list), so
    that reading goes on; `finish` raises them all. Keys of mistakes are paths such as ``rules[0].if``.
    """

    def __init__(self, path: str, source: bytes | str) -> None:
        self.path = path
        self.mistakes: list[Mistake] = []
        self.text = self._decoded(source)
        self.lines = self.text.splitlines()

    @classmethod
    def of_file(cls, path: Path, shown: str | None = None) -> "Reader":
        """Read a file, at most one byte more than `MAX_BYTES` of it; messages call it ``shown``.

        Raises
        ------
        OSError
            If it cannot be read.
        DocumentError
            If it is too large or is not UTF-8.
        """
        with path.open("rb") as stream:
            return cls(shown or str(path), stream.read(MAX_BYTES + 1))

    def _decoded(self, source: bytes | str) -> str:
        raw = source.encode("utf-8", "surrogatepass") if isinstance(source, str) else source
        if len(raw) > MAX_BYTES:
            self._stop(0, 0, f"a file must not be larger than {MAX_BYTES:,} bytes")
        try:
            text = raw.decode("utf-8-sig")
        except UnicodeDecodeError as error:
            before = raw[: error.start].decode("utf-8", "replace")
            self._stop(
                before.count("\n"),
                len(before) - before.rfind("\n") - 1,
                f"text must be UTF-8, got byte 0x{raw[error.start]:02x}",
            )
        # Other line ends than these are text to YAML, and must not move the places of mistakes.
        return re.sub(
            r"\r\n?|[\x0b\x0c\x1c-\x1e\x85\u2028\u2029]", lambda m: "\n" if m[0][0] == "\r" else " ", text
        )

    def _stop(self, line: int, column: int, message: str) -> NoReturn:
        """Raise the mistakes met so far and one after which nothing can be read."""
        source = self.lines[line] if hasattr(self, "lines") and line < len(self.lines) else ""
        raise DocumentError((*self.mistakes, Mistake(self.path, line + 1, column + 1, "", message, source)))

    # -- the tree -------------------------------------------------------------------------------------------

    def root(self) -> Node:
        """Parse the document; what is not allowed in it but can be read over is noted.

        Raises
        ------
        DocumentError
            If it is not one well-formed YAML document within the limits.
        """
        try:
            return parse_tree(self.text, self._note)
        except TreeError as error:
            line, column = error.line, error.column
            if line >= len(self.lines):
                line, column = max(0, len(self.lines) - 1), len(self.lines[-1]) if self.lines else 0
            self._stop(line, column, error.message)

    def _note(self, place: Place, message: str) -> None:
        source = self.lines[place.line] if place.line < len(self.lines) else ""
        self.mistakes.append(Mistake(self.path, place.line + 1, place.column + 1, "", message, source))

    # -- mistakes -------------------------------------------------------------------------------------------

    def mistake(self, node: Node, key: str, message: str, offset: int = 0) -> None:
        """Note a mistake at a node, or ``offset`` characters into a scalar's text.

        Of a node that was refused already nothing more is said.
        """
        if isinstance(node, Scalar) and node.refused:
            return
        line, column = node.line, node.column
        if isinstance(node, Scalar) and offset:
            line, column = self._place_inside(node, offset)
        source = self.lines[line] if line < len(self.lines) else ""
        self.mistakes.append(Mistake(self.path, line + 1, column + 1, key, message, source))

    def place(self, node: Node) -> str:
        """``file:line`` of a node, for explanations."""
        return f"{self.path}:{node.line + 1}"

    def _place_inside(self, scalar: Scalar, offset: int) -> tuple[int, int]:
        """Line and column of a character of a scalar's text, which YAML may have quoted or folded."""
        at, source = scalar.index, self.text
        if scalar.quoted and source[at : at + 1] in "|>":
            at = source.find("\n", at) + 1
        elif scalar.quoted:
            at += 1
        for character in scalar.text[:offset]:
            if character.isspace():
                while at < len(source) and source[at].isspace():
                    at += 1
                continue
            while at < len(source) and source[at] != character:
                at += 1
            at += 1
        while at < len(source) and source[at].isspace() and offset < len(scalar.text):
            at += 1
        return source.count("\n", 0, at), at - (source.rfind("\n", 0, at) + 1)

    def finish(self) -> None:
        """Raise every mistake noted.

        Raises
        ------
        DocumentError
            If there is any.
        """
        if self.mistakes:
            raise DocumentError(tuple(self.mistakes))

    # -- conversions ----------------------------------------------------------------------------------------

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

    def choice(self, node: Node, key: str, known: Collection[str]) -> str:
        """Give a scalar's text that must be one of the known ones."""
        text = self.string(node, key)
        if isinstance(node, Scalar) and text not in known:
            self.mistake(node, key, f"must be one of the known words, got {text!r}{suggestion(text, known)}")
            return ""
        return text

    def strings(self, node: Node, key: str) -> tuple[str, ...]:
        """Give one text, or a list of texts; none may be empty."""
        if isinstance(node, Scalar):
            return (self.phrase(node, key),)
        return tuple(self.phrase(item, f"{key}[{i}]") for i, item in enumerate(self.sequence(node, key)))

    def choices(self, node: Node, key: str, known: Collection[str]) -> tuple[str, ...]:
        """Give one text, or a list of texts, that must all be known ones."""
        if isinstance(node, Scalar):
            return (self.choice(node, key, known),)
        items = enumerate(self.sequence(node, key))
        return tuple(self.choice(item, f"{key}[{i}]", known) for i, item in items)

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
