"""From what a clause says ("when the frying pan is very hot") to a formula over the tables' variables."""

import re
from collections.abc import Iterable
from dataclasses import dataclass, replace

from fuzzytime.requirement import Condition
from fuzzytime.rulebook.durations import singular_forms
from fuzzytime.rulebook.formula import Formula, Happened, Is, Not
from fuzzytime.rulebook.tables import Tables
from fuzzytime.rulebook.variables import Term, Variable

_DETERMINERS = frozenset(
    ("the", "a", "an", "my", "your", "our", "his", "her", "its", "their", "this", "that", "these", "those")
)
_DENIALS = re.compile(r"\b(?:not|no longer|never|\w+n't)\b")


@dataclass(frozen=True, slots=True)
class Understood:
    """A clause with the subject and word that were found in it; its formula, or why there is none."""

    condition: Condition
    formula: Formula | None
    reason: str | None = None
    notes: tuple[str, ...] = ()


def understand(condition: Condition, tables: Tables) -> Understood:
    """Find the variable and the term, or the event, that a clause speaks of."""
    event = event_named(condition.text, tables)
    if event is not None:
        return Understood(condition, Happened(event))
    if not condition.negated and _denies(condition.text):
        condition = replace(condition, negated=True)
    if condition.subject is None or condition.word is None:
        return _by_text(condition, tables)
    if not _within(_plain(condition.subject), _plain(condition.text)):
        # The subject was put for a pronoun, and "it rains" speaks of nothing that was named before.
        impersonal = _by_text(condition, tables)
        if impersonal.formula is not None:
            return impersonal
    return _by_parts(condition, condition.subject, condition.word, tables)


def _by_parts(condition: Condition, subject: str, word: str, tables: Tables) -> Understood:
    named = [variable for variable in tables.variables.values() if names(variable, subject)]
    text = _plain(condition.text)
    # The longest way to say it: "too hot" is not hot, and "dente" alone says nothing.
    ways = [
        (way, variable, term)
        for variable in named
        for term in variable.terms.values()
        for way in _ways_to_say(term)
        if way == _plain(word) or (_plain(word) in way.split() and _within(way, text))
    ]
    if ways:
        way, variable, term = max(ways, key=lambda row: len(row[0]))
        hedges = tuple(hedge for hedge in condition.hedges if hedge.lower() not in way.split())
        return _atom(replace(condition, hedges=hedges), variable, term, tables)
    if named:
        terms = dict.fromkeys(term for variable in named for term in variable.terms)
        return Understood(condition, None, f"{subject!r} has no term {word!r} (known: {', '.join(terms)})")
    return _by_text(condition, tables)


def _by_text(condition: Condition, tables: Tables) -> Understood:
    """Look for a variable's words and one of its terms in a clause of any form, the longest words first."""
    text = _plain(condition.text)
    found: list[tuple[int, str, str, Variable, Term]] = []
    for variable in tables.variables.values():
        subject = max((word for word in _ways_to_name(variable) if _within(word, text)), key=len, default="")
        for term in variable.terms.values():
            word = max((word for word in _ways_to_say(term) if _within(word, text)), key=len, default="")
            if subject and word:
                found.append((len(subject) + len(word), subject, word, variable, term))
    if not found:
        return Understood(condition, None, f"no signal tells {condition.text!r}")
    _, subject, word, variable, term = max(found, key=lambda row: row[0])
    hedges = tuple(word for word in text.split() if word in tables.term_hedges)
    return _atom(replace(condition, subject=subject, word=word, hedges=hedges), variable, term, tables)


def _atom(condition: Condition, variable: Variable, term: Term, tables: Tables) -> Understood:
    hedges = [hedge.lower() for hedge in condition.hedges]
    known = tuple(hedge for hedge in hedges if hedge in tables.term_hedges)
    notes = tuple(
        f"unknown hedge {hedge!r}: taken as none" for hedge in hedges if hedge not in tables.term_hedges
    )
    atom = Is(variable.name, term.name, known)
    return Understood(condition, Not(atom) if condition.negated else atom, notes=notes)


def event_named(text: str, tables: Tables) -> str | None:
    """Find the event that a text names ("the timer rings"), by the longest words."""
    plain = _plain(text)
    found = [
        (len(word), signal.name)
        for signal in tables.signals.values()
        if signal.event
        for word in map(_plain, signal.words)
        if _within(word, plain)
    ]
    return max(found)[1] if found else None


def event_at_end(text: str, tables: Tables) -> str | None:
    """Find the event whose name a text ends with: "half an hour before lunch"."""
    event, plain = event_named(text, tables), _plain(text)
    if event is None:
        return None
    ways = map(_plain, tables.signals[event].words)
    return event if any(plain == way or plain.endswith(f" {way}") for way in ways) else None


def names(variable: Variable, subject: str) -> bool:
    """Tell whether a noun phrase names a variable: its last words do, perhaps in the plural."""
    said = _plain(subject)
    return any(said == way or said.endswith(f" {way}") for way in _in_numbers(_ways_to_name(variable)))


def _in_numbers(ways: Iterable[str]) -> set[str]:
    """Add to ways of naming a thing those of naming several."""
    found: set[str] = set()
    for way in ways:
        found |= {way, f"{way}s", f"{way}es", *singular_forms(way)}
    return found


def _ways_to_name(variable: Variable) -> tuple[str, ...]:
    return (_plain(variable.name), *map(_plain, variable.words))


def _ways_to_say(term: Term) -> tuple[str, ...]:
    return (_plain(term.name), *map(_plain, term.words))


def _plain(text: str) -> str:
    """Give a text in lower case, without punctuation and determiners."""
    words = re.findall(r"[^\W_]+(?:['\u2019-][^\W_]+)*", text.lower().replace("\u2019", "'"))
    return " ".join(word for word in words if word not in _DETERMINERS)


def _denies(text: str) -> bool:
    """Tell whether a clause denies what it says: "is not hot", "is no longer hot", "isn't hot"."""
    return _DENIALS.search(text.lower().replace("\u2019", "'")) is not None


def _within(words: str, text: str) -> bool:
    return bool(words) and f" {words} " in f" {text} "
