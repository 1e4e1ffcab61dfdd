"""When an instruction was given, and how far wall-clock times are from then: zones and changes of clocks."""

from dataclasses import dataclass
from datetime import UTC, datetime, timedelta, timezone, tzinfo

from fuzzytime.language.meaning.expressions import Duration
from fuzzytime.language.meaning.grounded.grounding import Grounding
from fuzzytime.language.meaning.grounded.standpoint import Clues
from fuzzytime.language.meaning.instants import CALENDAR_UNITS, SUB_DAY, shifted
from fuzzytime.language.meaning.times_of_day import UNNAMED
from fuzzytime.language.meaning.ungrounded import UngroundedError
from fuzzytime.language.policy import Policy
from fuzzytime.times import parse_clock, parse_zone, seconds_between


@dataclass(frozen=True, slots=True)
class Moment(Clues[float]):
    """When an instruction was given: with a zone, without, or not known."""

    now: datetime | None
    policy: Policy

    def grounding(self, zone: str | None = None) -> Grounding:
        """Give the wall clock to reckon by: that of a zone, where one is named and ours is known.

        Raises
        ------
        UngroundedError
            If no clock is known.
        """
        if self.now is None:
            raise UngroundedError("a time of day needs a clock: say what time it is now")
        if zone is not None and zone != UNNAMED and self.now.tzinfo is not None:
            return Grounding(self.now.astimezone(zone_of(zone)).replace(tzinfo=None), self.policy)
        here = self.now.replace(tzinfo=None)
        return Grounding(
            here,
            self.policy,
            since=_at(here, self.since),
            day=_at(here, self.day),
            released=_at(here, self.released),
            event=_at(here, self.event),
            ahead=_at(here, self.ahead),
            listed=self.listed,
            follows=self.follows,
            carried=self.carried,
            in_order=self.in_order,
            begun=self.begun,
            opened=_at(here, self.opened),
            due=_at(here, self.due),
            usual=self.usual,
            early=self.early,
            leads=self.leads,
            onto=self.onto,
            overnight=self.overnight,
            past=self.past,
            night=_from_to(here, self.night),
            window=_from_to(here, self.window),
        )

    def seconds(self, wall: datetime, zone: str | None = None) -> float:
        """Give the seconds from now to a wall-clock time, in our zone or another.

        A wall-clock time that a change of clocks skips is the moment that long after the change; of one
        that comes twice, it is the first.
        """
        if self.now is None:
            raise UngroundedError("a time of day needs a clock: say what time it is now")
        if self.now.tzinfo is None:
            return seconds_between(self.now, wall)
        there = self.clocks_of(zone) or self.now.tzinfo
        try:
            return seconds_between(self.now, wall.replace(tzinfo=there, fold=self._fold(wall, there)))
        except (OverflowError, ValueError) as error:
            raise UngroundedError("a time must lie in the years 1 to 9999") from error

    def clocks_of(self, zone: str | None) -> tzinfo | None:
        """Give the clocks of a zone, where it is named, or else those that the time now is told by."""
        if zone is None or zone == UNNAMED:
            return None if self.now is None else self.now.tzinfo
        return zone_of(zone)

    def skips(self, wall: datetime, zone: str | None) -> bool:
        """Whether a change of clocks skips a wall-clock time."""
        if self.now is None or self.now.tzinfo is None:
            return False
        there = wall.replace(tzinfo=self.clocks_of(zone))
        return there.astimezone(UTC).astimezone(there.tzinfo).replace(tzinfo=None) != wall

    def _fold(self, wall: datetime, zone: tzinfo) -> int:
        """Give the second of two equal wall-clock times, where the first is over."""
        if self.now is None or self.now.tzinfo is None:
            return 0
        first, second = (wall.replace(tzinfo=zone, fold=fold).astimezone(UTC) for fold in (0, 1))
        return 1 if first < self.now.astimezone(UTC) <= second else 0

    def later(self, duration: Duration, direction: int = 1) -> float:
        """Give the seconds to a duration from now: days and longer by the wall clock, the rest as elapsed."""
        days = tuple(term for term in duration.terms if term[1] not in SUB_DAY)
        rest = sum(Duration((term,)).seconds for term in duration.terms if term[1] in SUB_DAY)
        if not days or (self.now is None and not any(unit in CALENDAR_UNITS for _, unit in days)):
            return direction * duration.seconds
        try:
            wall = shifted(self.grounding().now, Duration(days), direction)
            return self.seconds(wall) + direction * rest
        except (OverflowError, ValueError) as error:
            raise UngroundedError("a time must lie in the years 1 to 9999") from error


def _at(here: datetime, seconds: float | None) -> datetime | None:
    """Give a time on the wall clock."""
    return None if seconds is None else here + timedelta(seconds=seconds)


def _from_to(here: datetime, seconds: tuple[float, float] | None) -> tuple[datetime, datetime] | None:
    """Give the ends of a stretch of time on the wall clock."""
    return seconds and (here + timedelta(seconds=seconds[0]), here + timedelta(seconds=seconds[1]))


def zone_of(name: str) -> tzinfo:
    """Give the zone of a name from the word tables: an IANA name or an offset."""
    if name[0] in "+-":
        offset = parse_clock(name[1:])
        minutes = (offset.hour * 60 + offset.minute) * (-1 if name[0] == "-" else 1)
        return timezone(timedelta(minutes=minutes))
    return parse_zone(name)
