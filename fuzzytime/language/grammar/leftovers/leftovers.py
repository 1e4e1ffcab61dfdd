"""Words that look like time and are part of no time: pointed at, never guessed.

So are times counted from one that is called by a letter: "T-30". What something is called by is none:
"the 10 minute rice".
"""

from collections.abc import Iterator, Sequence
from functools import cached_property

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.look_alikes.figures import Figures
from fuzzytime.language.grammar.judging.look_alikes.spoken_of import is_spoken_of
from fuzzytime.language.grammar.judging.look_alikes.things_of_times import is_of_thing
from fuzzytime.language.grammar.leftovers.unknown_days import unknown_days
from fuzzytime.language.grammar.leftovers.unknown_hours import unknown_hours
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.grammar.surroundings.surroundings import Surroundings
from fuzzytime.language.instruction import Remark, RemarkKind, Span, overlap
from fuzzytime.language.meaning.units import UnitWord

TELLING = frozenset(
    {"unit", "day", "weekday", "weekdays", "part", "parts", "day_part", "month", "hh:mm", "hh:mm:ss", "y-m-d"}
    | {"unfinished"}
)
"""Categories of pieces that look like time."""

SHORTEST = 3
"""Letters that a unit must have to look like time by itself."""

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


def leftovers(scanned: Scanned, explained: Sequence[Span]) -> list[Remark]:
    """Give a remark for each stretch that looks like time and was not understood."""
    known = frozenset(
        place
        for place, word in enumerate(scanned.words)
        if any(overlap(span, (word.start, word.end)) for span in explained)
    )
    if len(known) == len(scanned.words):
        return []
    found = [
        Remark(RemarkKind.NOT_UNDERSTOOD, span, not_understood(scanned.text, span))
        for span in _joined(scanned, sorted(set(_looking(scanned, known))))
    ]
    return [*found, *_clipped(scanned, known)]


def _clipped(scanned: Scanned, known: frozenset[int]) -> Iterator[Remark]:
    """Point at what ends an order like a time without its last letter: "stir the soup soo"."""
    for place, word in enumerate(scanned.words):
        meant = scanned.lexicon.clipped.get(word.text)
        behind = scanned.words[place + 1].text if place + 1 < len(scanned.words) else ""
        if meant is None or not place or behind[:1].isalnum() or word.capital:
            continue
        if place not in known:
            span = (word.start, word.end)
            message = f"{scanned.text[slice(*span)]!r} is no time that is known: did you mean {meant!r}?"
            yield Remark(RemarkKind.NOT_UNDERSTOOD, span, message)


def not_understood(text: str, span: Span) -> str:
    """Say that a stretch of a text looks like a time and is none that is known."""
    return f"{text[slice(*span)]!r} looks like a time and was not understood"


def _looking(scanned: Scanned, known: frozenset[int]) -> Iterator[int]:
    """Give the places of words that look like time, and are no part of a noun: "the Sunday dress"."""
    around, lexicon = scanned.around, scanned.lexicon
    figures = _Figures(scanned)
    yield from counted_from_zero(scanned, known)
    yield from unknown_days(scanned, known)
    yield from unknown_hours(scanned, known)
    for start, cell in enumerate(scanned.cells):
        for category in TELLING & cell.keys():
            for piece in cell[category].values():
                words = scanned.words[piece.start : piece.end]
                if not known.isdisjoint(range(piece.start, piece.end)):
                    continue
                counted = start > 0 and start - 1 not in known and "integer" in scanned.cells[start - 1]
                # "Call me in minutes", but "write up minutes"
                led = start > 0 and scanned.words[start - 1].text in lexicon.closed.prepositions_of_nouns
                doubtful = words[0].text in lexicon.ambiguous and not (led and words[0].text.endswith("s"))
                doubtful = doubtful or len(words[0].text) < SHORTEST
                if len(words) == 1 and words[0].is_letters and doubtful and not counted:
                    continue
                if not around.known_names.isdisjoint(range(piece.start, piece.end)) or figures.has(piece):
                    continue
                if (
                    _is_named(piece, known, around)
                    or is_of_thing(piece, around)
                    or is_event(piece, around)
                    or around.is_of_several(start)
                ):
                    continue
                if says_of_thing(piece, around) or says_which(piece, around) or is_played(start, around):
                    continue
                if around.describes(piece) and around.follower(piece) not in lexicon.beside.ahead:
                    continue
                yield from range(start, piece.end)


class _Figures:
    """Where figures stand that are none of times, and words that are spoken of: looked up when asked."""

    def __init__(self, scanned: Scanned) -> None:
        self._scanned = scanned

    def has(self, piece: Piece) -> bool:
        """Whether what looks like a time is a part of one."""
        return not self._places.isdisjoint(range(piece.start, piece.end))

    @cached_property
    def _places(self) -> frozenset[int]:
        around, figures = self._scanned.around, Figures(self._scanned.around)
        return frozenset(
            place
            for piece in self._scanned.pieces("said")
            if figures.hold(piece) or is_spoken_of(piece, around)
            for place in range(piece.start, piece.end)
        )


def _joined(scanned: Scanned, places: Sequence[int]) -> Iterator[Span]:
    """Join neighbours into stretches, with the number before them."""
    start = None
    for position, place in enumerate(places):
        if start is None:
            start = place
            before = scanned.words[place - 1] if place else None
            counts = scanned.words[place].text not in scanned.lexicon.closed.prepositions_of_points
            if before is not None and counts and (before.is_digits or "integer" in scanned.cells[place - 1]):
                start = place - 1
        if position + 1 == len(places) or places[position + 1] != place + 1:
            yield scanned.words[start].start, scanned.words[place].end
            start = None


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


def is_played(start: int, around: Surroundings) -> bool:
    """Whether a word is of the title of what is played: "play yesterday by the beatles", "Play Sunday Rain".

    That is the time words right behind the verb, or words with capitals.
    """
    verb = next((place for place in range(start) if around.plays(place)), start)
    title = range(verb + 1, start + 1)
    capital = all(around.words[p].capital or around.texts[p] in around.closed.articles for p in title)
    timely = all(around.timely(p) or around.is_number(p) for p in title)
    return verb < start and (capital or timely)


def says_which(piece: Piece, around: Surroundings) -> bool:
    """Whether a length says which thing it is: "the 10 minute rice"; but "boil a ten minute egg" may last."""
    unit = isinstance(piece.value, UnitWord) and not around.texts[piece.start].endswith("s")
    thing = around.follower(piece)
    named = thing.isalpha() and thing not in around.lexicon.function_words and not around.timely(piece.end)
    counted = piece.start > 1 and around.is_number(piece.start - 1)
    led = around.texts[piece.start - 2] if counted else ""
    known = led in around.closed.sure_noun_openers - around.closed.indefinite_determiners
    # "The cheddar, aged twelve months"
    return counted and ((unit and named and known) or led == "aged")


def _is_named(piece: Piece, known: frozenset[int], around: Surroundings) -> bool:
    """Whether it is what goes on at the hour beside it: "8:30 bedtime", "10:40 - 10:55: morning snack"."""
    if piece.category != "part":
        return False
    before, behind = {piece.start - 2, piece.start - 1}, {piece.end, piece.end + 1}
    marked = piece.start > 0 and around.texts[piece.start - 1] == ":" and not known.isdisjoint(before)
    follower = around.follower(piece)
    thing = follower.isalpha() and follower not in around.lexicon.function_words
    # "Milk at eight, morning coffee at ten", "3pm afternoon tea"
    beside = not known.isdisjoint(before | behind)
    begins = beside and (around.before(piece) in MARKS or piece.start - 1 in known)
    return (piece.value.event and beside) or ((marked or begins) and thing)


def is_event(piece: Piece, around: Surroundings) -> bool:
    """Whether it ends what happens, or a greeting, or gets a time: "parents evening", "set bedtime for 8"."""
    given = around.before(piece) in around.lexicon.moving | around.lexicon.appointing
    return around.ends_name(piece.start) or (given and piece.category == "part")


def says_of_thing(piece: Piece, around: Surroundings) -> bool:
    """Whether a unit says what a thing is like: "a 24 hour pharmacy", "the soup of the day"."""
    if piece.category != "unit" or piece.end - piece.start > 1:
        return False
    if around.belongs(piece.start - 1):
        return around.texts[piece.start - 1] in around.closed.the and around.may_end(piece)
    before, unit, thing = around.before(piece), around.texts[piece.start], around.follower(piece)
    counted = before.isdigit() or before in around.lexicon.numbers
    single = isinstance(piece.value, UnitWord) and unit == piece.value.unit.value
    known = thing in around.lexicon.function_words or around.timely(piece.end)
    # "Boil a ten minute egg" may say how long.
    lasts = not around.lexicon.timing.isdisjoint(around.texts[: piece.start])
    # "In 2 ten minute blocks"
    several = piece.start > 1 and around.is_number(piece.start - 2)
    return counted and single and thing.isalpha() and not (known or lasts or several)
