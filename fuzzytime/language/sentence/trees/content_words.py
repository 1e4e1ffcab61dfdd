"""The words of a text that name something, and what words alike have in common."""

from functools import lru_cache

from fuzzytime.language.grammar.words import words_of

EMPTY = frozenset(
    [
        "the",
        "a",
        "an",
        "my",
        "your",
        "our",
        "his",
        "her",
        "their",
        "some",
        "all",
        "any",
        "this",
        "that",
        "these",
        "those",
        "few",
        "couple",
        "of",
        "and",
        "is",
        "are",
        "has",
        "have",
        "been",
        "with",
        "in",
        "on",
        "to",
        "for",
    ]
)
"""Words that name nothing."""

NAMED_AFTER = ("ation", "ator", "ion", "or", "ing", "er", "ment")
"""Endings of words that are named after what is done, the longest first."""

SHORTEST_STEM = 5

REMEMBERED = 16384
"""Texts whose words are remembered: each reference asks for those of every instruction."""


@lru_cache(maxsize=REMEMBERED)
def content_words(text: str | None) -> frozenset[str]:
    """Give the words of a text that name something, in the singular."""
    if text is None:
        return frozenset()
    return frozenset(singular(w.text) for w in words_of(text) if w.is_letters and w.text not in EMPTY)


def singular(word: str) -> str:
    """Give a word as it is of one thing, by its ending."""
    if word.endswith("ies") and len(word) > 4:
        return word[:-3] + "y"
    if word.endswith("oes"):
        return word[:-2]
    return word[:-1] if word.endswith("s") and not word.endswith("ss") and len(word) > 3 else word


@lru_cache(maxsize=REMEMBERED)
def stems(words: frozenset[str]) -> frozenset[str]:
    """Give what words that are named after what is done have in common: incubator and incubation."""
    found = set()
    for word in words:
        ending = next((end for end in NAMED_AFTER if word.endswith(end)), "")
        if ending and len(word) - len(ending) >= SHORTEST_STEM:
            found.add(f"{word[: -len(ending)]}-")
    return frozenset(found)
