"""Times of day and parts of the day as said, before it is known which half of the day they are in."""

from dataclasses import dataclass, replace
from datetime import time
from enum import StrEnum

from fuzzytime.requirement import Unit

DAY_SECONDS = 86400
WHOLE_DAY = "day"
"""The name of a whole day, of which "first thing" is a part."""

NOON = DAY_SECONDS // 2
DAY_HOURS = 24
"""A number beyond it is no hour."""

NEAR = 3 * 3600
"""Seconds around a part of the day in which a clock time may still be said to be in it."""

UNNAMED = "unnamed"
"""The zone of a clock time by somebody else's clock, of which it is not said where that is."""


class Half(StrEnum):
    """Which half of the day a clock time is in, as said by "am", "in the evening", "at night"."""

    AM = "am"
    PM = "pm"
    DAY = "day"
    EVENING = "evening"
    NIGHT = "night"
    EITHER = "either"

    @property
    def is_late(self) -> bool:
        """Whether it goes on past midnight: an evening, a night."""
        return self in {Half.EVENING, Half.NIGHT}


@dataclass(frozen=True, slots=True)
class Clock:
    """A time of day as said; ``full_day`` where the hour counts from 0 to 24 ("15h30", "0730").

    ``bare`` says that it is a number alone ("six"); ``pair`` that it is two ("ten thirty"); ``midnight`` that
    it is named by that word, which people say of the end of a day, too. ``apart`` says that it is told by
    how far it is from another ("ten minutes before noon"), ``minutes`` that its number may as well be minutes
    past or to another hour ("twenty"), ``ends_day`` that it is where its day is over, or behind it ("24:00").
    ``hours`` says that "ten to six" may as well be from one hour to another, or that its number is the first.
    """

    hour: int
    minute: int = 0
    second: int = 0
    grain: Unit = Unit.HOUR
    half: Half | None = None
    full_day: bool = False
    bare: bool = False
    pair: bool = False
    shift: int = 0
    midnight: bool = False
    apart: bool = False
    minutes: bool = False
    ends_day: bool = False
    hours: bool = False

    @property
    def may_end_day(self) -> bool:
        """Whether it may be where its day is over: midnight, or minutes after it; not "ten to midnight"."""
        return self.midnight and self.shift >= 0

    @property
    def seconds(self) -> int:
        """Seconds since midnight, the hour taken as said."""
        return self.hour * 3600 + self.minute * 60 + self.second + self.shift

    @property
    def is_open(self) -> bool:
        """Whether it may be before noon or after."""
        return not self.full_day and self.half in {None, Half.EITHER} and 1 <= self.hour <= 12

    def candidates(self) -> tuple[int, ...]:
        """Give the seconds since midnight that it may mean, morning first."""
        base = self.minute * 60 + self.second + self.shift
        if self.full_day or self.hour > 12 or self.hour == 0:
            return ((self.hour * 3600 + base) % DAY_SECONDS,)
        before_noon = (self.hour % 12) * 3600 + base
        after_noon = before_noon + 12 * 3600
        if self.half in {Half.AM, Half.PM}:
            # "Quarter to twelve in the morning" is before noon.
            crossed = self.hour == 12 and self.shift < 0
            morning = (self.half is Half.AM) is not crossed
            return ((before_noon if morning else after_noon) % DAY_SECONDS,)
        if self.half is Half.EVENING:
            # "Half past four in the evening" is in the afternoon, as many people say it.
            return ((before_noon if self.hour in {12, 1} else after_noon) % DAY_SECONDS,)
        if self.half is Half.NIGHT:
            return ((before_noon if self.hour in {12, 1, 2, 3, 4} else after_noon) % DAY_SECONDS,)
        if self.half is Half.DAY:
            return ((before_noon if 6 <= self.hour <= 11 else after_noon) % DAY_SECONDS,)
        return tuple(sorted((before_noon % DAY_SECONDS, after_noon % DAY_SECONDS)))

    def first_from(self, hour: time) -> int:
        """Give which of them comes first from a time of day on."""
        begin = hour.hour * 3600 + hour.minute * 60
        return min(self.candidates(), key=lambda seconds: (seconds - begin) % DAY_SECONDS)


FIRST_THING = "first thing"
"""The name of the first of a part of the day, which is over once it has begun."""


@dataclass(frozen=True, slots=True)
class Part:
    """A part of the day: where it begins and ends, in seconds since midnight, beyond a day past the next.

    ``late`` is where its late half begins; None for its middle. ``meal`` says that it is an event too, that
    instructions can be about, ``place`` that it is one where people are. ``due`` says that it is what a day
    has before a deadline, and begins when a policy says. An ``event`` is what goes on then, beside an hour.
    """

    name: str
    start: int
    end: int
    half: Half
    meal: bool = False
    late: int | None = None
    place: bool = False
    due: bool = False
    event: bool = False

    @property
    def is_point(self) -> bool:
        """Whether it is a moment, as noon is."""
        return self.start == self.end

    def is_near(self, seconds: int) -> bool:
        """Whether a time of day, in seconds since midnight, is in it, or in the hours around it."""
        # "01:30 in the morning": the hours from midnight on are a morning's too.
        begin = 0 if self.half is Half.AM else self.start - NEAR
        around = range(begin, self.end + NEAR + 1)
        return any(moment in around for moment in (seconds, seconds + DAY_SECONDS, seconds - DAY_SECONDS))

    def share(self, low: float, high: float) -> "Part":
        """Give the stretch between two shares of it: the early morning."""
        return replace(self, start=self._at(low), end=self._at(high), late=None)

    def _at(self, share: float) -> int:
        """Give where a share of it is over; half of it is over where its late half begins."""
        late = self.late if self.late is not None else (self.start + self.end) // 2
        if share <= 0.5:
            return int(self.start + 2 * share * (late - self.start))
        return int(late + (2 * share - 1) * (self.end - late))
