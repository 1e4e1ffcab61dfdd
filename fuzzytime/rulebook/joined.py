"""Clauses of several parts: "when the pan is hot and the timer rings", "neither hot nor cold"."""

import re
from dataclasses import dataclass

from fuzzytime.rulebook.formula import And, Formula, Happened, Is, Not, Or
from fuzzytime.rulebook.phrases import denies, event_named, in_numbers, naming, plain, ways_to_name, within
from fuzzytime.rulebook.tables import Tables

_JOINTS = re.compile(r" (and|or|nor|but) ")
_VERBS = re.compile(r"\b(?:is|are|isn't|aren't|has|have|was|were|gets?|becomes?)\b")
_OF_JOINTS = re.compile(r"\b(?:both|either|neither|also|then|it|they)\b")


@dataclass(frozen=True, slots=True)
class Joined:
    """The formula of a clause of several parts, or the part that is not understood."""

    formula: Formula | None
    reason: str | None = None


@dataclass(frozen=True, slots=True)
class _Part:
    """One part: its formula, None where it is not understood; ``alike`` goes on with what was said before."""

    text: str
    formula: Formula | None
    subject: str
    denied: bool
    alike: bool


def joined(text: str, tables: Tables) -> Joined | None:
    """Read a clause of several parts; None where it is none, or where no part of it is understood.

    A part that names nothing speaks of what the part before it named ("hot but not smoking"), one that says
    nothing takes it from the parts behind ("both the pan and the oven are hot").
    """
    said = plain(text)
    pieces = _JOINTS.split(said)
    if len(pieces) == 1 or _is_a_name(said, tables):
        return None
    parts: list[_Part] = []
    for i in range(0, len(pieces), 2):
        parts.append(_part(pieces[i::2], pieces[i - 1] if i else "", parts, tables))
    if all(part.formula is None for part in parts):
        return None
    unknown = next((part for part in parts if part.formula is None), None)
    if unknown is not None:
        return Joined(None, f"no signal tells {unknown.text!r}")
    formula = _formula(parts, pieces[1::2])
    return Joined(Not(formula) if said.startswith("unless ") else formula)


def _part(pieces: list[str], joint: str, before: list[_Part], tables: Tables) -> _Part:
    """Read the first of the pieces that are left, behind a joint."""
    piece = pieces[0]
    event = event_named(piece, tables)
    denied = denies(piece)
    if event is not None:
        return _Part(piece, Not(Happened(event)) if denied else Happened(event), "", denied, alike=False)
    own = any(
        within(way, piece)
        for variable in tables.variables.values()
        for way in in_numbers(ways_to_name(variable))
    )
    alike = not own and bool(before) and not _speaks_of_another(piece)
    if alike and before[-1].denied and joint in ("or", "nor"):
        denied = True
    subject = before[-1].subject if alike else piece if own else ""
    found = None
    for text in (piece, *pieces[1:]):
        found = found or naming(tables.variables.values(), subject, text)
    if found is None:
        return _Part(piece, None, subject, denied, alike)
    atom = Is(found.variable.name, found.term.name, found.hedges(piece, tables))
    return _Part(piece, Not(atom) if denied else atom, subject, denied, alike)


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
