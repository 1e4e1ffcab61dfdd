"""Times said beside each other: one time of both."""

from dataclasses import replace

from fuzzytime.language.meaning.calendar import Calendar, Fields, is_day_of_month, is_weekday
from fuzzytime.language.meaning.days.relations import Away, Deictic, Relative
from fuzzytime.language.meaning.days.side_by_side import narrowed, same_day, weekday_at
from fuzzytime.language.meaning.expressions import Duration, HourMark, Range, Said, Wall
from fuzzytime.language.meaning.feasts import Feast
from fuzzytime.language.meaning.joined.distances import said_length
from fuzzytime.language.meaning.joined.range_ends import begins_before_part
from fuzzytime.language.meaning.times_of_day import Clock, Half, Part
from fuzzytime.requirement import STRETCHES, Constraint, Unit

HALF_PAST = 30
"""Minutes past an hour that are hardly said as those to the next."""

LONG = frozenset({Unit.MONTH, Unit.QUARTER, Unit.YEAR})
"""Periods that no clock time lies on."""


def _is_ordinal(wall: Wall) -> bool:
    """Whether it is a day of the month alone, which may be an ordinal of anything."""
    return wall.weak and is_day_of_month(wall.days) and wall.clock is None


def _is_number(clock: Clock | None) -> bool:
    """Whether it is a clock time that may be nothing but a number."""
    return clock is not None and clock.grain is Unit.HOUR and clock.half is None


def _is_month(wall: Wall) -> bool:
    """Whether it is nothing but a month."""
    return wall.weak and wall.days is not None and wall.days.grain is Unit.MONTH and wall.clock is None


def _one_day(first: Calendar, second: Calendar) -> Calendar | None:
    """Give what two days mean together: a day said again is taken at its word, the date."""
    if isinstance(first, Away) and isinstance(second, Fields) and second.weekly:
        if isinstance(first.anchor, Feast):
            # "The day after easter monday", "two weeks after easter monday"
            return None
        if first.unit is not Unit.DAY:
            return weekday_at(first, second)
    if same_day(first, second):
        return _told_by(second, first)
    return _told_by(first, second) if same_day(second, first) else narrowed(first, second)


def _told_by(date: Calendar, again: Calendar) -> Calendar:
    """Give a date with what is said of it beside it: "this friday (jun 15)", "tomorrow, the 5th"."""
    if not isinstance(date, Fields):
        return date
    if isinstance(again, Deictic):
        both = (date.joined(again.of) if isinstance(again.of, Fields) else None) or date
        # "Last friday the 8th"
        return replace(again, of=both) if again.which.offset < 0 else both
    # "Early in the day wednesday" does not say that it is today.
    return date if date.weekly and again == Relative(0) else replace(date, told=again)


def in_hour_of(mark: HourMark, wall: Wall) -> Wall | None:
    """Give "half past" in the hour of a clock time before it; None for "five to", and where that is later."""
    clock = wall.clock
    if not mark.open or clock is None or clock.shift or not clock.minute < mark.minute <= HALF_PAST:
        return None
    return replace(wall, clock=replace(clock, minute=mark.minute, grain=Unit.MINUTE, bare=False))


def _are_two(clock: Clock, part: Part) -> bool:
    """Whether a clock time and a part of the day are two times."""
    if clock.full_day and not part.is_near(clock.seconds):
        # "At sunup, noon and sundown" are three.
        return True
    # "At eight noon and six"; but "12 noon"
    return part.is_point and part.start not in clock.candidates()


def joined(first: Wall, second: Wall) -> Wall | None:
    """Give two wall-clock expressions as one, or None where they say the same thing twice."""
    # "Dinner on thursday" is a thing with its time; "tomorrow lunch" is a time.
    if (first.bare and second.bare) or (first.weak and first.part is not None):
        return None
    if second.weak and second.part is not None and (second.part.place or (first.clock and second.part.meal)):
        # "Gym at noon, lunch at one"
        return None
    # "The second on friday" is another thing's; "friday the second" is a day.
    if _is_ordinal(first) and is_weekday(second.days):
        return None
    if first.days is not None and _is_month(second) and _is_number(first.clock):
        # "Tue 10 march" is on the tenth.
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
    if clock is not None and part is not None and _are_two(clock, part):
        return None
    if days is not None and days.grain in LONG and (clock is not None or part is not None):
        # "Call April at five", "on a clear night in May"
        return None
    if clock is not None and (clock.bare or clock.pair):
        clock = replace(clock, bare=False, pair=False)
    weak = first.weak and second.weak
    return Wall(days, part, clock, first.zone or second.zone, weak)


def refined(said: Said, wall: Wall) -> Said | None:
    """Give a bound whose time lies on a day, or in a part of the day, that was said beside it."""
    if wall.clock is not None:
        return None
    time = said.time
    parted = isinstance(time, Wall) and time.part is not None and time.days is None
    # "Tomorrow sometime in the afternoon"; but "today or tomorrow" has two of each part of the day.
    sometime = said.preposition == "sometime" and parted
    beside = said.constraint is None and bool(said.hedges or said.preposition == "around" or sometime)
    starts = said.lasting is not None and isinstance(time, Wall) and time.clock is not None
    if not (said.constraint in STRETCHES or beside or starts):
        return None
    if isinstance(time, Wall) and time.part is not None and time.days is None:
        # As in "after breakfast tomorrow", "before sunset tonight".
        near = wall.part is None or (
            said.constraint in {Constraint.BEFORE, Constraint.AFTER}
            and (time.part.half is Half.AM) is (wall.part.half is Half.AM)
        )
        whole = wall.days is not None and wall.days.grain is Unit.DAY and near
        return replace(said, time=replace(time, days=wall.days, weak=False)) if whole else None
    if isinstance(time, Wall) and (time.clock is not None or _is_day_of(wall, time)):
        both = joined(time, wall)
        return None if both is None else replace(said, time=both)
    if isinstance(time, Range) and isinstance(time.first, Wall) and isinstance(time.last, Wall):
        first, last = joined(_as_clock(time.first), wall), time.last
        if first is not None and _is_weekday(time.first) and _is_weekday(last):
            # "Next week between wednesday and friday"
            last = joined(last, wall) or last
            return replace(said, time=replace(time, first=first, last=last))
        # "First monday 1 pm to 3 pm of next month" is one of its days; two days are their own.
        period = wall.days is not None and wall.days.grain is not Unit.DAY and last.days is None
        if first is None or (time.first.days is not None and not period):
            return None
        if wall.part is not None and last.part is None and last.clock is not None:
            last = replace(last, part=wall.part)
            first = replace(first, part=None) if begins_before_part(first, last) else first
        return replace(said, time=replace(time, first=first, last=last))
    return None


def _is_day_of(period: Wall, day: Wall) -> bool:
    """Whether it is a day that each such period has: "next week before friday", "next month by the 10th"."""
    if period.weak or period.days is None or day.part is not None:
        return False
    return (period.days.grain is Unit.WEEK and is_weekday(day.days)) or (
        period.days.grain is Unit.MONTH and is_day_of_month(day.days)
    )


def _as_clock(wall: Wall) -> Wall:
    """Give a number, or a meal, that is the end of a range for the time that it is: "from two to four"."""
    return replace(wall, weak=False, clock=None if wall.clock is None else replace(wall.clock, bare=False))


def _is_weekday(wall: Wall) -> bool:
    """Whether it is a day of any week, and no time of it."""
    return is_weekday(wall.days) and wall.clock is None and wall.part is None


def lasts_then(length: Duration) -> Said:
    """Give the new length of what goes on for another: "from ten minutes to fifteen"."""
    return said_length(length, Constraint.FOR, "to")
