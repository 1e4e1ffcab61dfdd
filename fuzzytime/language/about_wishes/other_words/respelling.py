"""A line about wishes whose first word is mistyped: "canel that", "mvoe the call to six"."""

from collections.abc import Callable, Mapping
from datetime import datetime
from functools import lru_cache

from fuzzytime.language.about_wishes.said import Said
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.lexicon.spelling import clipped, misspellings

OPENING = (
    "dropping", "clearing", "swapping", "undoing", "redoing", "delaying", "stopping", "showing", "what",
    "when", "why",
)  # fmt: skip
"""The tables of what a line about wishes may begin with."""

SHORTEST = 3
"""Letters of a word that is taken for a misspelling, at least."""


def respelled(text: str, now: datetime, lexicon: Lexicon, is_verb: Callable[[str], bool]) -> str | None:
    """Give a line with its first word as it is spelt; None where that is a word already, or like none.

    >>> from fuzzytime.language.finding import shipped_lexicon
    >>> respelled("canel that", datetime(2026, 3, 4, 9), shipped_lexicon(), lambda word: word == "sip")
    'cancel that'
    """
    said = Said.of(text, now, lexicon).without_exclamations()
    first = said.forms[0] if said.words else ""
    meant = _meant(lexicon).get(first) if len(first) >= SHORTEST else None
    if meant is None or is_verb(first):
        return None
    word = said.words[0]
    return f"{said.text[: word.start]}{meant}{said.text[word.end :]}"


@lru_cache(maxsize=4)
def _meant_by(opening: frozenset[str]) -> Mapping[str, str]:
    words = sorted(opening)
    return {**clipped(words, opening), **misspellings(words, opening)}


def _meant(lexicon: Lexicon) -> Mapping[str, str]:
    forms = (form for name in OPENING for form in lexicon.conversation[name])
    return _meant_by(frozenset(form[0] for form in forms if len(form[0]) > SHORTEST) | lexicon.moving)
