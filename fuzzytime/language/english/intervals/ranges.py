"""From one time to another: "between 5 and 6 pm", "friday from 10 to 4", "from 4 pm for an hour"."""

from dataclasses import replace

from fuzzytime.language.english.clock_times.clocks import TO_AN_HOUR, number
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.calendar import Calendar, Fields, is_day_of_month
from fuzzytime.language.meaning.expressions import (
    Ending,
    Goal,
    HourMark,
    Midway,
    Offset,
    Range,
    Said,
    Time,
    TimeWord,
    Wall,
    wall_of,
)
from fuzzytime.language.meaning.joined.beside import in_hour_of, refined
from fuzzytime.language.meaning.joined.range_ends import closes, comparable, is_meal, is_one, lent
from fuzzytime.language.meaning.times_of_day import Clock, Half
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()

NOON = 12
TO_THE_HOUR = frozenset({5, 10, 20, 25})
"""Minutes that are counted back from an hour: "ten to one"."""


def range_of(first: Goal, last: Goal, *, minutes: bool = False, within: bool = False) -> Said | None:
    """Give a stretch; ``minutes`` where its first number may be some to its last: "today five to eight".

    ``within`` where what is asked for is somewhere in it: "between two and four".
    """
    last = _in_hour(first, last)
    clock = first.wall.clock
    if isinstance(first.time, Wall) and clock is not None and clock.hours and not minutes:
        first = replace(first, time=replace(first.time, clock=replace(clock, hours=False)))
    for time in (first.time, last.time):
        if not isinstance(time, (Wall, Ending, Offset)) and not (
            isinstance(time, TimeWord) and time.word == "now"
        ):
            return None
    if _is_to_hour(first.time, last.time, minutes=minutes):
        # "Twenty to seven in the evening" is one time.
        return None
    if isinstance(first.time, Wall) and (
        closes(first.time) or (first.time.bare and isinstance(last.time, Offset))
    ):
        # "From close to noon"; "between 10 and 15 minutes from now": the number shares the unit.
        return None
    if isinstance(first.time, Wall) and isinstance(last.time, Wall):
        apart = lent(first.time, last.time)
        if apart is None or not comparable(*apart):
            return None
        first, last = replace(first, time=apart[0]), replace(last, time=apart[1])
    stretch = Range(first.time, last.time, within=within)
    return Said(stretch, Constraint.BETWEEN, "between", (*first.hedges, *last.hedges))


def _is_to_hour(first: Time, last: Time, *, minutes: bool) -> bool:
    """Whether the first end of a range is minutes to the hour that is its last."""
    start = first.anchor if isinstance(first, Offset) else first
    if not isinstance(start, Wall) or not isinstance(last, Wall) or start.clock is None or last.clock is None:
        return False
    # "20 to 3pm", "20 to 6am"; but "from 20 to 6am"
    halves = {Half.AM, Half.PM} if minutes else {Half.PM}
    typed = start.bare and start.clock.hour in TO_AN_HOUR and last.clock.half in halves
    return (start.clock.minutes or typed) and last.clock.hour <= NOON


def _in_hour(first: Goal, last: Goal) -> Goal:
    """Give the end of a range in the hour of its start: "after ten but before half past", never "five to"."""
    if not isinstance(last.time, HourMark) or not isinstance(first.time, Wall):
        return last
    whole = in_hour_of(last.time, first.time)
    return last if whole is None else replace(last, time=whole)


@grammar.rule(
    "said",
    "between the? <goal> and|to|-|through|thru|until|till the? <goal>",
    "between the hours of <goal> and|to <goal>",
    weight=1.1,
)
def between(first: Goal, last: Goal) -> Said | None:
    """Between 5 and 6 pm, between monday and friday."""
    return range_of(first, last, within=True)


@grammar.rule(
    "said",
    "from the? <goal> to|-|through|thru the? <goal>",
    "from the? <goal> right? through to|till|until the? <goal>",
    "starting|beginning at? the? <goal> ,? and? ending|finishing at? the? <goal>",
    weight=1.1,
)
@grammar.rule("said", "from the? <goal> until|till|til|untill|up to? the? <goal>", weight=1.1)
def from_until(first: Goal, last: Goal) -> Said | None:
    """From 5 to 6 pm, from monday to friday."""
    return range_of(first, last)


@grammar.rule("goal", "halfway|midway between the? <goal> and the? <goal>", weight=1.2)
def midway(first: Goal, last: Goal) -> Goal | None:
    """Halfway between noon and two."""
    whole = between(first, last)
    return Goal(Midway(whole.time), whole.hedges) if whole and isinstance(whole.time, Range) else None


@grammar.rule("said", "from|since the? <goal> to date", weight=1.3)
@grammar.rule("said", "since the? <goal> to|-|through|until|till|up to? <word>", weight=1.3)
def until_now(first: Goal, now: TimeWord | None = None) -> Said | None:
    """From march to date, since monday until now."""
    return range_of(first, Goal(now or TimeWord("now", Constraint.AT)))


@grammar.rule("said", "for the? <date>|<weak date> to|until|till|through the? <date>|<weak date>", weight=1.1)
def for_days(first: Calendar, last: Calendar) -> Said | None:
    """(book it) for the 20th to the 27th."""
    days = first.grain is Unit.DAY and last.grain is Unit.DAY
    return range_of(Goal(Wall(first)), Goal(Wall(last))) if days else None


@grammar.rule("said", "<goal> to|through|thru the? <goal>", weight=1.0)
def from_to(first: Goal, last: Goal) -> Said | None:
    """5 to 6 pm, monday to friday; but two numbers alone are none."""
    return _side_by_side(first, last, minutes=True)


def _side_by_side(first: Goal, last: Goal, *, minutes: bool = False) -> Said | None:
    walls = [goal.time for goal in (first, last) if isinstance(goal.time, Wall)]
    if len(walls) == 2 and all(wall.bare for wall in walls):
        return None
    if minutes and (_is_minutes(first.time, last.time) or _is_open(last.time)):
        return None
    if first.wall.clock is not None and _is_number_of_day(last.time):
        # "6 pm to the second" is exact.
        return None
    if isinstance(first.time, Wall) and is_meal(first.time):
        # "Move lunch to one": a meal is what is moved; "close to six".
        return None
    grains = {wall.days.grain for wall in walls if wall.days is not None and wall.clock is None}
    if len(grains) > 1 and walls[0].days is not None and not walls[0].days.fixed and not _is_day(walls[1]):
        # "Q1-2019" and "aug-01-2019" are one date each; "nov - feb 5th" is none.
        return None
    return range_of(first, last, minutes=minutes)


def _is_open(time: Time) -> bool:
    """Whether it is so many minutes to an hour that is not said: "take 20 to 30 minutes to change"."""
    return isinstance(time, HourMark) and time.open


def _is_number_of_day(time: Time) -> bool:
    """Whether it is a day of whichever month: "the second"."""
    wall = wall_of(time)
    return wall.clock is None and is_day_of_month(wall.days)


def _is_day(wall: Wall) -> bool:
    """Whether it is a day of a month that is said with it."""
    days = wall.days
    return isinstance(days, Fields) and days.month is not None and days.day is not None


def _is_minutes(first: Time, last: Time) -> bool:
    """Whether a number in words is minutes: "about ten to six pm", but not "ten in the morning to two"."""
    start, end = (wall_of(time).clock for time in (first, last))
    return (
        wall_of(first).part is None
        and start is not None
        and end is not None
        and start.hours
        and start.half is None
        and end.hour <= start.hour
    )


@grammar.rule("said", "<goal> - -? the? <goal>", weight=1.0)
def with_dash(first: Goal, last: Goal) -> Said | None:
    """9:30 - 11:00, mon-fri; but "friday - june 19", "6 january - 6:30" are one time each."""
    if isinstance(first.time, Wall) and isinstance(last.time, Wall) and is_one(first.time, last.time):
        return None
    # "2 weeks before 16-jul"
    anchor = first.time.anchor if isinstance(first.time, Offset) else None
    dated = isinstance(anchor, Wall) and anchor.bare and last.wall.weak
    return None if dated else _side_by_side(first, last)


@grammar.rule("arrow", "- >", "= >", ">", "→", "⇒")
def arrow() -> str:
    """->."""
    return ">"


@grammar.rule("said", "<goal> <arrow> <goal>", weight=1.0)
def pointed(first: Goal, _: str, last: Goal) -> Said | None:
    """9:00 -> 9:30, 2 > 3pm."""
    return _side_by_side(first, last)


@grammar.rule("said", "@ <clock> -|to|till|until <clock>", weight=1.2)
def from_hour_to(first: Clock, last: Clock) -> Said | None:
    """(lunch) @12-1: the mark says that they are hours."""
    return range_of(Goal(Wall(clock=first)), Goal(Wall(clock=last)))


@grammar.rule(
    "said",
    "anytime|sometime|whenever <clock> to|- <clock>",
    "any|some time <clock> to|- <clock>",
    weight=1.2,
)
def sometime_from(first: Clock, last: Clock) -> Said | None:
    """Anytime 3 to 5."""
    return between(Goal(Wall(clock=first)), Goal(Wall(clock=last)))


@grammar.rule("called at", "<clock> - <clock>", "<clock> <arrow> <clock>", weight=1.0)
def called_between(first: Clock, *last: Clock | str) -> Said | None:
    """(call ann) 10-12, (vet) 10 -> 11; beside what else is done the numbers may be of anything."""
    end = last[-1]
    if not isinstance(end, Clock) or (first.bare and (first.grain, end.grain) == (Unit.MINUTE, Unit.HOUR)):
        # "2026-09" is a month.
        return None
    return from_hour_to(first, end)


@grammar.rule("called at", "<clock> to|till|til|until <clock>", weight=1.2)
def called_from(first: Clock, last: Clock) -> Said | None:
    """(lunch) 12 to 1, (gym) six til seven; but ten to one is ten minutes before it."""
    return None if first.bare and first.hour in TO_THE_HOUR else from_hour_to(first, last)


@grammar.rule("said", "on|for? <wall> ,? <integer> - <integer>", weight=0.9)
def hours_of_day(wall: Wall, first: Integer, last: Integer) -> Said | None:
    """Monday 11-4, on friday 9-5."""
    ends = [number(first), number(last)]
    if wall.clock is not None or wall.weak or None in ends:
        return None
    said = range_of(Goal(Wall(clock=ends[0])), Goal(Wall(clock=ends[1])))
    return None if said is None else refined(said, wall)


@grammar.rule("said", "on|for the? <wall> ,? <integer> - <integer>", weight=0.9)
def hours_of_date(wall: Wall, first: Integer, last: Integer) -> Said | None:
    """On the 12th, 2-4: behind a preposition a number of a day is sure."""
    return hours_of_day(replace(wall, weak=False), first, last) if wall.days is not None else None


@grammar.rule("said", "on? the? <goal> until|till|til|untill|up to? the? <goal>", weight=1.1)
def then_until(first: Goal, last: Goal) -> Said | None:
    """9:30 until 11, over lunch until two; but who is "at work until five" is somewhere."""
    wall, part = first.wall, first.wall.part
    if part is not None and part.place:
        return None
    if part is not None and part.meal and not wall.weak:
        # Behind its preposition a meal is a part of the time; "lunch until two" is what follows it.
        first = replace(first, time=replace(wall, part=replace(part, meal=False)))
    return range_of(first, last)


@grammar.rule("said", "from? the? <goal> until|till|til|to|- <days> at? <clock>", weight=1.5)
def until_other_day(first: Goal, days: Calendar, clock: Clock) -> Said | None:
    """From 2pm till tomorrow 4:30pm: a day before the clock time is its own."""
    if not isinstance(first.time, Wall) or first.time.clock is None:
        return None
    return Said(Range(first.time, Wall(days, clock=clock)), Constraint.BETWEEN, "between", first.hedges)


@grammar.rule("said", "<preposition_after> <goal> but|and <preposition_before> <goal>", weight=0.8)
@grammar.rule(
    "said",
    "<preposition_after> <goal> ,? but|and <preposition_before> <goal> at the very? latest",
    weight=1.4,
)
def after_and_before(after: Preposition, first: Goal, before: Preposition, last: Goal) -> Said | None:
    """Later than 3:30pm but before 6pm, not before three but by five at the latest."""
    return between(first, last)
