"""Times said beside each other, or apart for the same thing to be done: one time of both."""

from dataclasses import replace
from typing import TypeGuard

from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields
from fuzzytime.language.meaning.expressions import (
    Coming,
    Duration,
    HourMark,
    Offset,
    Range,
    Repeat,
    Said,
    Time,
    Wall,
)
from fuzzytime.language.meaning.feasts import Feast, Season
from fuzzytime.language.meaning.first_times import closing_of, first_time, in_the_end, is_release
from fuzzytime.language.meaning.instants import halved
from fuzzytime.language.meaning.nested import Share
from fuzzytime.language.meaning.relations import Away, narrowed, same_day, weekday_at
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS, Clock, Half, Part
from fuzzytime.language.policy import Policy
from fuzzytime.requirement import Constraint, Unit

PLAUSIBLE = Policy().plausible_from
"""From when on the hours of a day are that a repetition is bound to."""

LONG = frozenset({Unit.MONTH, Unit.QUARTER, Unit.YEAR})
"""Periods that no clock time lies on."""

MOMENTS = frozenset({None, Constraint.AT})
"""How a time binds that says when."""


def _is_ordinal(wall: Wall) -> bool:
    """Whether it is a day of the month alone, which may be an ordinal of anything."""
    days = wall.days
    return wall.weak and isinstance(days, Fields) and days == Fields(day=days.day) and wall.clock is None


def _one_day(first: Calendar, second: Calendar) -> Calendar | None:
    """Give what two days mean together: a day said again is taken at its word, the date."""
    if isinstance(first, Away) and isinstance(second, Fields) and second.weekly:
        if first.unit is not Unit.DAY:
            return weekday_at(first, second)
        if isinstance(first.anchor, Feast):
            # "The day after easter monday"
            return None
    if same_day(first, second):
        return second
    return first if same_day(second, first) else narrowed(first, second)


def joined(first: Wall, second: Wall) -> Wall | None:
    """Give two wall-clock expressions as one, or None where they say the same thing twice."""
    # "Dinner on thursday" is a thing with its time; "tomorrow lunch" is a time.
    if (first.bare and second.bare) or (first.weak and first.part is not None):
        return None
    if second.weak and second.part is not None and second.part.place:
        return None
    # "The second on friday" is another thing's; "friday the second" is a day.
    if _is_ordinal(first) and isinstance(second.days, Fields) and second.days.weekly:
        return None
    # "The first twenty minutes" is no day at eight in the evening; but "14/3, 0830" is at half past eight.
    if any(
        one.weak and other.bare and other.clock is not None and other.clock.grain is not Unit.MINUTE
        for one, other in ((first, second), (second, first))
    ):
        return None
    days: Calendar | None = first.days or second.days
    if first.days is not None and second.days is not None:
        days = _one_day(first.days, second.days)
        if days is None:
            return None
    if (first.part and second.part) or (first.clock and second.clock):
        return None
    clock, part = first.clock or second.clock, first.part or second.part
    if clock is not None and part is not None and clock.full_day and not part.is_near(clock.seconds):
        # "At sunup, noon and sundown" are three.
        return None
    if days is not None and days.grain in LONG and (clock is not None or part is not None):
        # "Call April at five", "on a clear night in May"
        return None
    if clock is not None:
        clock = replace(clock, bare=False, pair=False)
    weak = first.weak and second.weak
    return Wall(days, part, clock, first.zone or second.zone, weak)


def refined(said: Said, wall: Wall) -> Said | None:
    """Give a bound whose time lies on a day, or in a part of the day, that was said beside it."""
    bounds = {Constraint.BEFORE, Constraint.AFTER, Constraint.BETWEEN}
    beside = said.constraint is None and bool(said.hedges or said.preposition == "around")
    starts = said.lasting is not None and isinstance(said.time, Wall) and said.time.clock is not None
    if not (said.constraint in bounds or beside or starts) or wall.clock is not None:
        return None
    if said.preposition == "sometime":
        # "Today or tomorrow" has two of each part of the day
        return None
    if isinstance(said.time, Wall) and said.time.part is not None and said.time.days is None:
        # As in "after breakfast tomorrow", "before sunset tonight".
        near = wall.part is None or (
            said.constraint in {Constraint.BEFORE, Constraint.AFTER}
            and (said.time.part.half is Half.AM) is (wall.part.half is Half.AM)
        )
        whole = wall.days is not None and wall.days.grain is Unit.DAY and near
        return replace(said, time=replace(said.time, days=wall.days, weak=False)) if whole else None
    if isinstance(said.time, Wall) and said.time.clock is not None:
        time = joined(said.time, wall)
        return None if time is None else replace(said, time=time)
    if (
        isinstance(said.time, Range)
        and isinstance(said.time.first, Wall)
        and isinstance(said.time.last, Wall)
    ):
        first, last = joined(_as_clock(said.time.first), wall), said.time.last
        if first is not None and _is_weekday(said.time.first) and _is_weekday(last):
            # "Next week between wednesday and friday"
            last = joined(last, wall) or last
            return replace(said, time=Range(first, last))
        if first is None or said.time.first.days is not None:
            return None
        if wall.part is not None and last.part is None and last.clock is not None:
            last = replace(last, part=wall.part)
        return replace(said, time=Range(first, last))
    return None


def _as_clock(wall: Wall) -> Wall:
    """Give a number, or a meal, that is the end of a range for the time that it is: "from two to four"."""
    return replace(wall, weak=False, clock=None if wall.clock is None else replace(wall.clock, bare=False))


def _is_weekday(wall: Wall) -> bool:
    """Whether it is a day of any week, and no time of it."""
    return isinstance(wall.days, Fields) and wall.days.weekly and wall.clock is None and wall.part is None


def _named_days(repeat: Repeat, wall: Wall) -> Calendar | None:
    """Give the day that a period is said to have: every year on the 4th of july, every week on friday."""
    days = wall.days
    yearly = isinstance(days, Share) and isinstance(days.of, Season)
    if yearly and len(repeat.walls) == 1 and repeat.walls[0].days == Cycle(Unit.YEAR) and repeat.skip == 1:
        return days
    if len(repeat.walls) != 1 or not isinstance(days, Fields) or days.fixed or wall.weak:
        return None
    period = repeat.walls[0].days
    if repeat.skip != 1 and period != Cycle(Unit.WEEK):
        return None
    if period == Cycle(Unit.YEAR) and days.month is not None:
        return days
    if period == Cycle(Unit.MONTH) and days == Fields(day=days.day) and days.day is not None:
        return days
    return days if period == Cycle(Unit.WEEK) and days.weekly else None


def names_day_of(repeat: Repeat, wall: Wall) -> bool:
    """Whether it is the day that a period is said to have."""
    return _named_days(repeat, wall) is not None


def narrowed_repeat(repeat: Repeat, wall: Wall) -> Repeat | None:
    """Give a repetition at a time of day, in a part of the day, or within days that are said beside it."""
    days = _named_days(repeat, wall)
    if days is not None:
        return replace(repeat, every=None, walls=(replace(wall, days=days),))
    if wall.days is not None and wall.clock is None and wall.part is None:
        if repeat.until is not None or repeat.starting is not None:
            return None
        return replace(repeat, starting=wall, until=wall)
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
        walls.append(replace(old, clock=clock, part=wall.part or old.part))
    return replace(repeat, walls=tuple(walls))


def _is_inside(inner: Part, outer: Part) -> bool:
    """Whether hours, or a part of the day, are in a part: "every morning between seven and eight" too."""
    if not inner.name:
        return outer.is_near(inner.start)
    return outer.start <= inner.start < outer.end


def bounded_repeat(repeat: Repeat, said: Said) -> Repeat | None:
    """Give a repetition with its bounds, or within hours of each day: every weekday from 9 to 5."""
    marked = isinstance(repeat.starting, HourMark) and repeat.until is None
    return _bounded_mark(repeat, said) if marked else _bounded(repeat, said)


def _bounded(repeat: Repeat, said: Said) -> Repeat | None:
    time = said.time
    if repeat.starting is not None or repeat.until is not None or isinstance(time, Repeat):
        return None
    if isinstance(time, Duration):
        # "Twice a day for two minutes" says how long each lasts.
        step = repeat.every.seconds if repeat.every is not None else DAY_SECONDS
        lasting = said.constraint is Constraint.FOR and time.seconds >= step
        bound = lasting or said.constraint is Constraint.BEFORE
        return replace(repeat, until=Offset(time)) if bound else None
    if (closing := closing_of(said)) is not None:
        return in_the_end(repeat, closing)
    if isinstance(time, Coming):
        return replace(repeat, until=Offset(time.duration))
    if repeat.walls and isinstance(time, Range) and is_of_day(time.first) and is_of_day(time.last):
        return within_hours(repeat, time.first, time.last)
    if repeat.walls and isinstance(time, Wall) and time.clock is not None and time.days is None:
        return _on_side(repeat, time.clock, said.constraint)
    if not repeat.walls and isinstance(time, Wall) and time.clock is None and said.constraint in MOMENTS:
        # "Every two hours tonight"
        return replace(repeat, starting=time, until=time)
    part = time.part if isinstance(time, Wall) and time.days is None and repeat.walls else None
    if part is not None and said.constraint in {Constraint.BEFORE, Constraint.AFTER}:
        # "Before school on tuesdays"
        before = said.constraint is Constraint.BEFORE
        hours = (0, part.start) if before else (part.end % DAY_SECONDS, DAY_SECONDS)
        return narrowed_repeat(repeat, Wall(part=Part("", *hours, Half.EITHER)))
    if said.constraint is Constraint.BEFORE:
        # "Three alarms ten minutes apart before seven": how many is said, and any of them may be then.
        return None if repeat.apart else replace(repeat, until=time)
    if is_release(said):
        first = first_time(said)
        return None if first is None else replace(repeat, starting=first)
    if said.constraint is Constraint.BETWEEN and isinstance(time, Range):
        return replace(repeat, starting=time.first, until=time.last)
    return None


def _bounded_mark(repeat: Repeat, said: Said) -> Repeat | None:
    """Give what is done at a mark of each hour, and when: "every hour on the hour overnight"."""
    time, mark = said.time, repeat.starting
    if not isinstance(time, Wall) or time.part is None or not isinstance(mark, HourMark):
        return None
    first = time.part.start + (mark.minute * 60 - time.part.start) % 3600
    within = replace(time, part=replace(time.part, start=first))
    return _bounded(replace(repeat, starting=None), replace(said, time=within))


def is_of_day(time: Time) -> TypeGuard[Wall]:
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
    return (clock if part is None else halved(clock, part.half)).first_from(PLAUSIBLE)


def _on_side(repeat: Repeat, clock: Clock, side: Constraint | None) -> Repeat | None:
    """Give a repetition on one side of a clock time of its days: every monday before seven."""
    moment = _hour_of(repeat, clock)
    hours = {Constraint.BEFORE: (0, moment), Constraint.AFTER: (moment, DAY_SECONDS)}.get(
        side or Constraint.AT
    )
    return None if hours is None else narrowed_repeat(repeat, Wall(part=Part("", *hours, Half.EITHER)))


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
    if isinstance(time, Offset) and isinstance(time.anchor, Wall):
        anchor = joined(other, time.anchor)
        return None if anchor is None else replace(said, time=replace(time, anchor=anchor))
    if isinstance(time, Wall) and said.constraint in MOMENTS:
        both = joined(other, time)
        return None if both is None else replace(said, time=both)
    return refined(said, other)
