"""How a text should sound to the model: words that it would cut, or take for others, are put otherwise.

Every token of what sounds stands for a stretch of what was typed, and the tree has that.
"""

import re
from collections.abc import Iterable, Iterator
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from typing import NamedTuple

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import quotes_in
from fuzzytime.language.instruction import Span

PREFIXED = re.compile(r"(?<![\w'’-])(pre|re|de|un|[ext](?=-[a-z]{3}))-([a-z]+)\b", re.IGNORECASE)
"""Words with a prefix, or one of some letters, that a hyphen joins: "pre-heat", "x-ray", "e-mail"."""

SPELT_HALF = re.compile(r"(?<=\w )([ap]) m\b(?!')", re.IGNORECASE)
"""A half of the day that is written as it is spelt: "six p m"."""

GLUED_AT = re.compile(r"(?<=[a-z])@(?=\d{1,2}(?:[:.]\d\d)?(?:[ap]m)?(?![\w@-]|\.\w))", re.IGNORECASE)
"""An "at" between a name and its clock time: "gym@6", but no address."""

HYPHENED = re.compile(
    r"([a-z’']+) ([a-z]{3,})-([a-z]+)(?:(?=\W*$)|(?=[.,;:)]? \(?([a-z]+|\d)))", re.IGNORECASE
)
"""A verb and its particle with a hyphen, and the words on both sides of them: "tent take-down at six"."""

TYPED = re.compile(r"(?<![\w'’-])\w+(?![\w'’-]|  )")
"""A word that stands by itself; one that was put in for a longer word, and left its room, stays as it is."""

NAME = "Tim"
"""What stands for what is quoted: a tree has it for a thing that is named."""

NOUN = "setup"
"""What stands for a verb and its particle that are a noun: the model knows this one for a noun."""

SPACE = " "
"""What stands for a hyphen between a verb and its particle that are none."""


class StandIn(NamedTuple):
    """A stretch of a text, and the word that sounds there."""

    start: int
    end: int
    word: str


@dataclass(frozen=True, slots=True)
class Sounding:
    """A text, and what stands in for some of its words, in their order."""

    text: str
    instead: tuple[StandIn, ...]

    @classmethod
    def of(cls, text: str, lexicon: Lexicon, verbs: AbstractSet[str]) -> "Sounding":
        """Find what something else should stand in for; ``verbs`` are those of a dictionary."""
        quotes = [StandIn(start, end, NAME) for start, end in quotes_in(text)]
        others = (
            one
            for one in (*_hyphened(text, lexicon, verbs), *_in_full(text, lexicon))
            if not any(quote.start <= one.start < quote.end for quote in quotes)
        )
        return cls(text, tuple(sorted((*quotes, *others))))

    @property
    def sound(self) -> str:
        """The text as the tokenizer should have it.

        A lone surrogate is no character to it, "pre-heat" would be three words, "p m" would be two, and what
        is quoted is a name.
        """
        whole = PREFIXED.sub(lambda match: f"{match[1]}{match[2]} ", self.text)
        whole = GLUED_AT.sub(" ", whole)
        whole = SPELT_HALF.sub(lambda match: f"{match[1]}m ", whole)
        for start, end, word in reversed(self.instead):
            whole = whole[:start] + word + whole[end:]
        return "".join("\ufffd" if "\ud800" <= c <= "\udfff" else c for c in whole)

    def typed(self, tokens: Iterable[tuple[int, int]]) -> Iterator[Span]:
        """Give where tokens of the sound, by place and length, stand in the text."""
        joined = (match for pattern in (PREFIXED, SPELT_HALF) for match in pattern.finditer(self.text))
        whole = {match.start(): match.end() for match in joined}
        whole.update((one.start, one.end) for one in self.instead)
        for place, length in tokens:
            start = place
            for one in self.instead:
                start += one.end - one.start - len(one.word) if one.start < start else 0
            yield start, whole.get(start, start + length)

    def is_noun(self, span: Span) -> bool:
        """Whether a stretch is a verb and its particle that are a noun."""
        return StandIn(*span, NOUN) in self.instead


def _in_full(text: str, lexicon: Lexicon) -> Iterator[StandIn]:
    """Give what stands in for words that are typed shortly: "before" for "b4"."""
    for match in TYPED.finditer(text):
        meant = lexicon.misspelt.get(match[0].lower())
        if meant is not None and len(meant) != len(match[0]):
            yield StandIn(*match.span(), meant)


def _hyphened(text: str, lexicon: Lexicon, verbs: AbstractSet[str]) -> Iterator[StandIn]:
    """Give what stands in for verbs and their particles with a hyphen: a noun, or a space for the hyphen.

    They are a noun in "rib turn-in 5pm" and "the wrap-up"; not before what they are done to: "to drop-off the
    kids".
    """
    closed = lexicon.closed
    opening = closed.noun_openers | closed.prepositions_of_nouns | closed.prepositions_of_time
    for match in HYPHENED.finditer(text):
        before, verb, particle, behind = ((group or "").lower() for group in match.groups())
        if verb not in verbs or particle not in lexicon.particles:
            continue
        named = before not in lexicon.function_words or before in opening
        ends = not behind.isalpha() or behind in lexicon.function_words - closed.noun_openers
        ends = ends or (behind in lexicon.entries and not lexicon.means(behind, "unit"))
        if named and ends:
            yield StandIn(match.start(2), match.end(3), NOUN)
        elif behind in closed.noun_openers | closed.object_pronouns:
            yield StandIn(match.end(2), match.start(3), SPACE)
