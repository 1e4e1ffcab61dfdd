"""Words that look like time and are part of no time: pointed at, never guessed."""

from collections.abc import Iterator, Sequence
from functools import cached_property

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.judging.look_alikes.figures import Figures
from fuzzytime.language.grammar.judging.look_alikes.proper_names import names_in
from fuzzytime.language.grammar.judging.look_alikes.spoken_of import is_spoken_of
from fuzzytime.language.grammar.judging.look_alikes.things_of_times import is_of_thing
from fuzzytime.language.grammar.leftovers.called_things import is_event, is_played, says_of_thing, says_which
from fuzzytime.language.grammar.leftovers.countdowns import counted_from_zero
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.grammar.surroundings.surroundings import Surroundings
from fuzzytime.language.grammar.understood.lent import counts_one, lacks_unit
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Remark, RemarkKind, Span, overlap
from fuzzytime.language.meaning.expressions import Repeat

TELLING = frozenset(
    {"unit", "day", "weekday", "weekdays", "part", "parts", "day_part", "month", "hh:mm", "hh:mm:ss", "y-m-d"}
    | {"unfinished"}
)
"""Categories of pieces that look like time."""

WEEKEND, IN = "weekend", "in"

LONGEST_WEEKEND = 6
"""Words from such a preposition to the weekend at most: "over the early may bank holiday weekend"."""

SHORTEST_MOMENT, LONGEST_MOMENT = 3, 4
"""Words from a preposition to the time that is described, at least and at most: "at the same old time"."""

HALF = "day_half"
"""The category of halves of the day: "pm"."""

BOTH = frozenset({"&", "/", "+"})
"""Marks between two halves of the day that are both meant."""

TYPED = ("n/n", "n/y", "y/n")
"""Shapes of two numbers that may be a date, or two hours."""

DAY = "day"
"""What words of days end in: "holidays", "match days", "birthday"."""

HOLIDAY = "holiday"

SHORTEST = 3
"""Letters that a unit must have to look like time by itself."""


def leftovers(scanned: Scanned, explained: Sequence[Span]) -> list[Remark]:
    """Give a remark for each stretch that looks like time and was not understood."""
    found = [
        Remark(RemarkKind.NOT_UNDERSTOOD, span, not_understood(scanned.text, span))
        for span in _joined(scanned, sorted(set(_looking(scanned, explained))))
    ]
    return [*found, *_clipped(scanned, explained)]


def _clipped(scanned: Scanned, explained: Sequence[Span]) -> Iterator[Remark]:
    """Point at what ends an order like a time without its last letter: "stir the soup soo"."""
    for place, word in enumerate(scanned.words):
        meant = scanned.lexicon.clipped.get(word.text)
        behind = scanned.words[place + 1].text if place + 1 < len(scanned.words) else ""
        if meant is None or not place or behind[:1].isalnum() or word.capital:
            continue
        if not _meets(explained, word, word):
            span = (word.start, word.end)
            message = f"{scanned.text[slice(*span)]!r} is no time that is known: did you mean {meant!r}?"
            yield Remark(RemarkKind.NOT_UNDERSTOOD, span, message)


def not_understood(text: str, span: Span) -> str:
    """Say that a stretch of a text looks like a time and is none that is known."""
    return f"{text[slice(*span)]!r} looks like a time and was not understood"


def _looking(scanned: Scanned, explained: Sequence[Span]) -> Iterator[int]:
    """Give the places of words that look like time, and are no part of a noun: "the Sunday dress"."""
    lexicon = scanned.lexicon
    around = Surroundings(scanned.words, lexicon)
    figures = _Figures(scanned, around)
    named = {place for start, end in names_in(scanned.words, lexicon) for place in range(start, end)}
    yield from counted_from_zero(scanned, explained)
    kinds = (_weekends, _other_feasts, _dates, _halves, _clocks, _ones, _moments, _untold, _typed, _left_out)
    for kind in kinds:
        yield from kind(scanned, explained, around)
    for start, cell in enumerate(scanned.cells):
        for category in TELLING & cell.keys():
            for piece in cell[category].values():
                words = scanned.words[piece.start : piece.end]
                if _meets(explained, words[0], words[-1]):
                    continue
                counted = start > 0 and "integer" in scanned.cells[start - 1]
                doubtful = words[0].text in lexicon.ambiguous or len(words[0].text) < SHORTEST
                if len(words) == 1 and words[0].is_letters and doubtful and not counted:
                    continue
                if not named.isdisjoint(range(piece.start, piece.end)) or figures.has(piece):
                    continue
                if is_of_thing(piece, around) or is_event(piece, around) or around.is_of_several(start):
                    continue
                if says_of_thing(piece, around) or says_which(piece, around) or is_played(start, around):
                    continue
                if around.describes(piece) and around.follower(piece) not in lexicon.beside.ahead:
                    continue
                yield from range(start, piece.end)


class _Figures:
    """Where figures stand that are none of times, and words that are spoken of: looked up when asked."""

    def __init__(self, scanned: Scanned, around: Surroundings) -> None:
        self._scanned, self._around = scanned, around

    def has(self, piece: Piece) -> bool:
        """Whether what looks like a time is a part of one."""
        return not self._places.isdisjoint(range(piece.start, piece.end))

    @cached_property
    def _places(self) -> frozenset[int]:
        around, figures = self._around, Figures(self._around)
        return frozenset(
            place
            for piece in self._scanned.pieces("said")
            if figures.hold(piece) or is_spoken_of(piece, around)
            for place in range(piece.start, piece.end)
        )


def _meets(explained: Sequence[Span], first: Word, last: Word) -> bool:
    """Whether some of the words from one to another were understood."""
    return any(overlap(span, (first.start, last.end)) for span in explained)


def _weekends(scanned: Scanned, explained: Sequence[Span], around: Surroundings) -> Iterator[int]:
    """Give the places of weekends that are not known: "over the bank holiday weekend"."""
    binding, openers = around.beside.before_weekends, around.closed.noun_openers
    for place, word in enumerate(scanned.words):
        if word.text != WEEKEND or _meets(explained, word, word):
            continue
        near = range(place - 2, max(-1, place - LONGEST_WEEKEND), -1)
        led = next((p for p in near if around.texts[p] in binding and around.texts[p + 1] in openers), None)
        if led is not None:
            yield from range(led + 2, place + 1)


def _other_feasts(scanned: Scanned, explained: Sequence[Span], around: Surroundings) -> Iterator[int]:
    """Give the places of feasts of calendars that are not known: "on orthodox easter"."""
    for piece in scanned.pieces("feast"):
        word = scanned.words[piece.start]
        other = around.before(piece) in around.lexicon.other_calendars
        if other and around.may_end(piece) and not _meets(explained, word, word):
            yield from range(piece.start - 1, piece.end)


def _dates(scanned: Scanned, explained: Sequence[Span], around: Surroundings) -> Iterator[int]:
    """Give the places of dates of what a thing is then: "a flight for the ninth returning the sixteenth"."""
    for place in range(1, len(scanned.words) - 1):
        word = scanned.words[place + 1]
        ends = around.texts[place + 2 : place + 3]
        typed = word.is_digits and not around.beside.ordinal_endings.isdisjoint(ends)
        led = around.texts[place] == "the" and around.texts[place - 1] in around.beside.dated
        known = _meets(explained, word, word)
        behind = around.texts[place + 2 + typed : place + 3 + typed]
        named = any(text.isalpha() and text not in around.lexicon.function_words for text in behind)
        if led and not known and not named and (typed or word.text in around.lexicon.ordinals):
            yield from range(place, place + 2 + typed)


def _halves(scanned: Scanned, explained: Sequence[Span], around: Surroundings) -> Iterator[int]:
    """Give the places of halves of the day that stand alone: "am: laundry, pm: cook", "iron pm"."""
    words, lexicon = scanned.words, around.lexicon
    for place, word in enumerate(words):
        if not lexicon.means(word.text, HALF) or _meets(explained, word, word):
            continue
        before, behind = words[max(0, place - 1) : place], words[place + 1 : place + 2]
        begins = not before or before[0].text in {";", ","}
        headed = begins and bool(behind) and behind[0].text == ":"
        ends = not behind or behind[0].text in {";", ",", "."}
        if headed or (ends and bool(before) and _is_left_over(words, place, lexicon)):
            yield place


def _clocks(scanned: Scanned, explained: Sequence[Span], around: Surroundings) -> Iterator[int]:
    """Give the places of an hour that is no number: "at silly o'clock"; not of "the o'clock news"."""
    for place, word in enumerate(scanned.words):
        hour = word.text in around.beside.of_hours and not around.lexicon.means(word.text, HALF)
        if not hour or not place or _meets(explained, word, word):
            continue
        *behind, _ = (*around.texts[place + 1 : place + 2], "")
        ends = all(not text.isalnum() or text in around.lexicon.function_words for text in behind)
        named = around.texts[place - 1]
        if ends and named.isalpha() and named not in around.lexicon.numbers:
            yield from (place - 1, place)


def _is_left_over(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a half of the day stands behind a thing, or behind the other: "iron pm", "am/pm"."""
    before = words[place - 1].text
    if before in BOTH:
        return place > 1 and lexicon.means(words[place - 2].text, HALF)
    return before[:1].isalpha() and before not in lexicon.function_words | lexicon.closed.coordinators


def _ones(scanned: Scanned, explained: Sequence[Span], around: Surroundings) -> Iterator[int]:
    """Give the places of a number of which nothing says what it counts: "in around one", "every 10"."""
    for piece in scanned.pieces("said"):
        said = around.texts[piece.start : piece.end]
        # "Every one of them"
        each = isinstance(piece.value.time, Repeat) and lacks_unit(piece.value)
        each = each and said[0] == "every" and said[-1] != "one"
        if not each and (around.texts[piece.start] != "in" or not counts_one(piece.value)):
            continue
        known = _meets(explained, scanned.words[piece.start], scanned.words[piece.end - 1])
        if not known and around.may_end(piece):
            yield from range(piece.start, piece.end)


def _moments(scanned: Scanned, explained: Sequence[Span], around: Surroundings) -> Iterator[int]:
    """Give the places of a time of which it is not known when that is: "at the usual time"."""
    closed = around.closed
    for place, word in enumerate(scanned.words):
        if word.text not in closed.named_moments or _meets(explained, word, word):
            continue
        for led in range(place - SHORTEST_MOMENT, max(-1, place - LONGEST_MOMENT - 1), -1):
            described = around.texts[led + 1] in closed.noun_openers
            binds = around.texts[led] in closed.prepositions_of_points | closed.prepositions_of_time
            if binds and described and all(text.isalpha() for text in around.texts[led:place]):
                yield from range(led, place + 1)
                break


def _untold(scanned: Scanned, explained: Sequence[Span], around: Surroundings) -> Iterator[int]:
    """Give the places of days of which nobody said when they are: "on his birthday", "over half term"."""
    beside, texts = around.beside, around.texts
    binding = beside.before_weekends - around.closed.prepositions_of_recipients | {IN}
    for place, word in enumerate(scanned.words):
        first = place - (" ".join(texts[max(0, place - 1) : place + 1]) in beside.untold_days)
        untold = " ".join(texts[first : place + 1]) in beside.untold_days
        untold = untold or (word.text.endswith(DAY) and not any(around.pieces(place)))
        if not untold or _meets(explained, word, word):
            continue
        if first and word.text.endswith("s") and "quantity" in scanned.cells[first - 1]:
            # "Call mum within 8 weekends"
            yield from range(first - 1, place + 1)
        near = range(first - 1, max(-1, first - LONGEST_MOMENT), -1)
        led = next((p for p in near if texts[p] in binding), -1)
        behind = "".join(texts[place + 1 : place + 2])
        more = behind.isalpha() and behind not in around.lexicon.function_words
        if led < 0 or (more and not around.opens(led)) or (led == first - 1 and word.text == HOLIDAY):
            # "Write it on my birthday card"; "book a week on holiday"
            continue
        if led == first - 1 or texts[led + 1] in around.closed.noun_openers:
            yield from range(led, place + 1)


def _typed(scanned: Scanned, explained: Sequence[Span], around: Surroundings) -> Iterator[int]:
    """Give the places of two numbers that end what is asked for: "dentist 3/15", "book the court 12-2"."""
    lexicon = around.lexicon
    numbered = lexicon.amount_nouns | lexicon.called_by_number
    counted = numbered | lexicon.no_times.set_to | lexicon.function_words
    for piece in (piece for shape in TYPED for piece in scanned.pieces(shape)):
        first, last = scanned.words[piece.start], scanned.words[piece.end - 1]
        comma = around.before(piece) == "," and piece.start > 1
        before = around.texts[piece.start - 2] if comma else around.before(piece)
        named = before.isalpha() and counted.isdisjoint({before, before.removesuffix("s")})
        ends = around.follower(piece) in around.beside.polite_ends | around.closed.coordinators_of_days | {""}
        if named and ends and not first.glued and not _meets(explained, first, last):
            yield from range(piece.start, piece.end)


def _left_out(scanned: Scanned, explained: Sequence[Span], around: Surroundings) -> Iterator[int]:
    """Give the places of days that are left out of others, and not known: "every weekday except holidays"."""
    texts, beside, joints = around.texts, around.beside, around.closed.coordinators
    timed = frozenset(place for place, word in enumerate(scanned.words) if _meets(explained, word, word))
    for place in range(1, len(texts)):
        denied = texts[place - 1] in beside.denying_times and texts[place] == "on"
        if place in timed or not (denied or texts[place] in beside.leaving_out):
            continue
        led = place - 1 - denied
        while led > 0 and texts[led] in beside.around_denials | {","}:
            led -= 1
        first = last = place + 1 + (texts[place + 1 : place + 2] == ["for"])
        while last < len(texts) and texts[last][:1].isalpha() and texts[last] not in joints:
            last += 1
        known = led not in timed or not timed.isdisjoint(range(first, last))
        if first < last and not known and texts[last - 1].removesuffix("s").endswith(DAY):
            yield from range(first, last)


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
