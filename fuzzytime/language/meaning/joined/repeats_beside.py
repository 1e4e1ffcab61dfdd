"""Repetitions with what is said beside them: a time of day, or days."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields, Weekend, is_day_of_month, is_weekday
from fuzzytime.language.meaning.days.nested import EachDay, Nth, Share
from fuzzytime.language.meaning.expressions import Repeat, Time, Wall
from fuzzytime.language.meaning.feasts import Season
from fuzzytime.language.meaning.times_of_day import Part
from fuzzytime.requirement import Unit


def _named_days(repeat: Repeat, wall: Wall) -> Calendar | None:
    """Give the day that a period is said to have: every year on the 4th of july, every week on friday."""
    days = wall.days
    if isinstance(days, Nth) and [day.days for day in repeat.walls] == [days.outer]:
        # "Every other month on the first monday"
        return days
    yearly = isinstance(days, Share) and isinstance(days.of, Season)
    if yearly and len(repeat.walls) == 1 and repeat.walls[0].days == Cycle(Unit.YEAR) and repeat.skip == 1:
        return days
    if len(repeat.walls) != 1 or not isinstance(days, Fields) or days.fixed:
        return None
    period = repeat.walls[0].days
    if wall.weak and not (period == Cycle(Unit.MONTH) and is_day_of_month(days)):
        return None
    if period == Cycle(Unit.YEAR) and days.month is not None:
        return days
    if period == Cycle(Unit.MONTH) and days == Fields(day=days.day) and days.day is not None:
        return days
    return days if period == Cycle(Unit.WEEK) and days.weekly else None


def names_day_of(repeat: Repeat, wall: Wall) -> bool:
    """Whether it is the day that a period is said to have."""
    return _named_days(repeat, wall) is not None


def on_named_days(repeat: Repeat, walls: Sequence[Wall]) -> Repeat | None:
    """Give a repetition of periods on days of each: "every other month", the fifth and the twentieth."""
    days = [_named_days(repeat, wall) for wall in walls]
    if repeat.every is None or None in days:
        return None
    turn = repeat.walls[0]
    return replace(repeat, every=None, walls=tuple(replace(turn, days=day) for day in days))


def narrowed_repeat(repeat: Repeat, wall: Wall) -> Repeat | None:
    """Give a repetition at a time of day, in a part of the day, or within days that are said beside it."""
    days = _named_days(repeat, wall)
    if days is not None:
        return replace(repeat, every=None, walls=(replace(wall, days=days),))
    if wall.days is not None and wall.clock is None and wall.part is None:
        if repeat.until is not None or repeat.starting is not None or _is_within_turn(repeat, wall.days):
            return None
        return replace(repeat, starting=wall, until=wall)
    if repeat.every is not None and wall.clock is not None and _is_day(repeat.until):
        return None  # "every hour until tomorrow | at seven" ends then
    if wall.clock is not None and repeat == Repeat(repeat.every, until=repeat.until):
        # "At ten every two hours" begins at ten.
        return replace(repeat, starting=wall)
    if wall.days is not None or not repeat.walls:
        return None
    walls = []
    for old in repeat.walls:
        if old.clock and wall.clock:
            return None
        late = old.part is not None and old.part.half.is_late and wall.clock is not None
        if old.part and wall.part and not late and not _is_inside(wall.part, old.part):
            return None
        # "Daily from six to nine | in the evening"
        hours = old.part if wall.part and old.part and not old.part.name else None
        clock = replace(wall.clock, bare=False, pair=False) if wall.clock else old.clock
        # "On weekends at nine" is on either day; every other weekend is taken as a whole.
        each = old.days == Weekend() and repeat.skip == 1
        days_of = EachDay(Weekend()) if each else old.days
        walls.append(replace(old, days=days_of, clock=clock, part=hours or wall.part or old.part))
    return replace(repeat, walls=tuple(walls))


def _is_day(until: Time | None) -> bool:
    """Whether a repetition ends with a day, or a part of one, whose hour is still open."""
    return isinstance(until, Wall) and until.days is not None and until.clock is None


def _is_within_turn(repeat: Repeat, days: Calendar) -> bool:
    """Whether days are too short to hold a repetition: "every monday" is none of a wednesday's."""
    longer = (Unit.WEEK, Unit.MONTH, Unit.QUARTER, Unit.YEAR)
    grains = [wall.days.grain for wall in repeat.walls if isinstance(wall.days, Cycle)]
    weekly = any(is_weekday(wall.days) for wall in repeat.walls)
    return days.grain is Unit.DAY and (weekly or any(grain in longer for grain in grains))


def _is_inside(inner: Part, outer: Part) -> bool:
    """Whether hours, or a part of the day, are in a part: "every morning between seven and eight" too."""
    if not outer.name:
        # "Every day from nine | in the morning until two" has no hours of its hours.
        return bool(inner.name) and inner.is_near(outer.start)
    if not inner.name:
        return outer.is_near(inner.start)
    return outer.start <= inner.start < outer.end


def without_clocks(repeat: Repeat) -> Repeat | None:
    """Give a repetition at clock times on the days of those; None where not all of it is."""
    if not repeat.walls or any(wall.clock is None for wall in repeat.walls):
        return None
    days = dict.fromkeys(replace(wall, clock=None, zone=None) for wall in repeat.walls)
    return replace(repeat, walls=tuple(days))


def timed_as(repeat: Repeat, other: Repeat) -> Repeat:
    """Give days without a time of day that of those behind them: "on saturdays and sundays at ten"."""
    clocks = {wall.clock for wall in other.walls}
    (clock,) = clocks if len(clocks) == 1 else (None,)
    open_days = all(wall.clock is None and wall.part is None for wall in repeat.walls)
    if clock is None or not open_days:
        return repeat
    return replace(repeat, walls=tuple(replace(wall, clock=clock) for wall in repeat.walls))
