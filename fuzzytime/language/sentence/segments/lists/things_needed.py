"""Lines that only name what is needed, and how much of it: "2 tins tomatoes", "300 g rice, 1 litre stock"."""

import re
from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Remark, RemarkKind

STOPS = frozenset({";", "+", "."})
"""Marks that may stand between two of them."""

LONGEST = 6
"""Words of one thing, at most: "1 tin of chopped plum tomatoes"."""

MARKED = re.compile(r"\s*(?:[-–—*•+]|\d{1,2}[.)])\s")
"""What stands in front of an entry of a list."""


def names_needed(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether all that words do is to name amounts of things, one of which is measured: "3 cloves garlic"."""
    inside = _bare(words)
    place = next((p + 1 for p, word in enumerate(inside) if word.text == ":"), 0)
    things = [*_things(inside[place:], lexicon.closed.joints_of_things | STOPS)]
    if not things or max(map(len, things)) > LONGEST:
        return False
    counted = [thing for thing in things if is_number(thing[0], lexicon)]
    measured = lexicon.no_times.measured_in | lexicon.no_times.portions
    known = any(_is_measured(thing, measured) for thing in counted)
    beside = lexicon.function_words - lexicon.closed.inside_names_of_things
    plain = all(word.text not in beside for thing in things for word in thing)
    return known and plain and 2 * len(counted) >= len(things) and counted[0] is things[0]


def needed(text: str) -> Remark:
    """Say of a line that it asks for nothing."""
    return Remark(
        RemarkKind.TOLD, (0, len(text)), f"{text.strip()!r} says what is needed, and asks for nothing"
    )


def is_marked(text: str) -> bool:
    """Whether a line begins like an entry of a list: "- dust", "2) fry"."""
    return MARKED.match(text) is not None


def _bare(words: Sequence[Word]) -> list[Word]:
    """Give words without those in brackets, and without marks in front."""
    found: list[Word] = []
    depth = 0
    for word in words:
        depth += word.text == "("
        # "1/2 tsp", "1.5 kg"
        parts = word.text in {"/", "."} and bool(found) and found[-1].is_digits and word.glued
        if not depth and not parts and (found or word.text[0].isalnum()):
            found.append(word)
        depth -= word.text == ")" and depth > 0
    return found


def _things(words: Sequence[Word], joints: AbstractSet[str]) -> Iterator[list[Word]]:
    thing: list[Word] = []
    for word in words:
        if word.text in joints:
            if thing:
                yield thing
            thing = []
        else:
            thing.append(word)
    if thing:
        yield thing


def _is_measured(thing: Sequence[Word], measured: AbstractSet[str]) -> bool:
    """Whether a measure stands behind a number: "1 1/2 cups flour", "1 large tin"."""
    behind = next((p for p in range(1, len(thing)) if not thing[p].is_digits), len(thing))
    return any(word.text in measured for word in thing[behind : behind + 2])


def is_number(word: Word, lexicon: Lexicon) -> bool:
    """Whether a word may say how many, or how much."""
    one = word.text in lexicon.closed.indefinite_articles
    return one or word.text[0].isdigit() or word.text in lexicon.numbers
