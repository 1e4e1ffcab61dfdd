"""Asides that say when somewhere opens or closes, or somebody comes: "(closes at 5)", ", who lands at nine,".

As those that say how long something takes they are no instructions; their time bounds what they stand
behind, or is when that is done: "fetch Omar, who lands at nine, from the airport".
"""

from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.calendar import Cycle
from fuzzytime.language.meaning.expressions import Edge, Phrase, Range, Repeat, Said
from fuzzytime.language.sentence.segments.segment import ENDS
from fuzzytime.language.sentence.segments.told.asides import OPENING, Aside
from fuzzytime.requirement import MOMENTS, Constraint

HOURS = "hours"
"""The rule of a time at which somewhere opens or closes."""

NAME = 4
"""Words at most for what opens or closes: "the main post office"."""


def asides_of_hours(scanned: Scanned) -> tuple[Aside, ...]:
    """Give the asides of a text that say when somewhere opens or closes, in order."""
    doing, phrases = scanned.lexicon.doing, phrases_of(scanned)
    found = [_of_end(scanned.words, first, phrase, scanned.lexicon) for first, phrase in pairwise(phrases)]
    found += [_of_days(scanned.words, phrase, scanned.lexicon) for phrase in phrases]
    known = doing.hours | doing.moments | doing.going_on | scanned.lexicon.standing
    if not known.isdisjoint(word.text for word in scanned.words):
        found += [_aside(scanned.words, phrase, scanned.lexicon) for phrase in phrases]
    return tuple(sorted((aside for aside in found if aside is not None), key=lambda aside: aside.span))


def bounding(phrase: Phrase, *, closing: bool) -> Phrase:
    """Give the time at which somewhere closes, or opens, as a bound of what is done there."""
    constraint = Constraint.BEFORE if closing else Constraint.AFTER
    preposition = "before" if closing else "not before"
    return replace(phrase, said=replace(phrase.said, constraint=constraint, preposition=preposition))


def due_by(phrase: Phrase) -> Phrase:
    """Give the time by which something is due, and on which it may be done: "it's due on friday"."""
    due = replace(phrase.said, constraint=Constraint.BEFORE, preposition="by", edge=Edge.LAST)
    return replace(phrase, said=due)


def _aside(words: Sequence[Word], phrase: Phrase, lexicon: Lexicon) -> Aside | None:
    doing = lexicon.doing
    verb, behind = phrase.first - 1, phrase.end
    lasts = phrase.said.preposition == "until" and verb > 0 and words[verb].text in doing.going_on
    opens = opening_before(words, verb, OPENING, NAME) if lasts else verb
    if lasts and (words[opens].text == "(" or words[verb - 1].text in OPENING):
        # A parcel is collected from where it is "(open till six)", or a bank called: "(lines open till 4)".
        end = behind + (words[opens].text == "(")
        bound = replace(bounding(phrase, closing=True), rule=HOURS)
        return Aside((words[opens].start, words[end - 1].end), bound, bounds=True)
    shut = verb > 0 and words[verb].text in lexicon.standing and words[verb - 1].text in OPENING
    if shut and isinstance(phrase.said.time, Range):
        # "Collect the suit (closed 1 to 2)": not then.
        end = behind + (words[verb - 1].text == "(")
        kept_off = replace(phrase, said=replace(phrase.said, denied=True), rule=HOURS)
        return Aside((words[verb - 1].start, words[end - 1].end), kept_off, bounds=True)
    if verb < 1 or phrase.said.constraint not in MOMENTS:
        return None
    if words[verb].text not in doing.hours:
        return _of_somebody(words, phrase, lexicon)
    opening, named = _opening(words, verb, lexicon)
    if opening is None or not any(word.is_letters for word in before_in_sentence(words, opening)):
        return None
    bracketed = words[opening].text == "(" and words[behind : behind + 1] and words[behind].text == ")"
    closing = words[verb].text in doing.closing_up | doing.closing_there
    told = bounding(phrase, closing=closing)
    told = replace(told, first=named, span=(words[named].start, phrase.span[1]), rule=HOURS)
    return Aside((words[opening].start, words[behind if bracketed else behind - 1].end), told, bounds=True)


def _of_end(words: Sequence[Word], first: Phrase, phrase: Phrase, lexicon: Lexicon) -> Aside | None:
    """Give the aside that says when what has its time is over: "meeting at nine, should be done by ten"."""
    begins = first.said.constraint in MOMENTS or first.said.preposition == "from"
    begins = begins and first.said.wall.clock is not None
    place = phrase.first - 1
    over = (words[place].text,) in lexicon.conversation["finished"]
    if not begins or not over or phrase.said.constraint is not Constraint.BEFORE:
        return None
    helping = lexicon.closed.verbs_of_obligation | lexicon.closed.future | lexicon.closed.present_be
    while place > first.end and words[place - 1].text in helping | {"be", *lexicon.closed.singular_anaphors}:
        place -= 1
    # A stop parts entries: "interview at two; finished by three".
    marks = OPENING | {";"}
    between = [word.text for word in words[first.end : place]]
    if not marks.issuperset(between[-1:]) or marks & {*between[:-1]} or phrase.said.wall.clock is None:
        return None
    told = replace(phrase, said=replace(phrase.said, preposition="until"), rule=HOURS)
    return None if not between else Aside((words[place - 1].start, phrase.span[1]), told, bounds=True)


def _of_days(words: Sequence[Word], phrase: Phrase, lexicon: Lexicon) -> Aside | None:
    """Give the aside that says on which days, or when, somebody is there: "she's only in mornings"."""
    time = phrase.said.time
    if not isinstance(time, Repeat) or len(time.walls) != 1 or time.walls[0].clock:
        return None
    opening = opening_before(words, phrase.first, OPENING, NAME)
    said = [word.text for word in words[opening + 1 : phrase.end - 1]]
    closed, only = lexicon.closed, lexicon.beside.limited
    # "Take the dog out, only in the mornings" says how often.
    there = {*said} - only - closed.articles - closed.prepositions_of_times_taken or words[
        opening
    ].text == "("
    if words[opening].text not in OPENING or only.isdisjoint(said) or not there:
        return None
    (wall,) = time.walls
    # The next that comes is enough.
    once = replace(wall, days=None) if wall.part is not None and isinstance(wall.days, Cycle) else wall
    end = phrase.end + (words[opening].text == "(")
    return Aside(
        (words[opening].start, words[end - 1].end), replace(phrase, said=Said(once), rule=HOURS), bounds=True
    )


def _of_somebody(words: Sequence[Word], phrase: Phrase, lexicon: Lexicon) -> Aside | None:
    """Give the aside that says when somebody comes, or something is over: ", whose train gets in at six"."""
    opening = opening_before(words, phrase.first, OPENING, NAME)
    said = [word.text for word in words[opening + 1 : phrase.first]]
    led = words[opening].text in OPENING and len(said) > 1 and said[0] in lexicon.closed.relatives - {"that"}
    does = bool(said) and said[-1] in lexicon.doing.moments
    if led and said[-1] in lexicon.particles.keys() | lexicon.closed.adverbs_of_arrival:
        does = said[-2] in lexicon.doing.moments | lexicon.closed.present_be
    ends = words[phrase.end : phrase.end + 1]
    if not led or not does or any(word.text not in lexicon.closed.end_of_an_event for word in ends):
        return None
    before = before_in_sentence(words, opening)
    events = any(longest_match(before, place, lexicon.clauses) is not None for place in range(len(before)))
    if events or not any(word.is_letters for word in before):
        # "Feed the cat before the film, which starts at nine"
        return None
    end = phrase.end + any(word.text in {",", ")"} for word in ends)
    told = replace(phrase, first=opening + 1, span=(words[opening + 1].start, phrase.span[1]), rule=HOURS)
    return Aside((words[opening].start, words[end - 1].end), told, bounds=True)


def _opening(words: Sequence[Word], verb: int, lexicon: Lexicon) -> tuple[int | None, int]:
    """Give where an aside begins, by the place of its verb, and where what it says does; None for none.

    Without a bracket, what opens or closes is not named, or it is said to be why.
    """
    reasons, persons = lexicon.beside.reasons, lexicon.closed.third_person | lexicon.closed.plural_agreement
    place = opening_before(words, verb, OPENING | reasons, NAME)
    mark, subject = words[place].text, [word.text for word in words[place + 1 : verb]]
    several = words[verb].text in lexicon.doing.closing_up | lexicon.doing.opening_up
    if several and (not subject or subject[-1] not in persons):
        # "Lock up, close at six": that is an order.
        return None, verb
    if mark in reasons:
        marked = place > 0 and words[place - 1].text in OPENING
        # "Lock the drawer as the shop closes at six" may say when.
        return (place - 1 if marked else None if mark == "as" else place), place + 1
    alone = not subject or subject[0] in lexicon.asides["naming"] | lexicon.closed.relatives
    told = mark == "(" or (mark in OPENING and alone and not several)
    return place if told else None, place + 1


def opening_before(words: Sequence[Word], place: int, marks: AbstractSet[str], longest: int) -> int:
    """Give the place of the mark before a place, or, without one, of the first of as many words before it."""
    first = max(0, place - longest - 1)
    return next((at for at in range(place - 1, first, -1) if words[at].text in marks), first)


def before_in_sentence(words: Sequence[Word], place: int) -> Sequence[Word]:
    """Give the words of the same sentence before a place."""
    start = place
    while start > 0 and words[start - 1].text not in ENDS:
        start -= 1
    return words[start:place]
