"""Marks between the entries of a line, each with its time: "10am vet - 12 lunch - 3pm pick up car".

A dash between two times is a stretch from the one to the other; one that has a thing and its time on either
side tells two entries apart. So do bars, arrows, slashes and wide gaps; a bullet does without times, too.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.expressions import Phrase, Wall

BULLET = re.compile(r"(?:(?<=\s)|^)[•●▪‣◦·]\s*(?=\w)")
"""A mark that stands in front of an entry, and nowhere else."""

MARKS = (
    re.compile(r"(?<=\s)(?:-+>|=+>|[→⇒➔➜])(?=\s)"),
    re.compile(r"(?<=\s)\|{1,2}(?=\s)"),
    re.compile(r"(?<=\s)/{1,2}(?=\s)"),
    re.compile(r"(?<=\s)>(?=\s)"),
    re.compile(r"(?<=\s)[-–—]{1,2}(?=\s)"),
    re.compile(r"(?<=\S)(?:[ \t]{2,}|\t)(?=\S)"),
)
"""Marks that stand between entries, and elsewhere: of each kind those of a line are judged together."""

LEADING = re.compile(r"^\s*[-*+•]\s+(?=\d)")
"""A bullet in front of a line that begins with a number: "* 15:00 pick up kids"."""

LINE = re.compile(r"[^\n;]+")
"""What such marks divide: a line, or what stands in it before a stop."""

LIST = 3
"""Entries of a list at least in which a number alone may be when."""

STOP = ";"
BRACKETS = (("(", ")"), ("[", "]"))


def divided(text: str, grammar: Grammar, lexicon: Lexicon) -> str:
    """Give a text of the same length with a stop in place of each mark between entries."""
    text = LEADING.sub(lambda found: " " * len(found[0]), text)
    for line in LINE.finditer(text):
        first, end = line.span()
        bullets = [found.span() for found in BULLET.finditer(text, first, end)]
        if bullets and _is_bulleted(text, line.span(), bullets, grammar, lexicon):
            text = _with_stops(text, bullets)
        for kind in MARKS:
            marks = [found.span() for found in kind.finditer(text, first, end)]
            if marks and _divide(text, line.span(), marks, grammar, lexicon):
                text = _with_stops(text, marks)
    return text


def _with_stops(text: str, marks: Sequence[Span]) -> str:
    for first, end in marks:
        stop = STOP if text[:first].strip() else " "
        text = text[:first] + stop.ljust(end - first) + text[end:]
    return text


def _between(line: Span, marks: Sequence[Span]) -> Iterator[Span]:
    """Give the stretches of a line around its marks."""
    begin = line[0]
    for first, end in (*marks, (line[1], line[1])):
        yield begin, first
        begin = end


def _is_bulleted(
    text: str, line: Span, bullets: Sequence[Span], grammar: Grammar, lexicon: Lexicon
) -> bool:
    """Whether each bullet of a line stands before something."""
    items = [text[slice(*span)] for span in _between(line, bullets)]
    return all(_Entry.of(item, grammar, lexicon).things for item in items if item.strip())


def _divide(text: str, line: Span, marks: Sequence[Span], grammar: Grammar, lexicon: Lexicon) -> bool:
    """Whether marks of one kind stand between entries: each side names something, and when."""
    items = [text[slice(*span)] for span in _between(line, marks)]
    if not all(any(map(str.isalnum, item)) and _is_whole(item) for item in items):
        return False
    entries = [_Entry.of(item, grammar, lexicon) for item in items]
    if not all(entry.things and entry.timed(listed=len(entries) >= LIST) for entry in entries):
        return False
    if any(before.ends and behind.begins for before, behind in pairwise(entries)):
        # "Gym tue 9 - 10 at the club"
        return False
    if any(entry.goes_on for entry in entries[1:]):
        return False
    alike = all(entry.begins for entry in entries) or all(entry.ends for entry in entries)
    return alike or len(entries) >= LIST


def _is_whole(item: str) -> bool:
    """Whether no bracket and no mark of a quotation is open in an entry."""
    return item.count('"') % 2 == 0 and all(item.count(a) == item.count(b) for a, b in BRACKETS)


@dataclass(frozen=True, slots=True)
class _Entry:
    """What may be an entry: its words and times, and the places of the words that name something."""

    words: tuple[Word, ...]
    times: tuple[Phrase, ...]
    things: tuple[int, ...]
    lexicon: Lexicon

    @classmethod
    def of(cls, item: str, grammar: Grammar, lexicon: Lexicon) -> "_Entry":
        scanned = Scanned.of(item, grammar, lexicon)
        times = tuple(phrase for phrase in phrases_of(scanned, lexicon) if _is_when(phrase))
        covered = {place for phrase in times for place in range(phrase.first, phrase.end)}
        things = (
            place
            for place, word in enumerate(scanned.words)
            if place not in covered and word.is_letters and word.text not in lexicon.function_words
        )
        return cls(scanned.words, times, tuple(things), lexicon)

    def timed(self, *, listed: bool) -> bool:
        """Whether it says when; a number alone does in a list, or beside what is known to have a time."""
        if self.times:
            return True
        lexicon = self.lexicon
        if not (self._begins_with_number or self._ends_with_number):
            return False
        known = lexicon.persons | lexicon.animals | lexicon.events | lexicon.happening | lexicon.taken
        beside = self.words[1] if self._begins_with_number else self.words[-2]
        return listed or beside.text in known

    @property
    def begins(self) -> bool:
        """Whether its time stands in front."""
        return self._begins_with_number or any(phrase.first == 0 for phrase in self.times)

    @property
    def ends(self) -> bool:
        """Whether its time stands at the end."""
        last = len(self.words)
        while last and not self.words[last - 1].text.isalnum():
            last -= 1
        return self._ends_with_number or any(phrase.end >= last for phrase in self.times)

    @property
    def goes_on(self) -> bool:
        """Whether it corrects, or offers instead of, what stands before it: "at five - no, at six"."""
        corrects = longest_match(self.words, 0, self.lexicon.corrections) is not None
        return corrects or self.words[0].text in self.lexicon.closed.alternatives

    @property
    def _begins_with_number(self) -> bool:
        return len(self.words) > 1 and self.words[0].is_digits and 1 in self.things

    @property
    def _ends_with_number(self) -> bool:
        last = len(self.words) - 1
        return last > 0 and self.words[last].is_digits and last - 1 in self.things


def _is_when(phrase: Phrase) -> bool:
    """Whether a time says when: a meal without a preposition may be what is planned."""
    time = phrase.said.time
    if phrase.said.preposition is not None or not isinstance(time, Wall) or time.part is None:
        return True
    return time.clock is not None or time.days is not None or not time.part.meal
