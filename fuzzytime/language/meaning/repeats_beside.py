"""Repetitions with what is said beside them: a time of day, days, bounds, hours of each day."""

from collections.abc import Sequence
from dataclasses import replace
from typing import TypeGuard

from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields, Weekend
from fuzzytime.language.meaning.expressions import (
    UNIT_SECONDS,
    Coming,
    Duration,
    Edge,
    Ending,
    HourMark,
    Offset,
    Range,
    Repeat,
    Rest,
    Said,
    Time,
    Wall,
)
from fuzzytime.language.meaning.feasts import Season
from fuzzytime.language.meaning.first_times import closing_of, first_time, in_the_end, is_release
from fuzzytime.language.meaning.instants import halved
from fuzzytime.language.meaning.nested import EachDay, Nth, Share
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS, Clock, Half, Part
from fuzzytime.language.policy import Policy
from fuzzytime.requirement import Constraint, Unit

POLICY = Policy()
"""What the hours of a day are that a repetition is bound to."""

MOMENTS = frozenset({None, Constraint.AT})
"""How a time binds that says when."""


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
    if wall.weak and not (period == Cycle(Unit.MONTH) and days.is_day_of_month):
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
        clock = replace(wall.clock, bare=False, pair=False) if wall.clock else old.clock
        # "On weekends at nine" is on either day; every other weekend is taken as a whole.
        each = old.days == Weekend() and repeat.skip == 1
        days_of = EachDay(Weekend()) if each else old.days
        walls.append(replace(old, days=days_of, clock=clock, part=wall.part or old.part))
    return replace(repeat, walls=tuple(walls))


def _is_within_turn(repeat: Repeat, days: Calendar) -> bool:
    """Whether days are too short to hold a repetition: "every monday" is none of a wednesday's."""
    longer = (Unit.WEEK, Unit.MONTH, Unit.QUARTER, Unit.YEAR)
    grains = [wall.days.grain for wall in repeat.walls if isinstance(wall.days, Cycle)]
    weekly = any(isinstance(wall.days, Fields) and wall.days.weekly for wall in repeat.walls)
    return days.grain is Unit.DAY and (weekly or any(grain in longer for grain in grains))


def _is_inside(inner: Part, outer: Part) -> bool:
    """Whether hours, or a part of the day, are in a part: "every morning between seven and eight" too."""
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


def bounded_repeat(repeat: Repeat, said: Said) -> Repeat | None:
    """Give a repetition with its bounds, or within hours of each day: every weekday from 9 to 5."""
    marked = isinstance(repeat.starting, HourMark) and repeat.until is None
    shared = _in_share(repeat, said)
    if shared is not None:
        return shared
    return _bounded_mark(repeat, said) if marked else _bounded(repeat, said)


def _bounded(repeat: Repeat, said: Said) -> Repeat | None:
    time = said.time
    if repeat.walls and _is_in_day(time):
        return _in_hours(repeat, said)
    if repeat.starting is not None or repeat.until is not None or isinstance(time, Repeat):
        return _ended(repeat, said)
    if isinstance(time, Duration):
        # "Twice a day for two minutes" says how long each lasts.
        step = repeat.every.seconds if repeat.every is not None else _apart(repeat)
        lasting = said.constraint is Constraint.FOR and time.seconds >= step
        bound = lasting or said.constraint is Constraint.BEFORE
        return replace(repeat, until=Offset(time)) if bound else None
    if (closing := closing_of(said)) is not None:
        return in_the_end(repeat, closing)
    if isinstance(time, (Coming, Rest)):
        return replace(repeat, until=_end_of(time))
    if not repeat.walls and isinstance(time, Wall) and time.clock is None and said.constraint in MOMENTS:
        # "Every two hours tonight"
        return replace(repeat, starting=time, until=time)
    if said.constraint is Constraint.BEFORE:
        # "Three alarms ten minutes apart before seven": how many is said, and any of them may be then.
        return None if repeat.apart else replace(repeat, until=time)
    if said.lasting is not None and isinstance(time, Wall) and repeat.every is not None:
        # "Every five minutes from noon for half an hour"
        longer = not repeat.walls and said.lasting.seconds > repeat.every.seconds
        return replace(repeat, starting=time, until=Offset(said.lasting, 1, time)) if longer else None
    if is_release(said):
        first = first_time(said)
        return None if first is None else replace(repeat, starting=first)
    if said.constraint is Constraint.BETWEEN and isinstance(time, Range):
        if any(wall.part is not None and not wall.part.name for wall in repeat.walls) and _is_clocked(time):
            # "Mon-thu 9-5, fri 9-3": the second are hours of another day.
            return None
        return replace(repeat, starting=time.first, until=time.last)
    return None


def _ended(repeat: Repeat, said: Said) -> Repeat | None:
    """Give what begins at a time with its end: "every two hours at ten until six"."""
    begins = repeat.until is None and isinstance(repeat.starting, Wall)
    if not begins or said.constraint is not Constraint.BEFORE or not isinstance(said.time, Wall):
        return None
    return replace(repeat, until=said.time)


def _is_clocked(time: Range) -> bool:
    """Whether it is from one clock time to another."""
    return all(isinstance(end, Wall) and end.clock is not None for end in (time.first, time.last))


def _apart(repeat: Repeat) -> float:
    """Give how far apart in seconds the days of a repetition are, on the whole: weekdays, or all."""
    weekdays = {wall.days.weekday for wall in repeat.walls if isinstance(wall.days, Fields)}
    weekly = all(isinstance(wall.days, Fields) and wall.days.weekly for wall in repeat.walls)
    # "On mondays for three days" is as long as that.
    return UNIT_SECONDS[Unit.WEEK] / len(weekdays) if weekly and weekdays else DAY_SECONDS


def _is_in_day(time: object) -> bool:
    """Whether it is hours of any day, or one side of a time of any day."""
    if isinstance(time, Range):
        return is_of_day(time.first) and is_of_day(time.last)
    return isinstance(time, Wall) and is_of_day(time)


def _in_hours(repeat: Repeat, said: Said) -> Repeat | None:
    """Give what is done on days within hours of each of them, whatever bounds the days have."""
    time, side = said.time, said.constraint
    if isinstance(time, Range) and is_of_day(time.first) and is_of_day(time.last):
        return within_hours(repeat, time.first, time.last)
    walls = [_on_side(wall, time, side) for wall in repeat.walls] if isinstance(time, Wall) else []
    kept = tuple(wall for wall in walls if wall is not None)
    return replace(repeat, walls=kept) if kept and len(kept) == len(walls) else None


def _on_side(day: Wall, time: Wall, side: Constraint | None) -> Wall | None:
    """Give one side of a time of day on a day, or in its part: "every monday before seven"."""
    if day.clock is not None or side not in {Constraint.BEFORE, Constraint.AFTER}:
        return None
    within = day.part
    if time.clock is not None:
        within = time.part or within
        clock = time.clock if within is None else halved(time.clock, within.half)
        first = last = clock.first_from(POLICY.plausible_from)
    elif time.part is not None:
        # "Before school on tuesdays"
        first, last = time.part.start, time.part.end % DAY_SECONDS
    else:
        return None
    if side is Constraint.AFTER:
        closes = within.end if within is not None and last < within.end else DAY_SECONDS
        return replace(day, part=Part("", last, closes, Half.EITHER))
    if within is not None and within.start < first:
        # "Every evening before nine"
        return replace(day, part=Part("", within.start, first, Half.EITHER))
    return replace(day, part=Part("", POLICY.begin_before(first), first, Half.EITHER, due=True))


def _in_share(repeat: Repeat, said: Said) -> Repeat | None:
    """Give what is done so often in some days the time of day of each: "twice a week at noon"."""
    time, side = said.time, said.constraint
    if isinstance(time, Range) and repeat.shared and repeat.every is not None and not repeat.walls:
        return _in_share_of_hours(repeat, repeat.every.seconds, time)
    longer = repeat.shared and repeat.every is not None and repeat.every.seconds > DAY_SECONDS
    if not longer or repeat.at is not None or not isinstance(time, Wall) or not is_of_day(time):
        return None
    if side in MOMENTS:
        return None if time.bare and said.preposition is None else replace(repeat, at=time)
    bounded = _on_side(Wall(), time, side)
    return None if bounded is None else replace(repeat, at=bounded)


def _in_share_of_hours(repeat: Repeat, step: float, hours: Range) -> Repeat | None:
    """Give what is done so often each day within hours of it: "three times a day between eight and six"."""
    open_ = repeat == Repeat(repeat.every, shared=True)
    if not open_ or step == DAY_SECONDS or not is_of_day(hours.first) or not is_of_day(hours.last):
        return None
    daily = within_hours(Repeat(walls=(Wall(Cycle(Unit.DAY)),)), hours.first, hours.last)
    part = None if daily is None else daily.walls[0].part
    if part is None or step > DAY_SECONDS:
        # "Twice a week between six and eight"
        return None if part is None else replace(repeat, at=Wall(part=part))
    every = Duration((((part.end - part.start) * step / DAY_SECONDS, Unit.SECOND),))
    return replace(repeat, every=every, within=daily)


def _end_of(stretch: Coming | Rest) -> Time | None:
    """Give where a stretch from now on is over: "every day for the rest of the week"."""
    if isinstance(stretch, Coming):
        return Offset(stretch.duration)
    return None if stretch.of.days is None else Ending(Edge.END, stretch.of.days)


def _bounded_mark(repeat: Repeat, said: Said) -> Repeat | None:
    """Give what is done at a mark of each hour, and when: "every hour on the hour overnight"."""
    time, mark = said.time, repeat.starting
    if not isinstance(time, Wall) or time.part is None or not isinstance(mark, HourMark):
        return None
    first = time.part.start + (mark.minute * 60 - time.part.start) % 3600
    within = replace(time, part=replace(time.part, start=first))
    return _bounded(replace(repeat, starting=None), replace(said, time=within))


def is_of_day(time: object) -> TypeGuard[Wall]:
    """Whether it is a clock time or a part of any day."""
    said = isinstance(time, Wall) and (time.clock is not None or time.part is not None)
    return said and isinstance(time, Wall) and time.days is None


def within_hours(repeat: Repeat, first: Wall, last: Wall) -> Repeat | None:
    """Give a repetition within hours of the day: every weekday from 9 to 5, every night from dusk on."""
    if first.clock is not None:
        clock = first.clock if first.part is None else halved(first.clock, first.part.half)
        begins = _hour_of(repeat, clock)
    elif first.part is not None:
        # "Between lunch and five": from its end.
        begins = (first.part.end if first.part.meal else first.part.start) % DAY_SECONDS
    else:
        return None
    known = last.clock.candidates() if last.clock is not None else ()
    known = (last.part.start,) if not known and last.part is not None else known
    length = min(((end - begins) % DAY_SECONDS for end in known), default=0)
    hours = Part("", begins, begins + length, Half.EITHER)
    return narrowed_repeat(repeat, Wall(part=hours)) if length else None


def _hour_of(repeat: Repeat, clock: Clock) -> int:
    """Give the seconds since midnight that a clock time of a repetition means: "every evening from nine"."""
    parts = {wall.part for wall in repeat.walls}
    (part,) = parts if len(parts) == 1 else (None,)
    return (clock if part is None else halved(clock, part.half)).first_from(POLICY.plausible_from)
