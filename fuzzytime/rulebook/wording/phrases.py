"""The words by which tables name things, terms and events, and where a text has them."""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache

from fuzzytime.english import DETERMINERS, MEASURES, PLACING, of_any_tense, singular_forms
from fuzzytime.rulebook.tables.contents import Tables
from fuzzytime.rulebook.tables.variables import Term, Variable

REMEMBERED = 16384
"""Texts whose plain form is remembered: those of tables are compared with each that is said."""

_tenseless = lru_cache(maxsize=REMEMBERED)(of_any_tense)


@dataclass(frozen=True, slots=True)
class Naming:
    """A variable and one of its terms, each with the words that name it in a text."""

    subject: str
    word: str
    variable: Variable
    term: Term

    def hedges(self, text: str, tables: Tables) -> tuple[str, ...]:
        """Give the hedges in a plain text that are no part of the words: "too hot" is a word of its own."""
        return tuple(
            word for word in text.split() if word in tables.term_hedges and word not in self.word.split()
        )


def naming(variables: Iterable[Variable], subject: str, word: str) -> Naming | None:
    """Find the longest way in which plain texts name one of some variables, and one of its terms."""
    found: list[Naming] = []
    for variable in variables:
        named = _longest(in_numbers(ways_to_name(variable)), subject)
        for term in variable.terms.values():
            said = _longest(ways_to_name(term), word)
            if named and said:
                found.append(Naming(named, said, variable, term))
    return max(found, key=lambda one: len(one.subject) + len(one.word), default=None)


def _longest(ways: Iterable[str], text: str) -> str:
    return max((way for way in ways if within(way, text)), key=len, default="")


def event_named(text: str, tables: Tables) -> str | None:
    """Find the event that a text names, in whatever tense, by the longest words."""
    said = plain(text)
    for form in (str, _tenseless):
        found = [
            (len(word), signal.name)
            for signal in tables.signals.values()
            if signal.event
            for word in map(plain, signal.words)
            if within(form(word), form(said))
        ]
        if found:
            return max(found)[1]
    return None


def event_at_end(text: str, tables: Tables) -> str | None:
    """Find the event whose name a text ends with: "half an hour before lunch"."""
    event, said = event_named(text, tables), plain(text)
    if event is None:
        return None
    ways = map(plain, tables.signals[event].words)
    return event if any(said == way or said.endswith(f" {way}") for way in ways) else None


def names(variable: Variable, subject: str) -> bool:
    """Tell whether a noun phrase names a variable: its last words do, perhaps in the plural."""
    said = plain(subject)
    return any(said == way or said.endswith(f" {way}") for way in in_numbers(ways_to_name(variable)))


def is_of_another(ways: Iterable[str], subject: str) -> bool:
    """Tell whether a noun phrase names a thing only beside another that it is about: "bed 3's sats".

    What is read of a thing is about it, and what stands in it is not about another: "the oven temperature",
    "water in the pot".
    """
    said = plain(subject)
    behind = [f" {said} ".partition(f" {way} ")[2].split() for way in ways if within(way, said)]
    rests = [[word for word in rest if not word.isdigit()] for rest in behind]
    return bool(rests) and not any(
        not rest or rest[0] in PLACING or not MEASURES.isdisjoint(rest) for rest in rests
    )


def in_numbers(ways: Iterable[str]) -> set[str]:
    """Add to ways of naming a thing those of naming several."""
    found: set[str] = set()
    for way in ways:
        found |= {way, f"{way}s", f"{way}es", *singular_forms(way)}
    return found


def ways_to_name(named: Variable | Term) -> tuple[str, ...]:
    """Give the plain names of a variable's thing, or the plain words for a term."""
    return (plain(named.name), *map(plain, named.words))


@lru_cache(maxsize=REMEMBERED)
def plain(text: str) -> str:
    """Give a text in lower case, without punctuation and determiners: "the oven's light" is "oven light"."""
    said = re.sub(r"\s?'s\b", "", text.lower().replace("\u2019", "'"))
    words = re.findall(r"[^\W_]+(?:['-][^\W_]+)*", said)
    return " ".join(word for word in words if word not in DETERMINERS)


def within(words: str, text: str) -> bool:
    """Tell whether whole words stand in a text, both plain."""
    return bool(words) and f" {words} " in f" {text} "
