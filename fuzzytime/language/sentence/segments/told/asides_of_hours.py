"""Asides that say when somewhere opens or closes: "return the books (closes at 5)", "(they open at nine)".

As those that say how long something takes they are no instructions; their time bounds what they stand behind.
"""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.segments.told.asides import OPENING, Aside
from fuzzytime.requirement import MOMENTS, Constraint

HOURS = "hours"
"""The rule of a time at which somewhere opens or closes."""

NAME = 4
"""Words at most for what opens or closes: "the main post office"."""


def asides_of_hours(scanned: Scanned) -> tuple[Aside, ...]:
    """Give the asides of a text that say when somewhere opens or closes, in order."""
    if scanned.lexicon.doing.hours.isdisjoint(word.text for word in scanned.words):
        return ()
    found = (_aside(scanned.words, phrase, scanned.lexicon) for phrase in phrases_of(scanned))
    return tuple(aside for aside in found if aside is not None)


def bounding(phrase: Phrase, *, closing: bool) -> Phrase:
    """Give the time at which somewhere closes, or opens, as a bound of what is done there."""
    constraint = Constraint.BEFORE if closing else Constraint.AFTER
    preposition = "before" if closing else "not before"
    return replace(phrase, said=replace(phrase.said, constraint=constraint, preposition=preposition))


def _aside(words: Sequence[Word], phrase: Phrase, lexicon: Lexicon) -> Aside | None:
    doing = lexicon.doing
    verb, behind = phrase.first - 1, phrase.end
    if verb < 1 or words[verb].text not in doing.hours or phrase.said.constraint not in MOMENTS:
        return None
    opening, named = _opening(words, verb, lexicon)
    if opening is None or not any(word.is_letters for word in _sentence_before(words, opening)):
        return None
    bracketed = words[opening].text == "(" and words[behind : behind + 1] and words[behind].text == ")"
    closing = words[verb].text in doing.closing_up | doing.closing_there
    told = bounding(phrase, closing=closing)
    told = replace(told, first=named, span=(words[named].start, phrase.span[1]), rule=HOURS)
    return Aside((words[opening].start, words[behind if bracketed else behind - 1].end), told, bounds=True)


def _opening(words: Sequence[Word], verb: int, lexicon: Lexicon) -> tuple[int | None, int]:
    """Give where an aside begins, by the place of its verb, and where what it says does; None for none.

    Without a bracket, what opens or closes is not named, or it is said to be why.
    """
    reasons, persons = lexicon.beside.reasons, lexicon.closed.third_person | lexicon.closed.plural_agreement
    place = verb - 1
    while place > max(0, verb - NAME - 1) and words[place].text not in OPENING | reasons:
        place -= 1
    mark, subject = words[place].text, [word.text for word in words[place + 1 : verb]]
    several = words[verb].text in lexicon.doing.closing_up | lexicon.doing.opening_up
    if several and (not subject or subject[-1] not in persons):
        # "Lock up, close at six": that is an order.
        return None, verb
    if mark in reasons:
        marked = place > 0 and words[place - 1].text in OPENING
        # "Lock the drawer as the shop closes at six" may say when.
        return (place - 1 if marked else None if mark == "as" else place), place + 1
    alone = not subject or subject[0] in lexicon.asides["naming"]
    told = mark == "(" or (mark in OPENING and alone and not several)
    return place if told else None, place + 1


def _sentence_before(words: Sequence[Word], place: int) -> Sequence[Word]:
    """Give the words of the same sentence before a place."""
    start = place
    while start > 0 and words[start - 1].text not in ENDS:
        start -= 1
    return words[start:place]
