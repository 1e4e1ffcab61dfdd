"""Repetitions with their bounds: a first or last time, a length, hours of each day."""

from dataclasses import replace
from typing import TypeGuard

from fuzzytime.language.meaning.calendar import Cycle, Fields, is_weekday
from fuzzytime.language.meaning.expressions import (
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
    wall_of,
)
from fuzzytime.language.meaning.instants import halved
from fuzzytime.language.meaning.joined.beside import joined
from fuzzytime.language.meaning.joined.first_times import closing_of, first_time, in_the_end, is_release
from fuzzytime.language.meaning.joined.repeats_beside import narrowed_repeat
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS, Clock, Half, Part
from fuzzytime.language.meaning.units import UNIT_SECONDS
from fuzzytime.language.policy import Policy
from fuzzytime.requirement import MOMENTS, Constraint, Unit

POLICY = Policy()
"""What the hours of a day are that a repetition is bound to."""


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
        return _for_so_long(repeat, said, time)
    if (closing := closing_of(said)) is not None:
        return in_the_end(repeat, closing)
    if isinstance(time, (Coming, Rest)):
        return replace(repeat, until=_end_of(time))
    if not repeat.walls and isinstance(time, Wall) and time.clock is None and said.constraint in MOMENTS:
        # "Every two hours tonight"
        return replace(repeat, starting=time, until=time)
    if said.constraint is Constraint.BEFORE:
        return _until(repeat, said, time)
    if said.lasting is not None and isinstance(time, Wall) and repeat.every is not None:
        # "Every five minutes from noon for half an hour"
        longer = not repeat.walls and said.lasting.seconds > repeat.every.seconds
        return replace(repeat, starting=time, until=Offset(said.lasting, 1, time)) if longer else None
    if is_release(said):
        first = first_time(said)
        return None if first is None else replace(repeat, starting=first)
    between = said.constraint is Constraint.BETWEEN
    return _through(repeat, time) if between and isinstance(time, Range) else None


def _through(repeat: Repeat, time: Range) -> Repeat | None:
    """Give a repetition from when to when: "every ten minutes from nine to noon"."""
    if _is_day_and_end(time) and not repeat.walls:
        # "Every 20 minutes on friday until noon"
        within = Said(time.last, Constraint.BEFORE, within=wall_of(time.first))
        return _until(repeat, within, time.last)
    return replace(repeat, starting=time.first, until=_of_night(time.last, time.first))


def _is_day_and_end(time: Range) -> bool:
    """Whether it is a day, and when on it something is over."""
    days = replace(wall_of(time.first), days=None) == Wall() and wall_of(time.first).days is not None
    return days and isinstance(time.last, Wall) and time.last.days is None


def _for_so_long(repeat: Repeat, said: Said, time: Duration) -> Repeat | None:
    """Give a repetition that begins, or is over, so long from now: "every six hours, starting in an hour"."""
    begins = from_now(said)
    if begins is not None and repeat.every is not None:
        return replace(repeat, starting=begins)
    # "Twice a day for two minutes" says how long each lasts.
    step = repeat.every.seconds if repeat.every is not None else _apart(repeat)
    lasting = said.constraint is Constraint.FOR and time.seconds >= step
    return replace(repeat, until=Offset(time)) if lasting or said.constraint is Constraint.BEFORE else None


def from_now(said: Said) -> Offset | None:
    """Give a moment that is so long from now: "in an hour"."""
    counts = isinstance(said.time, Duration) and said.constraint is Constraint.AT and said.preposition == "in"
    return Offset(said.time) if isinstance(said.time, Duration) and counts else None


def _until(repeat: Repeat, said: Said, end: Time) -> Repeat | None:
    """Give a repetition with its end, on the day of that: "every hour on thursday until noon"."""
    if repeat.apart:
        # "Three alarms ten minutes apart before seven": how many is said, and any of them may be then.
        return None
    day = said.within
    on_day = replace(repeat, starting=day, until=day)
    if day is not None and isinstance(end, Wall) and _is_on_day(on_day):
        return _in_hours_of_day(on_day, day, replace(said, time=replace(end, days=None)))
    return replace(repeat, until=end)


def _ended(repeat: Repeat, said: Said) -> Repeat | None:
    """Give what begins at a time with its end: "every two hours at ten until six"."""
    if _is_on_day(repeat) and isinstance(repeat.starting, Wall):
        return _in_hours_of_day(repeat, repeat.starting, said)
    begins = repeat.until is None and isinstance(repeat.starting, Wall)
    if not begins or said.constraint is not Constraint.BEFORE or not isinstance(said.time, Wall):
        return None
    return replace(repeat, until=said.time)


def _is_on_day(repeat: Repeat) -> bool:
    """Whether it is done by an interval on one day, or in a part of it: "every hour tomorrow"."""
    day = repeat.starting
    whole = isinstance(day, Wall) and day.days is not None and day.clock is None
    return whole and repeat.until == day and repeat.every is not None and not repeat.walls


def _in_hours_of_day(repeat: Repeat, day: Wall, said: Said) -> Repeat | None:
    """Give what is done by an interval on one day, in hours of it: "until noon", "from ten until two"."""
    time = said.time
    if isinstance(time, Range) and is_of_day(time.first) and is_of_day(time.last):
        begins = joined(day, time.first)
        return None if begins is None else replace(repeat, starting=begins, until=_of_night(time.last, day))
    if not is_of_day(time):
        return None
    if day.part is not None and said.constraint is Constraint.BEFORE:
        return replace(repeat, until=_of_night(time, day))
    hours = _on_side(replace(day, weak=False), time, said.constraint)
    return None if hours is None else replace(repeat, starting=hours, until=hours)


def _of_night(end: Time, day: Time) -> Time:
    """Give an hour of the night that is said: "tonight, every two hours until two"."""
    part = wall_of(day).part
    if part is None or part.half is not Half.NIGHT or not isinstance(end, Wall) or end.clock is None:
        return end
    return replace(end, clock=halved(end.clock, part.half))


def _apart(repeat: Repeat) -> float:
    """Give how far apart in seconds the days of a repetition are, on the whole: weekdays, or all."""
    weekdays = {wall.days.weekday for wall in repeat.walls if isinstance(wall.days, Fields)}
    weekly = all(is_weekday(wall.days) for wall in repeat.walls)
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
    return isinstance(time, Wall) and time.is_timed and time.days is None


def within_hours(repeat: Repeat, first: Wall, last: Wall) -> Repeat | None:
    """Give a repetition within hours of the day: every weekday from 9 to 5, every night from dusk on."""
    if len({wall.part for wall in repeat.walls}) > 1:
        # "From six to eight, morning and evening"
        each = [within_hours(replace(repeat, walls=(wall,)), first, last) for wall in repeat.walls]
        walls = tuple(wall for one in each if one is not None for wall in one.walls)
        return None if None in each else replace(repeat, walls=walls)
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
