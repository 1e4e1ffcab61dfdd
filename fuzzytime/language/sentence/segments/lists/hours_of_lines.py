"""Hours behind what lines name, where the lines together are a list of times: "Panel 11.30", "Lunch 12 to 1".

On a line by itself such a number may be a price, or of how many. Among lines that each say when something
is, it is an hour, as if "@" stood in front of it.
"""

import re
from collections.abc import Iterator, Sequence
from enum import IntEnum
from itertools import takewhile

from fuzzytime.english import looks_plural, singular
from fuzzytime.language.grammar.judging.walls.bare_hours import YEARS
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.timetables import SEPARATORS, counts_nothing, has_time
from fuzzytime.language.grammar.words import Word, words_of
from fuzzytime.language.sentence.segments.lists.dividers import LINE
from fuzzytime.language.sentence.segments.lists.typed_hours import (
    ALONE,
    FURTHER,
    LEADING,
    POINT,
    THREE,
    hours_behind,
)

PLACED = 3
"""Words of a thing that is in some place at least: "joint in the oven"."""

ONLY = re.compile(
    r"\d{1,2}(?:[:.]\d\d)?(?:\s?[ap]m)?(?:\s?[-–—]\s?\d{1,2}[:.]\d\d(?:\s?[ap]m)?)?\W{0,3}(?:\s[^\W\d][\w'’]*)+",
    re.IGNORECASE,
)
"""An hour, or from when to when, and words without a mark between: "9:30 - 10:05: group"."""

BESIDE_HOURS = (
    "hedge", "hedge_after", "preposition_at", "preposition_before", "preposition_after", "forward", "within",
    "weekday", "day", "month", "unit",
)  # fmt: skip
"""What words mean that belong to what is behind them: "exactly 9.10", "friday 9.30", "day 3"."""


class Timed(IntEnum):
    """How many lines say when something is: of most of them, a number alone is an hour, too: "Wrap 7".

    So is one in front of a line where most of those hours ``LEAD``: "10 cut bars"; and whatever it may count,
    where those in front go up ``IN_ORDER`` through a day: "7.30 drugs", "8 breakfasts", "10 ward round".
    """

    NO = 0
    SOME = 1
    MOST = 2
    LEAD = 3
    IN_ORDER = 4


def hours_in(text: str, lexicon: Lexicon, timed: Timed = Timed.SOME) -> frozenset[int]:
    """Give where in a line of a list of times a space stands before an hour, or a point in the first of it.

    >>> from fuzzytime.language import shipped_lexicon
    >>> sorted(hours_in("Panel 11.30", shipped_lexicon()))
    [5, 8]
    >>> hours_in("Wrap 7", shipped_lexicon()), hours_in("Wrap 7", shipped_lexicon(), Timed.MOST)
    (frozenset(), frozenset({4}))
    """
    if not timed:
        return frozenset()
    return frozenset((*_behind_things(text, lexicon, timed), *_in_front(text, lexicon, timed)))


def _behind_things(text: str, lexicon: Lexicon, timed: Timed) -> Iterator[int]:
    """Give where an hour follows what is then, and the points in it."""
    for found in hours_behind(lexicon.beside.of_hours).finditer(text):
        before = words_of(text[: found.start()])
        before = before[:-1] if before and before[-1].text in lexicon.beside.again else before
        behind = words_of(text[found.end() :])[:1]
        counts = _is_amount(behind, lexicon)
        # "Beef in 10.45 - 20 min"
        lasts = counts and found["dash"] is not None and (found["minutes"] or found["digits"]) is not None
        if not before or (counts and not lasts) or _is_other(found, before, lexicon) or _numbers(found):
            continue
        apart = found["last"] and found["dash"] and not found["minutes"] and not _is_within_hour(found)
        if apart and _is_called(before[-1], lexicon):
            # "Dive 1 - 9.30"
            yield found.end("dash") - 1
            continue
        if ":" in text[found.start("mark") : found.end()] and not lexicon.means(before[-1].text, "hedge"):
            # "Panel 9:15" needs no mark.
            continue
        if not (lasts or _may_end(found, before, behind, lexicon, timed)) or not _names(
            found, before, lexicon, timed
        ):
            continue
        yield found.start("mark")
        end = found.start("until") if lasts else found.end()
        yield from (point.start() for point in POINT.finditer(text, found.start(), end))


def _names(found: re.Match[str], before: Sequence[Word], lexicon: Lexicon, timed: Timed) -> bool:
    """Whether words name what is at the hour behind them; but "guests: 12" is how many."""
    typed = found["minutes"] or found["last"] or found["digits"]
    counted = found["gap"] == "," or _is_counted(before[-1], lexicon)
    apart = timed < Timed.MOST or (counted and not typed)
    if found["gap"] and (apart or not before[-1].is_letters):
        return False
    if found["digits"] and timed < Timed.MOST and not found["digits"].startswith("0"):
        return False
    numbers = [int(number) for number in re.findall(r"\d+", found[0])]
    if not typed and _takes(before, lexicon) and not (found["until"] and numbers[0] > numbers[1]):
        # "Simmer 10", "simmer 10 - 12"; but "boil 12 - 1"
        return False
    sure = timed >= Timed.MOST and found["minutes"] is not None
    # "Market stall 10-2": nothing is counted from ten to two.
    wraps = found["until"] is not None and len(numbers) > 1 and numbers[0] > numbers[1]
    named = _is_thing(before[-1], lexicon, sure=sure) if typed or wraps else _is_timed(before, lexicon, timed)
    return named or ((typed or timed >= Timed.MOST) and _has_state(before, lexicon))


def _in_front(text: str, lexicon: Lexicon, timed: Timed) -> Iterator[int]:
    """Give where the point is in an hour in front of what is then, or what is before it: "7.10 crew call"."""
    for line in LINE.finditer(text):
        found = LEADING.match(line[0])
        if found is not None and not _is_amount(words_of(line[0][found.end() :])[:1], lexicon):
            if found["point"]:
                ends = FURTHER.match(line[0], found.end()) or found
                points = POINT.finditer(line[0], found.start(), ends.end())
                yield from (line.start() + point.start() for point in points)
            elif timed >= Timed.LEAD:
                yield line.start() + found.start("digits") - 1
        three = THREE.match(line[0]) if timed is Timed.IN_ORDER else None
        if three is not None:
            yield line.start() + three.start("digits") - 1
            continue
        alone = ALONE.match(line[0]) if timed >= Timed.MOST else None
        behind = [] if alone is None else words_of(line[0][alone.end() :])
        ordered = timed is Timed.IN_ORDER and not _is_amount(behind[:1], lexicon)
        if alone is None or not (ordered or counts_nothing(behind, 0, lexicon)):
            continue
        # "11 - coffee", "12 lunch", "7 up"
        sure = alone["dash"] or alone["until"] or has_time(behind[0].text, lexicon)
        sure = sure or behind[0].text in lexicon.beside.states
        if timed >= Timed.LEAD or sure:
            yield line.start() + alone.start("hour") - 1


def _may_end(
    found: re.Match[str], before: Sequence[Word], behind: Sequence[Word], lexicon: Lexicon, timed: Timed
) -> bool:
    """Whether nothing is behind an hour, or beside minutes where or whose it is: "10-11.30 group A".

    Among lines of which most are timed, anything may be: "meeting 3.30 online"; behind an hour without
    minutes it says where, or with whom: "lunch 1 in the hall".
    """
    if found["ends"] is not None:
        return True
    typed = found["minutes"] or found["last"] or found["digits"]
    joint, *led = [word.text for word in words_of(found.string[found.end() :])[:PLACED]] or [""]
    # "Lunch 1 in the hall"; but "water plant 1 at 7"
    placed = joint in lexicon.closed.prepositions_of_times_taken
    placed = placed and not any(text.isdecimal() or text in lexicon.numbers for text in led)
    if found["digits"] and any(_is_counted(word, lexicon) for word in behind):
        # "Order 1200 bricks"
        return False
    if timed >= Timed.MOST:
        return bool(typed or found["until"]) or (placed and not _is_counted(before[-1], lexicon))
    beside = all(word.text in lexicon.function_words for word in behind)
    return bool(typed) and (found["until"] is not None or beside)


def _is_counted(word: Word, lexicon: Lexicon) -> bool:
    """Whether a word names several things that do not happen: "guests"."""
    others = lexicon.happening | lexicon.taken | lexicon.beside.states
    return looks_plural(word.text) and {word.text, singular(word.text)}.isdisjoint(others)


def _is_amount(behind: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a number counts what is behind it: "add 1.50 litres"."""
    measured = lexicon.no_times.measured_in
    return any(word.text in measured or lexicon.means(word.text, "unit") for word in behind)


def _is_other(found: re.Match[str], before: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a number is a price, a version, a year or shared: "milk 2.50", "9pm Alien 1979", "half 2"."""
    kinds = lexicon.no_times
    costs = not (kinds.costing | kinds.versioning).isdisjoint(word.text for word in before)
    # "Get mince 500g, onions 3, 2 tins of toms"
    got = before[0].text in lexicon.doing.getting and "," in {word.text for word in before}
    costs = costs or (got and found["minutes"] is None and _is_counted(before[-1], lexicon))
    year = found["digits"] in YEARS and any(word.is_digits for word in before)
    # "Half 2", "turn out all 3"
    led = lexicon.beside.parts_of_hours | lexicon.closed.universal_determiners
    return costs or year or before[-1].text in led


def _is_within_hour(found: re.Match[str]) -> bool:
    """Whether two numbers are from when to when within an hour: "4 - 4.30"."""
    first, last = re.findall(r"\d+", found[0])[:2]
    return bool(first == last)


def _numbers(found: re.Match[str]) -> bool:
    """Whether numbers alone say which, behind an hour in front: "9.30 ovens (deck 1)", "8.15 rows 2 & 3".

    So does one at the end of the only entry of a line: "9:30 group 1", but "9.30 vet, gym 6".
    """
    before = found.string[: found.start()]
    before = before[before.rfind("\n") + 1 :].lstrip()
    led = before[:1].isdigit()
    alone = not (found["minutes"] or found["digits"] or found["until"])
    several = found["more"] is not None and not any(mark in found["more"] for mark in ".:")
    only = found["ends"] is not None and not found["gap"] and ONLY.fullmatch(before) is not None
    return led and alone and (only or several or before.count("(") > before.count(")"))


def _takes(before: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether an entry begins with what takes so long."""
    return any(word.text in lexicon.timing | lexicon.timing_alone for word in _entry_of(before)[-1:])


def _has_state(before: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a word says in front of an hour where a thing is then: "oven on 10.15", "rolls in 4, out 4.35".

    No thing is called by the number behind such a word, or set to it; but "flip it in 8", "back in 8".
    """
    # "Joint in the oven 11"
    placed = [word.text in lexicon.closed.noun_openers for word in before[-2:-1]] == [True]
    before = before[:-2] if placed and len(before) > PLACED else before
    thing, state = before[-2:] if len(before) > 1 else (before[-1], before[-1])
    there = state.text in lexicon.beside.states - lexicon.closed.prepositions_of_points
    first = _entry_of(before)[-1:]
    ordered = any(word.text in lexicon.orders - lexicon.particles["in"] for word in first)
    from_now = state.text == "in" and (ordered or thing.text in lexicon.beside.states)
    named = thing.is_letters and thing.text not in lexicon.function_words
    return there and (named or thing.text in SEPARATORS) and not from_now


def _entry_of(before: Sequence[Word]) -> list[Word]:
    """Give the words of an entry in front of its hour, the last one first."""
    return [*takewhile(lambda word: word.text not in SEPARATORS, reversed(before))]


def _is_thing(word: Word, lexicon: Lexicon, *, sure: bool = False) -> bool:
    """Whether a word names something that may have an hour, and is no preposition, hedge or day of one.

    Where the hour is ``sure`` by its minutes, only what may have such a number has none: "stage 2.15".
    """
    kinds = lexicon.no_times
    numbered = kinds.numbered_in_two | kinds.set_to | lexicon.amount_nouns
    numbered |= frozenset() if sure else lexicon.measure_nouns
    known = has_time(word.text, lexicon)
    named = known or word.text not in numbered
    # "Mum arriving 6.40"
    joint = word.text in lexicon.function_words - lexicon.beside.dated
    # "Handover to nights 7.45"
    timed = lexicon.means(word.text, *BESIDE_HOURS) and word.text not in kinds.working
    return named and not joint and not timed


def _is_timed(before: Sequence[Word], lexicon: Lexicon, timed: Timed) -> bool:
    """Whether the last word names what has a time, and is not called by a number: "lunch", but "race 1".

    Among lines of which most are timed, so may be anything else: "wrap".
    """
    *others, word = before
    # "Bay B", but "Mrs B"
    lettered = len(word.text) == 1 and not (others and has_time(others[-1].text, lexicon))
    has_hour = has_time(word.text, lexicon) or (timed >= Timed.MOST and _is_thing(word, lexicon))
    has_hour = has_hour and word.text not in lexicon.beside.no_event
    return has_hour and word.is_letters and not lettered and not _is_called(word, lexicon)


def _is_called(word: Word, lexicon: Lexicon) -> bool:
    """Whether a number behind a word may be the name of a thing: "race 1"."""
    return not lexicon.called_by_number.isdisjoint({word.text, singular(word.text)})
