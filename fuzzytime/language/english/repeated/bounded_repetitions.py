"""Repetitions with times, days and bounds: "daily at nine", "every day this week", "every hour until six"."""

from dataclasses import replace

from fuzzytime.language.english.repeated.repetitions import SMALL
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.meaning.calendar import Cycle, Fields
from fuzzytime.language.meaning.expressions import (
    UNIT_SECONDS,
    Goal,
    HourMark,
    Range,
    Repeat,
    Said,
    SameTime,
    Wall,
)
from fuzzytime.language.meaning.joined.bounded_repeats import bounded_repeat, is_of_day
from fuzzytime.language.meaning.joined.first_times import ending_with
from fuzzytime.language.meaning.joined.intervals_on_days import on_days
from fuzzytime.language.meaning.joined.repeats_beside import narrowed_repeat, timed_as
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()


@grammar.rule("repeat", "<repeat> at|@|on|in|around the? <wall>", "<repeat> , on|at the? <wall>", weight=0.2)
def repeat_at(repeat: Repeat, wall: Wall) -> Repeat | None:
    """Every day at nine, on mondays at 4pm."""
    return narrowed_repeat(repeat, wall)


@grammar.rule("repeat", "<repeat> ,? the? <wall>", weight=0.2)
def repeat_beside(repeat: Repeat, wall: Wall) -> Repeat | None:
    """Every day 9 am, every day this week; but of "every two minutes, 15 children" no number is an hour."""
    counted = wall.bare and repeat.every is not None and repeat.every.seconds < DAY_SECONDS
    return None if counted else narrowed_repeat(repeat, wall)


@grammar.rule("repeat", "<wall> ,|on? <repeat>", weight=0.2)
def clock_repeat(wall: Wall, repeat: Repeat) -> Repeat | None:
    """9am on sundays, 0815 on weekdays; but "two nights" are no nights at two."""
    sure = wall.clock is not None and wall.clock.full_day and wall.clock.grain is Unit.MINUTE
    counts = wall.bare or _counts(wall, repeat)
    return None if (counts and not sure) or wall.weak else narrowed_repeat(repeat, wall)


@grammar.rule("repeat", "at|@ <wall> ,|on? <repeat>", weight=0.2)
def at_repeat(wall: Wall, repeat: Repeat) -> Repeat | None:
    """At noon every day, at nine on weekdays; but "at night for three | nights" has no hour."""
    return None if _counts(wall, repeat) and not wall.bare else narrowed_repeat(repeat, wall)


@grammar.rule(
    "said", "for <wall> ,|on? <repeat>", "for <wall> on? <repeat> ,|and <wall> on? <repeat>", weight=0.4
)
def for_repeat(wall: Wall, repeat: Repeat, *more: Wall | Repeat) -> Said | None:
    """(an alarm) for six on weekdays and eight at weekends."""
    found = None if _counts(wall, repeat) else narrowed_repeat(repeat, wall)
    if more and found is not None:
        second, days = more
        other = (
            narrowed_repeat(days, second) if isinstance(days, Repeat) and isinstance(second, Wall) else None
        )
        found = None if other is None else both(found, other)
    return None if found is None else Said(found, Constraint.EVERY, "for")


@grammar.rule("repeat", "on|in <wall> ,|on? <repeat>", weight=0.2)
def in_repeat(wall: Wall, repeat: Repeat) -> Repeat | None:
    """In the morning every day; but "in two working days" is none."""
    return None if wall.bare or _counts(wall, repeat) else narrowed_repeat(repeat, wall)


def _counts(wall: Wall, repeat: Repeat) -> bool:
    """Whether the number that a time ends in says how many parts of the day those behind it are."""
    return repeat.plural and wall.clock is not None and (wall.clock.bare or wall.part is not None)


@grammar.rule("repeat", "<repeat> ,|and at|@? <wall>", "at|@? <wall> ,|and <repeat>", weight=0.3)
def more_clocks(first: Repeat | Wall, second: Wall | Repeat) -> Repeat | None:
    """Every day at 8 am and 8 pm, at eight and nine every day."""
    repeat, wall = (first, second) if isinstance(first, Repeat) else (second, first)
    if not isinstance(repeat, Repeat) or not isinstance(wall, Wall) or wall.clock is None:
        return None
    clocked = bool(repeat.walls) and all(old.clock is not None for old in repeat.walls)
    if not clocked or wall.days is not None or wall.part is not None:
        return None
    clock = replace(wall.clock, bare=False, pair=False)
    more = dict.fromkeys(replace(old, clock=clock) for old in repeat.walls)
    return replace(repeat, walls=tuple(dict.fromkeys((*repeat.walls, *more))))


@grammar.rule("moments", "<wall>", weight=-0.1)
def moment(wall: Wall) -> tuple[Wall, ...] | None:
    """At eight, in the morning."""
    return (wall,) if wall.days is None and (wall.clock is not None or wall.part is not None) else None


@grammar.rule("moments", "<moments> ,|and|& at|@|in|once? <wall>", "<moments> , and at|@|in|once? <wall>")
def more_moments(moments: tuple[Wall, ...], wall: Wall) -> tuple[Wall, ...] | None:
    """At eight, at noon and at six."""
    last = moment(wall)
    return None if last is None else (*moments, *last)


@grammar.rule(
    "repeat",
    "<repeat> ,|:|-? at|@|in|once? <moments>",
    "at|@|in? <moments> , <repeat>",
    weight=0.7,
)
def so_often_at(first: Repeat | tuple[Wall, ...], second: tuple[Wall, ...] | Repeat) -> Repeat | None:
    """Twice a day, at eight and six; three times a day: morning, noon and night."""
    repeat, moments = (first, second) if isinstance(first, Repeat) else (second, first)
    if not isinstance(repeat, Repeat) or isinstance(moments, Repeat) or repeat.every is None:
        return None
    if (
        not repeat.shared
        or len(moments) == 1
        or repeat.every.seconds * len(moments) != UNIT_SECONDS[Unit.DAY]
    ):
        return None
    clocks = (wall.clock and replace(wall.clock, bare=False, pair=False) for wall in moments)
    walls = (
        replace(wall, days=Cycle(Unit.DAY), clock=clock, weak=False)
        for wall, clock in zip(moments, clocks, strict=True)
    )
    return Repeat(walls=tuple(walls))


@grammar.rule("repeat", "at|@ <wall> ,|and <wall> <repeat>", weight=0.35)
def two_clocks(first: Wall, second: Wall, repeat: Repeat) -> Repeat | None:
    """At 8 and 20 daily."""
    once = narrowed_repeat(repeat, second) if second.clock is not None else None
    return None if once is None else more_clocks(once, first)


@grammar.rule(
    "repeat",
    "<repeat> ,|and at? <wall> on? <repeat>",
    "<repeat> ,|and for|at|on? <repeat>",
    "<repeat> , and for|at|on? <repeat>",
    weight=0.35,
)
def both(first: Repeat, second: Wall | Repeat, third: Repeat | None = None) -> Repeat | None:
    """At 8 every morning and at 8 every night, every monday morning and every friday evening."""
    other = second if third is None and isinstance(second, Repeat) else None
    if third is not None and isinstance(second, Wall):
        other = narrowed_repeat(third, second)
    if other is None or not all(_is_plain(repeat) for repeat in (first, other)):
        return None
    # "On saturdays and sundays at ten", "at ten on saturdays and sundays"
    first, other = timed_as(first, other), timed_as(other, first)
    return replace(first, every=None, walls=tuple(dict.fromkeys((*first.walls, *other.walls))))


@grammar.rule("repeat", "<repeat> ,? on? <repeat>", weight=0.4)
def weeks_on_weekdays(weeks: Repeat, weekdays: Repeat) -> Repeat | None:
    """Every other week on mondays, once a week on saturday mornings."""
    weekly = all(isinstance(wall.days, Fields) and wall.days.weekly for wall in weekdays.walls)
    if [wall.days for wall in weeks.walls] != [Cycle(Unit.WEEK)] or not weekly or weekdays.skip != 1:
        return None
    return replace(weekdays, skip=weeks.skip) if _is_unbounded(weeks) and _is_unbounded(weekdays) else None


@grammar.rule("repeat", "<repeat> ,? <repeat>", weight=0.4)
def interval_on_days(interval: Repeat, days: Repeat) -> Repeat | None:
    """Every five minutes on weekdays, on mondays every hour."""
    return on_days(interval, days)


@grammar.rule("said", "<repeat> ,? <hedge> <repeat>", weight=0.6)
def weeks_mostly_on_weekdays(weeks: Repeat, hedge: str, weekdays: Repeat) -> Said | None:
    """Once a week, preferably on sundays."""
    both_said = weeks_on_weekdays(weeks, weekdays)
    return None if both_said is None else Said(both_said, Constraint.EVERY, None, (hedge,))


def _is_unbounded(repeat: Repeat) -> bool:
    return bool(repeat.walls) and repeat.starting is None and repeat.until is None


def _is_plain(repeat: Repeat) -> bool:
    """Whether it is nothing but days with times of day, or weekdays."""
    timed = all(wall.clock is not None or wall.part is not None for wall in repeat.walls)
    timed = timed or all(isinstance(wall.days, Fields) and wall.days.weekly for wall in repeat.walls)
    return bool(repeat.walls) and timed and repeat.skip == 1 and not (repeat.starting or repeat.until)


@grammar.rule("repeat", "<repeat> ,? at? <same>", "at? <same> ,? <repeat>", weight=0.2)
def every_mark(first: Repeat | SameTime | HourMark, second: Repeat | SameTime | HourMark) -> Repeat | None:
    """Every hour on the hour."""
    repeat, mark = (first, second) if isinstance(first, Repeat) else (second, first)
    if not isinstance(repeat, Repeat):
        return None
    counted = repeat.every is not None and repeat.every.unit in SMALL and repeat.starting is None
    return replace(repeat, starting=mark) if counted and isinstance(mark, HourMark) else None


@grammar.rule("repeat", "<repeat> <said>", "<repeat> , <said>", weight=0.1)
def bounded(repeat: Repeat, said: Said) -> Repeat | None:
    """Every day until friday, every ten minutes from noon to two."""
    return bounded_repeat(repeat, said)


@grammar.rule("so many each", "<so many each> ,? <said>", weight=0.1)
def so_many_each_bounded(each: Said, said: Said) -> Said | None:
    """(Learn five words) a day until friday."""
    found = bounded_repeat(each.time, said) if isinstance(each.time, Repeat) else None
    return None if found is None else replace(each, time=found)


@grammar.rule("repeat", "<hours open> ,|on? <repeat>", weight=-0.5)
def hours_repeated(said: Said, repeat: Repeat) -> Repeat | None:
    """(homework) 4 to 5 on weekdays."""
    return within_range(said, repeat)


@grammar.rule("repeat", "<said> ,|on? <repeat>", weight=-1)
def within_range(said: Said, repeat: Repeat) -> Repeat | None:
    """From nine to five every day, between lunch and three on fridays."""
    time = said.time
    # "Monday to friday every week" has no hours.
    hours = isinstance(time, Range) and is_of_day(time.first) and is_of_day(time.last)
    return bounded_repeat(repeat, said) if hours and repeat.walls else None


@grammar.rule(
    "repeat",
    "<repeat> ,|and the? first time|one|dose? <said>",
    "<repeat> the first time|one|dose? <said>",
    weight=0.6,
)
def from_first_time(repeat: Repeat, said: Said) -> Repeat | None:
    """Twice a day, the first time around eight."""
    moment = _moment_of(repeat, said)
    if moment is None or repeat.starting is not None or repeat.until is not None:
        return None
    return replace(repeat, starting=moment, shared=False)


@grammar.rule(
    "repeat",
    "<repeat> ,|and the? last time|one|dose? <said>",
    "<repeat> the last time|one|dose? <said>",
    weight=0.6,
)
def to_last_time(repeat: Repeat, said: Said) -> Repeat | None:
    """Every two hours, the last time at ten."""
    moment = _moment_of(repeat, said)
    bounded = repeat.until is not None or (repeat.times is not None and repeat.starting is not None)
    return None if moment is None or bounded else ending_with(repeat, moment)


def _moment_of(repeat: Repeat, said: Said) -> Wall | None:
    """Give the moment that an interval may begin or end at; None for other times, and other repetitions."""
    is_moment = said.constraint in {None, Constraint.AT} and bool(repeat.every)
    return said.time if isinstance(said.time, Wall) and is_moment else None


@grammar.rule(
    "repeat", "<repeat> thereafter|afterwards", "<repeat> after that", "<repeat> from then|there on"
)
def from_then_on(repeat: Repeat) -> Repeat:
    """(now and) every thirty seconds thereafter."""
    return repeat


@grammar.rule("said", "<repeat>", weight=0.1)
def repeated(repeat: Repeat) -> Said:
    """Every day at nine."""
    return Said(repeat, Constraint.EVERY)


@grammar.rule("said", "<preposition_at> <repeat>", weight=0.2)
def repeated_with_preposition(preposition: Preposition, repeat: Repeat) -> Said:
    """For wednesdays at two pm, by ten to eleven am daily."""
    return Said(repeat, Constraint.EVERY, preposition.name)


@grammar.rule("said", "<preposition_at> <goal> ,|on? <repeat>", "<goal> ,|on? <repeat>", weight=0.3)
def roughly_repeated(*said: Preposition | Goal | Repeat) -> Said | None:
    """At about four every day, midnight or so on weekdays."""
    *preposition, goal, repeat = said
    if not isinstance(goal, Goal) or not isinstance(repeat, Repeat):
        return None
    found = narrowed_repeat(repeat, goal.time) if goal.hedges and isinstance(goal.time, Wall) else None
    names = [first.name for first in preposition if isinstance(first, Preposition)]
    return None if found is None else Said(found, Constraint.EVERY, next(iter(names), None), goal.hedges)


@grammar.rule("said", "<repeat> ,? <preposition_at> <goal>", "<repeat> ,? <goal>", weight=0.3)
def repeated_roughly(repeat: Repeat, *said: Preposition | Goal) -> Said | None:
    """Every day at about four, every morning at eight sharp."""
    return roughly_repeated(*said, repeat)


@grammar.rule("said", "<hedge> <repeat>", weight=0.2)
def hedged_repeat(hedge: str, repeat: Repeat) -> Said:
    """About once a week."""
    return Said(repeat, Constraint.EVERY, None, (hedge,))


@grammar.rule("said", "<repeat> -|,? <hedge_after>", weight=0.2)
def repeated_hedged(repeat: Repeat, hedge: str) -> Said:
    """Every minute or so; every friday, if possible."""
    return Said(repeat, Constraint.EVERY, None, (hedge,))


@grammar.rule("said", "by <repeat>", "before <repeat>", weight=0.2)
def repeated_deadline(repeat: Repeat) -> Said:
    """By ten to eleven am daily."""
    return Said(repeat, Constraint.EVERY, "by")
