"""Working days, weekends and parts of them, again and again: "every weeknight", "every other weekend"."""

from collections.abc import Iterable
from dataclasses import replace

from fuzzytime.language.english.repeated.repetitions import daily
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.calendar import Cycle, Fields, Weekend
from fuzzytime.language.meaning.days.nested import EachDay
from fuzzytime.language.meaning.days.relations import Deictic, Stretch, Which
from fuzzytime.language.meaning.expressions import Duration, Offset, Repeat, Said, Wall
from fuzzytime.language.meaning.joined.repeats_beside import narrowed_repeat
from fuzzytime.language.meaning.times_of_day import NOON, Clock, Part
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()

WORKING, FREE = range(5), range(5, 7)
"""Days of the week, 0 for Monday."""

BEFORE_WORKING = (6, *range(4))
"""Days whose nights come before working ones."""

SOON = 7
"""Days of which one is meant by "one of these"."""

LONGEST_MONTH = 31


def _on(days: Iterable[int], *parts: Part) -> Repeat:
    return Repeat(walls=tuple(Wall(Fields(weekday=day), part) for part in parts for day in days))


@grammar.rule("repeat", "every|each school <part>", "on? school <parts>", weight=0.2)
def school_nights(part: Part) -> Repeat | None:
    """On school mornings, and on school nights: those before a day of school."""
    if part.meal or part.is_point:
        return None
    return _on(WORKING if part.end <= NOON else BEFORE_WORKING, part)


@grammar.rule("repeat", "every|each <weeknight>", "on? <weeknight>")
def weeknights(night: Part) -> Repeat:
    """Every weeknight."""
    return _on(WORKING, night)


@grammar.rule(
    "repeat",
    "every|each other|second|alternate weekday|workday",
    "every|each other|second|alternate working|work|business|school day",
    "on? alternate weekdays|workdays",
    weight=1.5,
)
def every_other_working_day() -> Repeat:
    """Every other weekday: monday, wednesday, friday, tuesday, and so on."""
    return Repeat(walls=(Wall(EachDay(Weekend(working=True))),), skip=2)


@grammar.rule(
    "repeat",
    "every|each other|second|alternate weekend",
    "on? alternate weekend|weekends",
    "on? every other weekends",
    weight=1.5,
)
def every_other_weekend() -> Repeat:
    """Every other weekend: taken as a whole, it begins on Saturday."""
    return Repeat(walls=(Wall(Weekend()),), skip=2)


@grammar.rule("called at", "<clock> <repeat>", weight=0.5)
def called_every(clock: Clock, repeat: Repeat) -> Said | None:
    """(call ann) 8 every morning; but "take 2 every morning", "two sundays", "two-hourly" say how many."""
    if repeat.every is not None or (repeat.plural and clock.bare):
        return None
    found = narrowed_repeat(repeat, Wall(clock=replace(clock, bare=False, pair=False)))
    return None if found is None else Said(found, Constraint.EVERY)


@grammar.rule("repeat", "on? weekend <parts>", "every|each weekend <part>", weight=0.3)
def weekend_parts(part: Part) -> Repeat:
    """Weekend mornings."""
    return _on(FREE, part)


@grammar.rule("repeat", "every|each weekday <part> and <part>", weight=0.5)
def two_weekday_parts(first: Part, second: Part) -> Repeat:
    """Every weekday morning and evening."""
    return _on(WORKING, first, second)


@grammar.rule("repeat", "for? <integer> days in a row", "for? <integer> days running", weight=0.6)
def days_in_a_row(number: Integer) -> Repeat | None:
    """Three days in a row."""
    if not 1 < number.value <= LONGEST_MONTH:
        return None
    return _each_for(number.value)


@grammar.rule("repeat", "for? <integer> <parts> in a row", "for? <integer> <parts> running", weight=0.6)
def parts_in_a_row(number: Integer, part: Part) -> Repeat | None:
    """Three mornings in a row."""
    if not 1 < number.value <= LONGEST_MONTH:
        return None
    return _each_for(number.value, part)


def _each_for(days: int, part: Part | None = None) -> Repeat:
    until = Offset(Duration(((days, Unit.DAY),)))
    if part is None:
        return replace(daily(), until=until)
    return Repeat(walls=(Wall(Cycle(Unit.DAY), part),), until=until)


@grammar.rule("wall", "one of these <parts>", weight=1.0)
def one_of_these(part: Part) -> Wall | None:
    """One of these evenings: of those of the next days."""
    return Wall(Stretch(SOON, Unit.DAY), part) if not part.is_point else None


@grammar.rule("said", "on? one|some <part>", weight=1.0)
def one_evening(part: Part) -> Said | None:
    """One evening: of the next days; "one night" is how long, and "(ring at) one afternoon" an hour."""
    wall = None if part.name == "night" else one_of_these(part)
    return None if wall is None else Said(wall)


@grammar.rule("wall", "all weekend long?", "throughout the? weekend", weight=0.5)
def all_weekend() -> Wall:
    """All weekend."""
    return Wall(Deictic(Which.THIS, Weekend()))


@grammar.rule("said", "weekend", weight=-0.2)
def weekend_alone() -> Said:
    """Weekend, in front of what is to be done then."""
    return Said(Wall(Deictic(Which.THIS, Weekend())))
