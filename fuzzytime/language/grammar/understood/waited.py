"""What is waited before an order that "and" joins: "two more minutes and take it off the heat"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Duration, Phrase
from fuzzytime.requirement import Constraint

STOPS = frozenset({".", ";", "!", "?"})
"""Marks behind which a sentence begins."""

JOINT = "and"


def waited(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> Phrase:
    """Read a length of time that opens a sentence, and has an order behind "and", as what is waited."""
    said, end = phrase.said, phrase.end
    opens = phrase.first == 0 or words[phrase.first - 1].text in STOPS
    alone = isinstance(said.time, Duration) and said.preposition is None
    joined = [word.text for word in words[end : end + 1]] == [JOINT]
    if not (opens and alone and joined) or not _is_order(words, end + 1, lexicon):
        return phrase
    return replace(phrase, said=replace(said, constraint=Constraint.AFTER, preposition="after"))


def _is_order(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether an order begins at a place: a known one, or a word with a particle or a thing behind it."""
    closed = lexicon.closed
    first, *behind = [word.text for word in words[place : place + 2]] or [""]
    if not first.isalpha() or first in lexicon.function_words | closed.noun_openers:
        return False
    things = closed.noun_openers | closed.object_pronouns | lexicon.particles.keys()
    return first in lexicon.orders or any(word in things for word in behind)
