"""Hours, clock times and parts of the day on a stretch of weekdays: "monday to friday from 9 to 5"."""

from dataclasses import replace

from fuzzytime.language.english.clock_times.clocks import number
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import Range, Repeat, Said, Wall
from fuzzytime.language.meaning.joined.bounded_repeats import bounded_repeat, within_hours
from fuzzytime.language.meaning.joined.repeats_beside import narrowed_repeat
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
    ends = _hours(*(part for part in said if isinstance(part, Integer)))
    return None if ends is None else within_hours(_each(days), *ends)


@grammar.rule("hours of weekday", "<weekday> <integer> -|to|until|till <integer>")
def numbers_of_weekday(weekday: int, first: Integer, last: Integer) -> Repeat | None:
    """(mon-thu 9-5,) fri 9-3."""
    return numbers_of_week((weekday,), first, last)


@grammar.rule("repeat", "<repeat> ,|and <hours of weekday>", weight=3.5)
def more_hours(repeat: Repeat, more: Repeat) -> Repeat | None:
    """Mon-thu 9-5, fri 9-3: each on its days."""
    hours = repeat.walls and all(wall.part is not None and not wall.part.name for wall in repeat.walls)
    return replace(repeat, walls=(*repeat.walls, *more.walls)) if hours and repeat.skip == 1 else None


@grammar.rule("repeat", "<repeat> ,? <integer> -|to|until|till <integer>", weight=2.5)
def numbers_of_day(repeat: Repeat, first: Integer, last: Integer) -> Repeat | None:
    """Every 30 minutes 9-5, every morning 9-12: hours, and no date."""
    ends = _hours(first, last)
    if any((wall.part is not None and not wall.part.name) or wall.clock is not None for wall in repeat.walls):
        return None
    return None if ends is None else bounded_repeat(repeat, Said(Range(*ends), Constraint.BETWEEN, "between"))


def _hours(*said: Integer) -> tuple[Wall, Wall] | None:
    """Give two numbers as the hours from which and to which something goes on."""
    first, last = (number(one) for one in said)
    if first is None or last is None or Unit.MINUTE in {first.grain, last.grain}:
        return None
    return Wall(clock=replace(first, bare=False)), Wall(clock=replace(last, bare=False))


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
