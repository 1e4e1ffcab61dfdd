"""Where what has a time is named among orders: "first lesson at nine", "…, with a break at five"."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Phrase, Wall
from fuzzytime.language.meaning.phrases import places_in

LONGEST_NAME = 4
"""Words at most, and one, of the name of what has a time: "first aid course"."""
LONGEST_MEANWHILE = 6
"""Words at most of what happens meanwhile: "with a ten-minute break at five"."""


def counts_event(words: Sequence[Word], place: int, phrases: Sequence[Phrase], lexicon: Lexicon) -> bool:
    """Whether "first" is of what has a time, or of several: "first lesson at nine", "first … second coat"."""
    if words[place].text != "first" or place + 1 >= len(words):
        return False
    behind = words[place + 1].text
    if any(one.text == "second" and other.text == behind for one, other in pairwise(words)):
        return True
    time = next((phrase.first for phrase in phrases if phrase.first > place), place)
    named = place + 1 < time <= place + LONGEST_NAME
    # "First coat at three"
    turns = lexicon.spacing["turns"]
    return named and words[time - 1].text in lexicon.happening | lexicon.taken | turns


def beside(phrases: Sequence[Phrase], words: Sequence[Word], lexicon: Lexicon) -> Iterator[int]:
    """Give where begins what happens meanwhile: "revise from four to six, with a break at five"."""
    covered = places_in(phrases)
    for phrase in phrases[1:]:
        last = phrase.first - 1
        called = words[last].text in lexicon.happening | lexicon.taken and last not in covered
        first = next(
            (p for p in range(last, max(0, last - LONGEST_MEANWHILE), -1) if words[p].text == "with"), 0
        )
        joined = first > 1 and (first - 1 in covered or words[first - 1].text == ",")
        if called and joined and first not in covered and isinstance(phrase.said.time, Wall):
            yield first + 1


def heads(phrase: Phrase, words: Sequence[Word]) -> bool:
    """Whether a day behind what it is the day of ends at a colon: "school trip on the 12th: …"."""
    ends = phrase.end + 1 < len(words) and words[phrase.end].text == ":" and not words[phrase.end + 1].glued
    return ends and phrase.said.is_day and phrase.first > 0
