"""What is said behind a comma in words of its own: "…, finished by five", "…, car needs picking up by noon".

It is told apart from what stands before it, which trees take together with it.
"""

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet

from fuzzytime.english import is_participle
from fuzzytime.language.grammar.lexicon import Lexicon, longest_match
from fuzzytime.language.grammar.spans import Scanned, phrases_of
from fuzzytime.language.instruction import blanked
from fuzzytime.language.meaning.expressions import Phrase
from fuzzytime.language.meaning.phrases import places_in
from fuzzytime.language.sentence.segments.told.asides_of_hours import before_in_sentence
from fuzzytime.language.sentence.segments.told.asides_of_needs import MARKS, said_of
from fuzzytime.requirement import BOUNDS, MOMENTS, Constraint

APART = ";"
"""The mark in front of what is told apart, in place of its bracket."""

STOP, IS, NO = ".", ("'s", "’s"), "no"
WORKING = 3
"""Words of "robot 2 docks"."""

LONGEST = 4
"""Words of "my best blue shirt" at most."""


def with_told_apart(scanned: Scanned) -> str:
    """Give a text of the same length with a stop in front of each that is said so."""
    words, text = scanned.words, scanned.text
    for mark in {mark for find in APART_BY for mark in find(scanned)}:
        text = text[: words[mark].start] + STOP.ljust(len(words[mark].text)) + text[words[mark].end :]
    return text


def _behind_days(scanned: Scanned) -> Iterator[int]:
    """Give the joints behind the days on which something is told to be: "the exam's monday | so revise"."""
    if any(word.text.endswith(IS) for word in scanned.words[1:-1]):
        yield from (phrase.end for phrase in phrases_of(scanned) if _is_of_day(scanned, phrase))


def _behind_workers(scanned: Scanned) -> Iterator[int]:
    """Give the marks before what further workers do: "robot 1 docks at two | , robot 2 leaves"."""
    workers = [p for p in range(2, len(scanned.words) - WORKING) if _acts_too(scanned, p)]
    timed = places_in(phrases_of(scanned)) if workers else frozenset()
    yield from (p for p in workers if p - 1 in timed and _asks_before(scanned, p, timed))


def _behind_being_there(scanned: Scanned) -> Iterator[int]:
    """Give the marks behind where somebody is to be by a time: "in bed by seven | , lights off at eight"."""
    there = [place for place in range(len(scanned.words) - 1) if _begins_there(scanned, place)]
    phrases = phrases_of(scanned) if there else ()
    timed = places_in(phrases)
    ends = (_end_of_being_there(scanned, place, phrases) for place in there if place not in timed)
    yield from (end for end in ends if end)


def _before_denials(scanned: Scanned) -> Iterator[int]:
    """Give the marks before what is denied by its name: "walk the dog daily | , no walks on sundays"."""
    words = scanned.words
    denied = [p for p in range(2, len(words)) if words[p].text == NO and words[p - 1].text in MARKS]
    phrases = phrases_of(scanned) if denied else ()
    yield from (place - 1 for place in denied if _denies(scanned, place, phrases))


def _before_ends_and_needs(scanned: Scanned) -> Iterator[int]:
    """Give the marks before what says that all is over by a time, or that something needs something."""
    words, lexicon = scanned.words, scanned.lexicon
    ended = lexicon.beside.ended - lexicon.particles.keys()
    places = [p for p in range(2, len(words)) if words[p].text in ended or _needs_deed(scanned, p)]
    phrases = phrases_of(scanned) if places else ()
    timed = places_in(phrases)
    ends = {p.first: p.end for p in phrases if p.said.constraint in {Constraint.BEFORE, *MOMENTS}}
    for place in places:
        end = ends.get(place + 1, 0) if words[place].text in ended else -1
        mark = _mark_of_end(scanned, place, end) if end >= 0 else _mark_of_need(scanned, place)
        first = mark - len(before_in_sentence(words, mark))
        # "Tomorrow, the car needs washing", "once it's dry, the fence needs painting"
        asks = any(words[p].is_letters and p not in timed for p in range(first, mark))
        if mark and asks and longest_match(words, first, lexicon.clauses) is None:
            yield mark


APART_BY = (_behind_days, _behind_workers, _behind_being_there, _before_denials, _before_ends_and_needs)
"""What gives the marks in front of what is told apart."""


def with_brackets_apart(scanned: Scanned) -> str:
    """Give a text of the same length where brackets with an hour of their own are told apart.

    So they are behind what has its hour: "party at eight (doors open at 7:30)"; but "party (at eight)", where
    only what leads to the hour is left out: "party (it's at eight)".
    """
    words, text = scanned.words, scanned.text
    opened = [place for place, word in enumerate(words) if word.text == "("] if ")" in text else []
    phrases = phrases_of(scanned) if opened else ()
    timed = places_in(phrases)
    for place in opened:
        end = next((p for p in range(place, len(words)) if words[p].text == ")"), place)
        named = [words[p].text for p in range(place + 1, end) if words[p].is_letters and p not in timed]
        own = any(_says_hour(one) and place < one.first and one.end <= end for one in phrases)
        before = any(_says_hour(one) and one.end <= place for one in phrases)
        first = words[place + 1].text if place + 1 < end else ""
        if named and own and before and first not in scanned.lexicon.function_words:
            inside = text[words[place].end : words[end].start]
            text = f"{text[: words[place].start]}{APART}{inside} {text[words[end].end :]}"
        elif not before and named and _lead_to_hour(named, scanned.lexicon):
            text = blanked(text, [(words[place + 1].start, words[place + len(named)].end)])
    return text


def _lead_to_hour(said: Sequence[str], lexicon: Lexicon) -> bool:
    """Whether words only say that something is, or begins, before they say when: "it's", "starts"."""
    being = {*said_of(said, lexicon.closed.anaphors)}
    begins = {word for word in lexicon.doing.surely_timed if lexicon.indicators.get(word) == "start"}
    return bool(being and being <= lexicon.asides["being needed"]) or {*said} <= begins


def _says_hour(phrase: Phrase) -> bool:
    """Whether a time says at which hour something is, or on which side of it."""
    return phrase.said.wall.clock is not None and phrase.said.constraint is not Constraint.FOR


def _is_of_day(scanned: Scanned, phrase: Phrase) -> bool:
    """Whether it is told on which day something is, and more behind: "the exam's monday so revise"."""
    words, joints = scanned.words, scanned.lexicon.closed.joints_of_orders | {"so"}
    told = phrase.said.is_day and phrase.first > 1 and words[phrase.first - 1].text.endswith(IS)
    return told and phrase.end < len(words) - 1 and words[phrase.end].text in joints


def _acts_too(scanned: Scanned, place: int) -> bool:
    """Whether a mark stands before what a further worker does: "robot 1 docks at two | , robot 2 leaves"."""
    mark, worker, number, verb = scanned.words[place : place + WORKING + 1]
    named = worker.text in scanned.lexicon.workers and number.is_digits
    return named and verb.is_letters and verb.text.endswith("s") and mark.text in {",", "and", ";"}


def _asks_before(scanned: Scanned, place: int, timed: AbstractSet[int]) -> bool:
    """Whether no clause is said before a place: but "when robot 1 docks at two, | robot 2 leaves"."""
    first = place - len(before_in_sentence(scanned.words, place))
    said = (p for p in range(first, place) if p not in timed)
    return all(longest_match(scanned.words, p, scanned.lexicon.clauses) is None for p in said)


def _begins_there(scanned: Scanned, place: int) -> bool:
    """Whether where somebody is to be begins a sentence: "up", "in bed"."""
    words = scanned.words
    return words[place].text in scanned.lexicon.beside.states and not before_in_sentence(words, place)


def _end_of_being_there(scanned: Scanned, place: int, phrases: Sequence[Phrase]) -> int:
    """Give the mark behind where somebody is to be by a time: "in bed by seven | , lights off at eight".

    What stands behind it has a time of its own, or is an order: but "home by five, please".
    """
    words = scanned.words
    behind = [phrase for phrase in phrases if phrase.first > place]
    due = behind[0] if behind else None
    if due is None or due.said.constraint not in {Constraint.BEFORE, *MOMENTS} or due.end > len(words) - 2:
        return 0
    orders = scanned.lexicon.orders | scanned.lexicon.addressing
    mark = due.end
    while words[due.end].text == "to" and mark < len(words) - 2 and words[mark].is_letters:
        # "Up by six to pack, out by seven"
        mark += 1
    if len(behind) == 1 and words[mark + 1].text not in orders:
        return 0
    named = due.first - place < LONGEST and all(word.is_letters for word in words[place : due.first])
    return mark if named and words[mark].text in {",", "and", ";"} else 0


def _denies(scanned: Scanned, place: int, phrases: Sequence[Phrase]) -> bool:
    """Whether "no" denies what is named behind it, up to its time: "…, no walks on sundays".

    What stands before it has a time, or that one is a bound: but "a coffee, no sugar, at eight".
    """
    first = place - len(before_in_sentence(scanned.words, place))
    timed = any(first <= phrase.first and phrase.end <= place - 1 for phrase in phrases)
    behind = next((phrase for phrase in phrases if phrase.first > place), None)
    if behind is None or not (timed or behind.said.constraint in BOUNDS):
        return False
    named = [word.text for word in scanned.words[place + 1 : behind.first]]
    known = scanned.lexicon.function_words.isdisjoint(named)
    return 0 < len(named) < LONGEST and known and all(map(str.isalpha, named))


def _mark_of_end(scanned: Scanned, place: int, end: int) -> int:
    """Give the mark in front of what says that all is over by a time, up to its end; 0 for none."""
    words, closed = scanned.words, scanned.lexicon.closed
    over = all(word.text in closed.end_of_an_aside for word in words[end : end + 1])
    place -= 1
    while place and words[place].text in closed.wholes | closed.both | closed.anaphors:
        place -= 1
    return place if end and over and words[place].text in MARKS - {"("} else 0


def _mark_of_need(scanned: Scanned, place: int) -> int:
    """Give the mark in front of a thing, without a word for anybody, that needs something; 0 for none."""
    words, lexicon = scanned.words, scanned.lexicon
    mark = next((p for p in range(place - 1, max(place - LONGEST, 1) - 1, -1) if words[p].text in MARKS), 0)
    named = [word.text for word in words[mark + 1 : place]]
    opened = named[:1] if named[:1] and named[0] in lexicon.closed.noun_openers else []
    known = lexicon.function_words.isdisjoint(named[len(opened) :])
    return mark if len(named) > len(opened) and known else 0


def _needs_deed(scanned: Scanned, place: int) -> bool:
    """Whether a word says that something needs what is behind it: "needs picking up"."""
    words = scanned.words
    needs = words[place].text.removesuffix("s") in scanned.lexicon.doing.needing
    return needs and any(is_participle(word.text) for word in words[place + 1 : place + 2])
