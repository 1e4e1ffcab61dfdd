"""From when on something is repeated: "every hour after dinner", "three times, an hour apart, from noon"."""

from dataclasses import replace

from fuzzytime.language.meaning.expressions import (
    Coming,
    Duration,
    Edge,
    Ending,
    Offset,
    Range,
    Repeat,
    Rest,
    Said,
    Time,
    Wall,
)
from fuzzytime.language.meaning.joined.distances import EARLIER, HALFWAY, INTO, LAST, LATER, LEFT
from fuzzytime.requirement import MOMENTS, Constraint, Unit

COUNTED_FROM_ELSEWHERE = frozenset({LATER, EARLIER, INTO, LEFT, LAST, HALFWAY})
"""Prepositions of times that count from another instruction."""


def first_time(said: Said) -> Time | None:
    """Give the moment, or the stretch, in which a time lets the first of several be; None for other times."""
    time, beginning = said.time, said.constraint in MOMENTS or said.constraint is Constraint.AFTER
    if said.preposition in COUNTED_FROM_ELSEWHERE or isinstance(time, (Repeat, Ending, Rest)):
        return None
    if isinstance(time, Duration):
        return Offset(time) if beginning else None
    if isinstance(time, Range):
        return time.first if said.constraint in MOMENTS | {Constraint.BETWEEN} else None
    if said.constraint is Constraint.AFTER and said.edge is Edge.END and isinstance(time, Wall):
        # "After dinner": once it is over.
        return Offset(Duration(((0, Unit.SECOND),)), 1, time)
    return time if beginning or said.constraint is Constraint.BETWEEN else None


def is_release(said: Said) -> bool:
    """Whether a time says from when on, and no more: "from noon", "starting at eight"."""
    return said.constraint is Constraint.AFTER or said.preposition == "starting"


def beginning(repeat: Repeat, first: Time) -> Repeat:
    """Give a repetition from a time on; how long it goes on counts from there."""
    until = repeat.until
    if isinstance(until, Offset) and until.anchor is None:
        until = replace(until, anchor=first)
    return replace(repeat, starting=first, until=until)


def closing_of(said: Said) -> Duration | None:
    """Give how much of the end of something a time is: "for the last hour", "with ten minutes left"."""
    time = said.time
    if isinstance(time, Coming):
        return time.duration if time.direction < 0 else None
    return time.duration if isinstance(time, Offset) and said.preposition in {LEFT, LAST} else None


def opening_of(said: Said) -> Duration | None:
    """Give how much of the beginning of something a time is: "for the first ten minutes"."""
    opening = said.preposition == "for" and said.constraint is Constraint.BETWEEN
    return said.time.duration if opening and isinstance(said.time, Coming) else None


def at_the_beginning(repeat: Repeat, length: Duration) -> Repeat | None:
    """Give a repetition within the beginning of something; None where it has other bounds, or days."""
    within = in_the_end(repeat, length)
    return None if within is None else replace(repeat, until=Offset(length))


def in_the_end(repeat: Repeat, length: Duration) -> Repeat | None:
    """Give a repetition within the end of something; None where it has other bounds, or days."""
    bounded = repeat.starting is not None or repeat.until is not None or repeat.times is not None
    if bounded or repeat.walls or repeat.every is None:
        return None
    return replace(repeat, closing=length)


def ending_with(repeat: Repeat, last: Time) -> Repeat:
    """Give so many times, so long apart, of which the last is said: the first is that much before it."""
    if repeat.every is None or repeat.times is None:
        return replace(repeat, until=last)
    terms = tuple((amount * (repeat.times - 1), unit) for amount, unit in repeat.every.terms)
    return replace(repeat, starting=Offset(Duration(terms), -1, last), until=None)
