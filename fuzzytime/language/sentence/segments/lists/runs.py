"""Entries that follow each other without a mark, told apart by their times: "8:00 up 8:15 mails 9:00 tea".

Three at least, of which each begins with its time. One that begins with the number of what hardly has another
is an entry too: "10am vet 12 lunch 3pm pick up car". Those that end in their times are ``unmarked``.
"""

import re
from collections.abc import Iterator, Sequence
from functools import cache

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.timetables import HALF_DAY
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Span
from fuzzytime.language.sentence.segments.lists.dividers import LINE, STOP

SHORTEST, LEAST = 3, 2
"""Entries at least, and where each time has its "@"."""

LONGEST_WORD = 40
"""Characters behind a number that are looked at."""


@cache
def _numbers(halves: frozenset[str]) -> re.Pattern[str]:
    """Give what finds clock times in such a list: surely so ("7:30", "@7", "7 am"), or a number alone."""
    half = rf"(?:\s?(?:{'|'.join(map(re.escape, sorted(halves, key=len, reverse=True)))}))"
    return re.compile(
        rf"""
        (?: (?<![^\s(]) | (?=@) )
        (?: (?P<sure> @\s?\d{{1,2}}(?:[:.]\d\d)?{half}? | \d{{1,2}}:\d\d{half}?
                    | \d{{1,2}}(?:\.\d\d)?{half} | [012]\d[0-5]\d )
            (?:\s?[-–]\s?\d{{1,2}}(?::\d\d)?{half}?)?
          | (?P<bare> \d{{1,2}}) )
        (?=[\s),;.]|$)
        """,
        re.VERBOSE | re.IGNORECASE,
    )


def run_apart(text: str, lexicon: Lexicon) -> str:
    """Give a text of the same length with a mark between such entries."""
    for line in LINE.finditer(text):
        for place in _pauses(text, line.span(), lexicon):
            text = text[:place] + STOP + text[place + 1 :]
    return text


def _pauses(text: str, line: Span, lexicon: Lexicon) -> Iterator[int]:
    """Give where one entry of a line ends."""
    tokens = list(_numbers(lexicon.beside.of_hours).finditer(text, *line))
    if len(tokens) < (LEAST if all(found[0].startswith("@") for found in tokens) else SHORTEST):
        return
    if text[line[0] : tokens[0].start()].strip(" -*"):
        return
    tokens = [found for found in tokens if found["sure"] or _is_hour(text, found, lexicon)]
    if len(tokens) < LEAST or tokens[0]["sure"] is None:
        return
    things = _behind(text, line, [found.span() for found in tokens])
    if not all(_names(thing, lexicon) for thing in things):
        return
    for found in tokens[1:]:
        if text[found.start() - 1].isspace():
            yield found.start() - 1


def _behind(text: str, line: Span, times: Sequence[Span]) -> list[str]:
    """Give what stands behind each time of a line."""
    ends = (*(first for first, _ in times[1:]), line[1])
    return [text[time[1] : end] for time, end in zip(times, ends, strict=True)]


def _names(thing: str, lexicon: Lexicon) -> bool:
    """Whether words name something, right beside the time that they are said of."""
    words = words_of(thing)
    if not words or not words[0].is_letters:
        return False
    own = words[0].text not in lexicon.function_words
    # As in "walk the dog and | 8:00".
    open_ended = words[-1].text in lexicon.function_words - lexicon.places
    return own and not open_ended and not lexicon.means(words[0].text, "unit", "preposition_before")


def _is_hour(text: str, found: re.Match[str], lexicon: Lexicon) -> bool:
    """Whether a number alone is when something is that has a time: "12 lunch"."""
    behind = words_of(text[found.end() : found.end() + LONGEST_WORD])
    timed = lexicon.happening | lexicon.taken | lexicon.events
    return 0 < int(found["bare"]) <= HALF_DAY and bool(behind) and behind[0].text in timed


@cache
def _switched(states: frozenset[str], binding: frozenset[str], halves: frozenset[str]) -> re.Pattern[str]:
    """Give what finds the pause between two states of a thing, each with its time."""
    state, bound, half = (
        "|".join(map(re.escape, sorted(words, key=len, reverse=True))) for words in (states, binding, halves)
    )
    when = rf"(?:(?:{bound})\s+|@\s?)?\d{{1,2}}(?:[:.]\d\d)?(?:\s?(?:{half}))?"
    return re.compile(
        rf"(?<=\w\s)({state})\s+{when}(\s)(?!\1)(?:{state})\s+{when}(?=\s*(?:[,.]|$))", re.IGNORECASE
    )


def switched_apart(text: str, lexicon: Lexicon) -> str:
    """Give a text of the same length with a mark between such times."""
    beside = lexicon.beside
    pattern = _switched(beside.switched, lexicon.closed.prepositions_of_points, beside.of_hours)
    for line in LINE.finditer(text):
        found = pattern.search(text, *line.span())
        if found is not None:
            text = text[: found.start(2)] + STOP + text[found.end(2) :]
    return text
