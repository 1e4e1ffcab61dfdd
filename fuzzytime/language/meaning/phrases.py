"""What is asked of phrases: which words they are, and whether they name a stretch of hours."""

from collections.abc import Iterable

from fuzzytime.language.meaning.expressions import Phrase, Range, wall_of
from fuzzytime.requirement import MOMENTS


def places_in(phrases: Iterable[Phrase]) -> frozenset[int]:
    """Give the places of the words that are about time."""
    return frozenset(place for phrase in phrases for place in range(phrase.first, phrase.end))


def is_at_clock(phrase: Phrase) -> bool:
    """Whether it is a clock time, or at one."""
    said = phrase.said
    return said.wall.clock is not None and said.preposition in {None, "at"} and said.constraint in MOMENTS


def is_window(phrase: Phrase) -> bool:
    """Whether it is from one clock time to another."""
    time = phrase.said.time
    ends = (time.first, time.last) if isinstance(time, Range) else ()
    return bool(ends) and all(wall_of(end).clock is not None for end in ends)
