"""From one time to another: ends that lend each other a day, a month, a half of the day."""

from dataclasses import replace
from datetime import datetime, time, timedelta
from itertools import islice

from fuzzytime.language.meaning.calendar import Calendar, Fields
from fuzzytime.language.meaning.days.nested import Share
from fuzzytime.language.meaning.days.relations import Relative
from fuzzytime.language.meaning.expressions import HourMark, Range, Time, TimeWord, Wall, wall_of
from fuzzytime.language.meaning.grounded.chosen_clocks import is_plausible
from fuzzytime.language.meaning.grounded.standpoint import Standpoint
from fuzzytime.language.meaning.instants import Instants, halved, midnight
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS, Clock, Half
from fuzzytime.language.meaning.ungrounded import UngroundedError
from fuzzytime.language.policy import SameWeekday

LATEST_TRIED = 3
"""Past days tried for one whose time of day has passed, too."""

LONGEST_MONTH = 31

MIDDLE = 0.5

NOON = 12


def range_instants(clock: Standpoint, said: Range) -> Instants:
    """Ground a range.

    Raises
    ------
    UngroundedError
        If it would end before it starts.
    """
    first, last = at_middle(said.first), at_middle(said.last)
    if isinstance(first, Wall) and isinstance(last, Wall) and first.clock and last.clock:
        if said.widest:
            return _day_between(clock, first, last)
        found = _clock_range(clock, first, last)
        return _under_way(clock, first, last, found) if said.within else found
    if (
        isinstance(first, Wall)
        and isinstance(last, Wall)
        and first.days is not None
        and last.days is not None
    ):
        return _day_range(clock, first, last)
    first = _on_last_day(clock, first, last)
    start = clock.instants(first)
    if isinstance(first, Wall) and first.part is not None and first.part.meal and first.clock is None:
        # "Between lunch and dinner": from its end, where that has not passed.
        start = replace(start, start=start.end)
    end = clock.instants(last)
    if isinstance(last, TimeWord) and isinstance(first, Wall) and start.start > end.start:
        return _begun_before(clock, first, start)
    clock_end = last.clock if isinstance(last, Wall) and last.days is None and last.part is None else None
    if clock_end is not None and clock_end.is_open and clock_end.half is None:
        # "From sunset until eleven": the next one, however late; "monday until ten at night" says which.
        return Instants(start.start, first_after(start.start, clock_end), start.grain)
    if end.start < start.start and isinstance(last, (Wall, HourMark)):
        end = _after(clock, start.start).instants(last)
    return Instants(start.start, end.start if end.is_point else _last_of(last, end), start.grain)


def at_middle(said: Time) -> Time:
    """Give the middle day of what is said as a bound: "from mid may to the middle of june", "by mid may"."""
    share = wall_of(said).days
    if not isinstance(said, Wall) or not isinstance(share, Share) or not 0 < share.low < share.high < 1:
        return said
    return replace(said, days=replace(share, low=MIDDLE, high=MIDDLE))


def _on_last_day(clock: Standpoint, first: Time, last: Time) -> Time:
    """Give the part of a day that a range begins with the day of its end: "between lunch and 4 tomorrow".

    Where it would end before it begins, it begins the day before: "from the evening until 10 tomorrow".
    """
    if not isinstance(first, Wall) or not isinstance(last, Wall) or first.part is None:
        return first
    if first.days is not None or first.clock is not None or last.clock is None:
        return first
    if last.part == first.part and last.days is None:
        # "In the morning until half past eight": of the next that has it.
        away = (clock.wall(last).start.date() - clock.now.date()).days
        return replace(first, days=Relative(away)) if away else first
    if last.days is None:
        return first
    there = replace(first, days=last.days)
    return there if clock.wall(there).end <= clock.wall(last).start else first


def since(clock: Standpoint, said: Wall, found: Instants) -> Instants:
    """Give the last of what is to come again: "since monday"; but "since tomorrow" names one day."""
    once = found.start <= clock.now or (said.days is not None and said.days.fixed)
    return found if once else _begun_before(clock, said, found)


def _begun_before(clock: Standpoint, first: Wall, start: Instants) -> Instants:
    """Ground a range up to now: it began at the last such time, or on the last such day.

    Raises
    ------
    UngroundedError
        If there is none.
    """
    if first.days is None:
        choices = start.choices or (start.start,)
        begun = max(choice - timedelta(days=1) for choice in choices)
        return Instants(begun, clock.now, start.grain)
    past = first.days.past(clock.today, clock.now.date() + timedelta(days=1))
    for days in islice(past, LATEST_TRIED):
        there = replace(clock, now=midnight(days.first), lasting=0.0).wall(first)
        if there.start <= clock.now:
            return Instants(there.start, clock.now, start.grain)
    raise UngroundedError("a range must not end before it starts")


def _day_range(clock: Standpoint, first: Wall, last: Wall) -> Instants:
    """Ground a range of days, which lend each other the month or the year that only one names."""
    first_days, last_days = first.days, last.days
    lent = borrowed = False
    if isinstance(first_days, Fields) and isinstance(last_days, Fields):
        lent = first_days.year is None and last_days.year is not None
        if first_days != Fields(year=first_days.year):
            # "From 2027 to may 2028" begins with its year.
            first_days = _before(first_days, last_days).filled(last_days)
        if last_days.month is None and last_days.weekday is None:
            last_days = replace(last_days, month=first_days.month, year=last_days.year or first_days.year)
        elif last_days.year is None and first_days.year is not None and last_days.month is not None:
            last_days, borrowed = replace(last_days, year=first_days.year), True
    first, last = replace(first, days=first_days), replace(last, days=last_days)
    start = clock.wall(first)
    if last_days is not None and last_days.fixed:
        end = clock.wall(last)
        if end.end < start.start and lent and isinstance(first_days, Fields):
            # "November to february 2017" begins the year before.
            year = (first_days.year or 1) - 1
            start = clock.wall(replace(first, days=replace(first_days, year=year)))
        if end.end < start.start and borrowed and isinstance(last_days, Fields):
            # "December 20 2026 to january 5" ends the year after.
            end = clock.wall(replace(last, days=replace(last_days, year=(last_days.year or 1) + 1)))
    else:
        start = _begun(clock, first, last, start)
        end = _after(clock, start.start).wall(last)
    backwards = end.start < start.start if end.is_point else end.end <= start.start
    if backwards or _turned(first_days, last_days):
        raise UngroundedError("a range must not end before it starts")
    return Instants(start.start, end.start if end.is_point else _last_of(last, end), start.grain)


def _turned(first: Calendar | None, last: Calendar | None) -> bool:
    """Whether both are days of one month of no year, the later first: "march 20 to march 10"."""
    if not isinstance(first, Fields) or not isinstance(last, Fields):
        return False
    named = first.month is not None and first.month == last.month and first.year is last.year is None
    return named and (first.day or 0) > (last.day or LONGEST_MONTH)


def _before(first: Fields, last: Fields) -> Fields:
    """Give a day in the month before that of the other, where it is later: "the 27th to the 3rd of may"."""
    if first.month is not None or first.day is None or last.month is None or last.day is None:
        return first
    if first.day <= last.day:
        return first
    year = last.year if last.year is None or last.month > 1 else last.year - 1
    return replace(first, month=last.month - 1 or 12, year=year)


def _after(clock: Standpoint, moment: datetime) -> Standpoint:
    """Give the grounding of what comes after a moment."""
    return replace(
        clock, now=moment, policy=replace(clock.policy, same_weekday=SameWeekday.NEXT), lasting=0.0
    )


def _begun(clock: Standpoint, first: Wall, last: Wall, start: Instants) -> Instants:
    """Give the start of a range of dates that is not over: "august to october", said in september."""
    days = first.days
    if not isinstance(days, Fields) or days.weekly or days.fixed or first.clock is not None:
        return start
    if start.start <= clock.now:
        return start
    dated = replace(days, weekday=None) if days.month is not None and days.day is not None else days
    before = next(dated.past(clock.today, clock.now.date()), None)
    if before is None:
        return start
    end = replace(clock, now=midnight(before.first), lasting=0.0).wall(last)
    return (
        Instants(midnight(before.first), midnight(before.end), days.grain) if end.end > clock.now else start
    )


def _clock_range(clock: Standpoint, first: Wall, last: Wall) -> Instants:
    """Ground a range of clock times: without am or pm, the shortest that they can mean."""
    start_clock, end_clock = first.clock, last.clock
    if start_clock is None or end_clock is None:
        raise UngroundedError("a range of clock times must have two")
    if first.part is not None:
        start_clock = halved(start_clock, first.part.half)
    # "Overnight from ten until six": what begins at night may end in the morning.
    late = last.part is not None and last.part == first.part and last.part.half.is_late
    # "Tomorrow morning 9-12", "from ten in the morning until two": at noon, or after it.
    smaller = end_clock.hour % NOON < start_clock.hour % NOON
    past = last.part is not None and last.part == first.part and last.part.half is Half.AM and smaller
    if last.part is not None and not (late or past):
        end_clock = halved(end_clock, last.part.half)
    if start_clock.midnight and last.days is None:
        # "Sunday from midnight to four": where that day begins.
        start_clock = replace(start_clock, midnight=False)
    known_end = not end_clock.is_open
    start = clock.wall(replace(first, clock=half_before(start_clock, end_clock), part=None))
    grounded = replace(start, choices=start.choices if not known_end else ())
    if last.days is not None:
        there = replace(last, clock=end_clock, part=None)
        end = clock.wall(there)
        if end.start <= start.start:
            # "From friday at five to thursday at three": the thursday behind that friday.
            end = _after(clock, start.start).wall(there)
        return replace(grounded, end=end.start)
    return replace(grounded, end=first_after(start.start, end_clock), zone=first.zone)


def _under_way(clock: Standpoint, first: Wall, last: Wall, found: Instants) -> Instants:
    """Give the stretch that has begun, while enough of it is left: "between eight and noon", said at nine."""
    days = {wall.days for wall in (first, last)} - {None}
    behind = clock.since is not None and clock.since > clock.now
    if behind or clock.follows or clock.past or not days <= {Relative(0)}:
        return found
    halves = [choice - timedelta(days=1) for choice in found.choices or (found.start,)]
    if first.clock and first.clock.is_open and last.clock and last.clock.is_open:
        halves.append(found.start - timedelta(hours=NOON))
    begun = max((start for start in halves if start < clock.now), default=found.start)
    length = found.end - found.start
    if clock.now.time() == time():
        # The moment is given as a day.
        return found
    short = (begun + length - clock.now) * 100 < length * clock.policy.under_way
    if short or (days and begun.date() != clock.now.date()):
        return found
    if not first.clock or (first.clock.is_open and not is_plausible(clock, begun, ahead=False)):
        return found
    choices = tuple(choice - found.start + begun for choice in found.choices)
    return replace(found, start=begun, end=begun + length, choices=choices)


def _day_between(clock: Standpoint, first: Wall, last: Wall) -> Instants:
    """Ground what lies between two denied sides: of clock times without am or pm, while people are up.

    "Not before eight or after ten" is from the morning to the evening, what is left of that today.
    """
    if first.clock is None or last.clock is None:
        raise UngroundedError("a range of clock times must have two")
    policy, open_first = clock.policy, first.clock.is_open
    up, down = ((end.hour * 60 + end.minute) * 60 for end in (policy.ahead_from, policy.plausible_to))
    starts = first.clock.candidates()
    start = next((seconds for seconds in starts if seconds >= up), starts[-1])
    ends = [seconds for seconds in last.clock.candidates() if seconds > start]
    end = max((seconds for seconds in ends if seconds <= down), default=min(ends, default=None))
    begins = replace(first, clock=_settled(first.clock, start) if open_first else first.clock)
    closes = last.clock if end is None or not last.clock.is_open else _settled(last.clock, end)
    found = _clock_range(clock, begins, replace(last, clock=closes))
    begun = found.start - timedelta(days=1)
    if first.days is last.days is None and (over := first_after(begun, closes)) > clock.now:
        found = replace(found, start=begun, end=over)
    halves = sorted((found.start, found.start + timedelta(hours=NOON if start < DAY_SECONDS // 2 else -NOON)))
    return replace(found, choices=tuple(halves) if open_first else ())


def first_after(moment: datetime, clock: Clock) -> datetime:
    """Give the first of the moments behind another that a clock time may mean."""
    there = (midnight(moment.date()) + timedelta(seconds=seconds) for seconds in clock.candidates())
    return min(found + timedelta(days=found <= moment) for found in there)


def half_before(start: Clock, end: Clock) -> Clock:
    """Give a clock time in the half of the day that makes it shortest to another, whose half is known."""
    if not start.is_open or end.is_open:
        return start
    over = end.candidates()[0]
    return _settled(start, min(start.candidates(), key=lambda s: (over - s) % DAY_SECONDS or DAY_SECONDS))


def _last_of(said: Time, found: Instants) -> datetime:
    """Where a range ends that ends in an interval: at its end, for days; at its start, for parts of a day."""
    return found.start if isinstance(said, Wall) and said.part is not None else found.end


def _settled(clock: Clock, seconds: int) -> Clock:
    """Give a clock time whose half of the day is decided."""
    return replace(clock, half=Half.AM if seconds < DAY_SECONDS // 2 else Half.PM)
