"""One YAML document: its text, its tree, the places in it, and the mistakes met so far.

Several documents, and what is too deep, too long or above `MAX_BYTES` are refused.
"""

import re
from pathlib import Path
from typing import NoReturn, Self

from fuzzytime.documents.tree import Node, Place, Scalar, TreeError
from fuzzytime.errors import DocumentError, Mistake

MAX_BYTES = 1 << 20


class Document:
    """A document's text, and the mistakes that were met in it; `finish` raises them all.

    Keys of mistakes are paths such as ``rules[0].if``.
    """

    def __init__(self, path: str, source: bytes | str) -> None:
        self.path = path
        self.mistakes: list[Mistake] = []
        self.text = self._decoded(source)
        self.lines = self.text.splitlines()

    @classmethod
    def of_file(cls, path: Path, shown: str | None = None) -> Self:
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

    def root(self) -> Node:
        """Parse the document; what is not allowed in it but can be read over is noted.

        Raises
        ------
        DocumentError
            If it is not one well-formed YAML document within the limits.
        """
        # The parser takes a while to import, and what is kept needs none.
        from fuzzytime.documents.parsing import parse_tree

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
