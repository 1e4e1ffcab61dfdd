"""Words that look like time and are part of no time: pointed at, never guessed."""

from collections.abc import Iterator, Sequence

from fuzzytime.language.grammar.called_things import is_event, is_played, says_which
from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.lent import counts_one
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.spans import Scanned
from fuzzytime.language.grammar.surroundings import Surroundings
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Remark, RemarkKind, Span
from fuzzytime.language.meaning.expressions import UnitWord
from fuzzytime.language.meaning.relations import Relative, Which
from fuzzytime.requirement import Unit

TELLING = frozenset(
    {"unit", "day", "weekday", "weekdays", "part", "parts", "day_part", "month", "hh:mm", "hh:mm:ss", "y-m-d"}
    | {"unfinished"}
)
"""Categories of pieces that look like time."""

WEEKEND = "weekend"

LONGEST_WEEKEND = 6
"""Words from such a preposition to the weekend at most: "over the early may bank holiday weekend"."""

DEICTICS = frozenset(Which)
"""Words before a unit that say which: "next week"."""

ZEROS = frozenset({"t", "h", "d", "l"})
"""Letters for the moment, hour or day that others are counted from."""

MOMENTS = frozenset({"t", "h"})
"""Those of them that hardly number a thing: "vitamin D-3"."""

HALF = "day_half"
"""The category of halves of the day: "pm"."""

BOTH = frozenset({"&", "/", "+"})
"""Marks between two halves of the day that are both meant."""

LONGEST_COUNT = 3
"""Digits of such a number at most."""

SIGNS = frozenset({"-", "+"})
"""Marks between such a letter and the number: before it, and behind."""

BOUND = frozenset({"in", "for", "during", "within", "of", "at", "on", "until", "before", "after", "by"})
"""Prepositions that make a day of what is named behind them."""

SHORTEST = 3
"""Letters that a unit must have to look like time by itself."""


def leftovers(scanned: Scanned, explained: Sequence[Span], lexicon: Lexicon) -> list[Remark]:
    """Give a remark for each stretch that looks like time and was not understood."""
    found = [
        Remark(RemarkKind.NOT_UNDERSTOOD, span, not_understood(scanned.text, span))
        for span in _joined(scanned, sorted(set(_looking(scanned, explained, lexicon))))
    ]
    return [*found, *_clipped(scanned, explained, lexicon)]


def _clipped(scanned: Scanned, explained: Sequence[Span], lexicon: Lexicon) -> Iterator[Remark]:
    """Point at what ends an order like a time without its last letter: "stir the soup soo"."""
    for place, word in enumerate(scanned.words):
        meant = lexicon.clipped.get(word.text)
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


def _looking(scanned: Scanned, explained: Sequence[Span], lexicon: Lexicon) -> Iterator[int]:
    """Give the places of words that look like time, and are no part of a noun: "the Sunday dress"."""
    around = Surroundings(scanned.words, lexicon)
    yield from _weekends(scanned, explained, around)
    yield from _dates(scanned, explained, around)
    yield from _counted_from_zero(scanned, explained)
    yield from _halves(scanned, explained, lexicon)
    yield from _ones(scanned, explained, around)
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
                if (
                    around.is_name(piece)
                    or around.is_object(start)
                    or (around.before(piece) == "to" and around.names_place(piece))
                    or _is_noun(piece, around)
                    or _is_title(piece, around)
                    or _is_share(piece, scanned)
                    or _is_rate(piece, around)
                    or (category.startswith("hh") and (around.cites(start) or around.before(piece) == "the"))
                    or (around.describes(piece) and around.follower(piece) not in lexicon.beside.ahead)
                    or _is_compound(piece, around)
                    or _is_owner(piece, around)
                    or is_event(piece, around)
                    or around.has_title(start)
                    or around.is_somebody(start)
                    or says_which(piece, around)
                    or is_played(start, around)
                    or _is_from_the_past(piece, around)
                ):
                    continue
                yield from range(start, piece.end)
        for piece in cell.get("feast", {}).values():
            # "On orthodox easter"
            other = start > 0 and around.texts[start - 1] in lexicon.other_calendars
            word = scanned.words[piece.start]
            if other and around.may_end(piece) and not _meets(explained, word, word):
                yield from range(start - 1, piece.end)


def _meets(explained: Sequence[Span], first: Word, last: Word) -> bool:
    """Whether some of the words from one to another were understood."""
    return any(begin < last.end and first.start < end for begin, end in explained)


def _weekends(scanned: Scanned, explained: Sequence[Span], around: Surroundings) -> Iterator[int]:
    """Give the places of weekends that are not known: "over the bank holiday weekend"."""
    for place, word in enumerate(scanned.words):
        if word.text != WEEKEND or _meets(explained, word, word):
            continue
        led = next(
            (p for p in range(place - 2, max(-1, place - LONGEST_WEEKEND), -1) if _binds(around, p)), None
        )
        if led is not None:
            yield from range(led + 2, place + 1)


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


def _counted_from_zero(scanned: Scanned, explained: Sequence[Span]) -> Iterator[int]:
    """Give the places of times counted from one that is called by a letter: "T-30", "H-2", "D+1"."""
    words = scanned.words
    for place in range(len(words) - 2):
        letter, sign, number = words[place : place + 3]
        if letter.text not in ZEROS:
            continue
        heads = not place or words[place - 1].text in {";", ",", "at", "@"}
        ends = place + 3 == len(words) or words[place + 3].text in {";", ",", "."}
        # "Vitamin D-3 at eight", "the T-1000"
        named = heads or (ends and letter.text in MOMENTS)
        whole = named and len(number.text) <= LONGEST_COUNT
        counts = sign.text in SIGNS and sign.glued and number.is_digits and number.glued
        signed = sign.text != "-" or letter.capital
        if whole and counts and signed and not _meets(explained, letter, number):
            yield from range(place, place + 3)


def _halves(scanned: Scanned, explained: Sequence[Span], lexicon: Lexicon) -> Iterator[int]:
    """Give the places of halves of the day that stand alone: "am: laundry, pm: cook", "iron pm"."""
    words = scanned.words
    for place, word in enumerate(words):
        if not lexicon.means(word.text, HALF) or _meets(explained, word, word):
            continue
        before, behind = words[max(0, place - 1) : place], words[place + 1 : place + 2]
        begins = not before or before[0].text in {";", ","}
        headed = begins and bool(behind) and behind[0].text == ":"
        ends = not behind or behind[0].text in {";", ",", "."}
        if headed or (ends and bool(before) and _is_left_over(words, place, lexicon)):
            yield place


def _is_left_over(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a half of the day stands behind a thing, or behind the other: "iron pm", "am/pm"."""
    before = words[place - 1].text
    if before in BOTH:
        return place > 1 and lexicon.means(words[place - 2].text, HALF)
    return before[:1].isalpha() and before not in lexicon.function_words | lexicon.closed.coordinators


def _is_rate(piece: Piece, around: Surroundings) -> bool:
    """Whether so much of something is in it: "10/min", "5 ml/min"."""
    stroke = around.texts[piece.start - 1] if piece.start else ""
    return stroke == "/" and around.words[piece.start].glued and around.words[piece.start - 1].glued


def _ones(scanned: Scanned, explained: Sequence[Span], around: Surroundings) -> Iterator[int]:
    """Give the places of a one of which nothing says what it counts: "in around one"."""
    for piece in scanned.pieces("said"):
        if around.texts[piece.start] != "in" or not counts_one(piece.value):
            continue
        known = _meets(explained, scanned.words[piece.start], scanned.words[piece.end - 1])
        if not known and around.may_end(piece):
            yield from range(piece.start, piece.end)


def _binds(around: Surroundings, place: int) -> bool:
    """Whether a preposition that binds times, and an article, stand at a place."""
    return (
        around.texts[place] in around.beside.before_weekends
        and around.texts[place + 1] in around.closed.noun_openers
    )


def _is_share(piece: Piece, scanned: Scanned) -> bool:
    """Whether it is a part of a thing: "three quarters of the flour", "at the end of the film"."""
    unit = piece.value.unit if isinstance(piece.value, UnitWord) else None
    behind = scanned.words[piece.end].text if piece.end < len(scanned.words) else ""
    return behind == "of" and (unit is Unit.QUARTER or piece.category == "unfinished")


def _is_title(piece: Piece, around: Surroundings) -> bool:
    """Whether it is a part of the day that begins the name of a thing: "Evening tablets at nine"."""
    named = around.follower(piece)
    known = named in around.lexicon.function_words or around.timely(piece.end)
    told = named in around.lexicon.beside.saying
    return piece.category == "part" and piece.start == 0 and (told or (named.isalpha() and not known))


def _is_from_the_past(piece: Piece, around: Surroundings) -> bool:
    """Whether it says of which time a thing is that was: "the report of last week", "mail from yesterday"."""
    place = piece.start - (around.before(piece) == "last")
    last = "last" in around.texts[place : piece.end]
    past = last or (isinstance(piece.value, Relative) and piece.value.days < 0)
    return past and around.belongs(place)


def _is_owner(piece: Piece, around: Surroundings) -> bool:
    """Whether a thing is of that time: "next week's shifts", but not "by next week's end"."""
    led = piece.start - (around.before(piece) in DEICTICS)
    leading = around.pieces(led - 1) if led else []
    bound = led > 0 and around.texts[led - 1] in around.closed.prepositions_of_time
    if bound or any(said.category.startswith("preposition") for said in leading):
        return False
    thing = around.texts[piece.end + 1 : piece.end + 2]
    timely = around.timely(piece.end + 1) or not around.lexicon.ordinals.keys().isdisjoint(thing)
    return around.follower(piece) == "'s" and bool(thing) and thing[0].isalpha() and not timely


def _is_compound(piece: Piece, around: Surroundings) -> bool:
    """Whether it is a unit that a hyphen makes an adjective: "the 24-hour shop"."""
    first, before = around.words[piece.start], around.words[piece.start - 1] if piece.start else None
    # Between number words, which "second" may be one of, the hyphen is left out.
    hyphenated = before is not None and first.glued and (before.text == "-" or before.end < first.start)
    joined = around.follower(piece) == "-" or not around.may_end(piece)
    return piece.category == "unit" and hyphenated and joined


def _is_noun(piece: Piece, around: Surroundings) -> bool:
    """Whether it is a unit that is a thing, or a manner: "mark the day", "sort the bills by month"."""
    if piece.category == "unit" and around.before(piece) == "into":
        # "Cut it into quarters"
        return True
    if piece.category == "unit" and "by" in around.texts[max(0, piece.start - 3) : piece.start]:
        # "Push the meeting back by half an hour": how much later, and no time.
        return True
    verb = around.texts[piece.start - 2] if piece.start > 1 else ""
    if piece.category == "unit" and verb in around.beside.amounts_of_time:
        # "Rewind two minutes"
        return True
    numbered = piece.end < len(around.words) and around.words[piece.end].is_digits
    if piece.category == "unit" and numbered and around.words[piece.start].capital:
        # "Year 4"
        return True
    called = around.before(piece)
    led = around.texts[max(0, piece.start - 3) : piece.start - 1]
    one = bool(led) and BOUND.isdisjoint(led)
    if piece.category == "unit" and called.isalpha() and (around.texts[piece.start].endswith("s") or one):
        # "Visiting hours", "it's trash day"; but "on boss day"
        known = called in around.lexicon.function_words or called in around.lexicon.entries
        if not known and called not in around.lexicon.numbers:
            return True
    named = around.before(piece) in around.closed.of_units
    behind = around.texts[piece.start - 2] if piece.start > 1 else ""
    bound = behind in BOUND
    return piece.category == "unit" and named and not bound


def _joined(scanned: Scanned, places: Sequence[int]) -> Iterator[Span]:
    """Join neighbours into stretches, with the number before them."""
    start = None
    for position, place in enumerate(places):
        if start is None:
            start = place
            before = scanned.words[place - 1] if place else None
            if before is not None and (before.is_digits or "integer" in scanned.cells[place - 1]):
                start = place - 1
        if position + 1 == len(places) or places[position + 1] != place + 1:
            yield scanned.words[start].start, scanned.words[place].end
            start = None
