"""Repetitions by an interval on some days: "every five minutes on weekdays"."""

from dataclasses import replace

from fuzzytime.language.meaning.bounded_repeats import bounded_repeat, is_of_day
from fuzzytime.language.meaning.calendar import Cycle
from fuzzytime.language.meaning.expressions import UNIT_SECONDS, HourMark, Range, Repeat, Said, Time
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
