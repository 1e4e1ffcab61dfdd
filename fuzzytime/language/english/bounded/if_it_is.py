"""Conditions that the calendar decides: "if it's thursday", "unless it's sunday", "if it's after nine"."""

from dataclasses import replace

from fuzzytime.language.english.repeated.days_left_out import except_on, off
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.calendar import Calendar, Fields, Weekend
from fuzzytime.language.meaning.days.relations import Deictic, Relative, Which
from fuzzytime.language.meaning.days.workdays import SparedDays, Workday, Workdays
from fuzzytime.language.meaning.expressions import Repeat, Said, Wall
from fuzzytime.language.meaning.feasts import Feast
from fuzzytime.language.meaning.joined.beside import joined
from fuzzytime.language.meaning.joined.intervals_on_days import on_days
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()

ANY_WEEKDAY = Workdays(1, Relative(0))
"""What "a weekday" is elsewhere: the next; as a condition it may be this day."""

TURNED = {Constraint.BEFORE: Constraint.AFTER, Constraint.AFTER: Constraint.BEFORE}


def _kind_of_day(days: Calendar) -> Calendar | None:
    """Give the days that a condition is about: "sunday", "the weekend", "a weekday"; but not "tomorrow"."""
    if days == ANY_WEEKDAY:
        return Workday()
    if isinstance(days, Deictic) and days.which is Which.THIS and days.of == Weekend():
        return Weekend()
    named = isinstance(days, (Feast, Weekend)) or (isinstance(days, Fields) and days.grain is Unit.DAY)
    return days if named else None


@grammar.rule("kind of day", "<days>")
def kind_of_day(days: Calendar) -> tuple[Calendar, ...] | None:
    """Sunday, the weekend."""
    named = _kind_of_day(days)
    return None if named is None else (named,)


@grammar.rule("kind of day", "<days> or a|the? <kind of day>", "<days> , <kind of day>", weight=0.2)
def kinds_of_day(first: Calendar, others: tuple[Calendar, ...]) -> tuple[Calendar, ...] | None:
    """Saturday or sunday."""
    named = _kind_of_day(first)
    return None if named is None else (named, *others)


@grammar.rule(
    "condition",
    "only? if|when|whenever it's|its <kind of day>",
    "only? if|when|whenever it|today is <kind of day>",
    "as long as it's|its <kind of day>",
    "unless it's|its not <kind of day>",
    weight=0.5,
)
def if_it_is(days: tuple[Calendar, ...]) -> Calendar:
    """(put the bins out) if it's thursday: on that day."""
    return days[0] if len(days) == 1 else SparedDays((SparedDays(days),))


@grammar.rule(
    "condition",
    "unless|except it's|its <kind of day>",
    "unless on <kind of day>",
    "unless|except it|today is <kind of day>",
    "except|not if|when it's|its <kind of day>",
    "except|not if|when it|today is <kind of day>",
    "if|when it's|its not <kind of day>",
    "if|when it|today is not <kind of day>",
    "if|when it|today isn't <kind of day>",
    "as long as it's|its not <kind of day>",
    "as long as it isn't <kind of day>",
    weight=0.6,
)
def unless_it_is(days: tuple[Calendar, ...]) -> Calendar:
    """(at six) unless it's sunday: on the next day that is none."""
    return SparedDays(days)


@grammar.rule("said", "<condition>", weight=0.5)
def on_condition(days: Calendar) -> Said:
    """If it's thursday."""
    return Said(Wall(days))


@grammar.rule("said", "<said> ,? <condition>", weight=0.5)
def at_on_condition(said: Said, days: Calendar) -> Said | None:
    """At six unless it's sunday."""
    wall = said.time
    both = joined(wall, Wall(days)) if isinstance(wall, Wall) and wall.days is None else None
    return None if both is None else replace(said, time=both)


@grammar.rule("repeat", "<repeat> ,? <condition>", weight=0.8)
def repeated_on_condition(repeat: Repeat, days: Calendar) -> Repeat | None:
    """Every day at six unless it's sunday, every hour if it's a weekday."""
    kept = _weekdays(days)
    if kept is None:
        return None
    left_out = tuple(set(range(7)) - kept)
    so = Repeat(walls=tuple(Wall(Fields(weekday=day)) for day in sorted(kept)))
    return except_on(repeat, left_out) or on_days(repeat, so)


def _weekdays(days: Calendar) -> set[int] | None:
    """Give the weekdays on which something is so; None where other days matter."""
    if isinstance(days, SparedDays):
        others = [_weekdays(other) for other in days.others]
        known = [other for other in others if other is not None]
        return set(range(7)).difference(*known) if len(known) == len(others) else None
    if isinstance(days, (Weekend, Workday)):
        weekend = set(off())
        return weekend if isinstance(days, Weekend) else set(range(7)) - weekend
    return {days.weekday} if isinstance(days, Fields) and days.weekly and days.weekday is not None else None


@grammar.rule(
    "said",
    "if|when|once|whenever it's|its <said>",
    "if|when|once|whenever it is|gets|goes <said>",
    weight=0.5,
)
def if_it_is_past(said: Said) -> Said | None:
    """(call the office) if it's after nine, once it's past nine: from then on, which may be now."""
    if not _bounds(said):
        return None
    return replace(said, preposition="from") if said.preposition == "after" else said


@grammar.rule("said", "unless it's|its <said>", "unless it is <said>", weight=0.5)
def unless_it_is_past(said: Said) -> Said | None:
    """(call) unless it's after nine: before that."""
    if not _bounds(said) or said.constraint is None:
        return None
    turned = TURNED[said.constraint]
    return replace(said, constraint=turned, preposition=turned.value)


def _bounds(said: Said) -> bool:
    """Whether it is before or after a clock time."""
    clock = said.wall.clock
    return clock is not None and said.constraint in TURNED
