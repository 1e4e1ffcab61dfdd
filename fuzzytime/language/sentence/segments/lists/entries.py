"""What may be an entry of a list: its words, when it is, and what it names."""

from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from itertools import takewhile

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.timetables import has_time
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Offset, Phrase, Wall
from fuzzytime.language.meaning.phrases import places_in
from fuzzytime.requirement import MOMENTS, Constraint

NUMERIC = frozenset({"-", ":", "."})
"""Marks in a number, or between two."""


@dataclass(frozen=True, slots=True)
class Entry:
    """What may be an entry: its words and times, and the places of the words that name something."""

    words: tuple[Word, ...]
    times: tuple[Phrase, ...]
    things: tuple[int, ...]
    lexicon: Lexicon

    @classmethod
    def of(cls, item: str, grammar: Grammar, lexicon: Lexicon) -> "Entry":
        """Give what stands between two marks."""
        scanned = Scanned.of(item, grammar, lexicon)
        times = tuple(phrase for phrase in phrases_of(scanned) if is_when(phrase))
        covered = places_in(times)
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
        front, end = self._number_in_front, self._number_at_end
        if not (front or end):
            return False
        beside = self.words[front] if front else self.words[-end - 1]
        return listed or has_time(beside.text, self.lexicon)

    @property
    def named(self) -> tuple[int, ...]:
        """The places of the words that name something, without what only says that it is due."""
        due = self.lexicon.beside.due
        named = (place for place in self.things if not names_day(self.words[place], self.lexicon))
        return tuple(place for place in named if self.words[place].text not in due)

    @property
    def clocked(self) -> bool:
        """Whether it has a time of day, or a day."""
        if self.words and names_day(self.words[-1], self.lexicon):
            return True
        return self._has_wall(MOMENTS)

    @property
    def bounded(self) -> bool:
        """Whether it is before or after a time of day, or a day."""
        return self._has_wall({Constraint.BEFORE, Constraint.AFTER})

    @property
    def ends_timed(self) -> bool:
        """Whether it begins with what it names, and ends in its time."""
        return (self.clocked or self.bounded) and self.ends and self.named[:1] == (0,)

    @property
    def bound(self) -> bool:
        """Whether it says before or after what it is, behind what it names."""
        sides = ("preposition_before", "preposition_after")
        return any(self.lexicon.means(word.text, *sides) for word in self.words[1:])

    @property
    def counted(self) -> bool:
        """Whether it ends so long before or after another, behind what it names: "mains 40 minutes later"."""
        offsets = (p for p in self.times if isinstance(p.said.time, Offset) and p.said.time.anchor is None)
        return 0 in self.named and any(p.end == len(self.words) for p in offsets)

    @property
    def has_time(self) -> bool:
        """Whether what it names ends in what has a time by itself: "bread party"."""
        return bool(self.named) and has_time(self.words[self.named[-1]].text, self.lexicon)

    def _has_wall(self, constraints: AbstractSet[Constraint | None]) -> bool:
        walls = (p.said.time for p in self.times if p.said.constraint in constraints)
        return any(isinstance(wall, Wall) and (wall.clock or wall.days) is not None for wall in walls)

    @property
    def opens(self) -> bool:
        """Whether it begins with its time, or with what it names."""
        return self.begins or 0 in self.named

    @property
    def begins(self) -> bool:
        """Whether its time stands in front."""
        return bool(self._number_in_front) or any(phrase.first == 0 for phrase in self.times)

    @property
    def ends(self) -> bool:
        """Whether its time stands at the end, or before a bracket there: "guitar 6 (Leo)"."""
        texts = [word.text for word in self.words]
        last = texts.index("(") if "(" in texts[1:] and texts[-1] == ")" else len(self.words)
        while last and not self.words[last - 1].text.isalnum():
            last -= 1
        return bool(self._number_at_end) or any(phrase.end >= last for phrase in self.times)

    @property
    def goes_on(self) -> bool:
        """Whether it corrects, or offers instead of, what stands before it: "at five - no, at six"."""
        corrects = longest_match(self.words, 0, self.lexicon.corrections) is not None
        return corrects or self.words[0].text in self.lexicon.closed.alternatives

    @property
    def _number_in_front(self) -> int:
        """Words of a number, or of a stretch between two, in front of what is named: "9-10 gym"."""
        length = sum(1 for _ in takewhile(_is_number, self.words))
        return length if length in self.things else 0

    @property
    def _number_at_end(self) -> int:
        """Words of a number, or of a stretch between two, behind what is named: "gym 9-10"."""
        length = sum(1 for _ in takewhile(_is_number, reversed(self.words)))
        return length if len(self.words) - length - 1 in self.things else 0


def _is_number(word: Word) -> bool:
    return word.is_digits or word.text in NUMERIC


def is_when(phrase: Phrase) -> bool:
    """Whether a time says when: a meal without a preposition may be what is planned."""
    time = phrase.said.time
    if phrase.said.preposition is not None or not isinstance(time, Wall) or time.part is None:
        return True
    return time.clock is not None or time.days is not None or not time.part.meal


def names_day(word: Word, lexicon: Lexicon) -> bool:
    """Whether a word is the name of a weekday."""
    return lexicon.means(word.text, "weekday")
