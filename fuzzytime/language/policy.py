"""What is decided where words leave it open: explicit, and configurable in ``rules/calendar.yaml``."""

from dataclasses import dataclass
from datetime import time
from enum import StrEnum

Hours = tuple[time, time | None]
"""From when to when, over midnight where the second is the smaller; without it, on days to come only."""


class SameWeekday(StrEnum):
    """Which day "on Tuesday" is when it is said on a Tuesday."""

    NEXT = "next"
    TODAY = "today"


class DateOrder(StrEnum):
    """Whether 4/5 is the fifth of April or the fourth of May."""

    MONTH_DAY = "month-day"
    DAY_MONTH = "day-month"


class Midnight(StrEnum):
    """Which midnight "midnight on Friday" is: where Friday begins, or where it is over."""

    START = "start"
    END = "end"


@dataclass(frozen=True, slots=True, kw_only=True)
class Steps:
    """When lines that lean on each other are steps in the order said.

    Parameters
    ----------
    lines
        Lines that ask for something, at least, behind the first.
    leaning
        One line of so many leans, at least, behind the first.
    same
        One of so many leans, is about a thing that was named above ("drain the potatoes"), or says how long.
    least
        So many lean where one of ``same`` is about a thing that any order above named: "fry the mushrooms",
        "set them aside", "return the mushrooms to the pan".
    timed
        Less than one of so many says when, by itself: else the times say the order.
    lasting
        Lines, at least, of which each says how long it goes on, and none when: "bike 10 min", "rest 2 min".
    """

    lines: int = 4
    leaning: int = 3
    same: int = 2
    least: int = 2
    timed: int = 3
    lasting: int = 3


@dataclass(frozen=True, slots=True, kw_only=True)
class Policy:
    """Decisions for what is ambiguous.

    Parameters
    ----------
    plausible_from, plausible_to
        A clock time without am or pm is its next occurrence within these hours of the day.
    soon_hours
        One that comes within so many hours from now is plausible at any time of day.
    night_from, night_to, night_hours
        Who speaks between these times of day is up at night, and means one within so many hours.
    ahead_from
        From when on people may be up on a day to come. A clock time that early is meant where it is usual.
    begun_hours
        How long ago the first lines may be of those that go through a day in its order.
    under_way
        A stretch between two clock times is the one that has begun while so many percent of it are left.
    hours_before
        What is due at a time of a day may begin on it at ``plausible_from``, or so many hours before. Who is
        to be somewhere then is at most so long on the way.
    workday_from
        A clock time without am or pm that is repeated on all working days is its first from this time of day
        on; any other that is repeated, its first from ``plausible_from`` on.
    same_weekday
        Which day a weekday means on that very day, where no time of day decides it.
    midnight
        Which midnight is meant beside a day; that of an eve, and of a night, is at its end.
    week_starts
        First day of the week, 0 for Monday.
    weekend_from, weekend_days
        The weekend's first weekday, 0 for Monday, and how many days it has.
    date_order
        How a date of two numbers is read.
    bare_pair_from
        The first hour from which two number words alone ("eight forty") are a clock time.
    planned_from
        The first year of plans; those before it are of things: "films from 2003".
    round_the_clock_hours
        What is done every so many hours or more, and has no end, goes on at night: a shorter repetition ends
        with the hours between ``plausible_from`` and ``plausible_to`` in which it begins, or with the night.
    steps
        When lines that lean on each other are steps in the order said.
    sure_hours
        Entries of a list that are surely at an hour, beside which a number alone is one of what lasts, too.
    kept_off
        Minutes on either side of a clock time at which something is not to be done.
    ask
        Whether ambiguous times become questions. The choice is made in any case, and said.
    """

    plausible_from: time = time(7)
    plausible_to: time = time(22)
    soon_hours: int = 2
    night_from: time = time(23)
    night_to: time = time(4)
    night_hours: int = 5
    ahead_from: time = time(6)
    begun_hours: int = 1
    under_way: int = 25
    hours_before: int = 2
    workday_from: time = time(6)
    same_weekday: SameWeekday = SameWeekday.NEXT
    midnight: Midnight = Midnight.END
    week_starts: int = 0
    weekend_from: int = 5
    weekend_days: int = 2
    date_order: DateOrder = DateOrder.MONTH_DAY
    bare_pair_from: int = 8
    planned_from: int = 2020
    round_the_clock_hours: int = 4
    steps: Steps = Steps()
    sure_hours: int = 2
    kept_off: int = 30
    ask: bool = True

    def far_from(self, hour: float, old: float) -> tuple[bool, float]:
        """Give how unlikely an hour is as the new one of what was at another: at night, and how far away.

        What was late itself may be at any hour of the night.
        """
        asleep = not self.plausible_from.hour <= hour <= self.plausible_to.hour
        late = not self.night_to.hour <= old % 24 < self.plausible_to.hour
        return abs(hour - old) > self.soon_hours and asleep and not late, abs(hour - old)

    def begin_before(self, deadline: float) -> int:
        """Give from when on, in seconds of its day, what is due at a time of that day may begin."""
        opens = self.plausible_from.hour * 3600 + self.plausible_from.minute * 60
        return max(0, min(opens, int(deadline) - self.hours_before * 3600))
