"""From a repetition as said to its occurrences."""

import math
from dataclasses import replace
from datetime import timedelta
from typing import TypeGuard

from fuzzytime.language.meaning.calendar import Cycle, Fields
from fuzzytime.language.meaning.expressions import (
    Duration,
    HourMark,
    Offset,
    Range,
    Repeat,
    Time,
    TimeWord,
    Wall,
)
from fuzzytime.language.meaning.grounded.moment import Moment
from fuzzytime.language.meaning.grounded.range_instants import first_after, half_before
from fuzzytime.language.meaning.instants import SUB_DAY, Instants, halved, midnight
from fuzzytime.language.meaning.recurrences.delayed_recurrence import ClosingRecurrence
from fuzzytime.language.meaning.recurrences.recurrence import JUST_BEFORE, CalendarRecurrence, EvenRecurrence
from fuzzytime.language.meaning.recurrences.recurrence_by_months import RecurrenceByMonths, is_by_months
from fuzzytime.language.meaning.recurrences.recurrence_on_days import RecurrenceOnDays
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS
from fuzzytime.language.meaning.ungrounded import UngroundedError
from fuzzytime.language.meaning.units import UNIT_SECONDS
from fuzzytime.requirement import Unit

WEEK = 7
"""Days."""

Series = EvenRecurrence | CalendarRecurrence | ClosingRecurrence | RecurrenceByMonths | RecurrenceOnDays
"""The kinds of repetitions."""


def recurrence_of(repeat: Repeat, moment: Moment) -> Series:
    """Ground a repetition.

    Raises
    ------
    UngroundedError
        If it needs a clock that is not known.
    """
    if repeat.closing is not None and repeat.every is not None:
        return ClosingRecurrence(step=repeat.every.seconds, stretch=repeat.closing.seconds)
    if repeat.within is not None and repeat.every is not None:
        mark = repeat.starting.minute * 60.0 if isinstance(repeat.starting, HourMark) else 0.0
        step = repeat.every.seconds
        days = _on_calendar(repeat.within, moment)
        return RecurrenceOnDays(days=days, step=step, offset=mark, length=step if repeat.shared else 0.0)
    if repeat.at is not None and repeat.every is not None:
        return _on_calendar(_on_days(repeat, repeat.at, repeat.every.seconds / DAY_SECONDS, moment), moment)
    if repeat.walls and not _is_even(repeat):
        return _on_calendar(repeat, moment)
    first, last = _bounds(repeat, moment)
    if repeat.apart:
        raise UngroundedError("how many times is not said")
    if repeat.times is not None and (repeat.every is not None or last is not None):
        return _counted(repeat, repeat.times, first or 0.0, last, moment)
    if repeat.every is None:
        raise UngroundedError("a repetition must say how often")
    if repeat.walls and moment.now is not None and is_by_months(repeat.every):
        return _by_months(repeat.every, repeat.starting, last, moment)
    step = repeat.every.seconds
    sub_day = all(unit in SUB_DAY for _, unit in repeat.every.terms)
    # "Every day", "every two weeks": any time in a day, in a week; "twice a day": in each half of one.
    length = step if repeat.shared else UNIT_SECONDS[repeat.every.unit] if repeat.walls else 0.0
    start = first if first is not None else (step if sub_day and not length else 0.0)
    if sub_day and last is not None and 0.0 < last < start:
        # "Every hour from dawn till dusk", said in the morning: it goes on already.
        start = 0.0
    if _is_of_one_day(repeat) and last is not None:
        # None begins when the day is over.
        return EvenRecurrence(step=step, first=start, last=last - JUST_BEFORE, length=length, all_day=True)
    return EvenRecurrence(step=step, first=start, last=math.inf if last is None else last, length=length)


def _counted(repeat: Repeat, times: int, first: float, last: float | None, moment: Moment) -> EvenRecurrence:
    """Ground a repetition that is done so many times."""
    if repeat.every is None:
        # "Twice today": once in each half of what is left of it.
        start, end = max(0.0, first), math.inf if last is None else last
        step = (end - start) / times
        return EvenRecurrence(step=step, first=start, last=end - JUST_BEFORE, length=step)
    # "Twice, an hour apart"
    step = repeat.every.seconds
    opens = moment.policy.plausible_from
    wakes = opens.hour * 3600.0 + opens.minute * 60.0 if begins_by_policy(repeat) else 0.0
    start = max(0.0, first + wakes)
    over = start + (times - 1) * step
    return EvenRecurrence(
        step=step,
        first=start,
        last=over if last is None else min(over, last),
        length=DAY_SECONDS if _begins_on_day(repeat.starting) and step >= DAY_SECONDS else 0.0,
        counted=last is None,
    )


def recurrence_that_comes(repeat: Repeat, moment: Moment) -> Series:
    """Ground a repetition whose bounds are its own.

    Raises
    ------
    UngroundedError
        If it is over before it comes: "every monday until friday", said on a tuesday.
    """
    found = recurrence_of(repeat, moment)
    if found.endless or repeat.lent or _comes(found):
        return found
    raise UngroundedError("a repetition must come at least once")


def _comes(series: Series) -> bool:
    """Whether a repetition with an end comes before it."""
    if isinstance(series, CalendarRecurrence):
        return bool(series.coming(1))
    if isinstance(series, EvenRecurrence):
        soon = max(series.first, 0.0) + 2 * series.step
        return bool(series.occurrences(min(series.last, soon)))
    return True


def _by_months(
    every: Duration, starting: Time | None, last: float | None, moment: Moment
) -> RecurrenceByMonths:
    """Give what is done every so many months or years, from today on where no first day is said."""
    here = moment.grounding()
    begins = here.now if starting is None or isinstance(starting, TimeWord) else here.instants(starting).start
    amount, unit = every.terms[0]
    until = math.inf if last is None else last
    return RecurrenceByMonths(amount=int(amount), unit=unit, begins=begins, moment=moment, last=until)


def _on_days(repeat: Repeat, at: Wall, days: float, moment: Moment) -> Repeat:
    """Give the days, so many apart, of what has a time of day; those of a week begin today."""
    turns = WEEK / days
    if not math.isclose(turns, round(turns)):
        return replace(
            repeat, every=None, at=None, walls=(replace(at, days=Cycle(Unit.DAY)),), skip=round(days)
        )
    today = moment.grounding().now.weekday()
    weekdays = [(today + math.ceil(turn * days)) % WEEK for turn in range(round(turns))]
    walls = tuple(replace(at, days=Fields(weekday=weekday)) for weekday in weekdays)
    return replace(repeat, every=None, at=None, walls=walls)


def _on_calendar(repeat: Repeat, moment: Moment) -> CalendarRecurrence:
    moment.grounding()
    first, last = _bounds(repeat, moment)
    found = CalendarRecurrence(
        walls=repeat.walls,
        moment=moment,
        skip=repeat.skip,
        first=0.0 if first is None else max(0.0, first),
        last=math.inf if last is None else last,
    )
    counted = first is None and isinstance(repeat.until, Offset) and repeat.until.anchor is None
    # "For three mornings", said in the first of them: two more.
    return replace(found, last=found.last - found.begun - JUST_BEFORE) if counted and found.begun else found


def begins_by_policy(repeat: Repeat) -> bool:
    """Whether of turns so many hours apart only the day is said: "three times tomorrow, an hour apart"."""
    counted = repeat.times is not None and repeat.every is not None and repeat.every.seconds < DAY_SECONDS
    return counted and _begins_on_day(repeat.starting)


def _begins_on_day(first: Time | None) -> TypeGuard[Wall]:
    """Whether nothing but a day, or more, says when the first is: at none of its hours in the night."""
    return isinstance(first, Wall) and first.days is not None and first.clock is None and first.part is None


def _is_of_one_day(repeat: Repeat) -> bool:
    """Whether it is done by an interval all through one day, or the rest of it: "every hour on thursday"."""
    first, last = repeat.starting, repeat.until
    interval = repeat.every is not None and not repeat.walls
    one = _begins_on_day(last) and last.days is not None and last.days.grain is Unit.DAY
    return interval and one and isinstance(first, Wall) and isinstance(last, Wall) and first.days == last.days


def _is_even(repeat: Repeat) -> bool:
    """Whether days are counted from today: "every two days", without a time of day."""
    return repeat.every is not None and all(wall.clock is None and wall.part is None for wall in repeat.walls)


def _bounds(repeat: Repeat, moment: Moment) -> tuple[float | None, float | None]:
    """Give where a repetition begins and is over: of two times of day, one may say the day of both."""
    first, last = bounds_said(repeat)
    # "Twice on friday": both bounds are that friday's.
    one = _is_of_one_day(repeat) or (repeat.times is not None and first == last)
    both = None if one else _as_range(first, last)
    if both is not None:
        found = moment.grounding().instants(both)
        return moment.seconds(found.start), moment.seconds(found.end)
    hours = hours_of_turns(first, last, moment)
    if hours is not None:
        over = moment.seconds(hours.end, hours.zone)
        return _next_turn(repeat, moment.seconds(hours.start, hours.zone), over), over
    begins, ends = _bound(first, moment, last=False), _bound(last, moment, last=True)
    gone = begins is not None and ends is not None and ends <= 0 < begins
    if gone and _is_timed(first) and _is_timed(last):
        # "Every hour between seven and nine", said at nine: the next seven and the nine behind it.
        found = moment.grounding().instants(Range(first, last))
        return moment.seconds(found.start), moment.seconds(found.end)
    return begins, ends


def _next_turn(repeat: Repeat, begins: float, ends: float) -> float:
    """Give when the next turn is of a stretch that may be on: now, where none is left in it."""
    if begins >= 0.0 or repeat.every is None:
        return begins
    coming = begins % repeat.every.seconds
    return coming if coming <= ends else 0.0


def _as_range(first: Time | None, last: Time | None) -> Range | None:
    """Give two bounds as a range, where one tells when the other is; None where each stands for itself."""
    if _is_timed(first) and _is_timed(last) and (first.days is None) is not (last.days is None):
        # "Every ten minutes from three to four tomorrow"
        return Range(first, last)
    if _begins_on_day(first) and _begins_on_day(last):
        # "Every evening from monday to wednesday": the wednesday behind that monday.
        return Range(first, last)
    return None


def bounds_said(repeat: Repeat) -> tuple[Time | None, Time | None]:
    """Give where a repetition begins and is over, the first in the half of the day that the last tells."""
    first, last = repeat.starting, repeat.until
    if (
        isinstance(first, Wall)
        and first.clock is not None
        and isinstance(last, Wall)
        and last.clock is not None
    ):
        return replace(first, clock=half_before(first.clock, last.clock)), last
    return first, last


def _is_timed(time: Time | None) -> TypeGuard[Wall]:
    """Whether it is a time of day, of any day or of one."""
    return isinstance(time, Wall) and (time.clock is not None or time.part is not None)


def _bound(time: Time | None, moment: Moment, *, last: bool) -> float | None:
    if time is None:
        return None
    if isinstance(time, TimeWord):
        return 0.0
    found = moment.grounding().instants(time)
    return moment.seconds(found.end if last else found.start)


def hours_of_turns(first: Time | None, last: Time | None, moment: Moment) -> Instants | None:
    """Give the stretch that is on, or the next one; None where no two clock times of any day bound it.

    It is on if it ends where the last time alone would: "every hour from nine to five", said at noon.

    Raises
    ------
    UngroundedError
        If no clock is known.
    """
    if not isinstance(first, Wall) or not isinstance(last, Wall) or first.clock is None or last.clock is None:
        return None
    if first.days is not None or last.days is not None:
        return None
    zone = first.zone or last.zone
    here = moment.grounding(zone)
    ended = here.instants(last)
    over, ends = ended.start, last.clock if last.part is None else halved(last.clock, last.part.half)
    begins = first.clock if first.part is None else halved(first.clock, first.part.half)
    days = (midnight(over.date()) - timedelta(days=back) for back in (0, 1))
    begun = [day + timedelta(seconds=seconds) for day in days for seconds in begins.candidates()]
    on = [start for start in begun if start <= here.now < over == first_after(start, ends)]
    found = replace(ended, start=max(on), choices=()) if on else here.instants(Range(first, last))
    return replace(found, zone=zone)
