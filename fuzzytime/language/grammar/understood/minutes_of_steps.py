"""Numbers behind what goes on for minutes, where a text says lengths of time: "simmer 20 min, rest 5".

So they are where nothing but such numbers ends its steps ("knead 10, rest 60, bake 40"), and behind what goes
on for seconds alone they are seconds: "hold it for 30 seconds, rest 10 between". Several distances have their
unit, and their side, in common: "30 and 10 minutes before".
"""

from collections.abc import Iterator, Sequence

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.understood.lent import DEGREES_DIGITS
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.units import UnitWord
from fuzzytime.requirement import Unit

MARKS = {Unit.SECOND: "″", Unit.MINUTE: "′", Unit.HOUR: "‵"}
"""What takes no room behind a number and says its unit."""

STEP_ENDS = frozenset({",", ";", "\n", "."})
"""Marks behind the steps of a text."""

JOINTS = frozenset({",", "and", "&", "+"})
"""What stands between numbers whose unit is said behind the last."""

SHORTEST_LIST = 2
"""Numbers behind steps, at least, that are minutes although the text says no length of time."""

LONGEST_STEP = 3
"""Words at most before the number of a step."""


def says_lengths(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words say how long something goes on within a day: "15 min", "half an hour"."""
    return any(_unit_at(words, place, lexicon) is not None for place in range(1, len(words)))


def with_units(words: Sequence[Word], lexicon: Lexicon, *, measured: bool) -> list[Word]:
    """Put the unit, which takes no room, behind each number that counts so many of it.

    The text is ``measured`` where others beside it say lengths of time.
    """
    units = {place: [mark] for place, mark in _units(words, lexicon, measured=measured)}
    units |= _of_distances(words, lexicon)
    found: list[Word] = []
    for place, word in enumerate(words):
        found.append(word)
        found += (Word(text, word.end, word.end, glued=True) for text in units.get(place, ()))
    return found


def _of_distances(words: Sequence[Word], lexicon: Lexicon) -> dict[int, list[str]]:
    """Give what is left out behind each number of a list of distances: "30 and 10 minutes before"."""
    closed, found = lexicon.closed, dict[int, list[str]]()
    led = closed.prepositions_of_time | closed.prepositions_of_points | closed.prepositions_of_two_ends
    for place, word in enumerate(words):
        last = place - 2
        if (
            last < 0
            or word.text not in lexicon.beside.before_or_after
            or _unit_at(words, place - 1, lexicon) is None
        ):
            continue
        while last > 1 and words[last - 1].text in JOINTS and _counts(words[last - 2].text, lexicon):
            last -= 2
            found[last] = [words[place - 1].text, word.text]
        if last and words[last - 1].text in led:
            # "At 5 and ten minutes before six", "between five and ten minutes before"
            return {}
    return found


def _units(words: Sequence[Word], lexicon: Lexicon, *, measured: bool) -> Iterator[tuple[int, str]]:
    """Give the numbers without a unit that count minutes or seconds, each with the mark of these."""
    steps = list(_steps(words, lexicon))
    begins = {end - 1: first for first, end in steps}
    numbers = {end - 1: _goes_on_for(words[first:end], lexicon) for first, end in steps}
    numbered = [place for place, lasts in numbers.items() if words[place].is_digits or lasts]
    listed = len(numbered) >= SHORTEST_LIST and all(
        numbers[place] and words[place].is_digits for place in numbered
    )
    lasting = [place for place in numbered if numbers[place]]
    if not lasting or not (measured or listed or says_lengths(words, lexicon)):
        return
    for place in lasting:
        verb = words[begins[place]].text
        before = {_unit_at(words, at, lexicon) for at in range(1, place)} - {None}
        # "Wait 2 hours, paint, wait 4"
        own = (_unit_at(words, at + 2, lexicon) for at in range(place - 2) if words[at].text == verb)
        unit = Unit.SECOND if before == {Unit.SECOND} else Unit.MINUTE
        yield place, MARKS[next((unit for unit in own if unit is not None), unit)]


def _unit_at(words: Sequence[Word], place: int, lexicon: Lexicon) -> Unit | None:
    """Give the unit of a length within a day that ends at a place; None where none does."""
    before, text = words[place - 1].text, words[place].text
    if not (_counts(before, lexicon) or before in lexicon.beside.of_lengths):
        return None
    said = (entry.value for entry in lexicon.entries.get(text, ()) if len(entry.words) == 1)
    units = (value.unit for value in said if isinstance(value, UnitWord))
    return next((unit for unit in units if unit in SUB_DAY), None)


def _steps(words: Sequence[Word], lexicon: Lexicon) -> Iterator[tuple[int, int]]:
    """Give where the steps of a text begin, and where they end up to what follows a number of minutes."""
    joints, first = STEP_ENDS | lexicon.closed.joints_of_instances, 0
    for end in range(len(words) + 1):
        # "Bake 1.15"
        inside = any(word.glued and word.is_digits for word in words[end + 1 : end + 2])
        if end < len(words) and (words[end].text not in joints or inside):
            continue
        if first < end:
            behind = (
                at for at in range(first + 1, end) if words[at].text in lexicon.beside.behind_minutes_of_steps
            )
            yield first, next(behind, end)
        first = end + 1


def _goes_on_for(step: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a step ends in how many minutes it takes, behind its verb, or is done "for the last five"."""
    *said, number = (word.text for word in step)
    if not said or not _counts(number, lexicon) or _is_long(number):
        return False
    if lexicon.beside.ends_of_steps.issuperset(said[-1:]) and "for" in said[-LONGEST_STEP:]:
        return True
    verb, before = said[0], said[-1]
    # "Warm up 5"
    settles = verb in lexicon.doing.settling and before in {verb, *lexicon.particles}
    timed = any(verb in words for words in (lexicon.timing, lexicon.timing_alone, lexicon.doing.settling))
    if not timed or len(said) > LONGEST_STEP or any(_counts(text, lexicon) for text in said):
        return False
    joins = before in lexicon.function_words and before not in lexicon.beside.before_another_number
    return len(said) == 1 or settles or not (joins or before in lexicon.called_by_number)


def _is_long(number: str) -> bool:
    """Whether a number is a temperature, or counts metres."""
    return number.isdecimal() and len(number) >= DEGREES_DIGITS


def _counts(text: str, lexicon: Lexicon) -> bool:
    return text.isdecimal() or lexicon.numbers.get(text, 0) > 1
