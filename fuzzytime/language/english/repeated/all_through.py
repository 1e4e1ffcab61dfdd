"""Clock times all through a period: "at six for the rest of the week", "all week at noon"."""

from fuzzytime.language.english.from_now.how_long import for_the_next_one
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.calendar import Calendar
from fuzzytime.language.meaning.expressions import Duration, Repeat, Rest, Said, Wall
from fuzzytime.language.meaning.joined.repeats_beside import narrowed_repeat
from fuzzytime.language.meaning.joined.throughout import (
    LONGER,
    THROUGHOUT,
    daily_at,
    each_day,
    is_rest_of_days,
)
from fuzzytime.language.meaning.units import UnitWord
from fuzzytime.requirement import Constraint

grammar = Grammar()


@grammar.rule("repeat", "<said> ,? for|over? <rest>", weight=0.6)
def clock_for_the_rest(said: Said, rest: Rest) -> Repeat | None:
    """At six for the rest of the week."""
    left = Said(rest)
    return each_day(said, left) if is_rest_of_days(left) else None


@grammar.rule("repeat", "for|over? <rest> ,? <said>", weight=0.6)
def for_the_rest_at(rest: Rest, said: Said) -> Repeat | None:
    """For the rest of the week, at six."""
    return clock_for_the_rest(said, rest)


@grammar.rule("repeat", "<said> all <unit>", "<said> all <unit> long", weight=0.6)
def clock_all_week(said: Said, unit: UnitWord) -> Repeat | None:
    """At six all week."""
    long = unit.unit in LONGER and unit.count == 1
    return each_day(said, Said(Duration(((1, unit.unit),)), Constraint.FOR)) if long else None


@grammar.rule("repeat", "<said> ,? for the next|coming <unit>", weight=0.6)
def clock_for_the_next(said: Said, unit: UnitWord) -> Repeat | None:
    """At six for the next week."""
    coming = for_the_next_one(unit)
    return None if coming is None else each_day(said, coming)


@grammar.rule("repeat", "all <unit> ,? <said>", "all <unit> long ,? <said>", weight=0.6)
def all_week_at(unit: UnitWord, said: Said) -> Repeat | None:
    """All week at six."""
    return clock_all_week(said, unit)


@grammar.rule("repeat", "all <days> ,? <said>", weight=0.6)
def all_next_week_at(days: Calendar, said: Said) -> Repeat | None:
    """All next week at noon; but "all monday at noon" is one day."""
    daily = daily_at(said) if days.grain in LONGER else None
    return None if daily is None else narrowed_repeat(daily, Wall(days))


@grammar.rule("repeat", "<said> all <days>", "<said> for all of? <days>", weight=0.6)
def clock_all_next_week(said: Said, days: Calendar) -> Repeat | None:
    """At noon all next week, at noon for all of next week."""
    return all_next_week_at(days, said)


@grammar.rule("said", "all of? <date>", "for|through all of? <date>", "throughout <date>", weight=0.4)
@grammar.rule("said", "all of? <days>", "for|through all of? <days>", "throughout <days>", weight=0.4)
def all_of_days(days: Calendar) -> Said | None:
    """All of next week; with a clock time elsewhere it is on each day."""
    return Said(Wall(days), None, THROUGHOUT) if days.grain in LONGER else None
