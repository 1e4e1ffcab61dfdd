"""The words of a language and what they mean, from ``rules/lexicon.yaml`` and ``rules/calendar.yaml``."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from fuzzytime.language.grammar.chart import Piece
from fuzzytime.language.grammar.lexicon.no_time_groups import NoTimes
from fuzzytime.language.grammar.lexicon.transliteration import Names
from fuzzytime.language.grammar.lexicon.verb_groups import Doing
from fuzzytime.language.grammar.lexicon.word_groups import BesideTimes, ClosedClasses
from fuzzytime.language.grammar.words import Word, joins, words_of
from fuzzytime.language.meaning.expressions import Edge
from fuzzytime.language.policy import Hours, Policy
from fuzzytime.requirement import Constraint, Side


@dataclass(frozen=True, slots=True)
class Preposition:
    """How a preposition binds a time: on which side, and by which edge of an interval."""

    name: str
    constraint: Constraint
    edge: Edge


@dataclass(frozen=True, slots=True)
class Entry:
    """One way to say something: its words, the category and the meaning they have."""

    words: tuple[str, ...]
    category: str
    value: Any
    weight: float = 0.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Lexicon:
    """Word tables.

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
    wanting, forgetting, ordering
        Verbs above the one that is meant: "I want to", "don't forget to".
    causing, letting
        Verbs that bring something about: "have … ready", "let … rest".
    intransitive
        Verbs that take no object, so that they share none either: "stop and open the door".
    alone, chores
        Orders alone: "reduce the heat and simmer"; and between two times: "… on monday and paint on tuesday".
    particles
        Words that belong to a verb ("put on"), with the verbs behind which they do before a noun.
    places
        Words that begin what says where.
    vague_adverbs
        Adverbs that say nothing of how something is done: "just", "also".
    doing
        Verbs, and what is said like one, by what they say of what happens or ask for.
    closed
        Determiners, pronouns, auxiliaries, conjunctions, prepositions and adverbs, in small groups.
    beside
        Words around a time, in small groups by what they make of it.
    no_times
        Words around what looks like a time and is none, in small groups by what it is.
    called
        Pronouns of persons, with the words that say of somebody that they are called so.
    past
        Irregular forms of verbs of what is over.
    undoing
        Verbs that undo what was done, with the verbs of that.
    told
        Words that tell how long something takes, or how far it is, by what they do there.
    asides
        Words of asides that say how long something takes, by what they do there.
    moments
        What is a moment and hardly a place: "at kick-off".
    spacing
        Words of gaps between what is done several times, by what they do there.
    other_calendars
        Words before a feast that put it on a day which is not known: "orthodox easter".
    fillers
        What people say while they think: "um".
    becoming, levels
        What something becomes, and how strong it is on: "pat it dry", "cook it on low".
    passing
        What is said of what is called by a number: "train 14 stops at nine".
    instances
        What tells several of one kind apart: the ``first``, and the ``further`` ones.
    appointing
        Words behind which "for" says when, not how long: "an alarm for two hours before noon".
    catching
        Verbs whose object is called by its time: "catch the 7:42".
    circling
        Verbs behind which "around" is where to, and no hedge: "bring the car around at six".
    dosing
        Verbs of what is taken so many at a time: "one in the morning and one at night".
    coming_in
        Verbs right behind which "in" is where to: "come in around six".
    dining
        Words of what is done at a meal that it is "for": "meet for lunch".
    playing
        Verbs whose object may be called like a time: "play yesterday".
    timing, timing_alone, citing
        Words behind which "for" and a number say how many minutes; what "3:16" belongs to.
    lasting
        Nouns that a length of time before them is about: "a ten minute walk".
    taken
        What keeps who speaks from all else: "I have an appointment", "I'm out".
    frames
        What goes on around other work, and keeps nobody from it: "my shift is from 7 to 3".
    standing
        In what state something is for a while: "the bridge is closed until noon".
    happening
        What has a time without a verb: "dinner at seven".
    persons, names, names_like_words, addressing, animals
        Words for people, those of them that are given names, further names that are other words, too, and
        verbs whose object is one: "it" stands for neither; what is "him" and "it".
    rescheduling, events
        Verbs that give another time to what has one, and what has one: "change the alarm to seven".
    machines
        What is called by a number: "robot 3, dock".
    workers
        Who or what is called by a number and does something: "robot 3 docks".
    landmarks
        Things on a way: "after the bridge" says where.
    impersonal
        What "it" does or is when it stands for nothing: "rains", "dark".
    measure_verbs, measure_nouns
        Words beside which a number is an amount.
    dividing
        Verbs beside which a number says into how many parts.
    changing, reading, counting, rating, amount_nouns
        Words beside which even a bound is one: "by 10", "until 10".
    transliterated
        By their sounds, feasts whose names Latin letters spell in many ways.
    usual_hours
        By words for what people do, the hours at which they do it.
    questions, foreign
        Words that begin a question, by how they do, and words that show that a text is not English.
    conversation
        What is said about what was asked for already, by what it does.
    function_words
        Words that may follow a bare number without making it a count.
    misspelt
        What is meant by words as they are often mistyped.
    clipped
        What may be meant by words whose last letter is left out or doubled: they are pointed at.
    orders
        Verbs of what is done at home, which trees may have for nouns: "order pizza", "bath ella".
    called_by_number
        What a number right behind is the name of: "room 12", "season 2".
    """

    entries: Mapping[str, tuple[Entry, ...]]
    numbers: Mapping[str, int]
    magnitudes: Mapping[str, int]
    ordinals: Mapping[str, int]
    ambiguous: frozenset[str]
    indicators: Mapping[str, str]
    connectives: Mapping[tuple[str, ...], str]
    clauses: Mapping[tuple[str, ...], str]
    comparisons: Mapping[tuple[str, ...], Side]
    corrections: frozenset[tuple[str, ...]]
    addresses: frozenset[str]
    courtesies: frozenset[tuple[str, ...]]
    called_behind: frozenset[tuple[str, ...]]
    amounts: Mapping[tuple[str, ...], tuple[str, tuple[float, float, float, float] | None]]
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
    questions: Mapping[str, frozenset[tuple[str, ...]]]
    conversation: Mapping[str, frozenset[tuple[str, ...]]]
    foreign: frozenset[str]
    function_words: frozenset[str]
    misspelt: Mapping[str, str]
    clipped: Mapping[str, str]
    transliterated: Names[Entry]
    usual_hours: Mapping[tuple[str, ...], Hours]
    policy: Policy = field(default_factory=Policy)
    orders: frozenset[str] = field(init=False)
    called_by_number: frozenset[str] = field(init=False)

    def __post_init__(self) -> None:
        alone = self.chores | self.ordering | self.alone | self.causing - self.wanting
        orders = alone.union(self.doing.by_the_day, self.doing.by_then, self.doing.of_events)
        object.__setattr__(self, "orders", orders)
        numbered = self.measure_nouns | self.machines | self.no_times.numbered
        object.__setattr__(self, "called_by_number", numbered)

    def pieces(self, words: Sequence[Word], start: int) -> Iterator[Piece]:
        """Give what the tables say of the words from one place on."""
        following = {word.text for word in words[start + 1 : start + 3]}
        for entry in self.entries.get(words[start].text, ()):
            if len(entry.words) > 1 and entry.words[1] not in following:
                continue
            end = _matched(words, start, entry.words)
            if end and not (entry.category == "unit" and _ends_sentence(words, end)):
                yield Piece(entry.category, start, end, entry.value, entry.weight, "word")
        for end, entry in self.transliterated.at(words, start):
            yield Piece(entry.category, start, end, entry.value, entry.weight, "word")

    def means(self, text: str, *categories: str) -> bool:
        """Whether a word alone has a meaning of one of some categories: "friday" is a "weekday"."""
        entries = self.entries.get(text, ())
        return any(entry.category in categories and len(entry.words) == 1 for entry in entries)


def _ends_sentence(words: Sequence[Word], end: int) -> bool:
    """Whether a full stop before a place is no abbreviation's: "for two min. Add the salt", "at 7h."."""
    return words[end - 1].text == "." and (end == len(words) or words[end].capital)


def _matched(words: Sequence[Word], start: int, form: tuple[str, ...]) -> int:
    """Give the end of a form that stands at a place, or 0; a hyphen may join its words."""
    at = start + 1
    for text in form[1:]:
        if at < len(words) and words[at].text != text and joins(words, at):
            at += 1
        if at >= len(words) or words[at].text != text:
            return 0
        at += 1
    return at


def longest_match(
    words: Sequence[Word], start: int, forms: Iterable[tuple[str, ...]]
) -> tuple[str, ...] | None:
    """Give the longest of some forms that stands at a place, or None."""
    found = [f for f in forms if words[start].text == f[0] and _matched(words, start, f)]
    return max(found, key=len, default=None)


def form_of(text: str) -> tuple[str, ...]:
    """Give a way to say something as the words it is matched by."""
    if text.isascii() and text.replace(" ", "").isalpha():
        # Most are plain words, and thousands are read at every start.
        return tuple(text.lower().split())
    return tuple(word.text for word in words_of(text))
