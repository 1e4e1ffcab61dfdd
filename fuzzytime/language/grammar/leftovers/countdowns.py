"""Times counted from one that is called by a letter: "T-30", "T minus 10", "D+1"."""

from collections.abc import Iterator

from fuzzytime.language.grammar.spans import Scanned

ZEROS = frozenset({"t", "h", "d", "l"})
"""Letters for the moment, hour or day that others are counted from."""

MOMENTS = frozenset({"t", "h"})
"""Those of them that hardly number a thing: "vitamin D-3"."""

LONGEST_COUNT = 3
"""Digits of such a number at most."""

SIGNS = frozenset({"-", "+"})
"""Marks between such a letter and the number: before it, and behind."""

MARKS = frozenset({";", ",", "."})
"""Marks behind such a time."""


def counted_from_zero(scanned: Scanned, known: frozenset[int]) -> Iterator[int]:
    """Give the places of such times: what they count from is not known."""
    words, lexicon = scanned.words, scanned.lexicon
    for place in range(len(words) - 2):
        letter, sign, number = words[place : place + 3]
        spelt = sign.text in lexicon.beside.signs and letter.text in MOMENTS
        if letter.text not in ZEROS or not (sign.text in SIGNS or spelt):
            continue
        heads = not place or words[place - 1].text in {";", ",", "at", "@"}
        ends = place + 3 == len(words) or words[place + 3].text in MARKS
        # "Vitamin D-3 at eight", "the T-1000"
        named = heads or (ends and letter.text in MOMENTS)
        whole = named and len(number.text) <= LONGEST_COUNT
        glued = sign.glued and number.is_digits and number.glued and (sign.text != "-" or letter.capital)
        counted = spelt and (number.is_digits or number.text in lexicon.numbers)
        places = range(place, place + 3)
        if known.isdisjoint(places) and ((whole and glued) or (heads and counted)):
            yield from places
