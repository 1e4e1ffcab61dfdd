"""How a time binds: stacked times, prepositions, hedges, ranges: "by noon", "in about ten minutes", "between 5 and 6 pm"."""

from dataclasses import replace

from fuzzytime.language.english.clocks import minutes_of, number
from fuzzytime.language.english.days import from_anchor
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.calendar import Calendar, Fields
from fuzzytime.language.meaning.expressions import (
    Clock,
    Coming,
    Duration,
    Edge,
    Ending,
    Goal,
    Offset,
    Quantity,
    Range,
    Said,
    Time,
    TimeWord,
    Wall,
)
from fuzzytime.language.meaning.relations import Relative, narrowed, same_day
from fuzzytime.requirement import Constraint

grammar = Grammar()


# -- stacked: "tomorrow morning at six am" ------------------------------------------------------------------------


@grammar.rule(
    "wall", "<wall> <wall>", "<wall> at|on|in|of|for|@|,|- <wall>", "<wall> , at|on|in <wall>", weight=0.1
)
def stacked(first: Wall, second: Wall) -> Wall | None:
    """Tomorrow at six, friday march fifteenth nine am, morning of the 15th."""
    return joined(first, second)


@grammar.rule("wall", "<wall> the <date>|<weak date>", "<wall> ( <date> )", weight=0.15)
def stacked_date(first: Wall, second: Calendar) -> Wall | None:
    """Tuesday the 19th."""
    return joined(first, Wall(second))


@grammar.rule("wall", "<weekday> <integer>", "<weekday> the <integer>", weight=0.0)
def weekday_and_day(weekday: int, day: object) -> Wall | None:
    """Monday 21."""
    number = getattr(day, "value", 0)
    return Wall(Fields(day=number, weekday=weekday)) if 12 < number <= 31 else None


def joined(first: Wall, second: Wall) -> Wall | None:
    """Give two wall-clock expressions as one, or None where they say the same thing twice."""
    # "Dinner on thursday" is a thing with its time; "tomorrow lunch" is a time.
    if (first.bare and second.bare) or (first.weak and first.part is not None):
        return None
    days: Calendar | None = first.days or second.days
    if first.days is not None and second.days is not None:
        # A day said again is taken at its word: the date.
        if same_day(first.days, second.days):
            days = second.days
        elif same_day(second.days, first.days):
            days = first.days
        else:
            days = narrowed(first.days, second.days)
        if days is None:
            return None
    if (first.part and second.part) or (first.clock and second.clock):
        return None
    clock = first.clock or second.clock
    if clock is not None:
        clock = replace(clock, bare=False, pair=False)
    weak = first.weak and second.weak
    return Wall(days, first.part or second.part, clock, first.zone or second.zone, weak)


# -- goals: a time and its hedges ------------------------------------------------------------------------------------


@grammar.rule("goal", "<wall>|<end>|<stretch>|<rest>|<offset>|<word>")
def goal(time: Time) -> Goal:
    """Any time."""
    return Goal(time)


@grammar.rule("goal", "<hedge> the? <goal>", weight=0.05)
def hedged(hedge: str, goal: Goal) -> Goal | None:
    """About noon, almost six."""
    return replace(goal, hedges=(hedge, *goal.hedges)) if len(goal.hedges) < 3 else None


@grammar.rule("goal", "<goal> <hedge_after>", "<goal> - <hedge_after>", "<goal> , <hedge_after>", weight=0.05)
def hedged_after(goal: Goal, hedge: str) -> Goal | None:
    """Noon sharp, 3pm approximately, elevenish."""
    if isinstance(goal.time, Wall) and goal.time.clock is not None:
        clock = replace(goal.time.clock, bare=False, pair=False)
        goal = replace(goal, time=replace(goal.time, clock=clock))
    return replace(goal, hedges=(*goal.hedges, hedge)) if len(goal.hedges) < 3 else None


@grammar.rule("said", "<duration> <forward>", "<duration> ' <forward>", weight=0.3)
def from_now(duration: Duration, preposition: Preposition) -> Said:
    """Ten minutes from now, half an hour later."""
    return Said(Offset(replace(duration, hedges=())), None, preposition.name, duration.hedges)


@grammar.rule("said", "<duration> <back>", weight=0.3)
def ago(duration: Duration, preposition: Preposition) -> Said:
    """Two days ago."""
    return Said(Offset(replace(duration, hedges=()), -1), None, preposition.name, duration.hedges)


@grammar.rule("offset", "<duration> <forward>|<back>")
def counted(duration: Duration, preposition: Preposition) -> Offset:
    """Ten minutes from now, as the end of a range or behind a preposition."""
    return Offset(duration, -1 if preposition.name == "ago" else 1)


@grammar.rule("offset", "<duration> before|'til|to|prior <goal>", "<duration> prior to <goal>", weight=0.1)
def before_goal(duration: Duration, goal: Goal) -> Offset | None:
    """Twenty minutes before noon."""
    return Offset(duration, -1, goal.time) if _counts_from(goal) else None


@grammar.rule("offset", "<duration> after|past|following <goal>", weight=0.1)
def after_goal(duration: Duration, goal: Goal) -> Offset | None:
    """Two hours after lunch."""
    return Offset(duration, 1, goal.time) if _counts_from(goal) else None


@grammar.rule("offset", "<duration> from <goal>", weight=0.1)
def from_goal(duration: Duration, goal: Goal) -> Offset | None:
    """An hour from noon, 15 minutes from 1pm."""
    return Offset(duration, 1, goal.time) if _counts_from(goal) else None


def _counts_from(goal: Goal) -> bool:
    return not goal.hedges and isinstance(goal.time, (Wall, TimeWord, Ending))


# -- said: with a preposition -------------------------------------------------------------------------------------------


def _said(
    goal: Goal, preposition: str | None, constraint: Constraint | None = None, edge: Edge = Edge.START
) -> Said:
    return Said(goal.time, constraint, preposition, goal.hedges, edge)


@grammar.rule("said", "<goal>")
def plain(goal: Goal) -> Said:
    """Tomorrow, now, six o'clock."""
    return _said(goal, None)


@grammar.rule(
    "offset", "less than <duration> after|from <goal>", "within <duration> after|from|of <goal>", weight=0.4
)
def soon_after(duration: Duration, goal: Goal) -> Range | None:
    """Less than three days after tomorrow: from then to then."""
    return Range(goal.time, Offset(duration, 1, goal.time)) if _counts_from(goal) else None


@grammar.rule("said", "<preposition_at> the? <goal>", weight=0.1)
def beside(preposition: Preposition, goal: Goal) -> Said | None:
    """At six, on friday, around noon, sometime tomorrow."""
    if isinstance(goal.time, TimeWord) and preposition.name in {"in", "at", "on"}:
        return None
    return _said(goal, preposition.name)


@grammar.rule("said", "<preposition_before> the? <goal>", "<preposition_before> at <goal>", weight=0.2)
def deadline(preposition: Preposition, goal: Goal) -> Said | None:
    """By noon, no later than six, before tomorrow."""
    if isinstance(goal.time, TimeWord) and goal.time.constraint is Constraint.VAGUE:
        return None
    if isinstance(goal.time, Coming):
        return replace(coming_deadline(goal), preposition=preposition.name)
    return _said(goal, preposition.name, Constraint.BEFORE, preposition.edge)


def coming_deadline(goal: Goal) -> Said:
    """Give "the next ten minutes" as a deadline: ten minutes from now."""
    time = goal.time
    duration = time.duration if isinstance(time, Coming) else Duration(())
    return Said(replace(duration, hedges=()), Constraint.BEFORE, "before", (*goal.hedges, *duration.hedges))


@grammar.rule("said", "<preposition_after> the? <goal>", "<preposition_after> at <goal>", weight=0.2)
def release(preposition: Preposition, goal: Goal) -> Said | None:
    """After 5 pm, from monday, not before noon."""
    if isinstance(goal.time, TimeWord) and goal.time.constraint is Constraint.VAGUE:
        return None
    return _said(goal, preposition.name, Constraint.AFTER, preposition.edge)


@grammar.rule(
    "said",
    "<goal> or|and|at later|after|greater|onwards|onward|on",
    "<goal> onwards|onward",
    "<goal> at the earliest",
    weight=0.3,
)
def or_later(goal: Goal) -> Said:
    """3 pm or later, monday onwards, at noon at the earliest."""
    return _said(goal, "not before", Constraint.AFTER, Edge.START)


@grammar.rule(
    "said",
    "at|on|from|by <goal> or|and later|after|onwards|onward|on",
    "at|on|from <goal> onwards|onward|on",
    "at|on <goal> at the earliest",
    weight=0.4,
)
def at_or_later(goal: Goal) -> Said:
    """At 3 pm or later."""
    return _said(goal, "not before", Constraint.AFTER, Edge.START)


@grammar.rule(
    "said",
    "<goal> or|and before|earlier|sooner",
    "by|at|on|in? <goal> at the latest",
    "at|on|by <goal> or earlier|before|sooner",
    weight=0.4,
)
def or_earlier(goal: Goal) -> Said:
    """Noon at the latest, six or earlier."""
    return _said(goal, "no later than", Constraint.BEFORE, Edge.LAST)


@grammar.rule("said", "<beside> the? <goal>", "at|on <beside> the? <goal>", weight=0.4)
def just_off(hedge: str, goal: Goal) -> Said | None:
    """Shortly before noon, just after 5 pm: points, no deadlines."""
    if not isinstance(goal.time, (Wall, Ending)):
        return None
    edge = Edge.END if hedge.endswith("after") else Edge.START
    return Said(goal.time, None, None, (hedge, *goal.hedges), edge, beside=True)


# -- from now on: durations with a preposition ----------------------------------------------------------------------------


def _length(duration: Duration, constraint: Constraint, preposition: str) -> Said:
    return Said(replace(duration, hedges=()), constraint, preposition, duration.hedges)


@grammar.rule(
    "said",
    "in the? <duration>",
    "in <duration> time",
    "in <duration> ' time",
    "in <duration> from now",
    weight=0.3,
)
def in_duration(duration: Duration) -> Said:
    """In ten minutes, in half an hour's time."""
    return _length(duration, Constraint.AT, "in")


@grammar.rule("said", "starting|beginning|commencing in <duration>", weight=0.4)
def starting_in(duration: Duration) -> Said:
    """Starting in a quarter of an hour."""
    return _length(duration, Constraint.AT, "in")


@grammar.rule("said", "starting|beginning|commencing at? the? <goal>", weight=0.3)
def starting_at(goal: Goal) -> Said | None:
    """Starting at three pm: then, not some time after it; but "starting tomorrow" is from then on."""
    clock = isinstance(goal.time, Wall) and goal.time.clock is not None
    return _said(goal, "starting") if clock else None


@grammar.rule("said", "in <quantity>", weight=-0.2)
def in_number(quantity: Quantity) -> Said | None:
    """In 15: minutes."""
    if (
        not 1 <= quantity.value <= 240
        or quantity.indefinite
        or quantity.hedges
        or quantity.value != int(quantity.value)
    ):
        return None
    return _length(minutes_of(quantity), Constraint.AT, "in")


@grammar.rule("said", "after <duration>", "after another <duration>", "<hedge> after <duration>", weight=0.3)
def after_duration(first: str | Duration, second: Duration | None = None) -> Said | None:
    """After ten minutes."""
    duration = second if isinstance(first, str) else first
    if duration is None:
        return None
    hedges = (first,) if isinstance(first, str) else ()
    return _length(duration.hedged(*hedges), Constraint.AFTER, "after")


@grammar.rule(
    "said",
    "before|within|in <hedge>? the? next <duration>",
    "before|within|in the? <hedge>? next <duration>",
    weight=0.6,
)
def before_the_next(hedge: str | None, duration: Duration) -> Said:
    """Before the next ten minutes, before approximately the next ten minutes."""
    return _length(duration.hedged(*([hedge] if hedge else [])), Constraint.BEFORE, "before")


@grammar.rule("said", "before <duration>", "before <duration> from now", weight=0.2)
def before_duration(duration: Duration) -> Said:
    """Before ten minutes."""
    return _length(duration, Constraint.BEFORE, "before")


@grammar.rule("said", "<within> the? <duration>", "<within> <duration> from now|today", weight=0.5)
def within(preposition: Preposition, duration: Duration) -> Said:
    """Within ten minutes."""
    return _length(duration, Constraint.BEFORE, preposition.name)


@grammar.rule("said", "<hedge>? within the? <deictic>? <goal>", weight=0.2)
def within_time(hedge: str | None, which: object, goal: Goal) -> Said | None:
    """Within the day."""
    if isinstance(goal.time, (TimeWord, Offset)):
        return None
    if isinstance(goal.time, Coming):
        return replace(coming_deadline(goal), preposition="within")
    hedges = () if hedge is None else (hedge,)
    return Said(goal.time, Constraint.BEFORE, "within", (*hedges, *goal.hedges), Edge.LAST)


@grammar.rule(
    "said",
    "for <duration>",
    "for the? next <duration>",
    "for another <duration>",
    "lasting|taking|of? <duration> long",
    "lasting|taking <duration>",
    "over|during the? next? <duration>",
    weight=0.35,
)
def for_duration(duration: Duration) -> Said:
    """For eight minutes, for the next hour."""
    return _length(duration, Constraint.FOR, "for")


@grammar.rule("said", "<duration>", weight=-0.2)
def duration_alone(duration: Duration) -> Said:
    """Ten minutes: how long."""
    return Said(replace(duration, hedges=()), Constraint.FOR, None, duration.hedges)


@grammar.rule(
    "said", "<preposition_at> <duration> <forward>", "<preposition_at> <duration> ' <forward>", weight=0.3
)
def at_offset(first: Preposition, duration: Duration, second: Preposition) -> Said | None:
    """For five minutes from now."""
    return (
        Said(Offset(replace(duration, hedges=())), None, first.name, duration.hedges)
        if second.name == "from now"
        else None
    )


@grammar.rule("said", "<preposition_before>|<within> <duration> <forward>", weight=0.3)
def deadline_offset(first: Preposition, duration: Duration, second: Preposition) -> Said:
    """Before ten minutes from now."""
    return _length(duration, Constraint.BEFORE, first.name)


# -- ranges ------------------------------------------------------------------------------------------------------------------


def _range(first: Goal, last: Goal, preposition: str | None, *, inclusive: bool = False) -> Said | None:
    for time in (first.time, last.time):
        if not isinstance(time, (Wall, Ending, Offset)) and not (
            isinstance(time, TimeWord) and time.word == "now"
        ):
            return None
    if isinstance(first.time, Wall) and isinstance(last.time, Wall):
        apart = _lent(first.time, last.time)
        if apart is None:
            return None
        first, last = replace(first, time=apart[0]), replace(last, time=apart[1])
    time = Range(first.time, last.time, inclusive=inclusive)
    return Said(time, Constraint.BETWEEN, preposition, (*first.hedges, *last.hedges))


def _lent(first: Wall, last: Wall) -> tuple[Wall, Wall] | None:
    """Lend each end what only the other says: "july 13 to 15", "from 5 to 6pm tomorrow", "13th to 15th july"."""
    if (first.clock is None) != (last.clock is None):
        bare = first if first.clock is not None else last
        other = last if first.clock is not None else first
        if bare.bare and isinstance(other.days, Fields) and other.days.day is not None:
            # A number beside a date is a day of the month.
            day = Fields(day=bare.clock.hour) if bare.clock is not None else None
            if day is None or not 1 <= (day.day or 0) <= 31:
                return None
            first, last = (Wall(day), last) if bare is first else (first, Wall(day))
    if first.clock is not None and last.clock is not None:
        days = first.days or last.days
        zone = first.zone or last.zone
        part = None if first.days and last.days else first.part or last.part
        # The other end's day, where it says one itself, is its own.
        first = replace(first, days=first.days or days, zone=zone, part=first.part or part)
        last = replace(last, zone=zone, part=last.part or part)
        if last.days == first.days:
            last = replace(last, days=None)
    return first, last


@grammar.rule(
    "said",
    "between the? <goal> and|to|- the? <goal>",
    "from the? <goal> to|-|through|thru the? <goal>",
    weight=1.1,
)
def between(first: Goal, last: Goal) -> Said | None:
    """Between 5 and 6 pm, from monday to friday."""
    return _range(first, last, "between")


@grammar.rule("said", "<goal> to|-|through|thru the? <goal>", weight=1.0)
def from_to(first: Goal, last: Goal) -> Said | None:
    """5-6 pm, 9:30 - 11:00, monday to friday; but two numbers alone are none."""
    if all(isinstance(goal.time, Wall) and goal.time.bare for goal in (first, last)):
        return None
    return _range(first, last, "between")


@grammar.rule("said", "<wall> <integer> - <integer>", weight=0.9)
def hours_of_day(wall: Wall, first: Integer, last: Integer) -> Said | None:
    """Monday 11-4."""
    ends = [number(first), number(last)]
    if wall.clock is not None or wall.weak or None in ends:
        return None
    said = _range(Goal(Wall(clock=ends[0])), Goal(Wall(clock=ends[1])), "between")
    return None if said is None else refined(said, wall)


@grammar.rule("said", "from? the? <goal> until|till|til|untill|up|'til to? the? <goal>", weight=1.1)
def from_until(first: Goal, last: Goal) -> Said | None:
    """From 9:30 until 11."""
    return _range(first, last, "between")


@grammar.rule("said", "from? the? <goal> until|till|til|to|- <days> at? <clock>", weight=1.5)
def until_other_day(first: Goal, days: Calendar, clock: Clock) -> Said | None:
    """From 2pm till tomorrow 4:30pm: a day before the clock time is its own."""
    if not isinstance(first.time, Wall) or first.time.clock is None:
        return None
    return Said(Range(first.time, Wall(days, clock=clock)), Constraint.BETWEEN, "between", first.hedges)


@grammar.rule(
    "said",
    "from|starting|beginning|at? at? the? <goal> ,? for <duration>",
    "for <duration> ,? from|starting|beginning|at from|at|on? the? <goal>",
    "<duration> starting|beginning from|at|on|in? the? <goal>",
    weight=0.9,
)
def lasting(first: Goal | Duration, second: Duration | Goal) -> Said | None:
    """From 4pm for thirty minutes, for 2 hours from 2pm: a start, and how long."""
    goal, duration = (second, first) if isinstance(first, Duration) else (first, second)
    if not isinstance(goal, Goal) or not isinstance(duration, Duration) or not isinstance(goal.time, Wall):
        return None
    return Said(goal.time, None, "from", goal.hedges, lasting=duration)


@grammar.rule("wall", "in <duration> ,? at|on? <wall>", weight=0.3)
def after_days_at(duration: Duration, wall: Wall) -> Wall | None:
    """In seven days at 5pm, in three days on friday."""
    away = from_anchor(duration, Relative(0), 1)
    return None if away is None or wall.bare else joined(Wall(away), wall)


@grammar.rule("said", "today in <duration>", weight=0.5)
def today_in(duration: Duration) -> Said:
    """Today in one hour."""
    return _length(duration, Constraint.AT, "in")


@grammar.rule("said", "at <clock>", weight=0.15)
def at_clock(clock: Clock) -> Said:
    """At 1030."""
    return Said(Wall(clock=clock), None, "at")


@grammar.rule("said", "<preposition_after> <goal> but|and <preposition_before> <goal>", weight=0.8)
def after_and_before(after: Preposition, first: Goal, before: Preposition, last: Goal) -> Said | None:
    """Later than 3:30pm but before 6pm."""
    return _range(first, last, "between")


@grammar.rule("said", "<said> at|on|of|,|in? the? <wall>", weight=0.1)
def range_on_day(said: Said, wall: Wall) -> Said | None:
    """Between 3 and 5 on friday."""
    return refined(said, wall)


@grammar.rule("said", "<wall> , <said>", "<wall> <said>", "<preposition_at> <wall> <said>", weight=0.1)
def day_and_bound(first: Preposition | Wall, second: Wall | Said, third: Said | None = None) -> Said | None:
    """Tomorrow before 5pm, tomorrow evening by seven, friday between 1PM and 4 PM."""
    wall, said = (first, second) if third is None else (second, third)
    if not isinstance(wall, Wall) or not isinstance(said, Said):
        return None
    return refined(said, wall)


def refined(said: Said, wall: Wall) -> Said | None:
    """Give a bound whose time lies on a day, or in a part of the day, that was said beside it."""
    if (
        said.constraint not in {Constraint.BEFORE, Constraint.AFTER, Constraint.BETWEEN}
        or wall.clock is not None
    ):
        return None
    if isinstance(said.time, Wall) and said.time.clock is not None:
        time = joined(said.time, wall)
        return None if time is None else replace(said, time=time)
    if (
        isinstance(said.time, Range)
        and isinstance(said.time.first, Wall)
        and isinstance(said.time.last, Wall)
    ):
        first, last = joined(said.time.first, wall), said.time.last
        if first is None or said.time.first.days is not None:
            return None
        if wall.part is not None and last.part is None and last.clock is not None:
            last = replace(last, part=wall.part)
        return replace(said, time=Range(first, last))
    return None
