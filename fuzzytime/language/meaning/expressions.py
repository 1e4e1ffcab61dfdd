"""What time words mean before it is known when they were said: the values that grammar rules build.

Nothing here knows a language or the time now; `grounding` turns these into instants.
"""

from dataclasses import dataclass, field, replace
from enum import StrEnum

from fuzzytime.language.meaning.calendar import Calendar
from fuzzytime.language.meaning.times_of_day import Clock, Part
from fuzzytime.language.meaning.units import UNIT_SECONDS
from fuzzytime.requirement import MOMENTS, Constraint, Unit


class Edge(StrEnum):
    """Which edge of an interval a bound means: its start, the moment it is over, its last moment.

    ``DUE`` is its last moment, too, but the start of a part of the day: "by friday", "by friday evening".
    """

    START = "start"
    END = "end"
    LAST = "last"
    DUE = "due"


@dataclass(frozen=True, slots=True)
class Duration:
    """A length of time: amounts of units, its hedges, and the longer end of a range ("five to ten minutes").

    ``bare_end`` says that it ends in a number without a unit ("an hour thirty"), ``ordinal_end`` in the word
    "second", which may be an ordinal. ``unsaid`` says that no words say its unit ("knead 10").
    """

    terms: tuple[tuple[float, Unit], ...]
    hedges: tuple[str, ...] = ()
    until: "Duration | None" = None
    bare_end: bool = False
    ordinal_end: bool = False
    indefinite: bool = False
    unsaid: bool = field(default=False, compare=False)

    @property
    def seconds(self) -> float:
        """Its length, by `UNIT_SECONDS`."""
        return sum(amount * UNIT_SECONDS[unit] for amount, unit in self.terms)

    @property
    def unit(self) -> Unit:
        """The finest unit said."""
        return min((unit for _, unit in self.terms), key=list(Unit).index)

    @property
    def number(self) -> float:
        """The amount as said; of several units, their sum in the finest."""
        return self.terms[0][0] if len(self.terms) == 1 else self.seconds / UNIT_SECONDS[self.unit]

    def hedged(self, *hedges: str) -> "Duration":
        """Give the same with hedges before its own."""
        return replace(self, hedges=(*hedges, *self.hedges))


@dataclass(frozen=True, slots=True)
class Wall:
    """A wall-clock expression: any of a day, a part of the day and a clock time, and the zone of its clock.

    ``weak`` says that the words alone are no sure time ("May", "2000"); ``others`` are the further days of a
    list with the same clock time, which is in one half of the day on all.
    """

    days: Calendar | None = None
    part: Part | None = None
    clock: Clock | None = None
    zone: str | None = None
    weak: bool = False
    others: tuple[Calendar, ...] = ()

    @property
    def bare(self) -> bool:
        """Whether it is nothing but a number."""
        return self.clock is not None and self.clock.bare and self.days is None and self.part is None

    @property
    def is_timed(self) -> bool:
        """Whether it says when on its day: by the clock, or in which part."""
        return self.clock is not None or self.part is not None


@dataclass(frozen=True, slots=True)
class Ending:
    """The start or the end of a day, week, month or year: "end of the month"; a moment, or a part of it."""

    edge: Edge
    days: Calendar


@dataclass(frozen=True, slots=True)
class Offset:
    """So long after (or before) now, or another time: "in ten minutes", "twenty minutes before noon"."""

    duration: Duration
    direction: int = 1
    anchor: "Time | None" = None


@dataclass(frozen=True, slots=True)
class Coming:
    """The stretch of time ahead, or just gone: "the next ten minutes", "the last two hours"."""

    duration: Duration
    direction: int = 1


@dataclass(frozen=True, slots=True)
class Range:
    """From one time to another.

    ``widest`` says that the words deny what lies outside: "not before eight or after ten" leaves the day.
    ``within`` says that what is asked for is somewhere in it, and does not fill it: "between two and four".
    """

    first: "Time"
    last: "Time"
    within: bool = field(default=False, kw_only=True, compare=False)
    widest: bool = field(default=False, kw_only=True)


@dataclass(frozen=True, slots=True)
class TimeWord:
    """A word that is a time by itself: "now", "soon"."""

    word: str
    constraint: Constraint


@dataclass(frozen=True, slots=True)
class Rest:
    """From now to the end of a period: "the rest of the day"."""

    of: Wall


@dataclass(frozen=True, slots=True)
class SameTime:
    """The time of day that it is now, on another day: "this time tomorrow"."""

    days: Calendar


@dataclass(frozen=True, slots=True)
class HourMark:
    """A minute of whichever hour comes next: "on the hour", "at half past".

    ``open`` says that not even "the hour" was said.
    """

    minute: int
    open: bool = False


@dataclass(frozen=True, slots=True)
class Midway:
    """The middle of a stretch: "halfway between noon and two"."""

    of: Range


Time = Wall | Ending | Offset | Coming | Range | Midway | TimeWord | Rest | SameTime | HourMark


NO_WALL = Wall()
"""Nothing said by calendar and clock."""


def wall_of(time: "Time | Duration | Repeat | None") -> Wall:
    """Give what of a time is said by calendar and clock: nothing, where it is of another kind."""
    return time if isinstance(time, Wall) else NO_WALL


@dataclass(frozen=True, slots=True)
class Repeat:
    """A repetition: every so long, or at each of some days, parts of the day and clock times.

    ``starting`` and ``until`` bound it where that was said; ``shared`` says that each occurrence has its
    whole share of the time ("twice a day"); ``times`` how often it is between those bounds ("twice today"),
    or so long ``every`` time after the one before. ``apart`` says that how often is said elsewhere: "two
    tablets, six hours apart". ``closing`` is how much of the end of something else it is in: "every twenty
    minutes for the last hour". ``within`` are the days that an interval is on: "every five minutes on
    weekdays". ``at`` is the time of day of each on its day: "twice a week at noon". ``lent`` says that the
    bounds are other instructions' times, and told of there; ``plural`` that its days are named by nothing
    else, and a number in front counts them: "three mornings".
    """

    every: Duration | None = None
    walls: tuple[Wall, ...] = ()
    skip: int = 1
    starting: Time | None = None
    until: Time | None = None
    shared: bool = False
    times: int | None = None
    apart: bool = False
    closing: Duration | None = None
    within: "Repeat | None" = None
    at: Wall | None = None
    lent: bool = False
    plural: bool = False


@dataclass(frozen=True, slots=True)
class Goal:
    """A time with its hedges, in the order said."""

    time: Time
    hedges: tuple[str, ...] = ()

    @property
    def wall(self) -> Wall:
        """What of it is said by calendar and clock: nothing, where it is another kind of time."""
        return wall_of(self.time)


@dataclass(frozen=True, slots=True)
class Said:
    """A temporal specification: how which time binds.

    ``constraint`` is None where the time itself decides between a point and an interval; ``beside`` says
    that a hedge puts it just off the time; ``lasting`` is a duration said in the same breath ("from 4pm for
    thirty minutes"). ``listed`` are the further times of a list ("in 10, 20 and 30 minutes"). ``within`` is
    the day, or the part of one, in which a deadline lies and what is due is done: "tomorrow before five".
    ``alternative`` says that it may be kept instead of the time before it: "at seven or at eight".
    ``denied`` says that it is when something is not to be done: "not on friday", "any day but friday".
    ``clocks`` are those of its own words, where others are told with it: "starting tomorrow … at six".
    """

    time: Time | Duration | Repeat
    constraint: Constraint | None = None
    preposition: str | None = None
    hedges: tuple[str, ...] = ()
    edge: Edge = Edge.START
    beside: bool = False
    lasting: Duration | None = None
    listed: tuple["Said", ...] = ()
    within: Wall | None = None
    alternative: bool = False
    denied: bool = False
    clocks: tuple[Clock, ...] | None = None

    @property
    def wall(self) -> Wall:
        """What of it is said by calendar and clock: nothing, where it is another kind of time."""
        return wall_of(self.time)

    def borrowing(self, told: "Said") -> "Said":
        """Give what is told here and in other words, with the clock times that are said here."""
        time = self.time
        walls = (*time.walls, time.starting, time.until) if isinstance(time, Repeat) else (time,)
        own = (wall_of(wall).clock for wall in walls)
        return replace(told, clocks=tuple(clock for clock in own if clock is not None))

    @property
    def is_day(self) -> bool:
        """Whether it is a day, a part of one, or a repetition of days, without a clock time."""
        time = self.time
        if self.denied:
            return False
        if isinstance(time, Repeat):
            timed = any(wall.clock is not None for wall in time.walls)
            # "Every day this week"
            bounds = (bound for bound in (time.starting, time.until) if bound is not None)
            whole = all(isinstance(bound, Wall) and not bound.is_timed for bound in bounds)
            return bool(time.walls) and not timed and whole
        # "On the 12th" is one, where "the 12th" alone may be something else.
        sure = isinstance(time, Wall) and (not time.weak or self.preposition is not None)
        binds = self.constraint in MOMENTS | {Constraint.BETWEEN, Constraint.EVERY}
        return sure and self.wall.clock is None and binds

    @property
    def sure(self) -> "Said":
        """The same as a time whatever stands beside it: "on the 12th", where others are on that day."""
        return replace(self, time=replace(self.time, weak=False)) if isinstance(self.time, Wall) else self


@dataclass(frozen=True, slots=True)
class Phrase:
    """A stretch of words that is a time: what it says, and where it stands, in words and in characters.

    ``above`` are its words where they stand on a line above, and none of them in this one.
    """

    said: Said
    first: int
    end: int
    span: tuple[int, int]
    rule: str
    above: str = ""

    def at(self, time: Time | Duration | Repeat) -> "Phrase":
        """Give the same words for another time, which binds as they say."""
        return replace(self, said=replace(self.said, time=time))
