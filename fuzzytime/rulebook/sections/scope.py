"""What a section is read with."""

from dataclasses import dataclass

from fuzzytime.rulebook.vocabulary import Vocabulary
from fuzzytime.yaml_nodes import Reader


@dataclass(frozen=True, slots=True)
class Scope:
    """One document, and the names that all documents declare."""

    reader: Reader
    names: Vocabulary
