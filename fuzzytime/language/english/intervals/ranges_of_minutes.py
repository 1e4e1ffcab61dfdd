"""From some minutes of an hour to others: "between three and half past", "from ten to twenty past nine"."""

from dataclasses import replace

from fuzzytime.language.english.clock_times.minutes_past import moved
from fuzzytime.language.english.intervals.ranges import range_of
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.expressions import Goal, HourMark, Range, Said, Wall
from fuzzytime.language.meaning.times_of_day import Clock
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()

QUARTER = 15
"""Minutes that are said as a part of an hour."""

HOUR = 60
"""Minutes."""

NEAR_HOURS = 2
"""Hours between two clock times of which the first may as well be minutes."""


@grammar.rule(
    "said",
    "between <clock> and <minutes past>",
    "from <clock> to|until|till <minutes past>",
    weight=1.1,
)
def until_past(first: Clock, minutes: float) -> Said | None:
    """Between three and half past, from quarter to ten until quarter past."""
    if first.minute or first.shift >= minutes * 60:
        return None
    last = replace(first, minute=int(minutes), shift=0, grain=Unit.MINUTE, bare=False)
    return range_of(Goal(Wall(clock=first)), Goal(Wall(clock=last)))


@grammar.rule("minutes past", "<minutes of clock>|<bare minutes of clock> past")
def minutes_past(minutes: float) -> float:
    """Half past: of the hour that was said before, or is said behind it."""
    return minutes


@grammar.rule("minutes off", "<minutes of clock>|<bare minutes of clock> to|before")
def minutes_to(minutes: float) -> float:
    """A quarter to: of the hour that is said behind it."""
    return -minutes


@grammar.rule("minutes off", "<minutes past>")
def minutes_after(minutes: float) -> float:
    """A quarter past."""
    return minutes


@grammar.rule(
    "said",
    "between <minutes of clock>|<bare minutes of clock> and <minutes past> <clock>",
    "from <minutes of clock>|<bare minutes of clock> to <minutes past> <clock>",
    weight=1.1,
)
@grammar.rule(
    "said",
    "between <minutes off> and <minutes off> <clock>",
    "from <minutes off> to|until|till <minutes off> <clock>",
    weight=1.2,
)
def between_minutes(minutes: float, more: float, clock: Clock) -> Said | None:
    """Between quarter to and quarter past nine, between ten and twenty past three.

    In "between ten and half past eleven" the first is an hour.
    """
    if more < 0 < minutes:
        # "Between half past and quarter to ten": half past nine.
        minutes -= HOUR
    part_of_hour = more % QUARTER == 0 and minutes % QUARTER
    if part_of_hour and 0 < clock.hour - minutes <= NEAR_HOURS:
        return None
    first, last = moved(clock, minutes), moved(clock, more)
    if minutes >= more or first is None or last is None:
        return None
    return range_of(Goal(Wall(clock=first)), Goal(Wall(clock=last)))


@grammar.rule(
    "said",
    "between <minutes off> and <minutes off>",
    "from <minutes off> to|until|till <minutes off>",
    weight=1.1,
)
def between_marks(minutes: float, more: float) -> Said | None:
    """Between quarter past and half past: of this hour, or the next."""
    first, last = (HourMark(int(minute) % HOUR, open=True) for minute in (minutes, more))
    return None if minutes == more else Said(Range(first, last), Constraint.BETWEEN, "between")
