"""Hours, clock times and parts of the day on a stretch of weekdays: "monday to friday from 9 to 5"."""

from dataclasses import replace

from fuzzytime.language.english.clocks import number
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import Range, Repeat, Said, Wall
from fuzzytime.language.meaning.repeats_beside import narrowed_repeat, within_hours
from fuzzytime.language.meaning.times_of_day import Part
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()


@grammar.rule("week stretch", "from? <weekday> to|-|through|thru|till|until <weekday>")
def week_stretch(first: int, last: int) -> tuple[int, ...]:
    """Monday to friday, beside hours: on each of these days."""
    return tuple((first + day) % 7 for day in range((last - first) % 7 + 1))


@grammar.rule("repeat", "every|each day ,? <week stretch>", weight=1.3)
def each_of_week(days: tuple[int, ...]) -> Repeat:
    """Every day from monday to friday."""
    return _each(days)


def _each(days: tuple[int, ...]) -> Repeat:
    """Give the repetition on each of some days of the week."""
    return Repeat(walls=tuple(Wall(Fields(weekday=day)) for day in days))


@grammar.rule("repeat", "<said> ,? <week stretch>", weight=1.3)
def hours_of_week(said: Said, days: tuple[int, ...]) -> Repeat | None:
    """From 9 to 5, monday to friday."""
    return of_week(days, said)


@grammar.rule("repeat", "<week stretch> ,? <said>", weight=1.3)
def week_of_hours(days: tuple[int, ...], said: Said) -> Repeat | None:
    """Monday to friday from 9 to 5, mon-fri at noon; but "friday to monday noon" ends at noon."""
    over_weekend = days[-1] < days[0] and said.preposition is None
    return None if over_weekend and not isinstance(said.time, Range) else of_week(days, said)


@grammar.rule("repeat", "<week stretch> ,? <integer> -|to|until|till <integer>", weight=2.5)
@grammar.rule("repeat", "<integer> -|to|until|till <integer> ,? <week stretch>", weight=2.5)
def numbers_of_week(*said: tuple[int, ...] | Integer) -> Repeat | None:
    """Mon-fri 9-5: hours, and no date."""
    days = next(part for part in said if not isinstance(part, Integer))
    first, last = (number(part) for part in said if isinstance(part, Integer))
    hours = (clock for clock in (first, last) if clock is not None and clock.grain is Unit.HOUR)
    ends = [Wall(clock=replace(clock, bare=False)) for clock in hours]
    return within_hours(_each(days), *ends) if len(ends) == len((first, last)) else None


@grammar.rule("repeat", "on? <week stretch> <parts>", "in? the? <parts> ,? <week stretch>", weight=1.5)
@grammar.rule("repeat", "every|each <part> ,? <week stretch>", weight=1.5)
def parts_of_week(first: tuple[int, ...] | Part, second: Part | tuple[int, ...]) -> Repeat | None:
    """Mon-wed mornings, every morning monday to friday."""
    days, part = (second, first) if isinstance(first, Part) else (first, second)
    if isinstance(days, Part) or not isinstance(part, Part) or part.place:
        return None
    return Repeat(walls=tuple(Wall(Fields(weekday=day), part) for day in days))


def of_week(days: tuple[int, ...], said: Said) -> Repeat | None:
    """Give a repetition on some days of the week, at a clock time or within hours."""
    whole, time = _each(days), said.time
    ends = (time.first, time.last) if isinstance(time, Range) else (time,)
    clocks = [end for end in ends if isinstance(end, Wall) and end.clock is not None and end.days is None]
    if len(clocks) != len(ends) or said.constraint in {Constraint.BEFORE, Constraint.AFTER} or said.hedges:
        return None
    if isinstance(time, Range):
        return within_hours(whole, clocks[0], clocks[1])
    return narrowed_repeat(whole, clocks[0]) if said.preposition is not None or not clocks[0].bare else None
