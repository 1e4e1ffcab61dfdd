"""Reading the groups of ``lexicon.yaml`` that rules ask for by name: every one is there, and no other."""

from dataclasses import fields
from typing import TypeVar

from fuzzytime.documents.nodes import Node
from fuzzytime.language.grammar.lexicon.no_time_groups import NoTimes
from fuzzytime.language.grammar.lexicon.verb_groups import Doing
from fuzzytime.language.grammar.lexicon.word_groups import BesideTimes, ClosedClasses, Words
from fuzzytime.language.grammar.word_tables.tables import Tables
from fuzzytime.spelling import suggestion

_Groups = TypeVar("_Groups", ClosedClasses, BesideTimes, Doing, NoTimes)


def read_groups(tables: Tables, section: str, kind: type[_Groups]) -> _Groups:
    """Read a section whose rows are the fields of a class: lists of words, and of ``<groups>`` above."""
    names: dict[str, str] = {field.name.replace("_", " "): field.name for field in fields(kind)}
    found: dict[str, Words] = {}
    for name, row in tables.rows(section, names):
        found[name.text] = _group(tables, row, f"{section}.{name.text}", found)
    return kind(**{field: found.get(name, frozenset()) for name, field in names.items()})


def _group(tables: Tables, node: Node, key: str, above: dict[str, Words]) -> Words:
    """Read one group: a word may stand in it once, but groups that it holds may share some."""
    said: set[str] = set()
    held: set[str] = set()
    for item in tables.reader.sequence(node, key):
        text = tables.reader.phrase(item, key)
        if text.startswith("<") and text.endswith(">"):
            name = text[1:-1]
            if name not in above:
                message = f"a group in another must stand above it, got {text!r}{suggestion(name, above)}"
                tables.reader.mistake(item, key, message)
            held |= above.get(name, frozenset())
        else:
            if text in said or text in held:
                tables.reader.mistake(item, key, f"words of a group must differ, got {text!r} twice")
            said.add(text)
    return frozenset(said | held)
