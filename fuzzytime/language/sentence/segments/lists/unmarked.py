"""Entries with their times that follow each other without a mark: "bath at six story at seven".

Words and times take turns there, and no words lead to what stands behind a time, or go on with it. A comma is
put between them, which tells apart what is each by itself, or is done with the next as well: "feed the cat at
8 the dog at 9". Where each begins with its time, as typed, a stop is: "8 gym 9 work 6 pub".
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from fuzzytime.english import looks_plural
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.timetables import LONGEST_STREET, has_time
from fuzzytime.language.grammar.words import Word, words_of
from fuzzytime.language.meaning.expressions import Phrase, TimeWord
from fuzzytime.language.meaning.phrases import is_window
from fuzzytime.language.sentence.references.phrase_anchors import ORDERING
from fuzzytime.language.sentence.segments.lists.dividers import STOP
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

    def joined(self, other: "_Time") -> "_Time":
        """Give both in one."""
        return _Time(self.first, max(self.end, other.end), self.sure or other.sure)


def with_marks_between(text: str, grammar: Grammar, lexicon: Lexicon) -> str:
    """Give a text of the same length with a mark between each two such entries."""
    for stretch in STRETCH.finditer(text):
        if _may_hold_several(words_of(stretch[0]), lexicon):
            for place, mark in _pauses(Scanned.of(stretch[0], grammar, lexicon)):
                at = stretch.start() + place
                text = f"{text[:at]}{mark}{text[at + 1 :]}"
    return text


def _may_hold_several(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether there may be two times, and words between: most lines are no list, and to scan costs time."""
    numbers = lexicon.numbers.keys() | lexicon.beside.parts_of_hours
    timed = [
        word.is_digits or word.text in numbers or lexicon.means(word.text, "part", "weekday", "word")
        for word in words
    ]
    return sum(new and not old for old, new in pairwise([False, *timed])) >= PAIR


def _pauses(scanned: Scanned) -> Iterator[tuple[int, str]]:
    """Give where the pauses between such entries are, and the mark for each."""
    words, lexicon, times = scanned.words, scanned.lexicon, list(_times(scanned))
    last = next((p for p in range(len(words), 0, -1) if words[p - 1].text not in {".", "!"}), 0)
    leads = bool(times) and times[0].first == 0
    if len(times) < PAIR or leads is (times[-1].end == last):
        return
    first = _behind_having(words, lexicon)
    starts = [time.end for time in times] if leads else [first, *(time.end for time in times[:-1])]
    ends = [*(time.first for time in times[1:]), last] if leads else [time.first for time in times]
    entries = [_Entry(words[a:b], time, lexicon) for a, b, time in zip(starts, ends, times, strict=True)]
    if not all(entry.is_named for entry in entries):
        return
    counting = zip(times, entries if leads else entries[1:], strict=False)
    if any(entry.is_counted(bare=not time.sure) for time, entry in counting):
        return
    # "Gym 6-7 dinner 8"; but "play twelve angry men at nine", "catch the 8.15 train at ten"
    *others, last_one = (entry.is_sure for entry in entries)
    surely = all(others) and (last_one or (entries[-1].has_time and not leads))
    known = len(times) >= LIST and any(entry.is_sure or entry.has_time for entry in entries)
    if not (surely or known) or any(entry.catches for entry in entries if not leads):
        return
    for before, behind in pairwise(entries):
        begin = behind.time.first if leads else before.time.end
        place = words[begin].start - 1
        if not behind.is_joined and scanned.text[place].isspace():
            # No number stands right behind a comma.
            typed = leads and not words[begin].is_letters
            # "Feed the cat at 7 p.m. Bob comes at eight"
            ended = words[begin - 1].text == "." and words[begin].capital
            yield place, STOP if typed or ended else ","


def _behind_having(words: Sequence[Word], lexicon: Lexicon) -> int:
    """Give where that begins which who speaks has: "I've got | yoga at six dinner at eight"; else 0."""
    closed, texts = lexicon.closed, [word.text for word in words[:3]]
    subject, apostrophe, helping = "".join(texts[:1]).partition("'")
    having = [f"{apostrophe}{helping}", *texts[1:]] if helping else texts[1:]
    if subject not in closed.first_person or not {*having[:1]} <= closed.have_before_got:
        return 0
    got = having[1:2] == ["got"]
    return 1 + (not helping) + got if got or not helping else 0


def _times(scanned: Scanned) -> Iterator[_Time]:
    """Give the times, each with all that stands beside it: "at nine for an hour", "9.40"."""
    words, lexicon = scanned.words, scanned.lexicon
    # In "8:00 up 8:15 mails" no stretch leads up to the second hour.
    apart = {p for p in range(1, len(words) - 1) if _stands_alone(words[p - 1 : p + 2], lexicon)}
    said = (
        one for one in phrases_of(scanned) if is_when(one) and apart.isdisjoint(range(one.first, one.end))
    )
    found = [_Time(one.first, one.end, _is_sure(one)) for one in said]
    # "At half past" needs no hour.
    walls = [piece for piece in scanned.pieces("wall") if piece.value.clock is not None]
    for piece in (*walls, *scanned.pieces("unfinished")):
        first, end = piece.start, piece.end
        led = words[first - 1].text if first else ""
        bound = led in {*lexicon.closed.prepositions_of_points, "@"}
        typed = piece.category == "wall" and not piece.value.bare
        # "Bath 6ish"
        hedged = end < len(words) and words[end].glued and lexicon.means(words[end].text, "hedge_after")
        found.append(_Time(first - bound, end + hedged, bound or hedged or typed))
    lengths = [_Time(piece.start, piece.end, sure=True) for piece in scanned.pieces("duration")]
    long = {place for one in lengths for place in range(one.first, one.end)}
    if all(long.issuperset(range(one.first, one.end)) for one in found):
        # "Rice 12 min peas 5 min"
        found = lengths
    last: _Time | None = None
    for one in sorted(found, key=lambda time: time.first):
        if last is not None and _is_stretch(words[last.end : one.first], lexicon):
            last = _Time(last.first, one.end, sure=True)
            continue
        if last is not None and one.first <= last.end:
            last = last.joined(one)
            continue
        if last is not None:
            yield last
        last = one
    if last is not None:
        yield last


def _stands_alone(around: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a particle stands between two numbers."""
    before, word, behind = around
    return before.is_digits and word.text in lexicon.particles and behind.is_digits


def _is_stretch(between: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether what stands between two times makes one of them: "gym 6-7 dinner 8", "six to seven"."""
    return len(between) == 1 and between[0].text in {"-", *lexicon.beside.until_hours}


def _is_sure(phrase: Phrase) -> bool:
    """Whether a time is by the clock, or right behind another: "gp 9.40 chemist after"."""
    time = phrase.said.time
    behind = isinstance(time, TimeWord) and time.word in ORDERING
    return behind or phrase.said.wall.clock is not None or is_window(phrase)


@dataclass(frozen=True, slots=True)
class _Entry:
    """The words of what may be an entry, without its time."""

    words: Sequence[Word]
    time: _Time
    lexicon: Lexicon

    @property
    def is_joined(self) -> bool:
        """Whether a joint stands in front of it."""
        return self.words[0].text in self.lexicon.closed.joints_of_orders

    @property
    def has_time(self) -> bool:
        """Whether it ends in what has a time by itself: "gym 6"."""
        return has_time(self.words[-1].text, self.lexicon)

    @property
    def is_sure(self) -> bool:
        """Whether its time is one, as it may be by how a thing is switched then: "oven on 5"."""
        return self.time.sure or self.words[-1].text in self.lexicon.beside.switched

    @property
    def is_named(self) -> bool:
        """Whether it names something, or asks for it, and is no part of a sentence that goes on."""
        lexicon, closed = self.lexicon, self.lexicon.closed
        words = [word.text for word in self.words][bool(self.words) and self.is_joined :]
        # "Kids' tea"
        lettered = all(word.is_letters or (word.text == "'" and word.glued) for word in self.words)
        if not 0 < len(words) <= LONGEST or not lettered:
            return False
        inside = closed.noun_openers | closed.object_pronouns | closed.prepositions_of_nouns
        inside = inside | lexicon.particles.keys() | lexicon.places
        opens = closed.noun_openers | closed.universal_pronouns | lexicon.beside.states
        ends = lexicon.beside.states | closed.object_pronouns
        whole = words[0] in opens or words[0] not in lexicon.function_words
        whole = whole and (words[-1] in ends or words[-1] not in lexicon.function_words)
        goes_on = any(word in lexicon.function_words - inside for word in words[1:])
        told = len(words) == 1 and words[0] in lexicon.doing.timed
        clauses = (longest_match(self.words, place, lexicon.clauses) for place in range(len(self.words)))
        return whole and not goes_on and not told and not any(clauses)

    @property
    def catches(self) -> bool:
        """Whether what is caught is called by the time behind it: "catch 8.15 train"."""
        return self.words[-1].text in self.lexicon.catching

    def is_counted(self, *, bare: bool) -> bool:
        """Whether a number before it is none of times: "1.50 cups of flour", "20 bricks", "2 mill lane"."""
        lexicon, words = self.lexicon, [word.text for word in self.words]
        several = bare and looks_plural(words[0]) and not has_time(words[0], lexicon)
        amount = words[0] in lexicon.no_times.measured_in or lexicon.means(words[0], "unit")
        street = not lexicon.no_times.streets.isdisjoint(words[:LONGEST_STREET])
        return several or amount or street or words[1:2] == ["of"]
