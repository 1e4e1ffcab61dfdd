"""Lists in which each entry ends in its hour, or begins with it: "vet 10, dentist 3", "10am vet; 12 lunch"."""

from collections.abc import Iterator, Sequence
from itertools import takewhile

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word

SEPARATORS = frozenset({",", ";", "\n"})
JOINTS = frozenset({":", "."})
"""Marks between hour and minute."""
HALF_DAY = 12
"""Hours that a number alone may name in a list."""
DAY = 24
"""Hours of a day, which one with minutes may name."""
MINUTES = 60
FOUR = 4
"""Digits of hour and minute together: "1830"."""
MINUTED = 3
"""Words of an hour with its minutes: "7:30"."""
SHORTEST = 2
"""Entries of a list at least, and words of an entry."""


def in_timetable(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> bool:
    """Whether words at the end of an entry are its hour, as every entry ends in a number.

    One at least must be surely an hour: by its minutes or half of the day, or as what is named is somebody, or
    happens. What is kneaded for ten, and eggs that are bought, have other numbers.
    """
    entries = list(_entries(words))
    ends = any(last == end and first < start for first, last in entries)
    return ends and len(entries) >= SHORTEST and _all_timed(words, entries, lexicon)


def leads_entry(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> bool:
    """Whether words in front of an entry are its hour, as every entry begins with a number: "12 lunch"."""
    if start and words[start - 1].text not in SEPARATORS:
        return False
    entries = list(_entries(words))
    leads = any(first == start and end < last for first, last in entries)
    return leads and len(entries) >= SHORTEST and _all_lead(words, entries, lexicon)


def _all_timed(words: Sequence[Word], entries: Sequence[tuple[int, int]], lexicon: Lexicon) -> bool:
    """Whether each entry ends in its hour."""
    numbers = [_number_at_end(words[first:last], lexicon) for first, last in entries]
    if any(length is None for length in numbers):
        return False
    named = [words[last - (length or 0) - 1].text for (_, last), length in zip(entries, numbers, strict=True)]
    minutes = any((length or 0) > 1 for length in numbers)
    lasting = {words[first].text for first, _ in entries} & (lexicon.timing | lexicon.timing_alone)
    return not lasting and (minutes or any(text in timed_words(lexicon) for text in named))


def _all_lead(words: Sequence[Word], entries: Sequence[tuple[int, int]], lexicon: Lexicon) -> bool:
    """Whether each entry begins with its hour: "10am vet; 12 lunch"; but "2 eggs; 3 onions"."""
    numbers = [_number_in_front(words[first:last], lexicon) for first, last in entries]
    if any(length is None for length in numbers):
        return False
    named = [words[first + (length or 0)].text for (first, _), length in zip(entries, numbers, strict=True)]
    surely = any((length or 0) > 1 for length in numbers) or any(text in timed_words(lexicon) for text in named)
    surely = surely or all(words[first].text.startswith("0") for first, _ in entries[:1])
    counted = any(
        length == 1 and text.endswith("s") and text not in timed_words(lexicon)
        for length, text in zip(numbers, named, strict=True)
    )
    return surely and not counted


def counts_nothing(words: Sequence[Word], place: int, lexicon: Lexicon, *, plural: bool = False) -> bool:
    """Whether a word is a thing, or is done, and is not counted by the number before it.

    What more than one counts is a ``plural``, which may stand behind what is surely an hour.
    """
    if place >= len(words) or not words[place].is_letters:
        return False
    text = words[place].text
    several = text.endswith("s") and not text.endswith("ss") and text not in timed_words(lexicon)
    units = any(found.category == "unit" for found in lexicon.entries.get(text, ()))
    inside = text in lexicon.function_words | lexicon.measure_nouns or len(text) == 1
    return not ((several and not plural) or units or inside)


def timed_words(lexicon: Lexicon) -> frozenset[str]:
    """Give what has a time, or somebody that is met."""
    return lexicon.persons | lexicon.animals | lexicon.events | lexicon.happening | lexicon.taken


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
    half = len(entry) > 1 and entry[-1].text in lexicon.beside.of_hours
    before = entry[: len(entry) - half]
    digits = [*takewhile(lambda word: word.is_digits or word.text in JOINTS, reversed(before))]
    if not digits:
        spelt = lexicon.numbers.get(entry[-1].text)
        return 1 if spelt is not None and 0 < spelt <= HALF_DAY and len(entry) >= SHORTEST else None
    length = len(digits)
    named = len(before) > length and before[-length - 1].is_letters
    return length + half if _is_hour(digits[::-1], half=half) and named else None


def _number_in_front(entry: Sequence[Word], lexicon: Lexicon) -> int | None:
    """Give how many words the number is that an entry begins with; None where it is no hour, or counts."""
    led = entry[0].text == "@"
    digits = [*takewhile(lambda word: word.is_digits or word.text in JOINTS, entry[led:])]
    length = led + len(digits)
    half = any(word.text in lexicon.beside.of_hours for word in entry[length : length + 1])
    named = next(iter(entry[length + half :]), None)
    if not digits or named is None or not named.is_letters or named.text in lexicon.function_words:
        return None
    counts = any(found.category == "unit" for found in lexicon.entries.get(named.text, ()))
    return length + half if not counts and _is_hour(digits, half=half) else None


def _is_hour(digits: Sequence[Word], *, half: bool) -> bool:
    """Whether digits, with minutes or without, are an hour that a number alone may name."""
    hour = digits[0].text
    if len(digits) == 1 and len(hour) == FOUR:
        return int(hour[:2]) < DAY and int(hour[2:]) < MINUTES and not half
    hours = HALF_DAY if len(digits) == 1 or half else DAY
    return len(digits) in {1, MINUTED} and hour.isdecimal() and 0 < int(hour) <= hours
