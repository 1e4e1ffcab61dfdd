"""What a line calls by its time: "the nine o'clock is cancelled", "move the one at 10.30 to noon"."""

from datetime import datetime, time

from fuzzytime.language.about_wishes.said import AT, CLOCKED, Said
from fuzzytime.language.finding import find_times
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Span
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.requirement import Constraint
from fuzzytime.times import instant_after

LONGEST_CLOCK = 4
"""Words of a clock time at most."""

BEHIND = (
    "cancelled",
    "later",
    "earlier",
    "late",
    "early",
    "finished",
    "towards",
    "more",
    "preferring",
    "absent",
)
"""Tables of what may be said right behind what is called by its time."""


def called_by_time(text: str, now: datetime, lexicon: Lexicon) -> tuple[Span, frozenset[time]] | None:
    """Give where a line calls something by its time, and which times that may be; None where it does not.

    >>> from fuzzytime.language.finding import shipped_lexicon
    >>> span, times = called_by_time("cancel my nine o'clock", datetime(2026, 3, 4, 8), shipped_lexicon())
    >>> span, sorted(one.hour for one in times)
    ((7, 22), [9, 21])
    """
    said = Said(text, now, lexicon)
    for place, word in enumerate(said.forms):
        if word not in lexicon.closed.noun_openers or word in lexicon.closed.indefinite_determiners:
            continue
        one = said.behind(place + 1).opens_with("listed")
        begin = (
            place + 1 + (one + 1 if one and said.forms[place + 1 + one : place + 2 + one] == ("at",) else 0)
        )
        for end in range(min(begin + LONGEST_CLOCK, len(said.words)), begin, -1):
            times = _clock_times(said.until(end).behind(begin), counted=begin == place + 1)
            behind = said.behind(end)
            one = behind.opens_with("several") or behind.opens_with("listed")
            if times and _ends(behind.behind(one)):
                return (said.words[place].start, said.words[end + one - 1].end), times
    return None


def _clock_times(said: Said, *, counted: bool) -> frozenset[time]:
    """Give which times of a day a text may mean that is one, and no more; a number may be ``counted``."""
    found = find_times(f"{AT}{said.text}", said.now, said.lexicon).found
    if len(found) != 1 or found[0].requirement.text != f"{AT}{said.text}" or (counted and said.as_number()):
        return frozenset()
    part, questions = found[0].requirement, found[0].questions
    if part.constraint is not Constraint.AT or part.grain not in CLOCKED or part.t_spec is None:
        return frozenset()
    choices = [choice for question in questions for choice in question.choices]
    return frozenset(one.time() for one in choices or [instant_after(said.now, part.t_spec)])


def _ends(behind: Said) -> bool:
    """Whether what is called so ends there: "the nine o'clock train" is a train."""
    if not behind.words:
        return True
    lexicon, first = behind.lexicon, behind.forms[0]
    small = (
        not content_words(first)
        or first in lexicon.function_words | lexicon.doing.happening
        or (first,) in lexicon.questions["helping"]
    )
    return small or any(behind.opens_with(name) for name in BEHIND)
