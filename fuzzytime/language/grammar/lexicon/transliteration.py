"""Names that other scripts have and Latin letters spell in many ways: "hannukkah", "id ul-azha"."""

import unicodedata
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Generic, TypeVar

from fuzzytime.language.grammar.words import Word

T = TypeVar("T")

LEAST_LETTERS = 6
"""Letters of a name by its sound, at least, where it is one word: shorter ones are like other words."""

LEAST_OF_SEVERAL = 5
"""Letters of a name of several words by their sound, at least."""

MOST_WORDS = 8
"""Words of a name, at most, with the marks between them."""

LEAST_JOINED = 4
"""Letters of a word, at least, to which the article behind it may be joined: "idul" of "idul azha"."""

INNER = frozenset(
    {"-", "'", "al", "ul", "el", "il", "an", "un", "en", "ar", "ur", "as", "us", "at", "ut", "ad", "e", "i"}
)
"""What joins the words of a name, and is written or not: articles, and the Persian "of"."""

ALIKE = (
    ("ch", "x"), ("kh", "x"), ("sh", "s"), ("th", "t"), ("dh", "d"), ("zh", "d"), ("ph", "f"), ("tz", "ts"),
    ("z", "d"), ("q", "k"), ("c", "k"), ("w", "v"), ("y", "i"), ("e", "i"), ("o", "u"), ("j", "i"),
)  # fmt: skip
"""Letters that stand for one sound, or for sounds that are often written as one."""


@lru_cache(maxsize=4096)
def sound_of(text: str) -> str:
    """Give a word by its sound, as far as spellings differ in it.

    >>> sound_of("hannukkah") == sound_of("chanukah"), sound_of("deepavali") == sound_of("dipawali")
    (True, True)
    """
    plain = unicodedata.normalize("NFKD", text)
    said = "".join(letter for letter in plain if letter.isascii() and letter.isalpha())
    said = said.removesuffix("ul") if len(said) >= LEAST_JOINED else said
    for written, sound in ALIKE:
        said = said.replace(written, sound)
    # An "h" is written or not, but at the beginning; a harsh one is, but at the end.
    said = said[:1].replace("x", "h") + said[1:].replace("h", "").replace("x", "h")
    return _single(said).removesuffix("h")


def _single(said: str) -> str:
    """Give letters without those that repeat the one before them."""
    return "".join(letter for place, letter in enumerate(said) if said[place - 1 : place] != letter)


def sound_of_name(form: Sequence[str]) -> str:
    """Give a name by its sound; nothing where that is too short to tell it from other words.

    >>> sound_of_name(("eid", "ul", "-", "azha")) == sound_of_name(("idul", "adha")), sound_of_name(["holi"])
    (True, '')
    """
    words = [text for text in form if text not in INNER]
    said = _single("".join(map(sound_of, words)))
    return said if len(said) >= (LEAST_LETTERS if len(words) == 1 else LEAST_OF_SEVERAL) else ""


@dataclass(frozen=True, slots=True)
class Names(Generic[T]):
    """What names mean, by their sounds."""

    by_sound: Mapping[str, T]
    openings: frozenset[str]
    """What any of them begins with."""

    @classmethod
    def of(cls, named: Iterable[tuple[Sequence[str], T]]) -> "Names[T]":
        """Give what some names mean; of two with one sound, the first."""
        found: dict[str, T] = {}
        for form, meaning in named:
            if said := sound_of_name(form):
                found.setdefault(said, meaning)
        return cls(found, frozenset(said[:length] for said in found for length in range(1, len(said) + 1)))

    def at(self, words: Sequence[Word], start: int) -> Iterator[tuple[int, T]]:
        """Give where names end that begin at a place, and what they mean."""
        first = words[start].text
        said = sound_of(first) if first[0].isalpha() and first not in INNER else ""
        if said not in self.openings:
            return
        for end in range(start + 1, min(start + MOST_WORDS, len(words)) + 1):
            text = words[end - 1].text
            if end > start + 1 and text not in INNER:
                if not text[0].isalpha():
                    return
                said = _single(said + sound_of(text))
                if said not in self.openings:
                    return
            if said in self.by_sound and text not in INNER:
                yield end, self.by_sound[said]
