"""Reading the groups of ``lexicon.yaml`` that rules ask for by name: every one is there, and no other."""

from dataclasses import fields
from typing import TypeVar

from fuzzytime.language.grammar.word_groups import BesideTimes, ClosedClasses, Doing, Words
from fuzzytime.language.grammar.word_tables.tables import SOURCE, Tables
from fuzzytime.spelling import suggestion
from fuzzytime.yaml_nodes import Node

_Groups = TypeVar("_Groups", ClosedClasses, BesideTimes, Doing)


def read_groups(tables: Tables, section: str, kind: type[_Groups]) -> _Groups:
    """Read a section whose rows are the fields of a class: lists of words, and of ``<groups>`` above."""
    node = tables.sections.get(section)
    names: dict[str, str] = {field.name.replace("_", " "): field.name for field in fields(kind)}
    known = (*names, SOURCE)
    rows = tables.reader.mapping(node, section, known, list(names)) if node is not None else {}
    found: dict[str, Words] = {}
    for name, row in rows.items():
        if name in names:
            found[name] = _group(tables, row, f"{section}.{name}", found)
    return kind(**{field: found.get(name, frozenset()) for name, field in names.items()})


def _group(tables: Tables, node: Node, key: str, above: dict[str, Words]) -> Words:
    """Read one group: a word may stand in it once, but groups that it holds may share some."""
    said: set[str] = set()
    held: set[str] = set()
    for place, item in enumerate(tables.reader.sequence(node, key)):
        here = f"{key}[{place}]"
        text = tables.reader.phrase(item, here)
        if text.startswith("<") and text.endswith(">"):
            name = text[1:-1]
            if name not in above:
                message = f"a group in another must stand above it, got {text!r}{suggestion(name, above)}"
                tables.reader.mistake(item, here, message)
            held |= above.get(name, frozenset())
        elif text:
            if text in said | held:
                tables.reader.mistake(item, here, f"words of a group must differ, got {text!r} twice")
            said.add(text)
    return frozenset(said | held)
