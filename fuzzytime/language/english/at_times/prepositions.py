"""How a preposition binds a time: "at six", "around noon", "shortly after lunch", "at 1730"."""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.meaning.calendar import Calendar
from fuzzytime.language.meaning.days.relations import Relative, days_away
from fuzzytime.language.meaning.expressions import (
    Duration,
    Edge,
    Ending,
    Goal,
    HourMark,
    Offset,
    Said,
    SameTime,
    TimeWord,
    Wall,
)
from fuzzytime.language.meaning.joined.beside import joined
from fuzzytime.language.meaning.joined.distances import LOWER, UPPER
from fuzzytime.language.meaning.times_of_day import Clock, Part
from fuzzytime.requirement import MOMENTS, Constraint, Unit

grammar = Grammar()

LEISURE = 3600
"""Seconds that somebody may have to spare, at most."""


def said_of(
    goal: Goal, preposition: str | None, constraint: Constraint | None = None, edge: Edge = Edge.START
) -> Said:
    """Give a time with its hedges, bound as said."""
    return Said(goal.time, constraint, preposition, goal.hedges, edge)


@grammar.rule("said", "<goal>")
def plain(goal: Goal) -> Said:
    """Tomorrow, now, six o'clock."""
    return said_of(goal, None)


@grammar.rule("said", "<preposition_at> the? <goal>", weight=0.1)
def beside(preposition: Preposition, goal: Goal) -> Said | None:
    """At six, on friday, around noon, sometime tomorrow; but "for an hour beforehand" says how long."""
    if preposition.name == "for" and isinstance(goal.time, Offset) and goal.time.anchor is None:
        return None
    wall = goal.wall
    clock = wall.clock if wall.days is None and wall.part is None else None
    if preposition.name == "in" and clock is not None and clock.half is None and not clock.full_day:
        # "In six forty minutes"
        return None
    if isinstance(goal.time, TimeWord) and (
        preposition.name in {"in", "at", "on"} or goal.time.constraint is Constraint.EVERY
    ):
        return None
    return said_of(goal, preposition.name)


@grammar.rule(
    "said",
    "when|once|whenever it's|its <hedge>? <wall>|<same>",
    "when|once|whenever it is|gets|strikes|hits|turns <hedge>? <wall>|<same>",
    "when|once|whenever the clock strikes|hits|shows|says|reads|turns <hedge>? <wall>|<same>",
    weight=0.55,
)
def when_it_is(hedge: str | None, time: Wall | HourMark | SameTime) -> Said | None:
    """When it is three p.m., once it's noon, when it's nearly ten, when it's a quarter to."""
    known = isinstance(time, HourMark) or (isinstance(time, Wall) and time.clock is not None)
    return Said(time, None, "at", () if hedge is None else (hedge,)) if known else None


@grammar.rule(
    "word",
    "when|whenever|if|once you|ya|u|i|we get|have|find|got|'ve a|some|any|the? spare|free|quiet? <leisure>",
    "when|whenever|if|once you've|i've|we've got|found|had? a|some|any|the? spare|free|quiet? <leisure>",
    "as soon as you've|i've|we've got|found|had a|some|any|the? spare|free|quiet? <leisure>",
    "when|whenever|if|once there's|theres a|some|any? spare|free|quiet? <leisure>",
    "when|whenever|if|once there is a|some|any? spare|free|quiet? <leisure>",
    "when|whenever|if|once you're|youre|i'm|im|we're free|available|idle",
    "when|whenever|if|once you|we are free|available|idle",
    "when|whenever|if|once you|i|we get|come|can|manage round|around? to it|that",
    "as soon as you|i|we get|have|find|got a|some|any|the? spare|free|quiet? <leisure>",
    weight=0.2,
)
def when_you_have_time(_leisure: str | None = None) -> TimeWord:
    """When you get a sec, once you find the time."""
    return TimeWord("when you can", Constraint.VAGUE)


@grammar.rule("leisure", "moment|minute|second|sec|mo|tick|chance|time|opportunity|while|hand")
def leisure() -> str:
    """A moment for something."""
    return "time"


@grammar.rule("leisure", "<duration>", "<duration> to spare|free")
def minutes_to_spare(duration: Duration) -> str | None:
    """(when you've got) five minutes; but not two days."""
    return "time" if duration.seconds <= LEISURE and duration.unit is not Unit.SECOND else None


@grammar.rule("said", "near <clock>", "near the? <part>", weight=0.3)
def near(time: Clock | Part) -> Said | None:
    """Near noon, near sunset; but "near school" is where."""
    if isinstance(time, Clock):
        return Said(Wall(clock=time), None, "around")
    return None if time.meal or time.is_point else Said(Wall(part=time), None, "around")


@grammar.rule("said", "at like|say ,? <clock>", weight=0.5)
def at_like(clock: Clock) -> Said:
    """At like five."""
    return Said(Wall(clock=replace(clock, bare=False, pair=False)), None, "at", ("about",))


@grammar.rule("said", "at <clock>|<clock behind at>", weight=0.3)
def at_clock(clock: Clock) -> Said:
    """At 1030, at 7h, at 2.30."""
    return Said(Wall(clock=clock), None, "at")


@grammar.rule("said", "at <hedge>|<hedge_after> <clock>", "at <clock> <hedge_after>", weight=0.35)
def at_hedged_clock(first: str | Clock, second: Clock | str) -> Said | None:
    """At exactly 1830, at 1830 sharp, at sharp nine."""
    clock, hedge = (first, second) if isinstance(first, Clock) else (second, first)
    if not isinstance(clock, Clock) or not isinstance(hedge, str):
        return None
    return Said(Wall(clock=replace(clock, bare=False, pair=False)), None, "at", (hedge,))


@grammar.rule("said", "at <clock>|<clock behind at> on|of the? <wall>", weight=0.8)
@grammar.rule("said", "at <clock>|<clock behind at> , on the? <wall>", weight=0.8)
def at_clock_on(clock: Clock, wall: Wall) -> Said | None:
    """At 2.30 on friday, at 2030 on friday, at seven on the 14th."""
    return at_clock_beside(replace(clock, bare=False), wall)


@grammar.rule("said", "at <clock>|<clock behind at> ,? <wall>", weight=0.8)
def at_clock_beside(clock: Clock, wall: Wall) -> Said | None:
    """At 2.30 tomorrow; but "at seven second helpings are served"."""
    time = joined(Wall(clock=clock), wall)
    return None if time is None else Said(time, None, "at")


@grammar.rule("said", "<hedge> <clock> ,? <days away>", weight=1.5)
def about_clock_days_away(hedge: str, clock: Clock, days: Calendar) -> Said | None:
    """About ten a week on friday: no ten a week; but "at most ten a week from friday" are so many."""
    if not clock.bare or hedge in UPPER | LOWER:
        return None
    return Said(Wall(days, clock=replace(clock, bare=False)), None, None, (hedge,))


@grammar.rule("said", "<beside> <clock> ,? <days away>", weight=1.7)
def just_off_days_away(hedge: str, clock: Clock, days: Calendar) -> Said | None:
    """Right after one a week from thursday."""
    return just_off(hedge, Goal(Wall(days, clock=replace(clock, bare=False)))) if clock.bare else None


@grammar.rule(
    "said",
    "at <clock>|<clock behind at> ,? in <duration> time?",
    "at <clock>|<clock behind at> ,? in <duration> '|'s time",
    weight=0.8,
)
def at_clock_after_days(clock: Clock, duration: Duration) -> Said | None:
    """At five in two days, at 1830 in a fortnight; "at five in two hours" are two times."""
    away = days_away(duration, Relative(0), 1)
    if away is None or duration.hedges:
        return None
    return Said(Wall(away, clock=replace(clock, bare=False, pair=False)), None, "at")


@grammar.rule("said", "starting|beginning|commencing at? the? <goal>", weight=0.3)
def starting_at(goal: Goal) -> Said | None:
    """Starting at three pm: then, not some time after it; but "starting tomorrow" is from then on."""
    return None if goal.wall.clock is None else said_of(goal, "starting")


@grammar.rule("said", "<beside> the? <goal>", "at <beside> the? <goal>", weight=0.4)
def just_off(hedge: str, goal: Goal) -> Said | None:
    """Shortly before noon, just after 5 pm: points, no deadlines."""
    if not isinstance(goal.time, (Wall, Ending)):
        return None
    edge = Edge.END if hedge.endswith("after") else Edge.START
    return Said(goal.time, None, None, (hedge, *goal.hedges), edge, beside=True)


@grammar.rule("said", "<beside> <four digits with hours>", weight=1.0)
def just_off_with_hours(hedge: str, clock: Clock) -> Said | None:
    """Just after 1330 hours."""
    return just_off(hedge, Goal(Wall(clock=clock)))


@grammar.rule(
    "said",
    "<said> ,? or|and shortly|soon|right|just|a thereafter|afterwards|after|later",
    "<said> ,? or|and a little|bit|while|moment thereafter|afterwards|after|later",
    "<said> ,? or|and thereafter|afterwards",
    "<said> ,? if not later",
    weight=0.5,
)
def or_shortly_after(said: Said) -> Said | None:
    """At noon or shortly thereafter, by six if not later."""
    return _a_little_off(said, "shortly after")


@grammar.rule(
    "said",
    "<said> ,? or|and shortly|right|just before|beforehand",
    "<said> ,? or|and a little|bit|while|moment before|beforehand|earlier",
    weight=0.5,
)
def or_shortly_before(said: Said) -> Said | None:
    """At noon or shortly before."""
    return _a_little_off(said, "shortly before")


def _a_little_off(said: Said, hedge: str) -> Said | None:
    """Put a point off its anchor; a bound stays one, and is meant less exactly: "by six or a bit later"."""
    if said.beside or not isinstance(said.time, (Wall, Ending)):
        return None
    if said.constraint in {Constraint.BEFORE, Constraint.AFTER}:
        return replace(said, hedges=(*said.hedges, "or so"))
    if said.constraint not in MOMENTS:
        return None
    return replace(
        said,
        hedges=(hedge, *said.hedges),
        edge=Edge.END if hedge.endswith("after") else Edge.START,
        beside=True,
    )


@grammar.rule("said", "<preposition_at> <said>", weight=0.05)
def sometime(preposition: Preposition, said: Said) -> Said | None:
    """Sometime between 3 and 4."""
    return said if preposition.name == "sometime" and said.preposition not in {None, "sometime"} else None


@grammar.rule("said", "somewhere|someplace <said>", weight=0.05)
def somewhere(said: Said) -> Said | None:
    """Somewhere between 3 and 4, somewhere in the next hour."""
    return said if said.constraint is Constraint.BETWEEN else None


@grammar.rule("said", "for <preposition_at> <goal>", weight=0.3)
def for_sometime(preposition: Preposition, goal: Goal) -> Said | None:
    """For sometime next week, behind what is made for a time."""
    return said_of(goal, preposition.name) if preposition.name == "sometime" else None


@grammar.rule("said", "<hedge> <said>", weight=0.05)
def hedged_said(hedge: str, said: Said) -> Said | None:
    """Exactly at six, roughly in ten minutes."""
    if said.preposition is None or len(said.hedges) > 1 or hedge in {"less than", "more than", "some"}:
        return None
    if hedge == "at most" and said.wall.days is not None:
        # "Up to tomorrow at seven": "up to" binds it.
        return None
    return replace(said, hedges=(hedge, *said.hedges))
