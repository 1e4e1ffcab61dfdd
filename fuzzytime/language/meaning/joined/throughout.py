"""What is on each day of a period: "at six for the rest of the week", "all week at noon"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.meaning.calendar import Cycle
from fuzzytime.language.meaning.expressions import Repeat, Rest, Said, Wall
from fuzzytime.language.meaning.joined.bounded_repeats import bounded_repeat
from fuzzytime.language.meaning.joined.repeats_beside import narrowed_repeat
from fuzzytime.language.meaning.times_of_day import Part
from fuzzytime.requirement import MOMENTS, Constraint, Unit

LONGER = frozenset({Unit.WEEK, Unit.MONTH, Unit.YEAR})
"""Periods of several days."""

THROUGHOUT = "throughout"
"""The preposition of all of a period: "all of next week"."""

DAILY = Repeat(walls=(Wall(Cycle(Unit.DAY)),))


def is_clock_time(said: Said) -> bool:
    """Whether it is a clock time of any day: "at six", and not "six"."""
    time = said.time
    clock = isinstance(time, Wall) and time.clock is not None and time.days is None and not said.hedges
    sure = isinstance(time, Wall) and (said.preposition is not None or not time.bare)
    return clock and sure and said.constraint in MOMENTS


def daily_at(said: Said) -> Repeat | None:
    """Give a clock time on each day; None for what is none, or has a day."""
    return narrowed_repeat(DAILY, said.time) if is_clock_time(said) and isinstance(said.time, Wall) else None


def each_day(said: Said, bound: Said) -> Repeat | None:
    """Give a clock time on each day within a bound; None for what is none, or has a day."""
    daily = daily_at(said)
    return None if daily is None else bounded_repeat(daily, bound)


def in_part(said: Said, part: Part) -> Said:
    """Give a clock time in a part of the day: "at ten" of a night."""
    time = said.time
    return replace(said, time=replace(time, part=part)) if isinstance(time, Wall) and not time.part else said


def in_parts_of_each_day(said: Sequence[Said]) -> Repeat | None:
    """Give what is in some parts of the day, or on one side of them, on each day; None for other times."""
    walls: list[Wall] = []
    for one in said:
        moment = isinstance(one.time, Wall) and one.constraint in MOMENTS | {Constraint.BETWEEN}
        daily = narrowed_repeat(DAILY, one.time) if isinstance(one.time, Wall) and moment else None
        daily = bounded_repeat(DAILY, one) if daily is None and not moment else daily
        if daily is None:
            return None
        walls += daily.walls
    return replace(DAILY, walls=tuple(dict.fromkeys(walls))) if walls else None


def is_rest_of_days(said: Said) -> bool:
    """Whether it is the rest of a week, or of a longer period."""
    days = said.time.of.days if isinstance(said.time, Rest) else None
    return days is not None and days.grain in LONGER
