"""Which of several times the answer to a question means: "the later one", "18:00", "the morning", "yes"."""

from collections.abc import Iterator
from dataclasses import replace
from datetime import datetime

from fuzzytime.language.about_wishes.corrections import opening_correction
from fuzzytime.language.about_wishes.other_words.merging import is_of_days
from fuzzytime.language.about_wishes.said import Said
from fuzzytime.language.finding import find_times
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Question
from fuzzytime.times import instant_after

NOON = 12
ONE = frozenset({("one",)})
TWO = 2
"""Choices of which one is meant where the other is not."""

LONGEST = 9
"""Letters or digits of a number that somebody chooses by at most."""


def choice_meant(text: str, question: Question, now: datetime, lexicon: Lexicon) -> int | None:
    """Give the position of the choice that an answer means; None where it means none, or may mean several.

    >>> from datetime import datetime
    >>> from fuzzytime.language.finding import shipped_lexicon
    >>> six = (datetime(2026, 3, 4, 18), datetime(2026, 3, 5, 6))
    >>> choice_meant("the morning", Question((0, 6), six, 0), datetime(2026, 3, 4, 9), shipped_lexicon())
    1
    """
    whole = Said.of(text, now, lexicon)
    corrected = opening_correction(whole)
    said = _answer(whole.behind(corrected))
    if said.forms[:1] == ("not",) and len(question.choices) == TWO:
        # "Not in the evening"
        other = _choice(said.behind(1), question, corrected=corrected)
        return None if other is None else 1 - other
    return _choice(said, question, corrected=corrected)


def _choice(said: Said, question: Question, *, corrected: int) -> int | None:
    time = said.one_time()
    # "No, tomorrow" is another day, and may be at the hour that was taken.
    if not said.words or (corrected and time is not None and is_of_days(time)):
        return None
    if said.is_in("agreeing"):
        return question.chosen
    if (named := _by_place(said, question)) is not None:
        return named
    # "The morning one"
    found = (_by_time(one, question) for one in (said.without_end(ONE), said))
    return next((choice for choice in found if choice is not None), None)


def chooses_none(text: str, now: datetime, lexicon: Lexicon) -> bool:
    """Whether an answer says no more than that it does not choose: "no", "neither", "both"."""
    return Said.of(text, now, lexicon).is_in("choosing none")


def lets_be(text: str, now: datetime, lexicon: Lexicon) -> bool:
    """Whether an answer to what was asked back lets that be: "never mind", "no"."""
    said = Said.of(text, now, lexicon)
    return said.is_in("choosing none") or said.without_exclamations().is_in("retracting")


def _answer(said: Said) -> Said:
    """Leave out what opens an answer, and what is polite behind it: "I mean the later one, please"."""
    said = said.behind(said.opens_with("meaning")).without_thanks()
    # "Morning, obviously"
    return said.without("of course")[0] if said.words else said


def _by_place(said: Said, question: Question) -> int | None:
    """Give the choice that is named by its place: "the second", "number two", "the later one"."""
    count = len(question.choices)
    in_order = sorted(range(count), key=lambda place: question.choices[place])
    if said.is_in("the earlier"):
        return in_order[0]
    if said.is_in("the later"):
        return in_order[-1]
    if said.is_in("other") and count == len(("this", "that")):
        return 1 - question.chosen
    number = said.behind(said.opens_with("numbering")).text.lower()
    counted = said.lexicon.numbers.get(number, number)
    # "Two" is what may be typed, as "2" is.
    places = (int(counted),) if str(counted).isdecimal() and len(number) <= LONGEST else said.places
    if len(places) != 1 or abs(places[0]) > count or not places[0]:
        return None
    return places[0] - 1 if places[0] > 0 else count + places[0]


def _by_time(said: Said, question: Question) -> int | None:
    """Give the only choice that a time agrees with, or of which it is the half or the part of the day."""
    time = said.one_time()
    if time is not None and is_of_days(time) and time.earliest is not None and time.latest is not None:
        first, end = (instant_after(said.now, bound) for bound in (time.earliest, time.latest))
        return _only(place for place, one in enumerate(question.choices) if first <= one < end)
    for words in (said.text, f"at {said.text}"):
        instant = _plain_instant(replace(said, text=words))
        if instant is not None:
            return _only(place for place, one in enumerate(question.choices) if one == instant)
    return _only(place for place, one in enumerate(question.choices) if _is_told_by(said, one))


def _plain_instant(said: Said) -> datetime | None:
    """Give the instant that words name without leaving another open: "06:00", "6 am"."""
    found = find_times(said.text, said.now, said.lexicon)
    time = said.one_time()
    if time is None or time.t_spec is None or time.earliest != time.latest or found.questions:
        return None
    return instant_after(said.now, time.t_spec)


def _is_told_by(said: Said, choice: datetime) -> bool:
    """Whether words behind the hour of a choice tell that it is that one: "pm", "in the evening"."""
    hour = f"at {choice.hour % NOON or NOON}:{choice.minute:02}"
    spoken = (f"{hour} {said.text}", f"{hour} in {said.text}")
    instants = (_plain_instant(replace(said, text=words)) for words in spoken)
    return next((instant for instant in instants if instant is not None), None) == choice


def _only(places: Iterator[int]) -> int | None:
    """Give the only one there is."""
    found = list(places)
    return found[0] if len(found) == 1 else None
