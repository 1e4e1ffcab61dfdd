"""Where what has a time is named among orders: "first lesson at nine", "…, with a break at five"."""

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet
from itertools import pairwise, takewhile

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Phrase, Wall
from fuzzytime.language.meaning.phrases import places_in

LONGEST_NAME = 4
"""Words at most, and one, of the name of what has a time: "first aid course"."""
LONGEST_MEANWHILE = 6
"""Words at most of what happens meanwhile: "with a ten-minute break at five"."""

MARKS = frozenset({":", "-", "–", "—"})
"""Marks between what is told and what is to be done for it."""


def counts_event(words: Sequence[Word], place: int, phrases: Sequence[Phrase], lexicon: Lexicon) -> bool:
    """Whether "first" is of what has a time, or of several: "first lesson at nine", "first … second coat"."""
    if words[place].text != "first" or place + 1 >= len(words):
        return False
    behind = words[place + 1].text
    if any(one.text == "second" and other.text == behind for one, other in pairwise(words)):
        return True
    time = next((phrase.first for phrase in phrases if phrase.first > place), place)
    named = place + 1 < time <= place + LONGEST_NAME
    # "First coat at three"
    turns = lexicon.spacing["turns"]
    return named and words[time - 1].text in lexicon.happening | lexicon.taken | turns


def beside(phrases: Sequence[Phrase], words: Sequence[Word], lexicon: Lexicon) -> Iterator[int]:
    """Give where begins what happens meanwhile: "revise from four to six, with a break at five"."""
    covered = places_in(phrases)
    for phrase in phrases[1:]:
        last = phrase.first - 1
        called = words[last].text in lexicon.happening | lexicon.taken and last not in covered
        first = next(
            (p for p in range(last, max(0, last - LONGEST_MEANWHILE), -1) if words[p].text == "with"), 0
        )
        joined = first > 1 and (first - 1 in covered or words[first - 1].text == ",")
        if called and joined and first not in covered and isinstance(phrase.said.time, Wall):
            yield first + 1


def heads(phrase: Phrase, words: Sequence[Word]) -> bool:
    """Whether a day behind what it is the day of ends at a colon: "school trip on the 12th: …"."""
    ends = phrase.end + 1 < len(words) and words[phrase.end].text == ":" and not words[phrase.end + 1].glued
    return ends and phrase.said.is_day and phrase.first > 0


def listed(phrases: Sequence[Phrase], words: Sequence[Word], lexicon: Lexicon) -> Iterator[int]:
    """Give where the lines of a timetable begin: "10:00 stretch 10:15 walk"; not "10:00, 10:15"."""
    clocks = [p for p in phrases if p.said.preposition is None and p.said.wall.clock is not None]
    if not clocks or clocks[0].first > 0:
        return
    for before, clock in pairwise(clocks):
        between = [other for other in phrases if before.end <= other.first < clock.first]
        told = (word for word in words[before.end : clock.first] if word.is_letters)
        if not between and any(word.text not in lexicon.function_words for word in told):
            yield clock.first


def behind_happening(phrases: Sequence[Phrase], words: Sequence[Word], lexicon: Lexicon) -> Iterator[int]:
    """Give where an order begins behind what happens: "lunch at noon, cook it beforehand".

    Its day may stand in front: "thu: swimming at four, bring a snack".
    """
    first, begin = next(iter(phrases), None), 0
    if first is not None and not first.first and first.said.is_day and len(phrases) > 1:
        begin, first = first.end + (words[first.end].text == ":"), phrases[1]
    if first is None or first.first <= begin or longest_match(words, begin, lexicon.clauses) is not None:
        # "After the wedding on the 21st, call mum"
        return
    # "My dentist appointment at ten, …" names what happens, "call at ten, …" asks for it.
    named = (
        all(word.text in lexicon.closed.noun_openers | lexicon.taken for word in words[begin : first.first])
        and first.first > begin + 1
    )
    # "Vet 10, dentist 3", "dentist at four, bring the card"; but "call at ten, …" asks for it
    asked = lexicon.orders | lexicon.addressing | lexicon.needing_nothing
    surely = len(phrases) > 1 or words[begin].text not in asked
    listed = first.first == begin + 1 and words[begin].text in lexicon.taken and surely
    if not (named or listed) and words[first.first - 1].text not in lexicon.happening:
        return
    behind = first.end + 1
    if behind < len(words) and words[first.end].text in {",", "-", ":"}:
        taken = lexicon.function_words | lexicon.places | lexicon.closed.alternatives
        timed = places_in(phrases)
        entry = takewhile(lambda place: words[place].text != ",", range(behind, len(words)))
        # "Gym on mon, wed and fri at 7"
        ordered = any(p not in timed and words[p].text not in lexicon.function_words for p in entry)
        if words[behind].is_letters and words[behind].text not in taken and ordered:
            yield behind


def behind_statements(
    phrases: Sequence[Phrase], words: Sequence[Word], lexicon: Lexicon, ends: AbstractSet[str]
) -> Iterator[int]:
    """Give the marks before an order that follows from what is told: "the shop shuts at six: buy milk"."""
    doing, closed = lexicon.doing, lexicon.closed
    told = doing.timed | doing.several_timed | doing.arriving | doing.leaving | closed.present_be
    told |= {f"{verb}{ending}" for verb in doing.arriving | doing.leaving for ending in ("s", "es")}
    subjects = closed.noun_openers | closed.personal_pronouns | closed.singular_anaphors
    subjects |= lexicon.happening | lexicon.persons
    for phrase in phrases:
        mark = words[phrase.end] if phrase.end + 1 < len(words) else None
        if mark is None or mark.text not in MARKS or (mark.glued and mark.text != ":"):
            continue
        first = next((p + 1 for p in range(phrase.first - 1, -1, -1) if words[p].text in ends), 0)
        said = [word.text for word in words[first : phrase.first]]
        behind = words[phrase.end + 1]
        orders = behind.is_letters and not behind.glued and behind.text not in lexicon.function_words
        if orders and len(said) > 1 and said[0] in subjects and not told.isdisjoint(said[1:]):
            yield phrase.end
