"""A YAML document as a tree of texts with their places."""

from dataclasses import dataclass

MAX_DEPTH = 32


@dataclass(frozen=True, slots=True)
class Scalar:
    """A text, and where it starts: line and column from 0, index in characters.

    ``refused`` marks what was no text, and was reported: nothing more need be said about it.
    """

    text: str
    line: int
    column: int
    index: int
    quoted: bool = False
    refused: bool = False


@dataclass(frozen=True, slots=True)
class Sequence:
    """A list of nodes."""

    items: tuple["Node", ...]
    line: int
    column: int
    index: int


@dataclass(frozen=True, slots=True)
class Mapping:
    """Keys, as scalars with their places, and their values; duplicates are still there."""

    entries: tuple[tuple[Scalar, "Node"], ...]
    line: int
    column: int
    index: int


Node = Scalar | Sequence | Mapping


@dataclass(frozen=True, slots=True)
class Place:
    """Line and column from 0, index in characters."""

    line: int
    column: int
    index: int


class TreeError(Exception):
    """What stops reading, and where."""

    def __init__(self, message: str, line: int, column: int) -> None:
        super().__init__(message)
        self.message = message
        self.line = line
        self.column = column
