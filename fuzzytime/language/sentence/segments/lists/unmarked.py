"""Entries that end in their times and follow each other without a mark: "bath at six story at seven".

Words and times take turns there, and none of the words leads to what stands behind a time. A comma is put
between them, which tells apart what is each by itself, or is done with the next as well: "feed the cat at 8
the dog at 9".
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.timetables import has_time
from fuzzytime.language.grammar.words import Word, words_of
from fuzzytime.language.meaning.expressions import Phrase, TimeWord
from fuzzytime.language.meaning.phrases import is_window
from fuzzytime.language.sentence.references.phrase_anchors import ORDERING
from fuzzytime.language.sentence.segments.lists.entries import is_when

STRETCH = re.compile(r"[^\n;,]+")
"""What stands between two marks."""

PAIR, LIST = 2, 3
"""Entries at least, and of those of which a number alone may be the time."""

LONGEST = 6
"""Words of an entry without its time at most."""


@dataclass(frozen=True, slots=True)
class _Time:
    """Where a time begins and ends, and whether it is ``sure``: neither a number alone, nor a day."""

    first: int
    end: int
    sure: bool


def with_commas(text: str, grammar: Grammar, lexicon: Lexicon) -> str:
    """Give a text of the same length with a comma behind each such entry but the last."""
    for stretch in STRETCH.finditer(text):
        if _may_hold_several(words_of(stretch[0]), lexicon):
            for pause in _ends(Scanned.of(stretch[0], grammar, lexicon)):
                place = stretch.start() + pause
                text = f"{text[:place]},{text[place + 1 :]}"
    return text


def _may_hold_several(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether there may be two times, and words between: most lines are no list, and to scan costs time."""
    numbers = lexicon.numbers.keys() | lexicon.beside.parts_of_hours
    timed = [
        word.is_digits or word.text in numbers or lexicon.means(word.text, "part", "weekday", "word")
        for word in words
    ]
    return sum(new and not old for old, new in pairwise([False, *timed])) >= PAIR


def _ends(scanned: Scanned) -> Iterator[int]:
    """Give where the pause behind an entry is."""
    words, lexicon = scanned.words, scanned.lexicon
    times = list(_times(scanned))
    ends = [0, *(time.end for time in times)]
    names = [words[a : b.first] for a, b in zip(ends, times, strict=False)]
    rest = [word for word in words[ends[-1] :] if word.text not in {".", "!"}]
    sure = sum(time.sure for time in times)
    named = sum(bool(name) and has_time(name[-1].text, lexicon) for name in names)
    least = PAIR if sure == len(times) else LIST
    if len(times) < least or rest or not (sure or named):
        return
    # "Stir 1.50 cups of flour in for ten minutes"
    measured = any(
        words[time.first].is_digits and [word.text for word in name[1:2]] == ["of"]
        for time, name in zip(times, names[1:], strict=False)
    )
    if not measured and all(_is_entry(name, lexicon) for name in names):
        for time, behind in zip(times, names[1:], strict=False):
            pause = words[time.end].start - 1
            if behind[0].text not in lexicon.closed.joints_of_orders and scanned.text[pause].isspace():
                yield pause


def _times(scanned: Scanned) -> Iterator[_Time]:
    """Give the times, each with all that stands beside it: "at nine for an hour", "9.40"."""
    words, lexicon = scanned.words, scanned.lexicon
    found = [_Time(one.first, one.end, _is_sure(one)) for one in phrases_of(scanned) if is_when(one)]
    # "At half past" needs no hour.
    walls = [piece for piece in scanned.pieces("wall") if piece.value.clock is not None]
    for piece in (*walls, *scanned.pieces("unfinished")):
        bound = piece.start > 0 and words[piece.start - 1].text in lexicon.closed.prepositions_of_points
        typed = piece.category == "wall" and not piece.value.bare
        found.append(_Time(piece.start - bound, piece.end, bound or typed))
    last: _Time | None = None
    for one in sorted(found, key=lambda time: time.first):
        if last is not None and one.first <= last.end:
            last = _Time(last.first, max(last.end, one.end), last.sure or one.sure)
            continue
        if last is not None:
            yield last
        last = one
    if last is not None:
        yield last


def _is_sure(phrase: Phrase) -> bool:
    """Whether a time is by the clock, or right behind another: "gp 9.40 chemist after"."""
    time = phrase.said.time
    behind = isinstance(time, TimeWord) and time.word in ORDERING
    return behind or phrase.said.wall.clock is not None or is_window(phrase)


def _is_entry(name: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words name something, or ask for it, and neither go on with a sentence nor lead on to one."""
    led = bool(name) and name[0].text in lexicon.closed.joints_of_orders
    words = [word.text for word in name[led:]]
    # "Kids' tea"
    lettered = all(word.is_letters or (word.text == "'" and word.glued) for word in name)
    if not 0 < len(words) <= LONGEST or not lettered:
        return False
    closed = lexicon.closed
    inside = closed.noun_openers | closed.object_pronouns | closed.prepositions_of_nouns
    inside = inside | lexicon.particles.keys() | lexicon.places
    first, last = words[0], words[-1]
    opens = first not in lexicon.function_words - closed.noun_openers - closed.universal_pronouns
    open_ended = last in lexicon.function_words - lexicon.beside.states - closed.object_pronouns
    goes_on = any(word in lexicon.function_words - inside for word in words[1:])
    measured = first in lexicon.no_times.measured_in or lexicon.means(first, "unit")
    told = first in lexicon.doing.timed and len(words) == 1
    clause = any(longest_match(name, place, lexicon.clauses) is not None for place in range(len(name)))
    return opens and not (open_ended or goes_on or measured or told or clause)
