"""The words of a text that name something, and what words alike have in common."""

from functools import lru_cache

from fuzzytime.english import EMPTY, singular, stem
from fuzzytime.language.grammar.words import words_of

REMEMBERED = 16384
"""Texts whose words are remembered: each reference asks for those of every instruction."""


@lru_cache(maxsize=REMEMBERED)
def content_words(text: str | None) -> frozenset[str]:
    """Give the words of a text that name something, in the singular."""
    if text is None:
        return frozenset()
    return frozenset(singular(w.text) for w in words_of(text) if w.is_letters and w.text not in EMPTY)


@lru_cache(maxsize=REMEMBERED)
def stems(words: frozenset[str]) -> frozenset[str]:
    """Give what words that are named after what is done have in common: incubator and incubation."""
    return frozenset(f"{begun}-" for begun in map(stem, words) if begun is not None)
