"""What the two ends of a range lend each other: "from 5 to 6 pm", "monday 9 to 5"."""

from dataclasses import replace

from fuzzytime.language.meaning.calendar import Calendar, Fields, is_weekday
from fuzzytime.language.meaning.days.relations import Deictic
from fuzzytime.language.meaning.expressions import Wall
from fuzzytime.language.meaning.times_of_day import Clock, Half, Part
from fuzzytime.requirement import Unit

NOON_HOUR = 12


BEFORE = 2 * 3600
"""Seconds before a part of the day in which what is named by it may be: "5pm - evening feed"; estimated."""


def closes(wall: Wall) -> bool:
    """Whether it is "close", which may be a hedge: "close to noon"."""
    return wall.weak and wall.part is not None and wall.part.is_point


def is_meal(wall: Wall) -> bool:
    """Whether it is a meal of a day that is not said, or may be none."""
    return wall.part is not None and (wall.weak or (wall.part.meal and wall.days is None))


def is_one(first: Wall, last: Wall) -> bool:
    """Whether a dash stands between parts of one time: "friday - june 19", "6 january - 6:30".

    So it does before the part of the day of an hour, which names what is then: "6.45am - morning feed". A
    number behind a date is a day: "march 10 - 17".
    """
    if first.clock is not None and last.part is not None and last.days is None and last.clock is None:
        return _is_part_of(first.clock, last.part)
    if first.days is None and last.days is not None and not last.is_timed:
        # As in "10:00 - march 5".
        return first.clock is not None and last.days.grain is Unit.DAY and not _is_ordinal(first, last)
    if first.days is None or first.clock is not None:
        return False
    if first.days.grain is not Unit.DAY:
        # "Next week - friday 5 pm"
        return first.days.grain is Unit.WEEK and is_weekday(last.days)
    if last.days is None:
        return not _is_ordinal(last, first)
    if first.part is not None or last.part is not None or last.clock is not None:
        return False
    return _says_again(first.days, last.days) or _says_again(last.days, first.days)


def _is_part_of(clock: Clock, part: Part) -> bool:
    """Whether no moment that a clock time may mean is well before a part of the day, and one is in it."""
    wide = not (part.is_point or part.meal)
    moments = clock.candidates()
    begin = 0 if part.half is Half.AM else part.start - BEFORE
    near = [moment for moment in moments if begin <= moment <= part.end]
    return wide and bool(near) and all(moment in near or moment > part.end for moment in moments)


def _is_ordinal(number: Wall, day: Wall) -> bool:
    """Whether a number beside a date, or beside another number, is a day of the month."""
    return number.bare and (day.bare or (isinstance(day.days, Fields) and day.days.day is not None))


def _says_again(weekday: Calendar, day: Calendar) -> bool:
    """Whether one is a weekday, and the other a date without one."""
    named = weekday.of if isinstance(weekday, Deictic) else weekday
    dated = isinstance(day, Fields) and day.day is not None and day.weekday is None
    return is_weekday(named) and dated


def comparable(first: Wall, last: Wall) -> bool:
    """Whether two can be the ends of one range: a year and a clock time cannot."""
    for one, other in ((first, last), (last, first)):
        coarse = one.days is not None and one.days.grain is not Unit.DAY and one.clock is None
        if coarse and other.clock is not None and other.days is None:
            return False
    return True


def begins_before_part(first: Wall, last: Wall) -> bool:
    """Whether a range begins before the part of the day that it ends in: "10 to 2 in the afternoon"."""
    late = last.part is None or last.part.half is not Half.PM
    if late or first.clock is None or last.clock is None:
        return False
    return first.clock.is_open and first.clock.hour % NOON_HOUR > last.clock.hour % NOON_HOUR


def lent(first: Wall, last: Wall) -> tuple[Wall, Wall] | None:
    """Lend each end what only the other says: "july 13 to 15", "from 5 to 6pm tomorrow"."""
    if (first.clock is None) != (last.clock is None):
        bare = first if first.clock is not None else last
        other = last if first.clock is not None else first
        if bare.bare and isinstance(other.days, Fields) and other.days.day is not None:
            # A number beside a date is a day of the month.
            day = Fields(day=bare.clock.hour) if bare.clock is not None else None
            if day is None or not 1 <= (day.day or 0) <= 31:
                return None
            dated = Wall(day, weak=other.weak)
            first, last = (dated, last) if bare is first else (first, dated)
    if first.clock is not None and last.clock is not None:
        days = first.days or last.days
        zone = first.zone or last.zone
        part = None if first.days and last.days else first.part or last.part
        # The other end's day, where it says one itself, is its own.
        own = first.part or (None if begins_before_part(first, last) else part)
        first = replace(first, days=first.days or days, zone=zone, part=own)
        last = replace(last, zone=zone, part=last.part or part)
        if last.days == first.days:
            last = replace(last, days=None)
    return first, last
