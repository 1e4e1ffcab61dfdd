"""Repetitions by an interval on some days: "every five minutes on weekdays", "every hour on thursday"."""

from dataclasses import replace

from fuzzytime.language.meaning.calendar import Cycle
from fuzzytime.language.meaning.expressions import HourMark, Offset, Range, Repeat, Said, Time, Wall
from fuzzytime.language.meaning.joined.beside import joined
from fuzzytime.language.meaning.joined.bounded_repeats import bounded_repeat, is_of_day
from fuzzytime.language.meaning.units import UNIT_SECONDS
from fuzzytime.requirement import Constraint, Unit


def on_days(one: Repeat, other: Repeat) -> Repeat | None:
    """Give what is done every so often, within each of some days or hours; None where neither says days.

    Bounds of the interval that are times of day are hours of the days: "every hour until noon on mondays".
    """
    if one.walls:
        one, other = other, one
    if [wall.days for wall in other.walls] == [Cycle(Unit.DAY)] and other.skip == 1 and _is_whole(other):
        # "Every hour, day by day"
        return one
    days = _with_hours(other, one)
    if one.every is None or one.walls or one.times is not None or one.apart or one.closing is not None:
        return None
    if one.every.seconds > UNIT_SECONDS[Unit.DAY] / 2 or days is None or not _are_stretches(days):
        return None
    mark = one.starting if isinstance(one.starting, HourMark) else None
    return replace(one, starting=mark, until=None, within=days)


def is_interval(repeat: Repeat) -> bool:
    """Whether it is done every so often, more than once a day, on days that are not said."""
    short = repeat.every is not None and repeat.every.seconds <= UNIT_SECONDS[Unit.DAY] / 2
    counted = repeat.times is not None or repeat.apart or repeat.shared or repeat.closing is not None
    bounds = (bound for bound in (repeat.starting, repeat.until) if bound is not None)
    return short and not counted and not repeat.walls and repeat.within is None and all(map(_is_open, bounds))


def _is_open(bound: Time) -> bool:
    """Whether it is a time of any day, or so long after one."""
    return is_of_day(bound.anchor if isinstance(bound, Offset) else bound)


def on_one_day(interval: Repeat, day: Wall) -> Repeat | None:
    """Give what is done every so often on one day, within its hours: "on thursday every hour until noon"."""
    if not is_interval(interval) or day.days is None or day.clock is not None:
        return None
    first, last = interval.starting, interval.until
    whole = replace(interval, starting=day, until=day)
    if isinstance(first, Offset):
        # "Every hour after ten" is an hour after that, and so on.
        begun = on_one_day(replace(interval, starting=first.anchor), day)
        return begun and replace(begun, starting=replace(first, anchor=begun.starting))
    if is_of_day(first):
        begins = joined(day, first)
        return None if begins is None else replace(whole, starting=begins, until=last or day)
    return whole if last is None else bounded_repeat(whole, Said(last, Constraint.BEFORE))


def _with_hours(days: Repeat, interval: Repeat) -> Repeat | None:
    """Give days with the hours that bound an interval; None for other bounds than hours."""
    first, last = interval.starting, interval.until
    if first is None or isinstance(first, HourMark):
        return days if last is None else _bounded(days, last, Constraint.BEFORE)
    if last is None:
        return _bounded(days, first, Constraint.AFTER)
    hours = Said(Range(first, last), Constraint.BETWEEN)
    return bounded_repeat(days, hours) if is_of_day(first) and is_of_day(last) else None


def _bounded(days: Repeat, time: Time, side: Constraint) -> Repeat | None:
    return bounded_repeat(days, Said(time, side)) if is_of_day(time) else None


def _is_whole(days: Repeat) -> bool:
    """Whether all of each day is said."""
    bounded = days.starting is not None or days.until is not None
    return not bounded and all(wall.clock is None and wall.part is None for wall in days.walls)


def _are_stretches(days: Repeat) -> bool:
    """Whether they are days, or parts of days, and no moments."""
    return bool(days.walls) and all(wall.clock is None for wall in days.walls)
