"""What is on each day of a period: "at six for the rest of the week", "all week at noon"."""

from fuzzytime.language.meaning.calendar import Cycle
from fuzzytime.language.meaning.expressions import Repeat, Rest, Said, Wall
from fuzzytime.language.meaning.repeats_beside import bounded_repeat, narrowed_repeat
from fuzzytime.requirement import Constraint, Unit

LONGER = frozenset({Unit.WEEK, Unit.MONTH, Unit.YEAR})
"""Periods of several days."""

DAILY = Repeat(walls=(Wall(Cycle(Unit.DAY)),))


def is_clock_time(said: Said) -> bool:
    """Whether it is a clock time of any day: "at six", and not "six"."""
    time = said.time
    clock = isinstance(time, Wall) and time.clock is not None and time.days is None and not said.hedges
    sure = isinstance(time, Wall) and (said.preposition is not None or not time.bare)
    return clock and sure and said.constraint in {None, Constraint.AT}


def daily_at(said: Said) -> Repeat | None:
    """Give a clock time on each day; None for what is none, or has a day."""
    return narrowed_repeat(DAILY, said.time) if is_clock_time(said) and isinstance(said.time, Wall) else None


def each_day(said: Said, bound: Said) -> Repeat | None:
    """Give a clock time on each day within a bound; None for what is none, or has a day."""
    daily = daily_at(said)
    return None if daily is None else bounded_repeat(daily, bound)


def is_rest_of_days(said: Said) -> bool:
    """Whether it is the rest of a week, or of a longer period."""
    days = said.time.of.days if isinstance(said.time, Rest) else None
    return days is not None and days.grain in LONGER
