"""One file of word tables: its sections, and the entries gathered from them."""

from collections.abc import Callable, Collection, Iterable
from dataclasses import dataclass
from enum import StrEnum
from itertools import product
from pathlib import Path
from typing import Any, TypeVar

from fuzzytime.documents.nodes import Mapping, Node, Scalar
from fuzzytime.language.grammar.lexicon import Entry, Form, Forms, form_of
from fuzzytime.language.grammar.word_tables.layers import HEAD, LayeredReader
from fuzzytime.times import parse_clock

FULL_STOP_BELOW = 6
"""Words shorter than this may be typed with a full stop, as abbreviations are."""

MORE_WORDS = 0.1
"""What each further word of a form weighs: "sometime around" is one preposition, not one and a hedge."""

NO_WORD = "a way to say something must hold a word, got none"

SOURCE = "source"
"""The key of a section that says where its words are from."""

WORDS = "words"
"""The key of a list that has a source."""

CHOICE = "|"
"""Between words one of which is said."""


_Choice = TypeVar("_Choice", bound=StrEnum)


class Tables:
    """One file of word tables, with others laid over it: its mappings, and the entries gathered from them."""

    def __init__(self, path: Path, sections: Collection[str], over: Iterable[Path] = ()) -> None:
        self.reader = LayeredReader.of_file(path)
        names = (*HEAD, *sections)
        self.sections = self.reader.mapping(self.reader.layered(over, sections), "", names, names)
        self._rows: dict[str, dict[str, tuple[Scalar, Node]]] = {}
        self._sourced()
        self.entries: list[Entry] = []
        self._seen: dict[tuple[Form, str], tuple[Node, str]] = {}
        if "fuzzytime" in self.sections:
            self.reader.whole(self.sections["fuzzytime"], "fuzzytime", 1, 1)

    def _sourced(self) -> None:
        """Read where the words of sections are from; a list with a source stands under "words" beside it."""
        for name, node in self.sections.items():
            found = {key.text: value for key, value in node.entries} if isinstance(node, Mapping) else {}
            if SOURCE in found:
                self.reader.phrase(found[SOURCE], f"{name}.{SOURCE}")

    def rows(self, section: str, names: Collection[str] | None = None) -> list[tuple[Scalar, Node]]:
        """Give the keys and values of a section, without its source.

        Where ``names`` are given, at first, they are the keys that must be there, and no other may be.
        """
        if section not in self._rows:
            node = self.sections.get(section)
            known = None if names is None else (*names, SOURCE)
            values = {} if node is None else self.reader.mapping(node, section, known, names or ())
            keys = {} if node is None else self.reader.keys(node)
            self._rows[section] = {
                name: (keys[name], value) for name, value in values.items() if name != SOURCE
            }
        return list(self._rows[section].values())

    def forms(self, node: Node, key: str) -> list[Form]:
        """Give ways to say something, cut into words: "could|can you" is two of them."""
        found = []
        for text in self.reader.strings(node, key):
            ways = [form_of(way) for way in _ways(text)]
            found += [form for form in ways if form]
            if text.strip() and not all(ways):
                self.reader.mistake(node, key, NO_WORD)
        return found

    def table(
        self,
        section: str,
        allowed: dict[str, bool],
        make: "Callable[[str, Row], Iterable[tuple[str, Any]]]",
        one_of: Collection[str] = (),
        otherwise: Callable[[Form], Iterable[Form]] | None = None,
    ) -> None:
        """Add the entries of a section whose rows are mappings: ``make`` gives categories and meanings.

        ``allowed`` says which keys a row may have, and which it must; it must also have ``one_of`` some.
        What ``otherwise`` gives are further ways to write a form, where no row says it so.
        """
        further: list[tuple[str, object, Form]] = []
        message = f"must have one of {', '.join(map(repr, one_of))}"
        for name, node in self.rows(section):
            key = f"{section}.{name.text}"
            required = [field for field, must in allowed.items() if must]
            fields = self.reader.mapping(node, key, (*allowed, "also"), required)
            if any(field not in fields for field in required):
                continue
            if one_of and self.reader.one_of(node, key, one_of, message) is None:
                continue
            row = Row(self, key, fields)
            said = [form_of(name.text), *row.forms("also")]
            for category, value in make(name.text, row):
                self.add(name, key, category, value, said)
                ways = (way for form in said for way in (otherwise(form) if otherwise else ()))
                further += ((category, value, way) for way in ways)
        for category, value, form in further:
            if (form, category) not in self._seen:
                self._enter(form, category, value)
                self._seen[form, category] = self.sections[section], section

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
            if not form:
                self.reader.mistake(node, key, NO_WORD)
                continue
            self._enter(form, category, value)
            before = self._seen.setdefault((form, category), (node, key))
            if before != (node, key):
                # Of two files, the upper one is where it can be mended.
                at, where = before if self.reader.is_over(before[0], node) else (node, key)
                message = f"words must have one meaning in a table, got {' '.join(form)!r} twice"
                self.reader.mistake(at, where, message)

    def _enter(self, form: Form, category: str, value: object) -> None:
        self.entries.append(Entry(form, category, value, MORE_WORDS * (len(form) - 1)))

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
        if key is None and not isinstance(node, Mapping):
            return self.forms(node, section)
        self.rows(section, (WORDS,) if key is None else None)
        row = self._rows[section].get(key or WORDS)
        return [] if row is None else self.forms(row[1], f"{section}.{key or WORDS}")

    def single_words(self, section: str, key: str | None = None) -> frozenset[str]:
        """Give a section, or a list within it, of forms that are one word each."""
        return frozenset(form[0] for form in self.words(section, key))


@dataclass(frozen=True, slots=True)
class Row:
    """A row whose values have names: each is read from where it stands, and is ``usual`` where none does."""

    tables: Tables
    key: str
    fields: dict[str, Node]

    def at(self, name: str) -> tuple[Node, str]:
        """Give a value that is there, and its path."""
        return self.fields[name], f"{self.key}.{name}"

    def part(self, name: str, *names: str) -> "Row":
        """Give a row in it, which must have some names."""
        node, key = self.at(name)
        return Row(self.tables, key, self.tables.reader.mapping(node, key, names, names))

    def has(self, *names: str) -> bool:
        """Whether it has all of some values."""
        return all(name in self.fields for name in names)

    def whole(self, name: str, low: int, high: int, usual: int = 0) -> int:
        """Read a whole number."""
        return self.tables.reader.whole(*self.at(name), low, high) if name in self.fields else usual

    def number(self, name: str, low: float, high: float) -> float:
        """Read a number."""
        return self.tables.reader.number(*self.at(name), low, high)

    def chosen(self, name: str, known: Collection[str]) -> str:
        """Read one of some words; none where it is not there, or another."""
        return self.tables.reader.choice(*self.at(name), known) if name in self.fields else ""

    def choice(self, name: str, usual: _Choice, *known: _Choice) -> _Choice:
        """Read one of the values of an enumeration, or of some of them."""
        return type(usual)(self.chosen(name, known or tuple(type(usual))) or usual)

    def flag(self, name: str) -> bool:
        """Read whether something is so."""
        return name in self.fields and self.tables.reader.boolean(*self.at(name))

    def clock(self, name: str) -> int:
        """Read a time of day as seconds since midnight."""
        return self.tables.clock(*self.at(name))

    def forms(self, name: str) -> list[Form]:
        """Give ways to say something."""
        return self.tables.forms(*self.at(name)) if name in self.fields else []


def _ways(text: str) -> Iterable[str]:
    """Give the ways that a text with choices stands for: "could|can you" is two of them."""
    if CHOICE not in text:
        return (text,)
    words = (word.split(CHOICE) if word != CHOICE else [word] for word in text.split())
    return (" ".join(chosen) for chosen in product(*words))


def numbers(tables: Tables, section: str) -> dict[str, int]:
    """Give a section's numbers by their words."""
    found = {}
    for name, node in tables.rows(section):
        for form in tables.forms(node, f"{section}.{name.text}"):
            if len(form) == 1:
                found[form[0]] = tables.reader.whole(name, f"{section}.{name.text}", 0, 99)
    return found


def numbered(tables: Tables, section: str) -> dict[str, int]:
    """Give the numbers of weekdays, or of months, by their words; a key that is none is told elsewhere."""
    rows = ((name.text, tables.forms(node, f"{section}.{name.text}")) for name, node in tables.rows(section))
    return {form[0]: int(number) for number, forms in rows if number.isdecimal() for form in forms}


def by_form(tables: Tables, section: str) -> Forms[str]:
    """Give a section's keys by the ways to say them."""
    return Forms(
        {
            form: name.text
            for name, node in tables.rows(section)
            for form in tables.forms(node, f"{section}.{name.text}")
        }
    )
