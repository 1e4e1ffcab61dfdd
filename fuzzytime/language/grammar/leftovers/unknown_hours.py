"""Hours and dates in numbers that nothing says more of: "iron pm", "at silly o'clock", "dentist 3/15"."""

from collections.abc import Iterator, Sequence

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.grammar.understood.lent import counts_one, lacks_unit
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Repeat

HALF = "day_half"
"""The category of halves of the day: "pm"."""

BOTH = frozenset({"and", "/", "+"})
"""What stands between two halves of the day that are both meant."""

TYPED = ("n/n", "n/y", "y/n")
"""Shapes of two numbers that may be a date, or two hours."""


def unknown_hours(scanned: Scanned, known: frozenset[int]) -> Iterator[int]:
    """Give the places of words of such hours that were not understood."""
    for kind in (_halves, _clocks, _ones, _typed):
        yield from kind(scanned, known)


def _halves(scanned: Scanned, known: frozenset[int]) -> Iterator[int]:
    """Give the places of halves of the day that stand alone: "iron pm", "am/pm"."""
    around = scanned.around
    words, lexicon = scanned.words, around.lexicon
    for place, word in enumerate(words):
        if place in known or not lexicon.means(word.text, HALF):
            continue
        before, behind = words[max(0, place - 1) : place], words[place + 1 : place + 2]
        ends = not behind or behind[0].text in {";", ",", "."}
        if ends and bool(before) and _is_left_over(words, place, lexicon):
            yield place


def _is_left_over(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a half of the day stands behind a thing, or behind the other: "iron pm", "am/pm"."""
    before = words[place - 1].text
    if before in BOTH:
        return place > 1 and lexicon.means(words[place - 2].text, HALF)
    return before[:1].isalpha() and before not in lexicon.function_words | lexicon.closed.coordinators


def _clocks(scanned: Scanned, known: frozenset[int]) -> Iterator[int]:
    """Give the places of an hour that is no number: "at silly o'clock"; not of "the o'clock news"."""
    around = scanned.around
    for place, word in enumerate(scanned.words):
        hour = word.text in around.beside.of_hours and not around.lexicon.means(word.text, HALF)
        if not hour or not place or place in known:
            continue
        *behind, _ = (*around.texts[place + 1 : place + 2], "")
        ends = all(not text.isalnum() or text in around.lexicon.function_words for text in behind)
        named = around.texts[place - 1]
        if ends and named.isalpha() and named not in around.lexicon.numbers:
            yield from (place - 1, place)


def _ones(scanned: Scanned, known: frozenset[int]) -> Iterator[int]:
    """Give the places of a number of which nothing says what it counts: "in around one", "every 10"."""
    around = scanned.around
    for piece in scanned.pieces("said"):
        said = around.texts[piece.start : piece.end]
        # "Every one of them"
        each = isinstance(piece.value.time, Repeat) and lacks_unit(piece.value)
        each = each and said[0] == "every" and said[-1] != "one"
        if not each and (around.texts[piece.start] != "in" or not counts_one(piece.value)):
            continue
        places = range(piece.start, piece.end)
        if known.isdisjoint(places) and around.may_end(piece):
            yield from places


def _typed(scanned: Scanned, known: frozenset[int]) -> Iterator[int]:
    """Give the places of two numbers that end what is asked for: "dentist 3/15", "book the court 12-2"."""
    around = scanned.around
    lexicon = around.lexicon
    numbered = lexicon.amount_nouns | lexicon.called_by_number
    counted = numbered | lexicon.no_times.set_to | lexicon.function_words
    for piece in (piece for shape in TYPED for piece in scanned.pieces(shape)):
        places = range(piece.start, piece.end)
        comma = around.before(piece) == "," and piece.start > 1
        before = around.texts[piece.start - 2] if comma else around.before(piece)
        named = before.isalpha() and counted.isdisjoint({before, before.removesuffix("s")})
        ends = around.follower(piece) in around.beside.polite_ends | around.closed.coordinators_of_days | {""}
        if named and ends and not scanned.words[piece.start].glued and known.isdisjoint(places):
            yield from places
