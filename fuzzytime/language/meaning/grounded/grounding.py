"""From what was said to instants: the time now and the policy decide what the words leave open."""

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import replace
from datetime import date, datetime, time, timedelta
from itertools import islice

from fuzzytime.language.meaning.calendar import Calendar, Days, Fields, is_weekday
from fuzzytime.language.meaning.days.nested import thirds
from fuzzytime.language.meaning.days.relations import Relative
from fuzzytime.language.meaning.expressions import (
    Coming,
    Edge,
    Ending,
    HourMark,
    Midway,
    Offset,
    Range,
    Rest,
    SameTime,
    Time,
    Wall,
)
from fuzzytime.language.meaning.grounded.chosen_clocks import (
    before_due,
    decided,
    is_unusual,
    just_over,
    same_day_after,
    within_window,
)
from fuzzytime.language.meaning.grounded.counted_from import day_alike, day_counted_from
from fuzzytime.language.meaning.grounded.dated_weekdays import nearest
from fuzzytime.language.meaning.grounded.part_instants import part_alone, part_on, part_within
from fuzzytime.language.meaning.grounded.range_instants import range_instants
from fuzzytime.language.meaning.grounded.standpoint import Standpoint
from fuzzytime.language.meaning.instants import (
    SUB_DAY,
    Instants,
    halved,
    midnight,
    next_minute,
    shifted,
)
from fuzzytime.language.meaning.midnights import over_at_midnight
from fuzzytime.language.meaning.times_of_day import Clock, Part
from fuzzytime.language.meaning.ungrounded import UngroundedError
from fuzzytime.language.policy import SameWeekday
from fuzzytime.requirement import Unit

HOUR = timedelta(hours=1)


class Grounding(Standpoint):
    """From times as they were said to instants."""

    __slots__ = ()

    def instants(self, said: Time) -> Instants:
        """Ground a time.

        Raises
        ------
        UngroundedError
            If the words name no time.
        """
        try:
            return self._instants(said)
        except (OverflowError, ValueError) as error:
            raise UngroundedError("a time must lie in the years 1 to 9999") from error

    def _instants(self, said: Time) -> Instants:
        if isinstance(said, Wall):
            return self.wall(said)
        if isinstance(said, Ending):
            return self._ending(said)
        if isinstance(said, Offset):
            return self._offset(said)
        if isinstance(said, Coming):
            return self._coming(said)
        if isinstance(said, Range):
            return range_instants(self, said)
        if isinstance(said, Midway):
            whole = range_instants(self, said.of)
            half = (whole.end - whole.start) / 2
            choices = tuple(choice + half for choice in whole.choices)
            return replace(whole, start=whole.start + half, end=whole.start + half, choices=choices)
        if isinstance(said, Rest):
            whole = self.wall(said.of)
            return Instants(max(self.now, whole.start), whole.end, Unit.SECOND)
        if isinstance(said, SameTime):
            day = day_alike(self, said.days.grain, next(self.days(said.days)).first)
            # "Call mum at six. Same time tomorrow, call dad": at six, too.
            here = self.now if self.since is None else self.since
            moment = datetime.combine(day, here.time())
            return Instants(moment, moment, Unit.MINUTE)
        if isinstance(said, HourMark):
            begun = self.now if self.since is None else max(self.now, self.since)
            moment = next_minute(begun, said.minute)
            if self.due is not None and said.open:
                # "Dinner is at seven, lay the table by quarter to"
                before = next_minute(self.due - HOUR, said.minute)
                moment = before if before > self.now else moment
            return Instants(moment, moment, Unit.MINUTE)
        return Instants(self.now, self.now, Unit.SECOND)

    # -- days -------------------------------------------------------------------------------------------

    def days(self, calendar: Calendar) -> Iterator[Days]:
        """Give the periods that an expression may mean, the likeliest first.

        Raises
        ------
        UngroundedError
            If there is none.
        """
        today = day_counted_from(self, calendar)
        if isinstance(calendar, Fields) and calendar.weekday is not None and calendar.day is not None:
            yield from nearest(calendar, self.today)
            return
        upcoming = islice(calendar.upcoming(today, today.day), 3)
        first = next(upcoming, None)
        if first is None:
            raise UngroundedError("there is no such date")
        yield first
        yield from upcoming

    # -- wall-clock expressions -------------------------------------------------------------------------

    def wall(self, wall: Wall) -> Instants:
        """Ground a day, a part of the day, a clock time, or what of them is said."""
        if wall.days is None:
            if wall.clock is not None:
                return self._clock_alone(wall, wall.clock)
            if wall.part is None:
                raise UngroundedError("a time must name a day or a time of day")
            inside = None if self.window is None else part_within(wall.part, *self.window)
            return inside or part_alone(
                wall.part, self.now, self.since, self.policy.plausible_from, follows=self.follows
            )
        if wall.clock is not None:
            found = self._clock_on(wall, wall.days, wall.clock)
            return self._as_on_others(wall.others, wall, found) if wall.others else found
        days = self._chosen_day(wall.days, wall.part)
        if wall.part is not None:
            return part_on(days.first, wall.part, self.policy.ahead_from)
        return Instants(midnight(days.first), midnight(days.end), wall.days.grain)

    def _chosen_day(self, calendar: Calendar, part: Part | None) -> Days:
        candidates = self.days(calendar)
        first = next(candidates)
        if self.opens and part is None and not calendar.fixed and midnight(first.first) <= self.now:
            # "Before winter", said in winter: the next.
            return next((days for days in candidates if midnight(days.first) > self.now), first)
        if is_weekday(calendar) and first.first == self.now.date():
            over = part is not None and midnight(first.first) + timedelta(seconds=part.end) <= self.now
            # "On tuesday and wednesday", said on a wednesday, is the wednesday that follows.
            over = over or (self.listed and self.day is not None and self.day.date() > first.first)
            if over or (part is None and self.policy.same_weekday is SameWeekday.NEXT):
                return next(candidates, first)
        return first

    def _clock_alone(self, wall: Wall, clock: Clock) -> Instants:
        """Give the next occurrence; without am or pm, the next plausible one."""
        if wall.part is not None:
            clock = halved(clock, wall.part.half)
        later = self.ends or (self.behind and clock.is_open)
        moments = sorted(self._next(seconds, later=later) for seconds in clock.candidates())
        if self.past:
            return Instants(last := max(map(self._last, moments)), last, clock.grain, (), wall.zone)
        placed = within_window(self, clock) or before_due(self, clock) or same_day_after(self, clock)
        over = just_over(self, clock)
        if over and not placed:
            other = (moment for moment in moments if moment.time() != over[0].time())
            return Instants(over[0], over[0], clock.grain, (over[0], *other), wall.zone)
        return decided(self, placed or moments, clock, wall)

    def _next(self, seconds: int, *, later: bool) -> datetime:
        moment = midnight(self.now.date()) + timedelta(seconds=seconds)
        ahead = moment > self.now or (moment == self.now and not later)
        return moment if ahead else moment + timedelta(days=1)

    def _last(self, moment: datetime) -> datetime:
        """Give the last moment of a time of day: "her last turn was at six"."""
        return moment if moment < self.now else moment - timedelta(days=1)

    def _clock_on(self, wall: Wall, calendar: Calendar, clock: Clock) -> Instants:
        night = wall.part is not None and wall.part.half.is_late
        if wall.part is not None:
            clock = halved(clock, wall.part.half)
        for days in self._beginning_today(islice(self.days(calendar), 3)):
            moments = [midnight(days.first) + timedelta(seconds=seconds) for seconds in clock.candidates()]
            if night:
                moments = [self._of_night(moment, days.first) for moment in moments]
            else:
                moments = [moment + over_at_midnight(wall, self.policy) for moment in moments]
            # A weekday or a date that is today means today only while its clock time is ahead.
            ahead = [moment for moment in moments if moment >= self.now]
            dated = isinstance(calendar, Fields) and calendar.weekday is not None and calendar.day is not None
            goes_on = days.first == self.now.date() and (days.end - days.first).days > 1
            weekly = is_weekday(calendar)
            if (goes_on or weekly) and days.first == self.now.date() and is_unusual(self, ahead):
                # "Wake me at six on wednesday", said on a wednesday at nine: who wakes does in the morning.
                continue
            if not ahead and (goes_on or (not calendar.fixed and not dated)):
                continue
            if not ahead and isinstance(calendar, Relative) and calendar.days == 0 and wall.part is not None:
                # "This morning at three", said at half past four, is the morning to come.
                moments = [moment + timedelta(days=1) for moment in moments]
            if days.first == self.now.date() and ahead:
                moments = ahead
            prepared = before_due(self, clock)
            if prepared and days.first <= prepared[0].date() < days.end:
                # Who has to be there on that day leaves on it.
                moments = prepared
            return decided(self, sorted(moments), clock, wall)
        raise UngroundedError("a time of day must lie on its day")

    def _as_on_others(self, days: Iterable[Calendar], wall: Wall, found: Instants) -> Instants:
        """Give a clock time the half of the day that alone is left on another of several days.

        "On monday, wednesday and friday at eight", said on a wednesday at nine: all in the evening.
        """
        left = set[time]()
        for other in days:
            # "On the 28th and 30th of february at six"
            with suppress(UngroundedError):
                there = self.wall(replace(wall, days=other, others=()))
                left |= set() if there.choices else {there.start.time()}
        told = next((choice for choice in found.choices if choice.time() in left), found.start)
        return replace(found, start=told, end=told)

    def _beginning_today(self, periods: Iterable[Days]) -> Iterator[Days]:
        """Give what is to come of periods of several days: "at six this week" is no day that is over."""
        today = self.now.date()
        for days in periods:
            begun = days.first < today < days.end
            yield replace(days, first=today) if begun else days
            if begun and today + timedelta(days=1) < days.end:
                yield replace(days, first=today + timedelta(days=1))

    def _of_night(self, moment: datetime, day: date) -> datetime:
        """Put the small hours into the night that began the evening before, unless that night is now."""
        if moment.hour >= 6 or (day == self.now.date() and moment >= self.now and self.now.hour < 6):
            return moment
        return moment + timedelta(days=1)

    # -- the rest ---------------------------------------------------------------------------------------

    def _ending(self, said: Ending) -> Instants:
        days = next(self.days(said.days))
        start, end = midnight(days.first), midnight(days.end)
        if (days.end - days.first).days == 1:
            last = start if said.edge is Edge.START else end - timedelta(seconds=1)
            return Instants(last, last, Unit.DAY if said.edge is Edge.START else Unit.SECOND)
        opened, closes = thirds(days)
        if said.edge is Edge.START:
            return Instants(start, midnight(opened), Unit.DAY)
        return Instants(midnight(closes), end, Unit.DAY)

    def _offset(self, said: Offset) -> Instants:
        duration = said.duration
        if said.anchor is None:
            start = shifted(self.now, duration, said.direction)
            if duration.until is not None:
                return Instants(start, shifted(self.now, duration.until, said.direction), Unit.SECOND)
            return Instants(start, start, duration.unit if duration.unit in SUB_DAY else Unit.SECOND)
        anchor = self._instants(said.anchor)
        edge = said.anchor.edge if isinstance(said.anchor, Ending) else None
        over = edge is Edge.END
        after = said.direction > 0 and not self._is_day(said.anchor) and edge is not Edge.START
        base = anchor.end if over or after else anchor.start
        start = shifted(base, duration, said.direction)
        if duration.until is not None:
            # "Five to ten minutes before noon"
            first, last = sorted((start, shifted(base, duration.until, said.direction)))
            if self._is_day(said.anchor) and duration.unit not in SUB_DAY:
                # "Two or three days after easter": to the end of the third.
                last += timedelta(days=1)
            return Instants(first, last, Unit.MINUTE, (), anchor.zone)
        # "An hour before seven": which seven, is not said.
        choices = tuple(shifted(choice, duration, said.direction) for choice in anchor.choices)
        return Instants(start, start, Unit.MINUTE, choices if start in choices else (), anchor.zone)

    @staticmethod
    def _is_day(said: Time) -> bool:
        return isinstance(said, Wall) and said.part is None and said.clock is None

    def _coming(self, said: Coming) -> Instants:
        if said.direction < 0:
            return Instants(shifted(self.now, said.duration, -1), self.now, Unit.SECOND)
        return Instants(self.now, shifted(self.now, said.duration, 1), Unit.SECOND)
