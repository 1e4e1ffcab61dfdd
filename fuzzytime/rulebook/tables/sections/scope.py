"""What a section is read with."""

from collections.abc import Iterable
from dataclasses import dataclass

from fuzzytime.documents.nodes import Node, Reader
from fuzzytime.rulebook.tables.vocabulary import Vocabulary


@dataclass(frozen=True, slots=True)
class Scope:
    """One document, and the names that all documents declare."""

    reader: Reader
    names: Vocabulary

    def row(
        self, node: Node, key: str, allowed: Iterable[str], required: Iterable[str] = ()
    ) -> dict[str, Node]:
        """Give the values of a mapping that may also say where its numbers come from (``source``)."""
        found = self.reader.mapping(node, key, (*allowed, "source"), required)
        source = found.pop("source", None)
        if source is not None:
            self.reader.phrase(source, f"{key}.source" if key else "source")
        return found
