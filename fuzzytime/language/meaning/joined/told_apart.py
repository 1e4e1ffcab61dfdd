"""Times said apart for the same thing to be done: one time of both."""

from dataclasses import replace

from fuzzytime.language.meaning.calendar import Calendar, Cycle
from fuzzytime.language.meaning.days.relations import Deictic, Relative, Which
from fuzzytime.language.meaning.expressions import Ending, Offset, Repeat, Said, Wall
from fuzzytime.language.meaning.joined.beside import joined, refined
from fuzzytime.language.meaning.joined.bounded_repeats import bounded_repeat
from fuzzytime.language.meaning.joined.intervals_on_days import on_one_day
from fuzzytime.language.meaning.joined.repeats_beside import narrowed_repeat
from fuzzytime.requirement import MOMENTS, Constraint, Unit

OF_THE_DAY = frozenset({Deictic(Which.THIS, Cycle(Unit.DAY)), Relative(0)})
"""The days of what ends, or begins, without a day said: "by the end of the day"."""


def ending_on(ending: Ending, day: Calendar | None) -> Ending | None:
    """Give the end, or the start, of a day that is said elsewhere; None where it names one itself."""
    if day is None or day.grain is not Unit.DAY or ending.days not in OF_THE_DAY:
        return None
    return replace(ending, days=day)


def told_apart(said: Said, frame: Said) -> Said | None:
    """Give a time on the day, or in the repetition of days, that is said elsewhere for the same thing.

    None where it has a day of its own, or does not go together with that one.
    """
    time, other = said.time, frame.time
    if isinstance(other, Repeat):
        moment = isinstance(time, Wall) and said.constraint in MOMENTS
        found = (
            narrowed_repeat(other, time) if isinstance(time, Wall) and moment else bounded_repeat(other, said)
        )
        if found is None:
            return None
        return Said(found, Constraint.EVERY, said.preposition, said.hedges, lasting=said.lasting)
    if not isinstance(other, Wall):
        return None
    if isinstance(time, Ending):
        ends = None if other.clock is not None else ending_on(time, other.days)
        return None if ends is None else replace(said, time=ends)
    if isinstance(time, Repeat):
        turns = on_one_day(time, other)
        return None if turns is None else replace(said, time=turns)
    if isinstance(time, Offset) and isinstance(time.anchor, Wall):
        anchor = joined(other, time.anchor)
        return None if anchor is None else replace(said, time=replace(time, anchor=anchor))
    if isinstance(time, Wall) and said.constraint in MOMENTS:
        both = joined(other, time)
        return None if both is None else replace(said, time=both)
    return refined(said, other)
