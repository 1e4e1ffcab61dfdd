"""What is named by the part of the day in which it is, beside its hour: "8:30 bedtime", "Lunch time 1 pm"."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Phrase, Range, Said, Wall
from fuzzytime.language.meaning.phrases import places_in
from fuzzytime.language.meaning.times_of_day import Half, Part
from fuzzytime.language.sentence.segments.segment import ENDS


def with_named_events(scanned: Scanned, phrases: Sequence[Phrase]) -> list[Phrase]:
    """Give times without such a part of the day, where its hour, and perhaps a thing, stand beside it."""
    events = [piece for piece in scanned.pieces("part") if piece.value.event]
    inside, found = places_in(phrases), list(phrases)
    marks = (p for p, word in enumerate(scanned.words) if word.text in ENDS | {","} and p not in inside)
    for before, end in pairwise((-1, *marks, len(scanned.words))) if events else ():
        whole = [piece for piece in events if before < piece.start and piece.end <= end]
        event = max(whole, key=lambda piece: piece.end - piece.start, default=None)
        hour = None if event is None else _hour_beside(scanned, event, before + 1, end)
        if event is not None and hour is not None:
            span = scanned.words[hour.start].start, scanned.words[hour.end - 1].end
            said = _in_half(hour.value, event.value)
            found = [phrase for phrase in found if not before < phrase.first < end]
            found.append(Phrase(said, hour.start, hour.end, span, hour.rule))
    return sorted(found, key=lambda phrase: phrase.first)


def _hour_beside(scanned: Scanned, event: Piece, first: int, end: int) -> Piece | None:
    """Give the hour, or from when to when, that is all that stands beside a part of the day."""
    for piece in sorted(scanned.pieces("said"), key=lambda one: one.start - one.end):
        apart = first <= piece.start and piece.end <= end
        apart = apart and (piece.end <= event.start or piece.start >= event.end)
        last = scanned.words[piece.end - 1].text
        if apart and last in scanned.lexicon.beside.of_hours and not scanned.lexicon.means(last, "day_half"):
            # "12 o'clock lunchtime" is a time of day.
            return None
        if apart and _is_hour(piece.value):
            # As a story is in "8:30 bedtime story".
            things = _things(scanned.words[event.end : end], scanned.lexicon)
            told = {*range(event.start, event.end + things), *range(piece.start, piece.end)}
            others = (scanned.words[place] for place in range(first, end) if place not in told)
            return None if any(word.text[0].isalnum() for word in others) else piece
    return None


def _things(words: Sequence[Word], lexicon: Lexicon) -> int:
    """Give how many words behind a part of the day say more of it: "story", "for the kids"."""
    first = words[0].text if words else "the"
    opens = first in lexicon.closed.prepositions_of_nouns or first not in lexicon.function_words
    whole = opens and not any(word.is_digits or lexicon.means(word.text, "unit") for word in words)
    return len(words) if whole else 0


def _is_hour(said: Said) -> bool:
    """Whether it is by the clock, and of no part of the day."""
    time = said.time
    sides = (time.first, time.last) if isinstance(time, Range) else (time,)
    return all(isinstance(one, Wall) and one.clock is not None and one.part is None for one in sides)


def _in_half(said: Said, part: Part) -> Said:
    """Give an hour in the half of the day in which a part of the day is, where it says none."""
    time = said.time
    if not isinstance(time, Wall) or time.clock is None or time.clock.half is not None:
        return said
    half = part.half if part.half in {Half.AM, Half.PM} else None
    return replace(said, time=replace(time, clock=replace(time.clock, half=half)))
