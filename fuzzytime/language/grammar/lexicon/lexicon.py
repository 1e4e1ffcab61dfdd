"""The words of a language and what they mean, from ``rules/lexicon.yaml`` and ``rules/calendar.yaml``."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.lexicon.forms import Forms, matched_to
from fuzzytime.language.grammar.lexicon.groups_beside_times import BesideTimes
from fuzzytime.language.grammar.lexicon.no_time_groups import NoTimes
from fuzzytime.language.grammar.lexicon.transliteration import Names
from fuzzytime.language.grammar.lexicon.verb_groups import Doing
from fuzzytime.language.grammar.lexicon.word_groups import ClosedClasses
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Edge
from fuzzytime.language.policy import Hours, Policy
from fuzzytime.requirement import Constraint, Side


@dataclass(frozen=True, slots=True)
class Preposition:
    """How a preposition binds a time: on which side, and by which edge of an interval."""

    name: str
    constraint: Constraint
    edge: Edge


class Entry(NamedTuple):
    """One way to say something: its words, the category and the meaning they have."""

    words: tuple[str, ...]
    category: str
    value: Any
    weight: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Lexicon:
    """The word tables of a language.

    Most are sections of ``rules/lexicon.yaml``, or rows of them: what each is for stands there, beside it.

    Parameters
    ----------
    entries
        By their first word, the entries of all tables that the grammar uses.
    numbers, magnitudes, ordinals
        Number words.
    ambiguous
        Words of the calendar that have another meaning too.
    indicators, connectives, clauses, comparisons, corrections, addresses, courtesies, amounts, results
        Words that the reading of sentences uses, by meaning.
    intransitive
        Verbs that take no object, so that they share none either: "stop and open the door".
    alone, chores
        Orders alone: "reduce the heat and simmer"; and between two times: "… on monday and paint on tuesday".
    vague_adverbs
        Adverbs that say nothing of how something is done: "just", "also".
    doing, closed, beside, no_times
        Verbs, words of closed classes, words around a time, and those around what is none, in small groups.
    other_calendars
        Words before a feast that put it on a day which is not known: "orthodox easter".
    transliterated
        By their sounds, feasts whose names Latin letters spell in many ways.
    usual_hours
        By words for what people do, the hours at which they do it.
    hours_on_days
        By words for what is on a day, the hours in which it is if no time of day is said.
    ways
        What is said of wishes in usual words, and a way to say the same: what may stand in its places.
    function_words
        Words that may follow a bare number without making it a count.
    misspelt, clipped
        What is meant by words as they are often mistyped, and what may be meant where the last letter is left
        out or doubled: that is pointed at.
    orders
        Verbs of what is done at home, which trees may have for nouns: "order pizza", "bath ella".
    people
        Words that somebody is called by, also those that are other words as well: "will", "rose".
    needing_nothing
        Verbs that need no object: those that take none, and those of what is done and names no thing.
    called_by_number
        What a number right behind is the name of: "room 12", "season 2".
    deadlines
        Prepositions of deadlines, as requirements carry them.
    """

    entries: Mapping[str, tuple[Entry, ...]]
    numbers: Mapping[str, int]
    magnitudes: Mapping[str, int]
    ordinals: Mapping[str, int]
    ambiguous: frozenset[str]
    indicators: Mapping[str, str]
    connectives: Forms[str]
    clauses: Forms[str]
    comparisons: Forms[Side]
    corrections: Forms[None]
    addresses: frozenset[str]
    courtesies: frozenset[tuple[str, ...]]
    called_behind: frozenset[tuple[str, ...]]
    amounts: Forms[tuple[str, tuple[float, float, float, float] | None]]
    results: frozenset[str]
    wanting: frozenset[str]
    forgetting: frozenset[str]
    ordering: frozenset[str]
    causing: frozenset[str]
    letting: frozenset[str]
    intransitive: frozenset[str]
    alone: frozenset[str]
    chores: frozenset[str]
    particles: Mapping[str, frozenset[str]]
    places: frozenset[str]
    vague_adverbs: frozenset[str]
    doing: Doing
    closed: ClosedClasses
    beside: BesideTimes
    no_times: NoTimes
    called: Mapping[str, frozenset[str]]
    past: Mapping[str, frozenset[str]]
    sky: Mapping[str, frozenset[str]]
    undoing: Mapping[str, frozenset[str]]
    asides: Mapping[str, frozenset[str]]
    spacing: Mapping[str, frozenset[str]]
    moments: frozenset[tuple[str, ...]]
    becoming: frozenset[str]
    other_calendars: frozenset[str]
    fillers: frozenset[str]
    levels: frozenset[str]
    passing: frozenset[str]
    instances: Mapping[str, frozenset[tuple[str, ...]]]
    told: Mapping[str, frozenset[str]]
    appointing: frozenset[str]
    lasting: frozenset[str]
    catching: frozenset[str]
    circling: frozenset[str]
    dosing: frozenset[str]
    coming_in: frozenset[str]
    dining: frozenset[str]
    playing: frozenset[str]
    timing: frozenset[str]
    timing_alone: frozenset[str]
    citing: frozenset[str]
    taken: frozenset[str]
    happening: frozenset[str]
    frames: frozenset[str]
    standing: frozenset[str]
    persons: frozenset[str]
    names: frozenset[str]
    names_like_words: frozenset[str]
    animals: frozenset[str]
    machines: frozenset[str]
    workers: frozenset[str]
    moving: frozenset[str]
    switching: frozenset[str]
    rescheduling: frozenset[str]
    events: frozenset[str]
    addressing: frozenset[str]
    landmarks: frozenset[str]
    travelling: frozenset[str]
    impersonal: frozenset[str]
    measure_verbs: frozenset[str]
    measure_nouns: frozenset[str]
    dividing: frozenset[str]
    changing: frozenset[tuple[str, ...]]
    counting: frozenset[str]
    rating: frozenset[str]
    reading: frozenset[str]
    amount_nouns: frozenset[str]
    questions: Mapping[str, Forms[None]]
    conversation: Mapping[str, frozenset[tuple[str, ...]]]
    ways: tuple[tuple[str, tuple[frozenset[str], ...]], ...]
    foreign: frozenset[str]
    function_words: frozenset[str]
    misspelt: Mapping[str, str]
    clipped: Mapping[str, str]
    transliterated: Names[Entry]
    usual_hours: Forms[Hours]
    hours_on_days: Forms[Hours]
    policy: Policy = field(default_factory=Policy)
    orders: frozenset[str] = field(init=False)
    people: frozenset[str] = field(init=False)
    needing_nothing: frozenset[str] = field(init=False)
    called_by_number: frozenset[str] = field(init=False)
    deadlines: frozenset[str] = field(init=False)

    def __post_init__(self) -> None:
        alone = self.chores | self.ordering | self.alone | self.causing - self.wanting
        orders = alone.union(self.doing.by_the_day, self.doing.by_then, self.doing.of_events)
        object.__setattr__(self, "orders", orders)
        object.__setattr__(self, "people", self.persons | self.names_like_words)
        object.__setattr__(self, "needing_nothing", self.intransitive | self.doing.naming_nothing)
        numbered = self.measure_nouns | self.machines | self.no_times.numbered
        object.__setattr__(self, "called_by_number", numbered)
        said = (entry for entries in self.entries.values() for entry in entries)
        deadlines = frozenset(entry.value.name for entry in said if entry.category == "preposition_before")
        object.__setattr__(self, "deadlines", deadlines)

    def pieces(self, words: Sequence[Word], start: int) -> Iterator[Piece]:
        """Give what the tables say of the words from one place on."""
        entries = self.entries.get(words[start].text, ())
        following = {word.text for word in words[start + 1 : start + 3]} if entries else ()
        for entry in entries:
            if len(entry.words) > 1 and entry.words[1] not in following:
                continue
            end = matched_to(words, start, entry.words)
            if end and not (entry.category == "unit" and _ends_sentence(words, end)):
                yield Piece(entry.category, start, end, entry.value, entry.weight, "word")
        for end, entry in self.transliterated.at(words, start):
            yield Piece(entry.category, start, end, entry.value, entry.weight, "word")

    def means(self, text: str, *categories: str) -> bool:
        """Whether a word alone has a meaning of one of some categories: "friday" is a "weekday"."""
        entries = self.entries.get(text, ())
        return any(entry.category in categories and len(entry.words) == 1 for entry in entries)

    def preposition(self, text: str) -> Preposition | None:
        """Give the preposition of times that a word alone is: "till" is "until"; None where it is none."""
        entries = (entry for entry in self.entries.get(text, ()) if len(entry.words) == 1)
        return next((entry.value for entry in entries if isinstance(entry.value, Preposition)), None)


def _ends_sentence(words: Sequence[Word], end: int) -> bool:
    """Whether a full stop before a place is no abbreviation's: "for two min. Add the salt", "at 7h."."""
    return words[end - 1].text == "." and (end == len(words) or words[end].capital)
