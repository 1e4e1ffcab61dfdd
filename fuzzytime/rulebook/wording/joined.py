"""Clauses of several parts: "when the pan is hot and the timer rings", "neither hot nor cold"."""

import re
from dataclasses import dataclass

from fuzzytime.context import Context
from fuzzytime.english import denies
from fuzzytime.requirement import Condition
from fuzzytime.rulebook.logic.formula import And, Formula, Happened, Is, Not, Or
from fuzzytime.rulebook.tables.contents import Tables
from fuzzytime.rulebook.wording.phrases import event_named, in_numbers, naming, plain, ways_to_name, within
from fuzzytime.rulebook.wording.thresholds import Threshold, threshold, without

_JOINTS = re.compile(r" (and|or|nor|but) ")
_VERBS = re.compile(r"\b(?:is|are|isn't|aren't|has|have|was|were|gets?|becomes?)\b")
_MARK = "#{}"
"""Stands for a number and its words; no plain text holds it."""

_OF_JOINTS = re.compile(r"\b(?:both|either|neither|also|then|it|they)\b")


@dataclass(frozen=True, slots=True)
class Joined:
    """The formula of a clause of several parts, or the part that is not understood.

    ``tables`` are those that it speaks the terms of; numbers add some. ``impossible`` says that the part
    that has no formula is never so.
    """

    tables: Tables
    formula: Formula | None
    reason: str | None = None
    notes: tuple[str, ...] = ()
    impossible: bool = False


@dataclass(frozen=True, slots=True)
class _Part:
    """One part: its formula, or None and ``why``; ``alike`` goes on with what was said."""

    formula: Formula | None
    subject: str
    denied: bool
    alike: bool
    why: Threshold | None = None
    variable: str | None = None


def joined(condition: Condition, tables: Tables, context: Context) -> Joined | None:
    """Read a clause of several parts; None where it is none, or where no part of it is understood.

    A part that names nothing speaks of what the part before it named ("hot but not smoking"), one that says
    nothing takes it from the parts behind ("both the pan and the oven are hot").
    """
    said = plain(condition.text)
    for place, comparison in enumerate(condition.comparisons):
        # "Between 150 and 180" is one part.
        said = without(comparison, said, _MARK.format(place))
    pieces = _JOINTS.split(said)
    if len(pieces) == 1 or _is_a_name(said, tables):
        return None
    reader = _Parts(condition, tables, context)
    for i in range(0, len(pieces), 2):
        reader.read(pieces[i::2], pieces[i - 1] if i else "")
    parts = reader.parts
    if all(part.formula is None for part in parts):
        return None
    unknown = next((part for part in parts if part.formula is None), None)
    if unknown is not None:
        why = unknown.why or Threshold(tables)
        return Joined(tables, None, why.reason, impossible=why.impossible)
    formula = _formula(parts, pieces[1::2])
    formula = Not(formula) if said.startswith("unless ") else formula
    return Joined(reader.tables, formula, notes=tuple(reader.notes))


class _Parts:
    """The parts that were read so far, and what their numbers added to the tables."""

    def __init__(self, condition: Condition, tables: Tables, context: Context) -> None:
        self.marks = {_MARK.format(place): one for place, one in enumerate(condition.comparisons)}
        self.tables = tables
        self.context = context
        self.parts: list[_Part] = []
        self.notes: list[str] = []

    def read(self, pieces: list[str], joint: str) -> None:
        """Read the first of the pieces that are left, behind a joint."""
        piece = pieces[0]
        event = event_named(piece, self.tables)
        denied = denies(piece)
        if event is not None:
            happened = Not(Happened(event)) if denied else Happened(event)
            self.parts.append(_Part(happened, "", denied, alike=False))
            return
        own = any(
            within(way, piece)
            for variable in self.tables.variables.values()
            for way in in_numbers(ways_to_name(variable))
        )
        alike = not own and bool(self.parts) and not _speaks_of_another(piece)
        if alike and self.parts[-1].denied and joint in ("or", "nor"):
            denied = True
        subject = self.parts[-1].subject if alike else piece if own else ""
        found = self._atom(pieces, subject, self.parts[-1].variable if alike else None)
        formula = Not(found.atom) if found.atom is not None and denied else found.atom
        variable = found.atom.variable if found.atom is not None else None
        self.parts.append(_Part(formula, subject, denied, alike, found, variable))

    def _atom(self, pieces: list[str], subject: str, before: str | None) -> Threshold:
        """Find what a part says, or the next part behind it that says something: a term, or a number."""
        for text in pieces:
            mark = next((mark for mark in text.split() if mark in self.marks), None)
            if mark is not None:
                named = " ".join(word for word in pieces[0].split() if word not in self.marks)
                found = threshold(self.marks[mark], named, subject, self.tables, self.context, before)
                self.tables = found.tables
                self.notes += [note for note in found.notes if note not in self.notes]
                return found
            term = naming(self.tables.variables.values(), subject, text)
            if term is not None:
                hedges = term.hedges(pieces[0], self.tables)
                return Threshold(self.tables, Is(term.variable.name, term.term.name, hedges))
        return Threshold(self.tables, reason=f"nothing tells {self._as_said(pieces[0])!r}")

    def _as_said(self, piece: str) -> str:
        return " ".join(self.marks[word].text if word in self.marks else word for word in piece.split())


def _speaks_of_another(piece: str) -> bool:
    """Tell whether a thing stands before the piece's verb."""
    before_verb, *behind = _VERBS.split(piece, maxsplit=1)
    return bool(behind) and bool(_OF_JOINTS.sub("", before_verb).strip())


def _formula(parts: list[_Part], joints: list[str]) -> Formula:
    """Join parts: "and" binds closer than "or"; "not hot or smoking" denies both."""
    groups: list[list[Formula]] = [[]]
    for part, joint in zip(parts, ("", *joints), strict=True):
        if joint == "or" and not (part.alike and part.denied):
            groups.append([])
        if part.formula is not None:
            groups[-1].append(part.formula)
    each = [group[0] if len(group) == 1 else And(tuple(group)) for group in groups]
    return each[0] if len(each) == 1 else Or(tuple(each))


def _is_a_name(text: str, tables: Tables) -> bool:
    """Tell whether a joint stands inside a name: "salt and pepper"."""
    names = [way for variable in tables.variables.values() for way in ways_to_name(variable)]
    names += [plain(word) for signal in tables.signals.values() for word in signal.words]
    return any(_JOINTS.search(f" {name} ") and within(name, text) for name in names)
