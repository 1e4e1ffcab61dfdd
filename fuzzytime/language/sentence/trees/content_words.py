"""The words of a text that name something, and what words alike have in common."""

import re
from collections.abc import Iterator
from functools import lru_cache
from itertools import zip_longest

from fuzzytime.english import EMPTY, singular, stem
from fuzzytime.language.grammar.words import words_of

OWNER = re.compile(r"(?<=\w)['\u2019]s$")
"""What tells whose something is, or that something is so."""

REMEMBERED = 16384
"""Texts whose words are remembered: each reference asks for those of every instruction."""


@lru_cache(maxsize=REMEMBERED)
def content_words(text: str | None) -> frozenset[str]:
    """Give the words of a text that name something, in the singular; digits behind letters belong to them.

    >>> sorted(content_words("Fill trays 2 and 3 with the A4 paper"))
    ['a4', 'fill', 'paper', 'tray']
    """
    return frozenset() if text is None else frozenset(_named_in(text))


def _named_in(text: str) -> Iterator[str]:
    words = words_of(text)
    for place in range(len(words) - 2):
        pair, mark = (words[place], words[place + 2]), words[place + 1]
        if mark.text == ":" and mark.glued and pair[1].glued and all(word.is_digits for word in pair):
            # What is named by two numbers, as the 1:1 is.
            yield f"{pair[0].text}:{pair[1].text}"
    for word, following in zip_longest(words, words[1:]):
        if word.is_letters and following is not None and following.glued and following.is_digits:
            yield word.text + following.text
        elif word.is_letters and word.text not in EMPTY:
            # "The bread's done", "Ann's call"
            yield singular(OWNER.sub("", word.text))


@lru_cache(maxsize=REMEMBERED)
def stems(words: frozenset[str]) -> frozenset[str]:
    """Give what words that are named after what is done have in common: incubator and incubation."""
    return frozenset(f"{begun}-" for begun in map(stem, words) if begun is not None)
