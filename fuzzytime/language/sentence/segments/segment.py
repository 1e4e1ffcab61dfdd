"""A text cut into instructions: at the ends of sentences, at "then" and its kind, before a further verb."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import Span
from fuzzytime.language.meaning.expressions import Offset, Phrase, TimeWord
from fuzzytime.language.meaning.joined.distances import LATER
from fuzzytime.language.meaning.phrases import places_in
from fuzzytime.language.sentence.segments.borrowed import Borrowed
from fuzzytime.language.sentence.segments.events.named_events import (
    behind_happening,
    behind_statements,
    beside,
    counts_event,
    heads,
    listed,
)
from fuzzytime.language.sentence.segments.openings import (
    before_courtesies,
    behind_all_due,
    behind_opening,
    requests_behind,
)
from fuzzytime.language.sentence.segments.other_cases import OTHER_CASE, begins_other_case
from fuzzytime.language.sentence.segments.taken_back.corrected_things import (
    AFTER_ALL,
    corrected_things,
    retractions,
)

ENDS = frozenset({".", "!", "?", ";", "…", "\n"})

DASHES = frozenset({"-", "–", "—"})

NOT = "not"
"""Behind a dash it takes back what was said: "scrub the tub - not now, in an hour"."""

SHORTEST = 3
"""Words of an order, at least, behind which a dash begins another: "Anna - feed the cat" calls somebody."""

JOINED = frozenset({"", "and"})
"""Connectives behind which nothing else says when."""


@dataclass(frozen=True, slots=True)
class Segment:
    """A stretch of the text that holds one instruction, and the connective that led to it, with its span.

    ``addressee`` is who was asked by name, before a comma or behind one; ``verbless`` says that its verb was
    said before: "the cat at eight and the dog at nine". ``doer`` is who does it, named before: "the drone
    takes off at nine, surveys the field"; that one is asked where both are the same. What is ``borrowed`` are
    other words said before that hold in it too; in an ``entry`` of a list, no others do.
    """

    span: Span
    connective: str = ""
    connective_span: Span = (0, 0)
    addressee: str | None = None
    verbless: bool = False
    doer: str | None = None
    borrowed: tuple[Borrowed, ...] = ()
    entry: bool = False

    def shares(self, text: str) -> bool:
        """Whether it shares object and time with the verb alone before it: "peel and chop the onions"."""
        return self.doer is None and text[slice(*self.connective_span)].lower() in {"and", ","}


def segments_of(
    text: str, words: Sequence[Word], phrases: Sequence[Phrase], lexicon: Lexicon, taken_back: Sequence[Span]
) -> list[Segment]:
    """Cut a text at what always ends an instruction: full stops and connectives, outside of times.

    ``taken_back`` are stretches that later words correct: nothing ends there.
    """
    inside = places_in(phrases)
    inside |= {place for place, word in enumerate(words) if any(a <= word.start < b for a, b in taken_back)}
    cuts: list[tuple[int, int, str]] = []
    place = 0
    vague = {phrase.first for phrase in phrases if isinstance(phrase.said.time, TimeWord)}
    corrections = list(corrected_things(words, phrases, lexicon))
    instead = {thing.pause: thing.start for thing in corrections}
    following = _following(words, phrases, lexicon) | {thing.end for thing in corrections if thing.further}
    following |= {end for let in retractions(words, lexicon, taken_back) for end in (let.start, let.stop)}
    times = {phrase.first: phrase.end for phrase in phrases}
    requests = dict(requests_behind(words, times, lexicon))
    while place < len(words):
        if place in following:
            cuts.append((place, place, ""))
        if place in requests:
            cuts.append((place, requests[place], ""))
            place = requests[place]
        if place in instead:
            cuts.append((place, instead[place], AFTER_ALL))
            place = instead[place]
            continue
        if place in inside and place not in vague:
            place += 1
            continue
        opens = _opens(words, place, vague, lexicon) and not counts_event(words, place, phrases, lexicon)
        cut = _connective_at(words, place, phrases, lexicon) if opens else None
        if cut is not None:
            cuts.append(cut)
            place = cut[1]
            continue
        ends = words[place].text in ENDS and _is_end(text, words, place, lexicon)
        begun = [p for p in range(cuts[-1][1] if cuts else 0, place) if p not in inside]
        parts = _parts_what_is_told(words, place, lexicon) if begun else False
        if ends or parts or _parts_orders(words, begun, place, lexicon):
            cuts.append((place, place + 1, ""))
        place += 1
    return list(_between(text, words, cuts, times, lexicon))


def _following(words: Sequence[Word], phrases: Sequence[Phrase], lexicon: Lexicon) -> set[int]:
    """Give the places at which what follows times, or has one, begins without a connective."""
    found = {phrase.first for phrase in phrases if _follows(phrase, words)}
    found |= {phrase.end for phrase in phrases if _stops(phrase, words, lexicon)}
    found |= {phrase.end for phrase in phrases[:1] if heads(phrase, words)}
    return found.union(
        listed(phrases, words, lexicon),
        behind_happening(phrases, words, lexicon),
        behind_statements(phrases, words, lexicon, ENDS),
        beside(phrases, words, lexicon),
    )


def _connective_at(
    words: Sequence[Word], place: int, phrases: Sequence[Phrase], lexicon: Lexicon
) -> tuple[int, int, str] | None:
    """Give the connective at a place, from where to where it stands, and its name; None without one."""
    found = longest_match(words, place, lexicon.connectives)
    if found is None or len(longest_match(words, place, lexicon.clauses) or ()) > len(found):
        # "Next time I'm at the shop"
        return None
    timed = {phrase.first for phrase in phrases if not isinstance(phrase.said.time, TimeWord)}
    if not timed.isdisjoint(range(place, place + len(found))):
        # "And next friday"
        return None
    end = _end_of(words, place, len(found))
    if end >= len(words) or words[end].text in {*ENDS, "as"}:
        # "Do it when you're done": nothing follows.
        return None
    each, name = lexicon.closed.distributives, lexicon.connectives[found]
    if name == "meanwhile" and words[end].text in each:
        # "At the same time every evening"
        return None
    if words[place].text in each and not _is_order(words, end, lexicon):
        return None
    if name == OTHER_CASE and not begins_other_case(words, place, end, phrases, lexicon):
        return None
    return place, end, name


def _parts_what_is_told(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a dash stands before what is told of somebody, or of something: "buy milk - we're out"."""
    behind = words[place + 1].text.partition("'")[0] if place + 1 < len(words) else ""
    return words[place].text == "-" and behind in lexicon.closed.subject_pronouns


def _parts_orders(words: Sequence[Word], begun: Sequence[int], place: int, lexicon: Lexicon) -> bool:
    """Whether a dash stands before a further order: "spray the tiles - leave it for ten minutes".

    "Anna - feed the cat" calls somebody, and "once it's cool - slice it" has its order behind the dash.
    """
    if words[place].text not in DASHES or words[place].glued or place + 2 >= len(words):
        return False
    behind = place + 1
    if len(begun) < SHORTEST or longest_match(words, begun[0], lexicon.clauses) is not None:
        return False
    said, following = words[behind].text, words[behind + 1].text
    denies = said in lexicon.closed.negators_as_typed and said != NOT
    if denies or (said in lexicon.letting and following in lexicon.closed.it_or_them):
        return True
    return not any(lexicon.pieces(words, behind)) and _acts(words, behind, lexicon)


def _acts(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a word at a place does something to what stands behind it, and behind its particle."""
    inside = words[place].text in lexicon.function_words | lexicon.places or not words[place].is_letters
    behind = place + 1 + (words[place + 1].text in lexicon.particles)
    things = lexicon.closed.noun_openers | lexicon.closed.it_or_them
    return not inside and behind < len(words) and words[behind].text in things


def _follows(phrase: Phrase, words: Sequence[Word]) -> bool:
    """Whether a time in front of an order counts from the order before: "…, five minutes later serve"."""
    later = isinstance(phrase.said.time, Offset) and phrase.said.preposition == LATER
    joined = phrase.first > 0 and words[phrase.first - 1].text in {",", "and", "then", ";"}
    return later and joined and phrase.end < len(words) and words[phrase.end].text not in ENDS


def _stops(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether the full stop of an abbreviation ends a sentence too: "at 6 p.m. Add the salt"."""
    if words[phrase.end - 1].text != "." or phrase.end + 1 >= len(words):
        return False
    begins = words[phrase.end].capital or _acts(words, phrase.end, lexicon)
    # "6 p.m. Add the salt" is one.
    return begins and not _leads(phrase, words, lexicon)


def _leads(phrase: Phrase, words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a time stands in front of its sentence: "hey robot, at 6 p.m. add the salt", "6 p.m. Bath"."""
    ends = (place + 1 for place in range(phrase.first) if words[place].text in ENDS)
    begin = max(ends, default=0)
    return behind_opening(words, begin, phrase.end, {phrase.first}, lexicon) == phrase.first


def _end_of(words: Sequence[Word], place: int, length: int) -> int:
    """Give the place behind a connective, and the comma that may follow it."""
    end = place + length
    return end + 1 if end < len(words) and words[end].text in {",", ":"} else end


def _is_order(words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether an order stands behind "each time", and not what that is of: "each time check her pulse"."""
    openers, objects = lexicon.closed.noun_openers, lexicon.closed.all_anaphors
    said = [word.text for word in words[place : place + 2]]
    subjects = openers | objects | lexicon.closed.personal_pronouns
    return len(said) > 1 and said[0] not in subjects and said[1] in openers | objects


def _opens(words: Sequence[Word], place: int, vague: set[int], lexicon: Lexicon) -> bool:
    """Whether a connective here opens an instruction, and is no word inside one ("the next step").

    A vague time does where an instruction begins: "wipe the table; afterwards sweep the floor".
    """
    closed = lexicon.closed
    if place + 1 >= len(words):
        return False
    before = words[place - 1].text if place else ","
    if words[place].text == "then" and before in closed.prepositions_of_time:
        return False
    if place in vague and (not place or (before[0].isalnum() and before not in closed.before_connectives)):
        return False
    return (
        words[place].text not in closed.conjuncts
        or before in closed.before_connectives
        or not before[0].isalnum()
    )


def _is_end(text: str, words: Sequence[Word], place: int, lexicon: Lexicon) -> bool:
    """Whether a mark ends a sentence: it is no part of a number or an abbreviation."""
    word = words[place]
    after = text[word.end : word.end + 1]
    if after == ")":
        # As in "buy bread (the brown one!) at noon".
        return False
    if word.text != ".":
        return True
    if after and not after.isspace():
        return False
    before = words[place - 1] if place else None
    if before is not None and before.glued and words[place - 2].is_digits:
        # "On the 21st": no saint.
        return True
    return before is None or (
        not (len(before.text) == 1 and before.is_letters) and before.text not in lexicon.closed.abbreviations
    )


def _between(
    text: str,
    words: Sequence[Word],
    cuts: Sequence[tuple[int, int, str]],
    times: Mapping[int, int],
    lexicon: Lexicon,
) -> Iterator[Segment]:
    start, connective, said = 0, "", (0, 0)
    for first, end, name in (*cuts, (len(words), len(words), "")):
        begin = behind_all_due(words, start, first, times, lexicon)
        begin = behind_opening(words, begin, first, times.keys(), lexicon)
        last = before_courtesies(words, begin, first, times, lexicon)
        segment = _segment(text, words, begin, last, connective, said)
        if segment is not None:
            yield segment
            connective, said = "", (0, 0)
        start = end
        if name:
            last = end - 1 if words[end - 1].text == "," else end
            connective, said = name, (words[first].start, words[last - 1].end)


def _segment(
    text: str, words: Sequence[Word], start: int, end: int, connective: str, said: Span
) -> Segment | None:
    while start < end and words[start].text in {",", "and", ":", "-"}:
        start += 1
    while end > start and words[end - 1].text in {",", "and", ":"}:
        end -= 1
    if start >= end:
        return None
    span = (words[start].start, words[end - 1].end)
    if not any(character.isalnum() for character in text[span[0] : span[1]]):
        return None
    return Segment(span, connective, said, verbless=connective == AFTER_ALL)
