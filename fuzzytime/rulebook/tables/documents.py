"""Rule files to tables: all files together, all mistakes at once."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from fuzzytime.documents.kept import Kept
from fuzzytime.documents.nodes import Node, Reader
from fuzzytime.errors import DocumentError, Mistake
from fuzzytime.resources import rules_directory
from fuzzytime.rulebook.tables.agreement import Clash, clashes, in_units_of_signals
from fuzzytime.rulebook.tables.contents import Tables
from fuzzytime.rulebook.tables.profile import Profile
from fuzzytime.rulebook.tables.sections.durations import read_durations
from fuzzytime.rulebook.tables.sections.models import read_models
from fuzzytime.rulebook.tables.sections.rows import (
    read_constraints,
    read_entries,
    read_grains,
    read_rows,
    read_time_hedges,
)
from fuzzytime.rulebook.tables.sections.rules import read_norm, read_rules
from fuzzytime.rulebook.tables.sections.scope import Scope
from fuzzytime.rulebook.tables.sections.signals import read_signals
from fuzzytime.rulebook.tables.sections.variables import read_term_hedges, read_variables
from fuzzytime.rulebook.tables.sections.widths import (
    read_actors,
    read_clock,
    read_plateau,
    read_repetition,
    read_roundness,
    read_thresholds,
    read_width,
)
from fuzzytime.rulebook.tables.vocabulary import Vocabulary, child

VERSION = "1"
SHIPPED = ("lookup.yaml", "durations.yaml", "kitchen.yaml", "household.yaml", "workshop.yaml")
"""The shipped rule files, in rising precedence."""

_SECTIONS: Mapping[str, Callable[[Scope, Node, str], Any]] = {
    "width": read_width,
    "plateau": read_plateau,
    "clock": read_clock,
    "repetition": read_repetition,
    "roundness": read_roundness,
    "thresholds": read_thresholds,
    "actors": read_actors,
    "models": read_models,
    "prepositions": read_rows,
    "words": read_rows,
    "clauses": read_rows,
    "grains": read_grains,
    "constraints": read_constraints,
    "entries": read_entries,
}
"""Sections of the lookup, which a profile may hold as well; each fills the field of `Tables` of its name."""

_OTHERS: Mapping[str, Callable[[Scope, Node, str], Any]] = {
    "options": read_norm,
    "durations": read_durations,
    "signals": read_signals,
    "variables": read_variables,
    "rules": read_rules,
}
"""Sections that every profile shares."""


@dataclass(frozen=True, slots=True)
class Document:
    """A rule file: where it is, and how messages and explanations call it."""

    path: Path
    shown: str

    @classmethod
    def shipped(cls, name: str) -> "Document":
        """Give one of the shipped files, called by a short path."""
        return cls(rules_directory() / name, f"rules/{name}")


def shipped_tables(profile: Profile, kept: Kept | None = None) -> Tables:
    """Give the shipped tables for a profile; they are read once, or were ``kept`` by an earlier program."""
    if profile not in _ONCE:
        documents = [Document.shipped(name) for name in SHIPPED]
        _ONCE[profile] = (
            load(documents, profile)
            if kept is None
            else kept.made(
                f"rules-{profile}",
                [document.path for document in documents],
                lambda: load(documents, profile),
            )
        )
    return _ONCE[profile]


_ONCE: dict[Profile, Tables] = {}
"""The shipped tables that were read so far: they do not change."""


def load(documents: Sequence[Document], profile: Profile, over: Tables | None = None) -> Tables:
    """Read files in rising precedence into tables for a profile, laid over others.

    Raises
    ------
    DocumentError
        With every mistake of every file.
    """
    readers: list[Reader] = []
    mistakes: list[Mistake] = []
    for document in documents:
        try:
            readers.append(_opened(document))
        except DocumentError as error:
            mistakes += error.mistakes
    tables, found = read_over(over or Tables(), readers, profile)
    if mistakes or found:
        raise DocumentError((*mistakes, *found))
    return tables


def read_over(
    tables: Tables, readers: Sequence[Reader], profile: Profile
) -> tuple[Tables, tuple[Mistake, ...]]:
    """Lay documents over tables; give the tables and every mistake of every document."""
    opened: list[tuple[Reader, Node]] = []
    mistakes: list[Mistake] = []
    for reader in readers:
        try:
            opened.append((reader, reader.root()))
        except DocumentError as error:
            mistakes += error.mistakes
    names = vocabulary_of(tables).joined(Vocabulary.of(root for _, root in opened))
    for reader, root in opened:
        # What a document says itself holds for its own rows, whatever later ones make of it.
        own = names.joined(Vocabulary.of([root]))
        tables = tables.overridden(_tables(reader, root, own, profile))
    for clash in clashes(tables, names):
        _note(clash, opened)
    mistakes += [mistake for reader, _ in opened for mistake in reader.mistakes]
    return (tables, tuple(mistakes)) if mistakes else (in_units_of_signals(tables), ())


def _note(clash: Clash, opened: Sequence[tuple[Reader, Node]]) -> None:
    """Note a mistake at a row of the last document that has it."""
    for reader, root in reversed(opened):
        section = child(root, clash.section)
        name = reader.keys(section).get(clash.name) if section is not None else None
        if name is not None:
            reader.mistake(name, f"{clash.section}.{clash.name}", clash.message)
            return


def vocabulary_of(tables: Tables) -> Vocabulary:
    """Give the names that tables declare."""
    return Vocabulary(
        prepositions=frozenset((*tables.prepositions, *tables.clauses)),
        words=frozenset(tables.words),
        models=frozenset(tables.models),
        time_hedges=frozenset(tables.time_hedges),
        term_hedges=frozenset(tables.term_hedges),
        units={name: signal.unit for name, signal in tables.signals.items()},
        events=frozenset(name for name, signal in tables.signals.items() if signal.event),
        terms={name: frozenset(variable.terms) for name, variable in tables.variables.items()},
        sources={name: variable.signal for name, variable in tables.variables.items()},
    )


def _opened(document: Document) -> Reader:
    try:
        return Reader.of_file(document.path, document.shown)
    except OSError as error:
        reason = error.strerror or type(error).__name__
        mistake = Mistake(document.shown, 1, 1, "", f"the file cannot be read: {reason}")
        raise DocumentError((mistake,)) from error


def _tables(reader: Reader, root: Node, names: Vocabulary, profile: Profile) -> Tables:
    scope = Scope(reader, names)
    found = scope.row(root, "", ("fuzzytime", "profiles", "hedges", *_SECTIONS, *_OTHERS), ("fuzzytime",))
    if "fuzzytime" in found:
        version = reader.string(found["fuzzytime"], "fuzzytime")
        if version != VERSION:
            reader.mistake(found["fuzzytime"], "fuzzytime", f"the version must be {VERSION}, got {version!r}")
    others = {name: read(scope, found[name], name) for name, read in _OTHERS.items() if name in found}
    tables = _lookup_tables(scope, found, "").overridden(Tables(**others))
    if "profiles" in found:
        for name, node in reader.mapping(found["profiles"], "profiles", tuple(Profile)).items():
            path = f"profiles.{name}"
            sections = scope.row(node, path, ("hedges", *_SECTIONS))
            own = _lookup_tables(scope, sections, f"{path}.")
            if name == profile:
                tables = tables.overridden(own)
    return tables


def _lookup_tables(scope: Scope, found: Mapping[str, Node], prefix: str) -> Tables:
    read = {
        section: reader(scope, found[section], f"{prefix}{section}")
        for section, reader in _SECTIONS.items()
        if section in found
    }
    if "hedges" in found:
        hedges = scope.reader.mapping(found["hedges"], f"{prefix}hedges", ("time", "term"))
        if "time" in hedges:
            read["time_hedges"] = read_time_hedges(scope, hedges["time"], f"{prefix}hedges.time")
        if "term" in hedges:
            read["term_hedges"] = read_term_hedges(scope, hedges["term"], f"{prefix}hedges.term")
    return Tables(**read)
