"""What the policy decided where words leave it open: said in a sentence, and as a question."""

import re
from calendar import month_name
from dataclasses import dataclass, replace
from datetime import UTC, date, datetime, timedelta

from fuzzytime.language.instruction import Question, Remark, RemarkKind, Span
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.days.relations import Relative
from fuzzytime.language.meaning.expressions import Duration, Offset, Range, Repeat, Said, Time, Wall, wall_of
from fuzzytime.language.meaning.grounded.moment import Moment
from fuzzytime.language.meaning.instants import Instants
from fuzzytime.language.meaning.midnights import is_eve
from fuzzytime.language.meaning.recurrences.recurrence import CalendarRecurrence, EvenRecurrence
from fuzzytime.language.meaning.recurrences.series import begins_by_policy, bounds_said, hours_of_turns
from fuzzytime.language.meaning.times_of_day import UNNAMED
from fuzzytime.language.policy import Midnight
from fuzzytime.requirement import Recurrence

HALF_OF_DAY_ADVICE = ": say am or pm"
"""How a remark ends that tells which half of the day was taken: such are many, and mostly right."""

FAR = timedelta(days=62)
"""How far ahead a weekday that is a day of some month is said to be."""


TODAY = Relative(0)

GONE_BY = re.compile(r"(?<![\d.:])0:\d\d(?![:\d])")
"""Hours and minutes that may have gone by, or be a clock time: "0:30"."""

LONG_DAY = 8
"""Hours for which something goes on by day, at most: "ten to six", but not "ten to nine"."""


@dataclass(frozen=True, slots=True)
class Deciding:
    """The words of a time and where they stand, and the moment whose policy decides."""

    text: str
    span: Span
    moment: Moment

    def of_repetition(self, walls: tuple[Wall, ...], recurrence: Recurrence) -> tuple[Remark, ...]:
        """Say which half of the day was chosen for clock times that are repeated."""
        remarks = []
        for wall in walls:
            clock = wall.clock
            if isinstance(wall.days, Fields) and _has_two(wall):
                remarks.append(self._noted(f" is taken as {self._where}"))
            if clock is None or wall.part is not None or not isinstance(recurrence, CalendarRecurrence):
                continue
            chosen = recurrence.time_of_day(wall, clock)
            others = [seconds for seconds in clock.candidates() if seconds != chosen]
            if others:
                remarks.append(self._taken(_hours(chosen), _hours(others[0])))
        return tuple(dict.fromkeys(remarks))

    def of_bounds(self, repeat: Repeat, recurrence: Recurrence) -> tuple[Remark, ...]:
        """Say what was chosen for the first and the last time of a repetition."""
        remarks: list[Remark] = []
        if begins_by_policy(repeat) and isinstance(recurrence, EvenRecurrence) and recurrence.first:
            first = self.moment.grounding().now + timedelta(seconds=recurrence.first)
            remarks.append(self._noted(f" begins at {first:%H:%M}: when on that day is not said"))
        bounds = () if repeat.lent else bounds_said(repeat)
        hours = hours_of_turns(*bounds, self.moment) if bounds else None
        if hours is not None and not remarks:
            return self.of_instants(hours, hours.zone)[0]
        for place, bound in enumerate(bounds):
            said = bound.anchor if isinstance(bound, Offset) else bound
            if isinstance(said, Wall) and said.clock is not None and not remarks:
                found = self.moment.grounding(said.zone).instants(said)
                found = self._behind_start(found, recurrence) if place and said.days is None else found
                remarks += self.of_instants(found, said.zone)[0]
        return tuple(dict.fromkeys(remarks))

    def _behind_start(self, found: Instants, recurrence: Recurrence) -> Instants:
        """Give where a repetition is over, of the hours that it may be: the one that is behind its start."""
        if not found.choices or not isinstance(recurrence, EvenRecurrence) or recurrence.endless:
            return found
        over = self.moment.grounding().now + timedelta(seconds=recurrence.last)
        others = (choice for choice in found.choices if choice.time() != over.time())
        return replace(found, start=over, end=over, choices=(over, *others))

    def of_instants(
        self, found: Instants, zone: str | None
    ) -> tuple[tuple[Remark, ...], tuple[Question, ...]]:
        """Say what was chosen, and give it as a question where the policy asks."""
        remarks, questions = [], []
        now = self.moment.now
        if zone == UNNAMED:
            remarks.append(self._noted(": the zone is not used, as it is not named"))
        elif zone is not None and now is not None and now.tzinfo is None:
            remarks.append(self._noted(": the zone is not used, as the time now has none"))
        if found.is_point and self.moment.skips(found.start, zone):
            remarks.append(
                self._noted(
                    f" does not exist on that day, as clocks change: {self._becomes(found, zone)} is taken"
                )
            )
        if found.choices:
            others = " or ".join(f"{choice:%H:%M}" for choice in found.choices if choice != found.start)
            remarks.append(self._taken(f"{found.start:%H:%M}", others))
            if self.moment.policy.ask:
                chosen = found.choices.index(found.start)
                questions.append(Question(self.span, self._with_zone(found.choices), chosen))
        return tuple(remarks), tuple(questions)

    def _becomes(self, found: Instants, zone: str | None) -> str:
        """Give the clock time that one becomes which a change of clocks skips."""
        there = self.moment.clocks_of(zone)
        return f"{found.start.replace(tzinfo=there).astimezone(UTC).astimezone(there):%H:%M}"

    def of_unit(self, length: Duration) -> tuple[Remark, ...]:
        """Say which unit was taken for a number that has none: "knead 10"."""
        if not length.unsaid:
            return ()
        return (self._noted(f" is taken as {length.number:g} {length.unit}s: in what unit is not said"),)

    def of_hour(self, found: Instants) -> Remark:
        """Say which hour was chosen for "at half past"."""
        return self._noted(f" is taken as {found.start:%H:%M}: of which hour is not said")

    def of_hours(self, said: Said, found: Instants) -> tuple[Remark, ...]:
        """Say that "ten to six" is taken as one time, or as a stretch, where it may be the other."""
        time = said.time
        if GONE_BY.search(self.text) and isinstance(time, Wall):
            taken = f"the clock time {found.start:%H:%M}, not as so long from the start: say T+"
            return (self._noted(f" is taken as {taken}"),)
        if isinstance(time, Range):
            first = time.first.clock if isinstance(time.first, Wall) else None
            last = time.last.clock if isinstance(time.last, Wall) else None
            if first is None or last is None or not first.hours or first.half or last.minute or last.shift:
                return ()
            other = found.end - timedelta(minutes=first.hour)
            return (
                self._noted(
                    f" is taken as from {found.start:%H:%M} to {found.end:%H:%M}, not {other:%H:%M}: say at"
                ),
            )
        clock = time.clock if isinstance(time, Wall) and said.preposition is None else None
        if clock is None or not clock.hours or clock.shift >= 0:
            return ()
        if not 0 < (clock.hour + clock.shift // 60) % 12 <= LONG_DAY:
            return ()
        return (
            self._noted(
                f" is taken as {found.start:%H:%M}, not from {-clock.shift // 60} to {clock.hour}: say from"
            ),
        )

    def of_weekday(self, time: Time, found: Instants) -> tuple[Remark, ...]:
        """Say which day was chosen, where a weekday does not fit its date, or today's time has passed."""
        ends = ((time.first, found.start), (time.last, found.end)) if isinstance(time, Range) else ()
        for said, moment in ends or ((time, found.start),):
            days = wall_of(said).days
            fits = (
                not isinstance(days, Fields) or days.day is None or days.weekday in {None, moment.weekday()}
            )
            if not fits and not (isinstance(time, Range) and moment == found.end):
                return (self._noted(f" is taken as {moment:%Y-%m-%d}, which is a {moment:%A}"),)
            if self._has_passed(said, moment):
                return (self._noted(f" is taken as {moment:%Y-%m-%d %H:%M}: today's has passed"),)
            other = self._otherwise(days, moment) if isinstance(days, Fields) else None
            if other is not None:
                return (self._noted(f" is taken as {moment:%Y-%m-%d}, not {other:%Y-%m-%d}"),)
            if isinstance(days, Fields) and days.turnable and days.weekday is None:
                # Not of the moment: midnight is the day after.
                day, month = days.day or moment.day, days.month or moment.month
                told, turned = f"{day} {month_name[month]}", f"{month} {month_name[day]}"
                return (self._noted(f" is taken as {told}, not {turned}"),)
            if isinstance(days, Fields) and self._is_far(days, moment):
                return (self._noted(f" is taken as {moment:%Y-%m-%d}: none is nearer"),)
        return ()

    def _otherwise(self, days: Fields, moment: datetime) -> date | None:
        """Give the other day that is said beside a date: "tomorrow, the 7th"."""
        today = self.moment.grounding().today
        told = None if days.told is None else next(days.told.upcoming(today, today.day), None)
        return None if told is None or told.first == moment.date() else told.first

    def _has_passed(self, said: Time, moment: datetime) -> bool:
        """Whether a clock time in a part of today is that of the day after: "this morning at three"."""
        if not isinstance(said, Wall) or said.clock is None or said.part is None or said.days != TODAY:
            return False
        # "Tonight at two" is in the night that begins today.
        return not said.part.half.is_late and moment.date() > self.moment.grounding().today.day

    def _is_far(self, days: Fields, moment: datetime) -> bool:
        """Whether a weekday and a day of a month that is not said go together only months from now."""
        open_ = days.weekday is not None and days.day is not None and days.month is days.year is None
        return open_ and moment - self.moment.grounding().now > FAR

    def of_midnight(self, time: Time, found: Instants) -> tuple[Remark, ...]:
        """Say which midnight was chosen, where a day that is named has one at either end."""
        if isinstance(time, Range):
            return self._of_midnight(time.first, found.start) or self._of_midnight(time.last, found.end)
        return self._of_midnight(time, found.start)

    def _of_midnight(self, time: Time, moment: datetime) -> tuple[Remark, ...]:
        now = self.moment.now
        if not isinstance(time, Wall) or time.days is None or now is None or not _has_two(time):
            return ()
        ends = self.moment.policy.midnight is Midnight.END
        if (moment - timedelta(days=ends)).date() <= now.date():
            # The other one has passed.
            return ()
        return (self._noted(f" is taken as {moment:%Y-%m-%d %H:%M}, {self._where}"),)

    @property
    def _where(self) -> str:
        ends = self.moment.policy.midnight is Midnight.END
        return "where that day is over" if ends else "where that day begins"

    def _taken(self, chosen: str, others: str) -> Remark:
        return self._noted(f" is taken as {chosen}, not {others}{HALF_OF_DAY_ADVICE}")

    def _noted(self, message: str) -> Remark:
        return Remark(RemarkKind.POLICY, self.span, f"{self.text!r}{message}")

    def _with_zone(self, choices: tuple[datetime, ...]) -> tuple[datetime, ...]:
        zone = None if self.moment.now is None else self.moment.now.tzinfo
        return tuple(choice.replace(tzinfo=zone) for choice in choices)


def _has_two(wall: Wall) -> bool:
    """Whether a midnight may be that at either end of its day."""
    return wall.clock is not None and wall.clock.may_end_day and not is_eve(wall)


def _hours(seconds: int) -> str:
    return f"{seconds // 3600:02}:{seconds // 60 % 60:02}"
