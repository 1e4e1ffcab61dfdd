"""Times with their hedges, and times counted from them: "about noon", "twenty minutes before six"."""

from dataclasses import replace

from fuzzytime.language.english.clock_times.clocks import with_half
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.calendar import Calendar
from fuzzytime.language.meaning.days.relations import Away, days_away
from fuzzytime.language.meaning.expressions import (
    Duration,
    Edge,
    Ending,
    Goal,
    HourMark,
    Offset,
    Range,
    Time,
    TimeWord,
    Wall,
    wall_of,
)
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.joined.distances import LOWER, UPPER
from fuzzytime.language.meaning.times_of_day import Clock, Half
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()

SHORT_OF = frozenset({"less than"})
"""Hedges of distances that do not reach the day that they end on."""

ISH = "ish"
"""The hedge behind a clock time: "sevenish"."""

SOME = "some"
"""The hedge before a length, that says how much of a thing as well: "some ten minutes", "some dinner"."""


@grammar.rule("goal", "<wall>|<end>|<stretch>|<rest>|<word>|<same>")
def goal(time: Time) -> Goal:
    """Any time."""
    return Goal(time)


@grammar.rule("goal", "<hedge> the? <goal>", weight=0.05)
def hedged(hedge: str, goal: Goal) -> Goal | None:
    """About noon, almost six."""
    clock, part = goal.wall.clock, goal.wall.part
    if clock is not None and clock.apart and hedge in LOWER | UPPER:
        # "At least ten minutes before noon": how far, at least.
        return None
    if hedge == SOME and part is not None and part.meal:
        # "Eat some breakfast", "cook some dinner tonight": as much of it as there is.
        return None
    return replace(goal, hedges=(hedge, *goal.hedges)) if len(goal.hedges) < 3 else None


@grammar.rule(
    "goal",
    "agreed|closing|departure|latest|opening|set|starting|stated|usual time of <clock>",
    "check -? in|out time of <clock>",
    "stated|agreed|usual check -? in|out time of <clock>",
    weight=0.4,
)
def time_of(clock: Clock) -> Goal:
    """(no later than) the agreed time of ten, the check-out time of 10 am."""
    return Goal(Wall(clock=clock))


@grammar.rule("goal", "the? <edge> of? <hedge> <days>|<date>|<weak date>", weight=0.3)
def about_the_end(edge: Edge, hedge: str, days: Calendar) -> Goal:
    """The end of about next week, end of around june."""
    return Goal(Ending(edge, days), (hedge,))


@grammar.rule("goal", "<goal> <hedge_after>", "<goal> - <hedge_after>", "<goal> , <hedge_after>", weight=0.05)
def hedged_after(goal: Goal, hedge: str) -> Goal | None:
    """Noon sharp, 3pm approximately, elevenish."""
    distance = _distance(goal.time) if hedge in LOWER | UPPER else None
    if distance is not None:
        return _far_off(distance, hedge)
    goal = _as_hour(goal)
    return replace(goal, hedges=(*goal.hedges, hedge)) if len(goal.hedges) < 3 else None


@grammar.rule("goal", "<clock> -? ish in? the? <meridiem>", weight=0.2)
def ish_in_half(clock: Clock, half: Half) -> Goal | None:
    """7ish am."""
    found = with_half(clock, half)
    return None if found is None else Goal(Wall(clock=found), (ISH,))


def _distance(time: Time) -> Offset | None:
    """Give a time that is so far off another as that: "ten minutes before noon" is one with minutes, too."""
    if isinstance(time, Offset) and time.anchor is not None:
        return time
    clock = wall_of(time).clock
    if clock is None or not clock.apart or not isinstance(time, Wall):
        return None
    whole = replace(clock, shift=0, apart=False, grain=Unit.MINUTE if clock.minute else Unit.HOUR)
    minutes = Duration(((abs(clock.shift) / 60, Unit.MINUTE),))
    return Offset(minutes, 1 if clock.shift > 0 else -1, replace(time, clock=whole))


def _far_off(offset: Offset, hedge: str) -> Goal | None:
    """Give what is so far off another time, at most or at least: "ten minutes before noon at most"."""
    if hedge in LOWER:
        return Goal(replace(offset, duration=offset.duration.hedged(hedge)))
    side = at_most_before if offset.direction < 0 else at_most_after
    return None if offset.anchor is None else side(hedge, offset.duration, Goal(offset.anchor))


@grammar.rule("goal", "<duration> <forward>|<back>")
def counted(duration: Duration, preposition: Preposition) -> Goal:
    """Ten minutes from now, as the end of a range or behind a preposition."""
    return Goal(Offset(duration, -1 if preposition.name == "ago" else 1))


@grammar.rule(
    "goal",
    "<duration> before|til|to|prior <goal>",
    "<duration> prior to <goal>",
    "<duration> shy|short of <goal>",
    weight=0.1,
)
def before_goal(duration: Duration, goal: Goal) -> Goal | None:
    """Twenty minutes before noon, an hour before about six."""
    counts = _counts_from(goal) and not _is_quarter_hour(duration, goal)
    return replace(goal, time=Offset(duration, -1, goal.time)) if counts else None


@grammar.rule("goal", "<duration> before the <clock>", weight=0.3)
def before_train(duration: Duration, clock: Clock) -> Goal:
    """Twenty minutes before the 7:52."""
    return Goal(Offset(duration, -1, Wall(clock=clock)))


@grammar.rule("goal", "<duration> after|past|following|from <goal>", weight=0.1)
def after_goal(duration: Duration, goal: Goal) -> Goal | None:
    """Two hours after lunch, 15 minutes from 1pm."""
    counts = _counts_from(goal) and not _is_quarter_hour(duration, goal)
    return replace(goal, time=Offset(duration, 1, goal.time)) if counts else None


@grammar.rule("goal", "<duration> before|til|to|prior <goal>", "<duration> prior to <goal>", weight=2.0)
def stretch_before(duration: Duration, goal: Goal) -> Goal | None:
    """Five to ten minutes before noon: no stretch from five to ten before noon."""
    return None if duration.until is None else before_goal(duration, goal)


@grammar.rule("goal", "<duration> after|past|following|from <goal>", weight=2.0)
def stretch_after(duration: Duration, goal: Goal) -> Goal | None:
    """Five or ten minutes past four."""
    return None if duration.until is None else after_goal(duration, goal)


@grammar.rule(
    "goal", "less than <duration> after|from <goal>", "within <duration> after|from <goal>", weight=0.4
)
def soon_after(duration: Duration, goal: Goal) -> Goal | None:
    """Less than three days after tomorrow: from then to then."""
    whole = isinstance(goal.time, Wall) and not goal.wall.is_timed
    if whole and all(unit in SUB_DAY for _, unit in duration.terms):
        # "Within an hour of the fall"
        return None
    found = Range(goal.time, Offset(duration, 1, goal.time))
    return replace(goal, time=found) if _counts_from(goal) else None


@grammar.rule("goal", "within <duration> of <goal>", weight=0.4)
def near(duration: Duration, goal: Goal) -> Goal | None:
    """Within ten minutes of noon: on either side; within an hour of lunch: from then on."""
    found = soon_after(duration, goal)
    if found is None or not isinstance(goal.time, Wall) or goal.time.clock is None:
        return found
    before, after = (Offset(duration, side, goal.time) for side in (-1, 1))
    return replace(found, time=Range(before, after))


@grammar.rule("goal", "<hedge> <duration> after|past|following <goal>", weight=0.5)
def at_most_after(hedge: str, duration: Duration, goal: Goal) -> Goal | None:
    """At most ten minutes after noon, no more than two days after monday: from then to then."""
    if hedge not in UPPER or _is_quarter_hour(duration, goal):
        return None
    if not _is_day(goal):
        return soon_after(duration, goal)
    last = None if hedge in SHORT_OF else _days_off(goal, duration, 1)
    return None if last is None else replace(goal, time=Range(goal.time, Wall(last)))


@grammar.rule("goal", "<hedge> <duration> before <goal>", "<hedge> <duration> prior to <goal>", weight=0.5)
def at_most_before(hedge: str, duration: Duration, goal: Goal) -> Goal | None:
    """No more than ten minutes before noon, less than three days before friday: from then to then."""
    if hedge not in UPPER or not _counts_from(goal):
        return None
    if not _is_day(goal):
        return replace(goal, time=Range(Offset(duration, -1, goal.time), goal.time))
    first = _days_off(goal, duration, -1)
    if first is None or not isinstance(goal.time, Wall) or goal.time.days is None:
        return None
    first = Away(1, Unit.DAY, first) if hedge in SHORT_OF else first
    return replace(goal, time=Range(Wall(first), Ending(Edge.START, goal.time.days)))


def _days_off(goal: Goal, duration: Duration, direction: int) -> Calendar | None:
    """Give the day so far off another; None off longer periods, and for hours."""
    day = goal.wall.days
    return None if day is None or day.grain is not Unit.DAY else days_away(duration, day, direction)


@grammar.rule("goal", "<duration> from|after|following <days>|<date>|<day of month>", weight=0.25)
def hedged_days_after(duration: Duration, days: Calendar) -> Goal | None:
    """Ten days or so from tomorrow: a day, too."""
    return _hedged_days(duration, days, 1)


@grammar.rule("goal", "<duration> before <days>|<date>|<day of month>", weight=0.25)
@grammar.rule("goal", "<duration> prior to <days>|<date>|<day of month>", weight=0.25)
def hedged_days_before(duration: Duration, days: Calendar) -> Goal | None:
    """A week or so before easter, five days or more before the 14th."""
    return _hedged_days(duration, days, -1)


def _hedged_days(duration: Duration, anchor: Calendar, direction: int) -> Goal | None:
    days = days_away(duration, anchor, direction) if duration.hedges else None
    if days is None:
        return None
    nearest = next((hedge for hedge in duration.hedges if hedge in UPPER), None)
    if nearest is None:
        return Goal(Wall(days), duration.hedges)
    side = at_most_before if direction < 0 else at_most_after
    return side(nearest, replace(duration, hedges=()), Goal(Wall(anchor), duration.hedges))


@grammar.rule("goal", "<goal> ,? give or take <duration>|<integer>", weight=0.6)
@grammar.rule("goal", "<goal> plus|+ or|/? minus|- <duration>", "<goal> ± <duration>", weight=0.6)
def give_or_take(goal: Goal, width: Duration | Integer) -> Goal | None:
    """Ten, give or take five (minutes): on either side."""
    if isinstance(width, Integer):
        width = Duration(((width.value, Unit.MINUTE),))
    return near(width, _as_hour(goal)) if goal.wall.clock is not None else None


def _as_hour(goal: Goal) -> Goal:
    """Give a number that is a clock time, as what stands beside it tells."""
    if not isinstance(goal.time, Wall) or goal.time.clock is None:
        return goal
    return replace(goal, time=replace(goal.time, clock=replace(goal.time.clock, bare=False, pair=False)))


def _is_quarter_hour(duration: Duration, goal: Goal) -> bool:
    """Whether a quarter beside a clock time is no quarter of a year: "up to a quarter past three"."""
    return duration.unit is Unit.QUARTER and goal.wall.clock is not None


def _is_day(goal: Goal) -> bool:
    """Whether it is a day, or a longer period, and no time of it."""
    return isinstance(goal.time, Wall) and not goal.wall.is_timed


def _counts_from(goal: Goal) -> bool:
    vague = isinstance(goal.time, TimeWord) and goal.time.constraint is not Constraint.AT
    return not vague and isinstance(goal.time, (Wall, TimeWord, Ending, HourMark))
