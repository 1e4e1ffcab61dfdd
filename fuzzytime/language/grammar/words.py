"""A text cut into words that remember their place, in a form that word tables can be asked about.

Case, full-width digits, typographic apostrophes, dashes, "&" and "w/" are levelled; the text is never
changed, so that spans point into what was typed.
"""

import re
import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

from fuzzytime.language.instruction import Span

REMEMBERED = 4096
"""Texts whose words are kept: whoever reads a text asks for the words of the same stretches over and over."""

_ADDRESS = (
    r"\b(?:https?://|www\.)[^\s<>()\[\]]*[^\s<>()\[\].,;:!?]"
    r"|\b[\w.+-]+@[^\W\d_][\w-]*(?:\.[\w-]+)*\.[^\W\d_]{2,}\b"
)
_ADDRESSED = re.compile(_ADDRESS)
_WORD = re.compile(rf"{_ADDRESS}|\b[wW]/(?!\S)|\d+|[^\W\d_]+(?:['’ʼ][^\W\d_]+)?|\S", re.IGNORECASE)
_LEVELLED = str.maketrans(
    {"’": "'", "ʼ": "'", "′": "'", "‘": "'", "“": '"', "”": '"', "″": '"', "×": "x", "∼": "~"}
)
_SHORT = {"&": "and", "w/": "with"}
_DASHES = frozenset("-–—−‐‑‒")
_FRACTIONS = frozenset("¼½¾⅓⅔")

QUOTED = re.compile(
    r"""(?<![^\s(\[,:;-])(?:"[^"\n]+"|“[^”\n]+”|«[^»\n]+»|'(?!(?:till?|cause|cos|em)\b)[^'\n]+'|‘[^’\n]+’)"""
    r"""(?![^\s.,;:!?)\]])"""
)
"""Words between quotation marks that stand apart; not the inches of a 5" pipe, nor the mark of 'til."""


@dataclass(frozen=True, slots=True)
class Word:
    """A word, a run of digits or a mark: levelled, with its place, and whether no space stands before it.

    ``capital`` says whether it was typed with a capital, where not all of the text is in capitals.
    """

    text: str
    start: int
    end: int
    glued: bool
    capital: bool = False

    @property
    def is_digits(self) -> bool:
        """Whether it is a run of digits."""
        return self.text[0].isdigit() and self.text.isdecimal()

    @property
    def is_letters(self) -> bool:
        """Whether it is a word in the common sense."""
        return self.text[0].isalpha()

    @property
    def is_address(self) -> bool:
        """Whether it is where a page is, or who gets a letter: "https://example.org", "ann@example.org"."""
        return len(self.text) > 1 and _ADDRESSED.fullmatch(self.text) is not None


@lru_cache(maxsize=REMEMBERED)
def words_of(text: str) -> tuple[Word, ...]:
    """Cut a text into words and marks; letters and digits that touch are cut apart ("3pm" are two).

    The address of a page, or of who gets a letter, is one word.

    >>> [word.text for word in words_of("At 3PM – o’clock")]
    ['at', '3', 'pm', '-', "o'clock"]
    """
    found = []
    last, shouted = -1, text.isupper() and " " in text
    for match in _WORD.finditer(text):
        start, end = match.span()
        found.append(
            Word(_levelled(match[0]), start, end, start == last, match[0][0].isupper() and not shouted)
        )
        last = end
    return tuple(found)


def joins(words: Sequence[Word], place: int) -> bool:
    """Whether the word at a place is a hyphen without spaces around it."""
    return (
        words[place].text == "-" and words[place].glued and place + 1 < len(words) and words[place + 1].glued
    )


def is_minute(words: Sequence[Word], place: int) -> bool:
    """Whether the number at a place is the minute of an hour: the "15" of "train 7:15"."""
    first, mark = words[place], words[place - 1]
    typed = place > 1 and first.glued and mark.glued and mark.text == ":"
    return typed and first.is_digits and words[place - 2].is_digits


def _levelled(raw: str) -> str:
    if raw.isascii():
        return _SHORT.get(raw.lower(), raw.lower())
    if raw in _DASHES:
        return "-"
    if raw in _FRACTIONS:
        return raw
    # A compatibility form may fall apart into several characters; a word stays one.
    plain = unicodedata.normalize("NFKC", raw.translate(_LEVELLED)).lower()
    return plain.strip() or raw


def quotes_in(text: str) -> list[Span]:
    """Give the stretches of a text that are quoted, with their marks; none where nothing else is said.

    >>> quotes_in('text Jo "back at six" at five')
    [(8, 21)]
    >>> quotes_in('"call mum at six"')
    []
    """
    found = [match.span() for match in QUOTED.finditer(text)]
    rest = QUOTED.sub("", text)
    return found if any(character.isalnum() for character in rest) else []


def is_quoted(text: str) -> bool:
    """Whether a text is words between quotation marks."""
    return QUOTED.fullmatch(text) is not None
