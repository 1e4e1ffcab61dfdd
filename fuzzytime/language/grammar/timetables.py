"""Lists in which each entry ends, or begins, with its hour: "vet 10, dentist 3", "10am vet; 12 lunch"."""

from collections.abc import Iterator, Sequence
from itertools import pairwise, takewhile

from fuzzytime.english import looks_plural
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word

SEPARATORS = frozenset({",", ";", "\n"})
"""Marks between entries."""
NEXT = "then"
"""Word between entries, alone or behind a mark."""
JOINTS = frozenset({":", "."})
"""Marks between hour and minute."""
STRETCHES = JOINTS | {"-", "=", ">", "→", "⇒"}
"""Marks that may stand in two numbers from when to when."""
HALF_DAY = 12
"""Hours that a number alone may name in a list."""
QUARTERS = frozenset({"00", "15", "30", "45"})
"""Minutes that hardly a price has."""
DAY = 24
"""Hours of a day, which one with minutes may name."""
MINUTES = 60
"""Minutes of an hour."""
TOGETHER = 4
"""Digits of hour and minute together: "1830"."""
LONGEST_DAY = 2
"""Words of a day in front of a list at most: "fri:"."""
COUNTED = 3
"""Words of a number and of what it counts: "8 dinner plates"."""
SHORT_HOUR = 2
"""Digits of an hour without minutes at most."""
MINUTED = 3
"""Words of an hour with its minutes: "7:30"."""
LONGEST_STREET = 3
"""Words of the name of a street at most."""
CALLED = 3
"""Words of an entry that says who is called when: "call ann 9"."""
LONE = 1
"""Words of a number that is not from when to when."""
PAIR = 2
"""Numbers that are from when to when."""
SHORTEST = 2
"""Entries of a list at least, and words of an entry."""


def timetable_of(words: Sequence[Word], lexicon: Lexicon) -> dict[int, int]:
    """Give where each entry of a list begins, by where it ends, as every entry ends in its hour; else none.

    One at least must be surely an hour: by its minutes or half of the day, or as what is named is somebody,
    or happens. What is kneaded for ten, and eggs that are bought, have other numbers.
    """
    entries = list(_entries(words))
    begins = {last: first for first, last in entries}
    numbered = [span for span in entries if _number_at_end(words[slice(*span)], lexicon)]
    if len(numbered) >= SHORTEST and all(_is_plain(words[slice(*e)]) for e in entries if e not in numbered):
        # "Bank 10, dentist 3, pick up cake"
        entries = numbered
    return begins if len(entries) >= SHORTEST and _all_timed(words, entries, lexicon) else {}


def _is_plain(entry: Sequence[Word]) -> bool:
    """Whether an entry says only what there is to do, in words."""
    return len(entry) >= SHORTEST and all(word.is_letters for word in entry)


def leads_entry(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> bool:
    """Whether words in front of an entry are its hour, as every entry begins with a number: "12 lunch".

    Numbers in brackets are how many: "8am pills (2 white, 1 pink)".
    """
    before = [word.text for word in words[:start]]
    if before.count("(") > before.count(")"):
        return False
    if start and words[start - 1].text not in SEPARATORS and start > LONGEST_DAY:
        return False
    entries = [(_behind_day(words, first, last, lexicon), last) for first, last in _entries(words)]
    if any(first >= last for first, last in entries):
        return False
    leads = any(first == start and end < last for first, last in entries)
    return leads and len(entries) >= SHORTEST and _all_lead(words, entries, lexicon)


def holds_stretch(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> bool:
    """Whether two numbers are from when to when an entry is: "lecture 10-12", "gym six to seven", "9-10 gym".

    It, or another entry with such numbers, names what has a time; or they are all that is said: "12-2".
    """
    if (start, end) == (0, len(words)):
        numbers = [word.text for word in words if word.is_digits]
        hours = [int(text) for text in numbers if text[0] != "0" and int(text) <= DAY]
        # "12-2", "14-16"; but "9-14"
        alike = len({hour <= HALF_DAY for hour in hours}) == 1
        return len(hours) == len(numbers) == PAIR and alike
    entries = [(_behind_day(words, first, last, lexicon), last) for first, last in _entries(words)]
    if not any((first == start and end < last) or (first < start and end == last) for first, last in entries):
        return False
    found = (_beside_stretch(words[first:last], lexicon) for first, last in entries)
    named = [word.text for word in found if word is not None and word.is_letters]
    beside = words[start - 1] if any(last == end for _, last in entries) else words[end]
    numbers = [word.text for word in words[start:end] if word.is_digits]
    if numbers[:1] == [str(DAY)] or beside.text in lexicon.beside.plurals:
        # "24-7 service", "10-12 people"
        return False
    if beside.text in lexicon.addressing and any(len(number) > SHORT_HOUR for number in numbers):
        # "Call 555-1234"
        return False
    sure = any(has_time(text, lexicon) for text in named)
    return sure and (has_time(beside.text, lexicon) or len(named) > 1) and beside.is_letters


def _beside_stretch(entry: Sequence[Word], lexicon: Lexicon) -> Word | None:
    """Give the word beside two numbers in front of an entry, or at its end."""
    inside = STRETCHES | lexicon.beside.until_hours | lexicon.numbers.keys()
    for words in (entry, entry[::-1]):
        numbers = list(takewhile(lambda word: word.is_digits or word.text in inside, words))
        # "Thu 12th: plumber 8-10" begins with no stretch.
        if LONE < len(numbers) < len(words):
            return words[len(numbers)]
    return None


def _behind_day(words: Sequence[Word], first: int, last: int, lexicon: Lexicon) -> int:
    """Give where an entry begins behind its day: "fri | 9 dentist"."""
    day = first < last and lexicon.means(words[first].text, "weekday", "day")
    place = first + day
    while day and place < last and words[place].text in {":", "-"}:
        place += 1
    return place


def _all_timed(words: Sequence[Word], entries: Sequence[tuple[int, int]], lexicon: Lexicon) -> bool:
    """Whether each entry ends in its hour."""
    lengths = [_number_at_end(words[first:last], lexicon) for first, last in entries]
    if not all(lengths):
        return False
    named = [words[last - length - 1].text for (_, last), length in zip(entries, lengths, strict=True)]
    said = [
        (words[last - length : last], name)
        for (_, last), length, name in zip(entries, lengths, named, strict=True)
    ]
    if _are_prices(said, lexicon):
        return False
    exact = sum(length > 1 for length in lengths)
    led = any(words[last - 1].text.startswith("0") for _, last in entries)
    # "Call ann 9, feed the cat at 10"
    called = any(
        words[first].text in lexicon.addressing and last - first == CALLED for first, last in entries
    )
    # "Lights on 6; off 8"
    switched = len(set(named)) > 1 and lexicon.beside.switched.issuperset(named)
    timed = exact > 0 or led or called or switched or any(has_time(text, lexicon) for text in named)
    return timed or _are_chores([words[first:last] for first, last in entries], lexicon)


def _are_chores(entries: Sequence[Sequence[Word]], lexicon: Lexicon) -> bool:
    """Whether one chore after another has its hour: "clean bathroom ten, kitchen eleven".

    Nothing is only called by its number, and the hours go up from the first on in the morning.
    """
    named = [entry[-2].text for entry in entries]
    numbers = [entry[-1] for entry in entries]
    hours = [lexicon.numbers.get(word.text, int(word.text) if word.is_digits else 0) for word in numbers]
    first = lexicon.policy.plausible_from.hour
    since = [(hour - first) % HALF_DAY for hour in hours]
    ordered = entries[0][0].text in lexicon.chores and len(entries[0]) > SHORTEST
    # "Water beds 3, pots 4"
    ordered = ordered and not all(map(looks_plural, named))
    called = lexicon.called_by_number.issuperset(named) or len(set(named)) < len(named)
    return ordered and not called and all(a < b for a, b in pairwise(since))


def _are_prices(said: Sequence[tuple[Sequence[Word], str]], lexicon: Lexicon) -> bool:
    """Whether numbers with a point are what things cost: "tea 2.50, coffee 3.20".

    So they are where each has a point, some are no quarters of an hour, and nothing is named that has a time.
    """
    minutes = [number[-1].text for number, _ in said if [word.text for word in number[1:2]] == ["."]]
    if len(minutes) < len(said) or all(text in QUARTERS for text in minutes):
        return False
    return not any(has_time(name, lexicon) for _, name in said)


def _all_lead(words: Sequence[Word], entries: Sequence[tuple[int, int]], lexicon: Lexicon) -> bool:
    """Whether each entry begins with its hour: "10am vet; 12 lunch"; but "2 eggs; 3 onions"."""
    lengths = [_number_in_front(words[first:last], lexicon) for first, last in entries]
    if not all(lengths):
        return False
    named = [words[first + length].text for (first, _), length in zip(entries, lengths, strict=True)]
    counted = (text for text, length in zip(named, lengths, strict=True) if length == 1)
    if any(_are_several(text, lexicon) for text in counted):
        return False
    if any(_counts_things(words[slice(*one)], lexicon) for one in entries):
        return False
    exact = any(length > 1 for length in lengths) or words[entries[0][0]].text.startswith("0")
    return exact or any(has_time(text, lexicon) for text in named)


def _are_several(text: str, lexicon: Lexicon) -> bool:
    """Whether a word is a plural of what has no time: "chairs", "people"; not "drinks"."""
    return text in lexicon.beside.plurals or (looks_plural(text) and not has_time(text, lexicon))


def _counts_things(entry: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether an entry is a number and what it counts, called after what happens: "8 dinner plates"."""
    if len(entry) != COUNTED or not entry[0].is_digits:
        return False
    happens, several = entry[1].text, entry[2].text
    plural = looks_plural(several) and not has_time(several, lexicon)
    return plural and (happens in lexicon.happening or happens in lexicon.taken)


def is_hour_of(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> bool:
    """Whether a number alone stands before one thing that has a time: "12 lunch"; but "5 train tickets"."""
    number, behind = words[start].text, [word.text for word in words[end : end + 2]]
    if end - start != 1 or not number.isdecimal() or not 1 < int(number) <= HALF_DAY or not behind:
        return False
    thing, *after = behind
    ends = not after or after[0] in SEPARATORS | {"("} or after[0] in lexicon.function_words
    return ends and not looks_plural(thing) and thing in lexicon.happening | lexicon.taken


def counts_nothing(words: Sequence[Word], place: int, lexicon: Lexicon, *, plural: bool = False) -> bool:
    """Whether a word is a thing, or is done, and is not counted by the number before it.

    What more than one counts is a ``plural``, which may stand behind what is surely an hour.
    """
    if place >= len(words) or not words[place].is_letters:
        return False
    text = words[place].text
    if any(word.text in lexicon.no_times.streets for word in words[place + 1 : place + LONGEST_STREET]):
        # "1215 Pine Street"
        return False
    several = looks_plural(text) and not has_time(text, lexicon)
    measured = text in lexicon.measure_nouns or text in lexicon.no_times.measured_in
    inside = text in lexicon.function_words or measured or len(text) == 1
    return not ((several and not plural) or inside or lexicon.means(text, "unit"))


def has_time(text: str, lexicon: Lexicon) -> bool:
    """Whether a word names what has a time, or somebody that is met."""
    somebody = (lexicon.persons, lexicon.animals)
    known = (*somebody, lexicon.events, lexicon.happening, lexicon.taken, lexicon.frames)
    return any(text in words for words in known)


def _entries(words: Sequence[Word]) -> Iterator[tuple[int, int]]:
    """Give where each entry begins, and one past where it ends, without the full stop."""
    first = 0
    for place in range(len(words) + 1):
        if place < len(words) and words[place].text not in {*SEPARATORS, NEXT}:
            continue
        last = place - (place > first and words[place - 1].text == ".")
        if last > first:
            yield first, last
        first = place + 1


def _number_at_end(entry: Sequence[Word], lexicon: Lexicon) -> int:
    """Give how many words the number is that an entry ends in; 0 where it is no hour, or all is number."""
    half = len(entry) > 1 and entry[-1].text in lexicon.beside.of_hours
    before = entry[: len(entry) - half]
    digits = [*takewhile(lambda word: word.is_digits or word.text in JOINTS, reversed(before))]
    if not digits:
        spelt = lexicon.numbers.get(entry[-1].text)
        return int(spelt is not None and 0 < spelt <= HALF_DAY and len(entry) >= SHORTEST)
    length = len(digits)
    named = len(before) > length and before[-length - 1].is_letters
    return length + half if _is_hour(digits[::-1], half=half) and named else 0


def _number_in_front(entry: Sequence[Word], lexicon: Lexicon) -> int:
    """Give how many words the number is that an entry begins with; 0 where it is no hour, or counts."""
    led = entry[0].text == "@"
    digits = [*takewhile(lambda word: word.is_digits or word.text in JOINTS, entry[led:])]
    length = led + len(digits)
    half = any(word.text in lexicon.beside.of_hours for word in entry[length : length + 1])
    named = next(iter(entry[length + half :]), None)
    if not digits or named is None or not named.is_letters or named.text in lexicon.function_words:
        return 0
    counts = lexicon.means(named.text, "unit")
    return length + half if not counts and _is_hour(digits, half=half) else 0


def _is_hour(digits: Sequence[Word], *, half: bool) -> bool:
    """Whether digits, with minutes or without, are an hour that a number alone may name."""
    hour = digits[0].text
    if len(digits) == 1 and len(hour) == TOGETHER:
        return int(hour[:2]) < DAY and int(hour[2:]) < MINUTES and not half
    hours = HALF_DAY if len(digits) == 1 or half else DAY
    return len(digits) in {1, MINUTED} and hour.isdecimal() and 0 < int(hour) <= hours
