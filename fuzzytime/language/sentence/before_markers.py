"""Lengths of time right before what begins a clause: "five minutes before", "within an hour of"."""

from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Coming, Duration, Offset, Phrase, Said, Wall
from fuzzytime.requirement import Constraint

BESIDE = 2
"""Words of a length of time that is a unit alone: "the day"."""


@dataclass(frozen=True, slots=True)
class BeforeMarker:
    """Reads what stands before a marker; ``covered`` are the words about time."""

    words: Sequence[Word]
    phrases: Sequence[Phrase]
    lexicon: Lexicon
    covered: AbstractSet[int]

    def distance(self, place: int) -> Phrase | None:
        """Give the length of time right before a marker: "five minutes before"."""
        for phrase in self.phrases:
            if (
                phrase.end == place
                and phrase.said.preposition is None
                and isinstance(phrase.said.time, Duration)
                and not self._lasts(phrase.first - 1)
            ):
                return phrase
        return self._whole_unit(place)

    def bound(self, place: int) -> Phrase | None:
        """Give the length of time right before a marker that something must not be later than."""
        found = (phrase for phrase in self.phrases if phrase.end == place)
        return next((p for p in found if _counts_within(p)), None)

    def part_of_day(self, place: int) -> Phrase | None:
        """Give the part of a day right before a marker: "the evening before the trip"."""
        words = self.words[max(0, place - BESIDE) : place]
        if (
            len(words) < BESIDE
            or words[0].text != "the"
            or not self.covered.isdisjoint((place - 2, place - 1))
        ):
            return None
        found = (entry for entry in self.lexicon.entries.get(words[1].text, ()) if entry.category == "part")
        part = next((entry.value for entry in found if entry.words == (words[1].text,)), None)
        if part is None:
            return None
        return Phrase(Said(Wall(part=part)), place - BESIDE, place, (words[0].start, words[1].end), "part")

    def _whole_unit(self, place: int) -> Phrase | None:
        """Give "the day", "the hour" before a marker as a length of time: "the day before the flight"."""
        words = self.words[max(0, place - 2) : place]
        if len(words) < BESIDE or words[0].text not in {"the", "a"} or place - 2 in self.covered:
            return None
        found = (e for e in self.lexicon.entries.get(words[1].text, ()) if e.category == "unit")
        unit = next((entry.value for entry in found if entry.words == (words[1].text,)), None)
        if unit is None or unit.form in {"night", "second"} or words[1].text.endswith("s"):
            # "Write the minutes right after the meeting"
            return None
        said = Said(Duration(((unit.count, unit.unit),)), Constraint.FOR)
        return Phrase(said, place - 2, place, (words[0].start, words[1].end), "unit")

    def _lasts(self, place: int) -> bool:
        """Whether a verb that takes a length of time stands here: "rest five minutes before slicing"."""
        return place >= 0 and self.words[place].text in self.lexicon.lasting


def _counts_within(phrase: Phrase) -> bool:
    """Whether it is so long from what is named behind it: "within an hour of", "for the first hour of"."""
    first = isinstance(phrase.said.time, Coming) and phrase.said.time.direction > 0
    return first or (phrase.said.preposition == "within" and not _is_dated(phrase))


def _is_dated(phrase: Phrase) -> bool:
    time = phrase.said.time
    return not isinstance(time, Duration) and not (isinstance(time, Offset) and time.anchor is None)
