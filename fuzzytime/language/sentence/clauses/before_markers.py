"""Lengths of time right before what begins a clause: "five minutes before", "within an hour of"."""

from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace

from fuzzytime.language.grammar.lexicon import Entry, Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.days.relations import Deictic, Which
from fuzzytime.language.meaning.expressions import Coming, Duration, Phrase, Repeat, Said, Wall
from fuzzytime.language.meaning.joined.first_times import closing_of
from fuzzytime.requirement import Constraint

BESIDE = 2
"""Words of a unit, or a part of a day, behind its article: "the day", "the evening"."""

OF = "of"
"""The marker of what a time is the end of: "for the last hour of roasting"."""

BEFORE = "before"
"""The marker of what is done behind something."""

LEAVING = frozenset({"leave"})
"""What is done to "it" for so long, where no verb says what it does then."""

LONGEST_ASIDE = 6
"""Words at most before the time of an event in what is said of it."""


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
                and not self._is_left_for(phrase.first, place)
            ):
                return phrase
        return self._whole_unit(place)

    def bound(self, place: int) -> Phrase | None:
        """Give the length of time right before a marker that something must not be later than."""
        found = (phrase for phrase in self.phrases if phrase.end == place)
        return next((p for p in found if counts_within(p)), None)

    def closes(self, place: int) -> bool:
        """Whether a time right before "of" is the end of something: "for the last hour of roasting"."""
        said = [phrase.said for phrase in self.phrases if phrase.end == place]
        repeats = [one.time for one in said if isinstance(one.time, Repeat)]
        return any(map(closing_of, said)) or any(repeat.closing for repeat in repeats)

    def behind_denied(self, place: int, form: tuple[str, ...]) -> int | None:
        """Give where "after" stands in "don't … until ten minutes after it", None in other words."""
        denied = any(word.text in self.lexicon.closed.negators_as_typed for word in self.words[:place])
        if not denied or self.lexicon.clauses.get(form) != "until":
            return None
        behind = place + len(form)
        ends = (phrase.end for phrase in self.phrases if phrase.first == behind)
        return next(
            (end for end in ends if [word.text for word in self.words[end : end + 1]] == ["after"]), None
        )

    def aside(self, end: int) -> Phrase | None:
        """Give when an event is, by an aside behind it: "before the party, which is on the 21st"."""
        closed = self.lexicon.closed
        texts = [word.text for word in self.words]
        bracketed = texts[end : end + 1] == ["("]
        relative = not closed.nonrestrictive_relatives.isdisjoint(texts[end + 1 : end + 2])
        if not bracketed and not (relative and texts[end : end + 1] == [","]):
            return None
        # A bracket needs no word before its time: before the party (eight o'clock)
        first = end + 1 if bracketed else end + 3
        told = (phrase for phrase in self.phrases if first <= phrase.first <= end + 2 + LONGEST_ASIDE)
        time = next(told, None)
        if time is None or not closed.end_of_an_event.isdisjoint(texts[end + 2 : time.first]):
            return None
        closes = time.end == len(texts) or texts[time.end] in closed.end_of_an_event
        over = not closed.past_be.isdisjoint(texts[end + 2 : time.first])
        return (_before_now(time) if over else time) if closes else None

    def part_of_day(self, place: int) -> Phrase | None:
        """Give the part of a day right before a marker: "the evening before the trip"."""
        part = self._named(place, "part", {"the"})
        return None if part is None else self._beside(place, Said(Wall(part=part.value)), "part")

    def _whole_unit(self, place: int) -> Phrase | None:
        """Give "the day", "the hour" before a marker as a length of time: "the day before the flight"."""
        named = self._named(place, "unit", {"the", "a"})
        unit = None if named is None else named.value
        if unit is None or unit.form in {"night", "second"} or self.words[place - 1].text.endswith("s"):
            # "Write the minutes right after the meeting"
            return None
        return self._beside(place, Said(Duration(((unit.count, unit.unit),)), Constraint.FOR), "unit")

    def _named(self, place: int, category: str, articles: AbstractSet[str]) -> Entry | None:
        """Give the entry of a category of the word right before a marker, behind an article."""
        first = place - BESIDE
        if first < 0 or self.words[first].text not in articles or first in self.covered:
            return None
        word = self.words[place - 1].text
        entries = self.lexicon.entries.get(word, ())
        return next((e for e in entries if e.category == category and e.words == (word,)), None)

    def _beside(self, place: int, said: Said, rule: str) -> Phrase:
        first = place - BESIDE
        # "Ring the nurse on the morning after you arrive"
        first -= self.words[first - 1].text == "on" and first - 1 not in self.covered
        return Phrase(said, first, place, (self.words[first].start, self.words[place - 1].end), rule)

    def _lasts(self, place: int) -> bool:
        """Whether a verb that takes a length of time stands here: "rest five minutes before slicing".

        What has a time is none: "remind me of the meeting an hour before it starts".
        """
        texts = [word.text for word in self.words[: place + 1]]
        # "Hang on a minute before you pour it"
        waits = len(texts) > 1 and texts[-1] == "on" and texts[-2] in self.lexicon.doing.waiting
        return waits or (bool(texts) and texts[-1] in self.lexicon.lasting - self.lexicon.events)

    def _is_left_for(self, first: int, place: int) -> bool:
        """Whether it is how long something is left alone before the next step: "rest it five before baking".

        So is what is let do so, or is left: "leave it a minute before opening the lid"; but "leave the house
        an hour before starting work", "let the dog out ten minutes before leaving".
        """
        texts = [word.text for word in self.words]
        if texts[place] != BEFORE or not self._is_step(*texts[place + 1 : place + 3][:2]):
            return False
        begin = max((at + 1 for at in range(first) if not self.words[at].is_letters), default=0)
        said = [text for text in texts[begin:first] if text not in self.lexicon.addressing]
        led = next((at for at, text in enumerate(said) if text in self.lexicon.letting), None)
        doing, it = self.lexicon.doing, self.lexicon.closed.object_pronouns
        if led is None:
            return not doing.left_alone.isdisjoint(said)
        left = {*said[led + 1 :]}
        alone = said[led] in LEAVING and bool(left) and left <= it
        return alone or not (doing.by_itself | self.lexicon.timing).isdisjoint(left)

    def _is_step(self, behind: str = "", further: str = "") -> bool:
        """Whether words say what is done next: "before slicing"; but "before opening", "before meetings"."""
        events = self.lexicon.events | self.lexicon.happening | self.lexicon.taken
        done = further in self.lexicon.closed.noun_openers | self.lexicon.closed.object_pronouns
        return behind.endswith("ing") and (done or behind not in events)


def _before_now(phrase: Phrase) -> Phrase | None:
    """Give the last weekday that a time names: "the operation, which was on monday"; None for other times."""
    time = phrase.said.time
    if not isinstance(time, Wall) or not isinstance(time.days, Fields) or not time.days.weekly:
        return None
    last = replace(time, days=Deictic(Which.PAST, time.days))
    return phrase.at(last)


def counts_within(phrase: Phrase) -> bool:
    """Whether it is so long from what is named behind it: "within an hour of", "for the first hour of"."""
    first = isinstance(phrase.said.time, Coming) and phrase.said.time.direction > 0
    return first or phrase.said.preposition == "within"
