"""Dates in front of an entry that would be none alone: "11/3 dentist 9:30", "12th: plumber 8-10"."""

import itertools
from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.english import singular
from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.surroundings.measuring import LARGEST_SHARE
from fuzzytime.language.grammar.surroundings.surroundings import Surroundings
from fuzzytime.language.grammar.timetables import MINUTED, MINUTES, counts_nothing, has_time
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Phrase, Wall

LINE_STARTS = frozenset({";", "\n", "-", "*", "]", "•"})
"""Marks that an entry stands behind."""

HALF = "parts.half_alone"
"""The rule of "am" and "pm" without an hour."""

HEADS_ALONE = frozenset({HALF, "nights_and_weekends.weekend_alone", "parts.night_before"})
"""The rules of what is a time only as the head of a list: "AM: post, bank", "night before: soak beans"."""

ENDS = frozenset({".", "!"})
"""Marks behind a sentence."""

STOPS = ENDS | {","}
"""Marks behind an entry or a sentence."""

HEADS = frozenset({":", "-"})
"""Marks behind a date in front of an entry."""

COMPOUND = 2
"""Words, at most, of what is done in a part of a day: "dog walk"."""

FEW = 5
"""Up to here an ordinal with a mark behind it counts steps: "2nd: rinse"."""


def heads_list(words: Sequence[Word], start: int, end: int) -> bool:
    """Whether a colon behind words makes them the head of what stands behind it: "AM: post, bank"."""
    begins = not start or words[start - 1].text in LINE_STARTS | STOPS | HEADS
    behind = [word.text for word in words[end : end + 1]]
    return begins and behind == [":"] and end + 1 < len(words)


def ends_entry(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> bool:
    """Whether a half of the day stands behind what is done then: "gym am, shops pm"; but "I am".

    A bracket may stand between: "sports day (pm)", "one pill (am and pm)".
    """
    joints = lexicon.closed.joints_of_orders
    halved = [word.text in lexicon.beside.of_hours for word in words[max(0, start - 2) : max(0, start - 1)]]
    # "Walk the dog am & pm"
    place = start - (3 if halved == [True] and words[start - 1].text in joints else 1)
    place -= place >= 0 and words[place].text == "("
    named = place >= 0 and words[place].is_letters and words[place].text not in lexicon.function_words
    return named and all(word.text in LINE_STARTS | STOPS | joints | {")"} for word in words[end : end + 1])


def is_activity_in_part(piece: Piece, around: Surroundings) -> bool:
    """Whether a part of a day and what is done in it are an entry: "evening walk", "early morning swim"."""
    words, lexicon = around.words, around.lexicon
    ends = LINE_STARTS | ENDS | lexicon.closed.joints_of_orders
    end = next((p for p in range(piece.end, len(words)) if words[p].text in ends), len(words))
    behind = words[piece.end : end]
    noun = list(itertools.takewhile(lambda word: word.text not in lexicon.function_words, behind))
    timed = any(around.pieces(place) or words[place].is_digits for place in range(piece.end, end))
    opens = not piece.start or words[piece.start - 1].text in LINE_STARTS | ENDS
    return opens and not timed and 0 < len(noun) <= COMPOUND and _is_activity(noun[-1], lexicon)


def _is_activity(word: Word, lexicon: Lexicon) -> bool:
    """Whether a word names what is done, or happens, in some part of a day."""
    known = lexicon.lasting | lexicon.happening | lexicon.taken | lexicon.beside.in_parts
    return not known.isdisjoint({word.text, singular(word.text)})


def is_of_timed_activity(piece: Piece, around: Surroundings) -> bool:
    """Whether a part of a day is of what has its hour right behind it: "morning run 7am"."""
    words, lexicon = around.words, around.lexicon
    opens, hour = not piece.start or words[piece.start - 1].text in LINE_STARTS | STOPS, piece.end + 1
    timed = hour < len(words) and words[hour].is_digits
    return opens and timed and _is_activity(words[piece.end], lexicon)


def dates_entry(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> bool:
    """Whether numbers in front of an entry are its date, and no share of what stands behind them.

    A mark says so ("12th: plumber"), or what happens ("14/3 party"), or a clock time ("11/3 dentist 9:30");
    "1/2 cup" and "3/4 pages" are shares, and "2nd coat 9:30" is counted.
    """
    if (start and words[start - 1].text not in LINE_STARTS) or end >= len(words):
        return False
    if not words[start + (words[start].text in lexicon.closed.the)].is_digits:
        return False
    typed = any(word.text == "/" for word in words[start:end])
    numbers = [int(word.text) for word in words[start:end] if word.is_digits]
    if not typed and (words[end - 1].text not in lexicon.beside.ordinal_endings or numbers[0] <= FEW):
        return False
    if words[end].text in HEADS:
        # "10/12:30" is none.
        return not words[end].glued or (end + 1 < len(words) and not words[end + 1].glued)
    if not typed or not words[end].is_letters:
        return False
    if has_time(words[end].text, lexicon):
        return True
    share = numbers[0] < numbers[-1] <= LARGEST_SHARE
    thing = _last_of_compound(words, end)
    return not share and counts_nothing(words, thing, lexicon, plural=True) and _is_clocked(words, thing)


def sure_in_front(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> Phrase:
    """Give a time as a sure day, where it is the date of an entry."""
    time = phrase.said.time
    weak = isinstance(time, Wall) and time.weak and time.clock is None
    dated = weak and dates_entry(words, phrase.first, phrase.end, lexicon)
    return replace(phrase, said=phrase.said.sure) if dated else phrase


def beside_name(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> Phrase:
    """Give the hour of an entry without the part of the day that names what is then: "3pm | afternoon tea".

    What it says of the hour is kept: "9:30 evening prayer" is in the evening.
    """
    last, wall = phrase.end - 1, phrase.said.wall
    told = wall.clock is None or wall.part is None or not words[last - 1].text.isalnum()
    if told or last <= phrase.first or words[last - 1].text in lexicon.function_words:
        return phrase
    names = lexicon.means(words[last].text, "part") and _ends_in_activity(phrase.end, words, lexicon)
    return replace(phrase, end=last, span=(phrase.span[0], words[last - 1].end)) if names else phrase


def _ends_in_activity(place: int, words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether what is done, or happens, stands at a place, and nothing behind it in its entry."""
    ends = LINE_STARTS | STOPS
    end = next((p for p in range(place, len(words)) if words[p].text in ends), len(words))
    noun = words[place:end]
    alone = all(word.is_letters and word.text not in lexicon.function_words for word in noun)
    return alone and 0 < len(noun) <= COMPOUND and _is_activity(noun[-1], lexicon)


def _last_of_compound(words: Sequence[Word], place: int) -> int:
    """Give the last of the words that hyphens join to one: "x-ray"."""
    while place + 2 < len(words) and words[place + 1].text == "-" and words[place + 1].glued:
        if not (words[place + 2].is_letters and words[place + 2].glued):
            break
        place += 2
    return place


def _is_clocked(words: Sequence[Word], place: int) -> bool:
    """Whether a clock time with its minutes stands behind a place in the same entry: "9:30"."""
    for hour in range(place, len(words) - MINUTED + 1):
        if words[hour].text in LINE_STARTS:
            return False
        number, colon, minute = words[hour : hour + MINUTED]
        typed = number.is_digits and colon.text == ":" and minute.is_digits
        if typed and colon.glued and minute.glued and int(minute.text) < MINUTES:
            return True
    return False
