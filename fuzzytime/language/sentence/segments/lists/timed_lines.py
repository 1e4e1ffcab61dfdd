"""Whether lines are together a list of times: two are surely timed, or three have numbers like hours."""

import re
from collections.abc import Iterable, Sequence
from functools import cache
from itertools import pairwise

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.timetables import MINUTES, has_time
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.sentence.segments.lists.dividers import LINE
from fuzzytime.language.sentence.segments.lists.hours_of_lines import Timed
from fuzzytime.language.sentence.segments.lists.typed_hours import (
    ALONE,
    DECIMAL,
    LEADING,
    THREE,
    hours_behind,
)

SURELY = 2
"""Lines with a time that is surely one, beside which others are a list of times."""

TYPED = 3
"""Lines with a number that may be an hour and its minutes that are a list of times by themselves."""

MOST = 3
"""Lines with a time, at least, and the part of all lines that makes most of them timed: a third."""

IN_A_ROW = 4
"""Numbers in front of lines, at least, that are hours as they go up through a day."""

FEWEST = 5
"""Of so many lines, one at least has such a time where others end in numbers that may be hours."""

FIVES = 5
"""Minutes by which people plan; prices have others, but so have trains and sunsets, one of four at most."""

CALENDAR = ("weekday", "day", "part", "meal", "month")
"""What a word means in a title that says when: "Monday morning:"."""

HALF_DAY = 12
"""Hours that numbers spelled out may be: "at half eight"."""

LONG_LIST = 8
WAKING = 18
"""Hours of a day that so many lines may go through."""

HUNDRED = 100
"""Behind it, the hours of a number that is typed without a mark: 430."""

FEW_ODD = 4
"""Of so many numbers with two digits behind their points, one may have others."""


@cache
def _sure(
    prepositions: frozenset[str], halves: frozenset[str], parts: frozenset[str], hours: frozenset[str]
) -> re.Pattern[str]:
    """Give what finds a time that is surely one by how it is typed, or by what stands in front of it."""
    half = "|".join(map(re.escape, sorted(halves, key=len, reverse=True)))
    part = rf"(?:{'|'.join(sorted(parts))})\s(?:[a-z]+\s)?"
    before = rf"(?:{'|'.join(sorted(prepositions))})\s"
    return re.compile(
        rf"""
        (?<![\d.:]) \d{{1,2}} (?: : [0-5]\d (?![\d:]) | (?:\.[0-5]\d)?\s?(?:{half})(?!\w) )
        | (?<=\w\s) 0\d[0-5]\d (?!\w)
        | (?<![\d.:]) \d{{1,2}} \s (?:'?till?|until) \s \d{{1,2}} (?![\d.:]\S|[/%])
        | \b (?: {before} (?:{part})? | {part} )
          (?: (?:[01]?\d|2[0-3])(?:\.[0-5]\d)? | {"|".join(sorted(hours))} ) (?= \s* (?:[,;.)]|$) )
        """,
        re.VERBOSE | re.IGNORECASE,
    )


def _with_digits(
    fronts: Sequence[re.Match[str] | None], behind: Sequence[Sequence[re.Match[str]]]
) -> list[bool]:
    """Give which lines have four digits that are hours: "1830 doors", "1900 supper", "2015 raffle".

    They are where one begins with a zero, or most lines begin with them.
    """
    digits = [
        [found["digits"] for found in (*hours, front) if found and found["digits"]]
        for front, hours in zip(fronts, behind, strict=True)
    ]
    led = sum(front is not None and front["digits"] is not None for front in fronts)
    zero = any(number.startswith("0") for numbers in digits for number in numbers)
    timed = zero or (led >= MOST and 2 * led >= len(fronts))
    return [timed and bool(numbers) for numbers in digits]


def timed_lines(texts: Sequence[str], lexicon: Lexicon) -> list[Timed]:
    """Give how far each text is one of a list of times; nothing below a title is where no line says when.

    "Saturday:", "swim 9.30", "lunch 1", then "Shopping:", "onions 3", "milk".
    """
    whole = how_timed(texts, lexicon)
    titles = [place for place, text in enumerate(texts) if _is_title(text, lexicon)]
    found, halves = [whole] * len(texts), hours_behind(lexicon.beside.of_hours)
    for first, end in pairwise((*titles, len(texts))):
        below = [line[0] for text in texts[first + 1 : end] for line in LINE.finditer(text)]
        if not any(
            _surely(line, lexicon) or _is_typed(LEADING.match(line), halves.finditer(line)) for line in below
        ):
            found[first:end] = [Timed.NO] * (end - first)
    return found


def _is_title(text: str, lexicon: Lexicon) -> bool:
    """Whether a line with a colon names what is below it, and no day or part of one: "Shopping:"."""
    words = words_of(text.strip(" *_-"))
    timed = any(word.is_digits or lexicon.means(word.text, *CALENDAR) for word in words)
    return bool(words) and words[-1].text == ":" and not timed


def _surely(line: str, lexicon: Lexicon) -> re.Match[str] | None:
    """Give the first time of a line that is surely one."""
    prepositions = lexicon.closed.prepositions_of_points | lexicon.closed.prepositions_of_time
    parts = lexicon.beside.parts_of_hours - lexicon.closed.noun_openers
    hours = frozenset(word for word, number in lexicon.numbers.items() if 0 < number <= HALF_DAY)
    return _sure(prepositions, lexicon.beside.of_hours, parts, hours).search(line)


def _is_typed(front: re.Match[str] | None, behind: Iterable[re.Match[str]]) -> bool:
    """Whether a number of a line is typed like an hour and its minutes, or two from when to when."""
    return front is not None or any(found["minutes"] or found["digits"] or found["last"] for found in behind)


def how_timed(texts: Sequence[str], lexicon: Lexicon) -> Timed:
    """Give whether lines are a list of times, as two are surely timed, or three have numbers like hours."""
    lines = [line[0] for text in texts for line in LINE.finditer(text)]
    halves = hours_behind(lexicon.beside.of_hours)
    behind, fronts = [[*halves.finditer(line)] for line in lines], [LEADING.match(line) for line in lines]
    firsts = [_surely(line.strip(), lexicon) for line in lines]
    leads = sum((front or THREE.match(line)) is not None for front, line in zip(fronts, lines, strict=True))
    if leads >= SURELY and _go_up(lines):
        return Timed.IN_ORDER
    decimals = [int(found[1]) for line in lines for found in DECIMAL.finditer(line)]
    typed = [_is_typed(*found) for found in zip(fronts, behind, strict=True)]
    happens = sum(
        found["minutes"] is not None and has_time(words_of(line[: found.start()])[-1].text, lexicon)
        for line, hours in zip(lines, behind, strict=True)
        for found in hours
    )
    digits = _with_digits(fronts, behind)
    sure = [one is not None or counted for one, counted in zip(firsts, digits, strict=True)]
    odd = sum(digits >= MINUTES or digits % FIVES != 0 for digits in decimals)
    # "Bus 8.02": what happens has any minutes, but no price.
    happen = happens >= TYPED and max(decimals, default=0) < MINUTES
    planned = len(decimals) >= TYPED and (len(decimals) >= FEW_ODD * odd or happen)
    if sum(sure) < SURELY and not (planned and sum(typed) >= TYPED):
        return Timed.NO
    surest = [one or other for one, other in zip(sure, typed, strict=True)]
    timed = sum(surest)
    perhaps = (
        ALONE.match(line) or any(found["ends"] is not None for found in hours)
        for line, hours in zip(lines, behind, strict=True)
    )
    most = sum(one or bool(other) for one, other in zip(surest, perhaps, strict=True))
    if timed < MOST or FEWEST * timed < len(lines) or MOST * most < len(lines):
        return Timed.SOME
    leading = sum(
        (one is not None and not one.start()) or front is not None
        for one, front in zip(firsts, fronts, strict=True)
    )
    return Timed.LEAD if leading >= MOST and MOST * leading >= timed else Timed.MOST


def _go_up(lines: Sequence[str]) -> bool:
    """Whether the numbers in front of lines go up through one day: 7, 7.30, 8, 10, 12, 2.30; or 430, 500, 12.

    One alone may count: "9.15 open", "10.30 tea", "12 eggs", "4.30 lock".
    """
    found = [LEADING.match(line) or THREE.match(line) or ALONE.match(line) for line in lines]
    alone = sum((ALONE.match(line) or THREE.match(line)) is not None for line in lines)
    numbers = [int(re.findall(r"\d+", one[0])[0]) for one in found if one is not None]
    hours = [(number if number < HUNDRED else number // HUNDRED) % HALF_DAY for number in numbers]
    steps = [(second - first) % HALF_DAY for first, second in pairwise(hours)]
    return (
        alone >= MOST
        and len(hours) >= IN_A_ROW
        and MOST * len(hours) >= len(lines)
        and sum(steps) <= (HALF_DAY if len(hours) < LONG_LIST else WAKING)
    )
