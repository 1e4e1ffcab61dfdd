"""One file of word tables: its sections, and the entries gathered from them."""

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from fuzzytime.language.grammar.lexicon import Entry, form_of
from fuzzytime.times import parse_clock
from fuzzytime.yaml_nodes import Node, Reader, Scalar

FULL_STOP_BELOW = 6
"""Words shorter than this may be typed with a full stop, as abbreviations are."""

MORE_WORDS = 0.1
"""What each further word of a form weighs: "sometime around" is one preposition, not one and a hedge."""

SOURCE = "source"
"""The key of a section that says where its words are from."""

Form = tuple[str, ...]


class Tables:
    """One file of word tables: its mappings, and the entries gathered from them."""

    def __init__(self, path: Path, sections: Iterable[str]) -> None:
        self.reader = Reader.of_file(path)
        names = ("fuzzytime", "language", *sections)
        self.sections = self.reader.mapping(self.reader.root(), "", names, names)
        self.entries: list[Entry] = []
        self.seen: dict[tuple[Form, str], int] = {}
        if "fuzzytime" in self.sections:
            self.reader.whole(self.sections["fuzzytime"], "fuzzytime", 1, 1)

    def rows(self, section: str) -> list[tuple[Scalar, Node]]:
        """Give the keys and values of a section."""
        node = self.sections.get(section)
        if node is None:
            return []
        values = self.reader.mapping(node, section)
        keys = self.reader.keys(node)
        return [(keys[name], value) for name, value in values.items()]

    def forms(self, node: Node, key: str) -> list[Form]:
        """Give ways to say something, cut into words."""
        found = []
        for text in self.reader.strings(node, key):
            if form_of(text):
                found.append(form_of(text))
            else:
                self.reader.mistake(node, key, "a way to say something must hold a word, got none")
        return found

    def table(
        self,
        section: str,
        allowed: dict[str, bool],
        make: Callable[[str, dict[str, Node]], Iterable[tuple[str, Any]]],
    ) -> None:
        """Add the entries of a section whose rows are mappings: ``make`` gives categories and meanings.

        ``allowed`` says which keys a row may have, and which it must.
        """
        for name, node in self.rows(section):
            key = f"{section}.{name.text}"
            required = [field for field, must in allowed.items() if must]
            fields = self.reader.mapping(node, key, (*allowed, "also"), required)
            if any(field not in fields for field in required):
                continue
            said = [form_of(name.text)]
            if "also" in fields:
                said += self.forms(fields["also"], f"{key}.also")
            for category, value in make(name.text, fields):
                self.add(name, key, category, value, said)

    def plain(
        self, section: str, make: Callable[[Scalar], Iterable[tuple[str, Any]]], *, named: bool
    ) -> None:
        """Add the entries of a section whose rows are lists of forms; ``named``: the key is a form too."""
        for name, node in self.rows(section):
            said = [form_of(name.text)] if named else []
            said += self.forms(node, f"{section}.{name.text}")
            for category, value in make(name):
                self.add(name, f"{section}.{name.text}", category, value, said)

    def add(self, node: Node, key: str, category: str, value: object, forms: Iterable[Form]) -> None:
        """Add entries; the same words must not have two meanings in one category."""
        for form in forms:
            self.entries.append(Entry(form, category, value, MORE_WORDS * (len(form) - 1)))
            if self.seen.setdefault((form, category), len(self.entries)) != len(self.entries):
                self.reader.mistake(
                    node, key, f"words must have one meaning in a table, got {' '.join(form)!r} twice"
                )

    def clock(self, node: Node, key: str) -> int:
        """Read a time of day as seconds since midnight."""
        found = self.reader.read(node, key, parse_clock) if isinstance(node, Scalar) else None
        if found is None:
            if not isinstance(node, Scalar):
                self.reader.string(node, key)
            return 0
        return found.hour * 3600 + found.minute * 60 + found.second

    def words(self, section: str, key: str | None = None) -> list[Form]:
        """Give a section that is one list of forms, or a list within it."""
        node = self.sections.get(section)
        if node is None:
            return []
        if key is None:
            return self.forms(node, section)
        fields = self.reader.mapping(node, section)
        return self.forms(fields[key], f"{section}.{key}") if key in fields else []

    def single_words(self, section: str, key: str | None = None) -> frozenset[str]:
        """Give a section, or a list within it, of forms that are one word each."""
        return frozenset(form[0] for form in self.words(section, key))


def numbers(tables: Tables, section: str) -> dict[str, int]:
    """Give a section's numbers by their words."""
    found = {}
    for name, node in tables.rows(section):
        for form in tables.forms(node, f"{section}.{name.text}"):
            if len(form) == 1:
                found[form[0]] = tables.reader.whole(name, f"{section}.{name.text}", 0, 99)
    return found


def by_form(tables: Tables, section: str) -> dict[Form, str]:
    """Give a section's keys by the ways to say them."""
    return {
        form: name.text
        for name, node in tables.rows(section)
        for form in tables.forms(node, f"{section}.{name.text}")
    }
