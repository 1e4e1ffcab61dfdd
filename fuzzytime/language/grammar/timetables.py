"""Lists in which each entry ends in its hour: "vet 10, dentist 3", "feed cat 6; walk dog 7.30"."""

from collections.abc import Iterator, Sequence
from itertools import takewhile

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word

SEPARATORS = frozenset({",", ";", "\n"})
JOINTS = frozenset({":", "."})
"""Marks between hour and minute."""
HALF_DAY = 12
"""Hours that a number alone may name in a list."""
SHORTEST = 2
"""Entries of a list at least, and words of an entry."""


def in_timetable(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> bool:
    """Whether words at the end of an entry are its hour, as every entry ends in a number.

    One at least must be surely an hour: by its minutes, or as what is named is somebody, or happens. What is
    kneaded for ten, and eggs that are bought, have other numbers.
    """
    entries = list(_entries(words))
    ends = any(last == end and first < start for first, last in entries)
    if len(entries) < SHORTEST or not ends:
        return False
    numbers = [_number_at_end(words[first:last], lexicon) for first, last in entries]
    if any(length is None for length in numbers):
        return False
    named = [words[last - (length or 0) - 1].text for (_, last), length in zip(entries, numbers, strict=True)]
    timed = lexicon.persons | lexicon.animals | lexicon.events | lexicon.happening | lexicon.taken
    minutes = any((length or 0) > 1 for length in numbers)
    lasting = {words[first].text for first, _ in entries} & (lexicon.timing | lexicon.timing_alone)
    return not lasting and (minutes or any(text in timed for text in named))


def _entries(words: Sequence[Word]) -> Iterator[tuple[int, int]]:
    """Give where each entry begins, and one past where it ends, without the full stop."""
    first = 0
    for place in range(len(words) + 1):
        if place < len(words) and words[place].text not in SEPARATORS:
            continue
        last = place - (place > first and words[place - 1].text == ".")
        if last > first:
            yield first, last
        first = place + 1


def _number_at_end(entry: Sequence[Word], lexicon: Lexicon) -> int | None:
    """Give how many words the number is that an entry ends in; None where it is no hour, or all is number."""
    digits = [*takewhile(lambda word: word.is_digits or word.text in JOINTS, reversed(entry))]
    if not digits:
        spelt = lexicon.numbers.get(entry[-1].text)
        return 1 if spelt is not None and 0 < spelt <= HALF_DAY and len(entry) >= SHORTEST else None
    hour = digits[-1].text
    whole = len(digits) in {1, 3} and hour.isdecimal() and 0 < int(hour) <= HALF_DAY
    return len(digits) if whole and len(entry) > len(digits) and entry[-len(digits) - 1].is_letters else None
