"""Lists in which each entry ends, or begins, with its hour: "vet 10, dentist 3", "10am vet; 12 lunch"."""

from collections.abc import Iterator, Sequence
from itertools import takewhile

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word

SEPARATORS = frozenset({",", ";", "\n"})
JOINTS = frozenset({":", "."})
"""Marks between hour and minute."""
STRETCHES = JOINTS | {"-"}
"""Marks in two numbers from when to when."""
HALF_DAY = 12
"""Hours that a number alone may name in a list."""
DAY = 24
"""Hours of a day, which one with minutes may name."""
MINUTES = 60
FOUR = 4
"""Digits of hour and minute together: "1830"."""
LONGEST_DAY = 2
"""Words of a day in front of a list at most: "fri:"."""
MINUTED = 3
"""Words of an hour with its minutes: "7:30"."""
SURELY = 2
"""Entries with minutes or a half of the day beside which a number alone is an hour of what lasts, too."""
SHORTEST = 2
"""Entries of a list at least, and words of an entry."""


def in_timetable(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> bool:
    """Whether words at the end of an entry are its hour, as every entry ends in a number.

    One at least must be surely an hour: by its minutes or half of the day, or as what is named is somebody,
    or happens. What is kneaded for ten, and eggs that are bought, have other numbers.
    """
    entries = list(_entries(words))
    ends = any(last == end and first < start for first, last in entries)
    return ends and len(entries) >= SHORTEST and _all_timed(words, entries, lexicon)


def leads_entry(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> bool:
    """Whether words in front of an entry are its hour, as every entry begins with a number: "12 lunch"."""
    if start and words[start - 1].text not in SEPARATORS and start > LONGEST_DAY:
        return False
    entries = [(_behind_day(words, first, last, lexicon), last) for first, last in _entries(words)]
    if any(first >= last for first, last in entries):
        return False
    leads = any(first == start and end < last for first, last in entries)
    return leads and len(entries) >= SHORTEST and _all_lead(words, entries, lexicon)


def holds_stretch(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> bool:
    """Whether two numbers are from when to when an entry is: "lecture 10-12", "9-10 gym, 10-11 mails".

    It, or another entry with such numbers, names what has a time.
    """
    entries = [(_behind_day(words, first, last, lexicon), last) for first, last in _entries(words)]
    if not any((first == start) != (last == end) for first, last in entries):
        return False
    named = [
        word.text
        for first, last in entries
        for word in (_beside_stretch(words[first:last]),)
        if word is not None and word.is_letters
    ]
    beside = words[start - 1] if any(last == end for _, last in entries) else words[end]
    sure = not timed_words(lexicon).isdisjoint(named)
    return sure and (beside.text in timed_words(lexicon) or len(named) > 1) and beside.is_letters


def _beside_stretch(entry: Sequence[Word]) -> Word | None:
    """Give the word beside two numbers in front of an entry, or at its end."""
    for words in (entry, entry[::-1]):
        length = sum(1 for _ in takewhile(lambda word: word.is_digits or word.text in STRETCHES, words))
        if 0 < length < len(words):
            return words[length]
    return None


def _behind_day(words: Sequence[Word], first: int, last: int, lexicon: Lexicon) -> int:
    """Give where an entry begins behind its day: "fri | 9 dentist"."""
    day = first < last and any(
        entry.category in {"weekday", "day"} and len(entry.words) == 1
        for entry in lexicon.entries.get(words[first].text, ())
    )
    place = first + day
    while day and place < last and words[place].text in {":", "-"}:
        place += 1
    return place


def _all_timed(words: Sequence[Word], entries: Sequence[tuple[int, int]], lexicon: Lexicon) -> bool:
    """Whether each entry ends in its hour."""
    numbers = [_number_at_end(words[first:last], lexicon) for first, last in entries]
    if any(length is None for length in numbers):
        return False
    named = [words[last - (length or 0) - 1].text for (_, last), length in zip(entries, numbers, strict=True)]
    minutes = any((length or 0) > 1 for length in numbers)
    minutes = minutes or any(words[last - 1].text.startswith("0") for _, last in entries)
    goes_on = lexicon.timing | lexicon.timing_alone
    # "Dough out 6am, shape 6:30, bake 7"; but "shape it 6:30, bake 40"
    sure = sum((length or 0) > 1 for length in numbers)
    lasting = any(
        words[first].text in goes_on and length == 1
        for (first, _), length in zip(entries, numbers, strict=True)
    )
    return (not lasting or sure >= SURELY) and (
        minutes or any(text in timed_words(lexicon) for text in named)
    )


def _all_lead(words: Sequence[Word], entries: Sequence[tuple[int, int]], lexicon: Lexicon) -> bool:
    """Whether each entry begins with its hour: "10am vet; 12 lunch"; but "2 eggs; 3 onions"."""
    numbers = [_number_in_front(words[first:last], lexicon) for first, last in entries]
    if any(length is None for length in numbers):
        return False
    named = [words[first + (length or 0)].text for (first, _), length in zip(entries, numbers, strict=True)]
    surely = any((length or 0) > 1 for length in numbers) or any(
        text in timed_words(lexicon) for text in named
    )
    surely = surely or all(words[first].text.startswith("0") for first, _ in entries[:1])
    counted = any(
        length == 1 and text.endswith("s") and text not in timed_words(lexicon)
        for length, text in zip(numbers, named, strict=True)
    )
    return surely and not counted


def is_hour_of(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> bool:
    """Whether a number alone stands before one thing that has a time: "12 lunch"; but "5 train tickets"."""
    number, behind = words[start].text, [word.text for word in words[end : end + 2]]
    if end - start != 1 or not number.isdecimal() or not 1 < int(number) <= HALF_DAY or not behind:
        return False
    several = behind[0].endswith("s") and not behind[0].endswith("ss")
    ends = behind[1:] == [] or behind[1] in SEPARATORS or behind[1] in lexicon.function_words
    return ends and not several and behind[0] in lexicon.happening | lexicon.taken


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
