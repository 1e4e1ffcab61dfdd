"""Repetitions with bounds, days and hedges: "every day this week", "every hour until six"."""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.meaning.calendar import Cycle, is_weekday
from fuzzytime.language.meaning.expressions import (
    Goal,
    HourMark,
    Offset,
    Range,
    Repeat,
    Said,
    SameTime,
    TimeWord,
    Wall,
)
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.joined.bounded_repeats import bounded_repeat, from_now, is_of_day
from fuzzytime.language.meaning.joined.first_times import ending_with
from fuzzytime.language.meaning.joined.intervals_on_days import on_days
from fuzzytime.language.meaning.joined.repeats_beside import narrowed_repeat
from fuzzytime.requirement import MOMENTS, Constraint, Unit

grammar = Grammar()


@grammar.rule("repeat", "<repeat> ,? on? <repeat>", weight=0.4)
def weeks_on_weekdays(weeks: Repeat, weekdays: Repeat) -> Repeat | None:
    """Every other week on mondays, once a week on saturday mornings."""
    weekly = all(is_weekday(wall.days) for wall in weekdays.walls)
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


@grammar.rule("repeat", "<repeat> ,? at? <same>", "at? <same> ,? <repeat>", weight=0.2)
def every_mark(first: Repeat | SameTime | HourMark, second: Repeat | SameTime | HourMark) -> Repeat | None:
    """Every hour on the hour."""
    repeat, mark = (first, second) if isinstance(first, Repeat) else (second, first)
    if not isinstance(repeat, Repeat):
        return None
    counted = repeat.every is not None and repeat.every.unit in SUB_DAY and repeat.starting is None
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
@grammar.rule("repeat", "<said> ,|on? <repeat>", weight=-1)
def within_range(said: Said, repeat: Repeat) -> Repeat | None:
    """From nine to five every day, between lunch and three on fridays; (homework) 4 to 5 on weekdays."""
    time = said.time
    # "Monday to friday every week" has no hours.
    hours = isinstance(time, Range) and is_of_day(time.first) and is_of_day(time.last)
    return bounded_repeat(repeat, said) if hours and repeat.walls else None


@grammar.rule(
    "repeat",
    "<repeat> ,|and the? first time|one|dose|feed? <said>",
    "<repeat> the first time|one|dose|feed? <said>",
    "<repeat> ,|and the? next time|one|dose|feed <said>",
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
    """Every two hours, the last time at ten, the last one before midnight."""
    if said.constraint is Constraint.BEFORE and repeat.every is not None:
        return bounded_repeat(repeat, said)
    moment = _moment_of(repeat, said)
    bounded = repeat.until is not None or (repeat.times is not None and repeat.starting is not None)
    return None if moment is None or bounded else ending_with(repeat, moment)


def _moment_of(repeat: Repeat, said: Said) -> Wall | TimeWord | Offset | None:
    """Give the moment that an interval may begin or end at; None for other times, and other repetitions."""
    time = said.time
    if repeat.every is None:
        return None
    if isinstance(time, Wall):
        return time if said.constraint in MOMENTS else None
    if isinstance(time, TimeWord):
        # "Every six hours, the first one now"
        return time if time.constraint is Constraint.AT else None
    return from_now(said)


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
