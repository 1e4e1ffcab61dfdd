"""What begins a clause in front: "when", "an hour before", "(on) the evening before"."""

from collections.abc import Sequence
from dataclasses import dataclass

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Duration, Phrase
from fuzzytime.language.sentence.clauses.before_markers import OF, counts_within
from fuzzytime.requirement import Unit

DAYS_APART = frozenset({"before", "after"})
"""Markers before which a part of a day, or a day, is that before or after."""

LEAST = 3
"""Words of "the evening before", and of "and nobody calls"."""


BOUNDS = frozenset({"preposition_before", "preposition_after"})
"""Categories of what bounds a length of time that counts from an event."""


@dataclass(frozen=True, slots=True)
class Marker:
    """What begins a clause: its kind, the character where the clause begins, the place behind the marker."""

    kind: str
    start: int
    end: int


def marker_at(
    words: Sequence[Word], phrases: Sequence[Phrase], place: int, end: int, lexicon: Lexicon
) -> Marker | None:
    """Give the marker of a clause at a place; a length of time, or a day, may stand before it.

    ``end`` is the character where what it leads is over.
    """
    before = next((phrase for phrase in phrases if phrase.first == place), None)
    before = _bounded(words, phrases, place, lexicon) if before is None else before
    first = _behind_day(words, place, lexicon) if before is None else before.end
    inside = any(phrase.first <= first < phrase.end for phrase in phrases)
    if first >= len(words) or words[first].start >= end or inside:
        return None
    if before is not None and words[first].text == OF and counts_within(before):
        # "Within ten minutes of landing"
        return Marker("after", words[place].start, first + 1)
    form = longest_match(words, first, lexicon.clauses)
    return None if form is None else Marker(lexicon.clauses[form], words[place].start, first + len(form))


def _bounded(words: Sequence[Word], phrases: Sequence[Phrase], place: int, lexicon: Lexicon) -> Phrase | None:
    """Give the length of time behind a bound of a clause: "no later than an hour after waking"."""
    bounds = [piece.end for piece in lexicon.pieces(words, place) if piece.category in BOUNDS]
    lengths = (phrase for phrase in phrases if isinstance(phrase.said.time, Duration))
    return next((phrase for phrase in lengths if phrase.first in bounds), None)


def second_marker(
    words: Sequence[Word], phrases: Sequence[Phrase], place: int, end: int, lexicon: Lexicon
) -> Marker | None:
    """Give the marker of a further clause in front, behind the comma of the one before it."""
    if place >= end:
        return None
    place += words[place].text in lexicon.closed.conjunctions
    marker = marker_at(words, phrases, place, words[end].start, lexicon)
    return marker if marker is not None and marker.end < end else None


def _behind_day(words: Sequence[Word], place: int, lexicon: Lexicon) -> int:
    """Give the place of the marker that a day counts from: "(on) the evening before the party"."""
    begin = place + (words[place].text == "on")
    named = [word.text for word in words[begin : begin + 3]]
    if len(named) < LEAST or named[0] not in lexicon.closed.articles or named[2] not in DAYS_APART:
        return place
    counted = any(
        piece.category == "part" or (piece.category == "unit" and piece.value.unit is Unit.DAY)
        for piece in lexicon.pieces(words, begin + 1)
        if piece.end == begin + 2
    )
    return begin + 2 if counted else place


def goes_on_behind(words: Sequence[Word], comma: int, following: int, lexicon: Lexicon) -> bool:
    """Whether another thing that must be so stands between two commas: ", and the oil shimmers,"."""
    said = [word.text for word in words[comma + 1 : following]]
    return (
        len(said) >= LEAST
        and said[0] in lexicon.closed.conjunctions_of_times
        and said[1] in lexicon.closed.condition_openers
    )


def is_dated_behind(
    words: Sequence[Word], phrases: Sequence[Phrase], comma: int, following: int, lexicon: Lexicon
) -> bool:
    """Whether two commas hold when an event in front is: "before the party, which is at eight, …"."""
    led = words[comma + 1].text in lexicon.closed.nonrestrictive_relatives
    return led and any(comma + 2 < phrase.first < phrase.end == following for phrase in phrases)
