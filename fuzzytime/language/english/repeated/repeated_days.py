"""Repetitions on days and in parts of them: "on mondays", "every other friday", "with meals"."""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields, Weekend
from fuzzytime.language.meaning.days.nested import Nth
from fuzzytime.language.meaning.expressions import Duration, Edge, Offset, Repeat, Said, Wall
from fuzzytime.language.meaning.joined.bounded_repeats import bounded_repeat
from fuzzytime.language.meaning.joined.repeats_beside import narrowed_repeat
from fuzzytime.language.meaning.times_of_day import Clock, Half, Part
from fuzzytime.language.meaning.units import UnitWord
from fuzzytime.requirement import MOMENTS, Constraint, Unit

grammar = Grammar()

LONGEST_MONTH = 31


@grammar.rule("repeat", "every|each single? <weekday>", "on <weekdays>", "every <weekdays>")
def every_weekday(number: int) -> Repeat:
    """Every monday, on sundays."""
    return Repeat(walls=(Wall(Fields(weekday=number)),))


@grammar.rule("repeat", "<weekdays>")
def plural_weekday(number: int) -> Repeat:
    """(seven am) sundays."""
    return replace(every_weekday(number), plural=True)


@grammar.rule(
    "repeat",
    "every|each other|second|alternate <weekday>",
    "on? alternate <weekday>|<weekdays>",
    "on? every other <weekdays>",
    weight=1.5,
)
def every_other_weekday(number: int) -> Repeat:
    """Every other friday."""
    return Repeat(walls=(Wall(Fields(weekday=number)),), skip=2)


@grammar.rule("repeat", "every|each <ordinal> <weekday>", weight=0.5)
def every_nth_weekday(number: int, weekday: int) -> Repeat | None:
    """Every third thursday."""
    return Repeat(walls=(Wall(Fields(weekday=weekday)),), skip=number) if 1 < number < 100 else None


@grammar.rule("parts of each day", "<part> and <part>", "<part> , <part> ,? and <part>", weight=0.2)
def parts_of_each_day(*parts: Part) -> Repeat | None:
    """Morning and evening: of each day; but "the morning and evening" are those of one."""
    if len({part.name for part in parts}) < len(parts) or any(part.place for part in parts):
        return None
    return Repeat(walls=tuple(Wall(Cycle(Unit.DAY), part=part) for part in parts))


@grammar.rule("said", "<parts of each day> ,? <said>?", weight=0.2)
def parts_alone(parts: Repeat, bound: Said | None = None) -> Said | None:
    """Morning and evening this week, morning and night until friday."""
    if bound is None:
        return Said(parts, Constraint.EVERY)
    days = bound.time if bound.constraint in MOMENTS else None
    found = narrowed_repeat(parts, days) if isinstance(days, Wall) else bounded_repeat(parts, bound)
    return None if found is None else Said(found, Constraint.EVERY)


@grammar.rule("repeat", "<repeat> ,|and|or <weekday>|<weekdays>", "<repeat> , and <weekday>|<weekdays>")
@grammar.rule("repeat", "<repeat> <weekday>|<weekdays>", weight=0.3)
def more_weekdays(repeat: Repeat, number: int) -> Repeat | None:
    """Every monday and thursday, on mondays and fridays."""
    if not repeat.walls or any(not isinstance(wall.days, Fields) or wall.clock for wall in repeat.walls):
        return None
    if any(wall.part is not None and not wall.part.name for wall in repeat.walls):
        # "Mon-wed 10-12, thu 2-4"
        return None
    return replace(repeat, walls=(*repeat.walls, Wall(Fields(weekday=number))))


@grammar.rule(
    "repeat",
    "on? weekdays|workdays|wkdays",
    "every|each weekday|workday|wkday",
    "every|each working|work|business|school day",
    "on business|working|work|school days",
)
def weekdays() -> Repeat:
    """On weekdays."""
    return Repeat(walls=tuple(Wall(Fields(weekday=day)) for day in range(5)))


@grammar.rule("repeat", "business|working|work|school days")
def plural_workdays() -> Repeat:
    """(seven am) working days."""
    return replace(weekdays(), plural=True)


@grammar.rule("repeat", "on weekends", "every|each weekend", "all weekends", "at weekends")
def weekends() -> Repeat:
    """On weekends."""
    return Repeat(walls=(Wall(Weekend()),))


@grammar.rule("repeat", "weekends")
def plural_weekends() -> Repeat:
    """(seven am) weekends."""
    return replace(weekends(), plural=True)


@grammar.rule(
    "repeat", "every|each single? <part>|<meal>", "in the? <parts>", "the <parts>", "on <parts>", "a <parts>"
)
def every_part(part: Part) -> Repeat:
    """Every morning, in the evenings."""
    return Repeat(walls=(Wall(Cycle(Unit.DAY), part),))


@grammar.rule("repeat", "<parts>")
def plural_parts(part: Part) -> Repeat:
    """(seven am) mornings."""
    return replace(every_part(part), plural=True)


@grammar.rule("repeat", "for|over|on the? next|coming? <integer> <parts>", weight=0.8)
def so_many_parts(number: Integer, part: Part) -> Repeat | None:
    """For three evenings, for the next two mornings; but "for three nights" is as long as that."""
    if not 1 < number.value <= LONGEST_MONTH or part.half is Half.NIGHT:
        return None
    return replace(every_part(part), until=Offset(Duration(((number.value, Unit.DAY),))))


@grammar.rule("repeat", "for|over|on the? next|coming? <integer> <weekdays>", weight=0.8)
@grammar.rule("repeat", "for|over|on the? next|coming? <integer> weekends", weight=0.8)
@grammar.rule(
    "repeat", "the? next|coming <integer> <weekdays>", "the? next|coming <integer> weekends", weight=0.8
)
def so_many_weeks(number: Integer, weekday: int | None = None) -> Repeat | None:
    """For the next three mondays, for three weekends."""
    days = weekends() if weekday is None else every_weekday(weekday)
    weeks = Offset(Duration(((number.value, Unit.WEEK),)))
    return replace(days, until=weeks) if 1 < number.value <= LONGEST_MONTH else None


@grammar.rule("repeat", "<share> every|each single? <part>", "every|each <part> ,? <share>", weight=0.4)
def early_every_part(first: tuple[float, float] | Part, second: Part | tuple[float, float]) -> Repeat | None:
    """First thing every morning, late every evening."""
    part, share = (first, second) if isinstance(first, Part) else (second, first)
    if not isinstance(part, Part) or isinstance(share, Part) or part.is_point:
        return None
    return Repeat(walls=(Wall(Cycle(Unit.DAY), part.share(*share)),))


@grammar.rule("repeat", "with|at|during every|each? <meals>", "every|each <meals>", weight=0.3)
def every_meal(meals: tuple[Part, ...]) -> Repeat:
    """With meals, at every meal."""
    return Repeat(walls=tuple(Wall(Cycle(Unit.DAY), part) for part in meals))


@grammar.rule("repeat", "before <meals>", "before every|each <meals>|<meal>", weight=0.7)
def before_every_meal(meals: tuple[Part, ...] | Part) -> Repeat:
    """Before meals, before every dinner: when they begin."""
    parts = (meals,) if isinstance(meals, Part) else meals
    return Repeat(walls=tuple(Wall(Cycle(Unit.DAY), replace(part, end=part.start)) for part in parts))


@grammar.rule("repeat", "after every|each? <meals>", weight=0.3)
def after_every_meal(meals: tuple[Part, ...]) -> Repeat:
    """After meals: when they are over."""
    return Repeat(walls=tuple(Wall(Cycle(Unit.DAY), replace(part, start=part.end)) for part in meals))


@grammar.rule("repeat", "<duration> before every|each? <meals>", weight=0.4)
def so_long_before_meals(duration: Duration, meals: tuple[Part, ...]) -> Repeat:
    """Fifteen minutes before each meal."""
    moments = (part.start - int(duration.seconds) for part in meals)
    parts = (replace(part, start=at, end=at) for part, at in zip(meals, moments, strict=True))
    return Repeat(walls=tuple(Wall(Cycle(Unit.DAY), part) for part in parts))


@grammar.rule("repeat", "<duration> after every|each? <meals>", weight=0.4)
def so_long_after_meals(duration: Duration, meals: tuple[Part, ...]) -> Repeat:
    """Half an hour after meals."""
    moments = (part.end + int(duration.seconds) for part in meals)
    parts = (replace(part, start=at, end=at) for part, at in zip(meals, moments, strict=True))
    return Repeat(walls=tuple(Wall(Cycle(Unit.DAY), part) for part in parts))


@grammar.rule("repeat", "every|each other|second <part>", "on? alternate <parts>", weight=0.3)
def every_other_part(part: Part) -> Repeat:
    """Every other morning."""
    return Repeat(walls=(Wall(Cycle(Unit.DAY), part),), skip=2)


@grammar.rule("repeat", "every|each <part> and <part>", weight=0.3)
def every_two_parts(first: Part, second: Part) -> Repeat:
    """Every morning and evening."""
    return Repeat(walls=(Wall(Cycle(Unit.DAY), first), Wall(Cycle(Unit.DAY), second)))


@grammar.rule("repeat", "weekday <part>|<parts>", "every|each weekday <part>", weight=0.2)
def weekday_part(part: Part) -> Repeat:
    """Weekday mornings."""
    return Repeat(walls=tuple(Wall(Fields(weekday=day), part) for day in range(5)))


@grammar.rule("weekday list", "<weekday>")
def one_weekday(number: int) -> tuple[int, ...]:
    """Tuesday, in "tuesday and friday nights"."""
    return (number,)


@grammar.rule(
    "weekday list", "<weekday list> ,|and|or <weekday>", "<weekday list> , and <weekday>", weight=0.1
)
def another_weekday(numbers: tuple[int, ...], number: int) -> tuple[int, ...]:
    """Monday, wednesday and friday."""
    return (*numbers, number)


@grammar.rule("repeat", "on? <weekday list> <parts>", "every|each <weekday list> <part>", weight=0.2)
def weekly_part(numbers: tuple[int, ...], part: Part) -> Repeat:
    """Tuesday afternoons, every friday evening, tuesday and friday nights."""
    return Repeat(walls=tuple(Wall(Fields(weekday=number), part) for number in numbers))


@grammar.rule("repeat", "every|each <date>", "every|each <feast>", "every|each <season>", weight=0.1)
def every_date(days: Calendar) -> Repeat | None:
    """Every june third, every easter."""
    return Repeat(walls=(Wall(days),)) if not days.fixed else None


@grammar.rule(
    "repeat", "at|by? the <edge> of? every|each <unit>", "at|by? <edge> every|each <unit>", weight=0.5
)
def edge_of_every(edge: Edge, unit: UnitWord) -> Repeat | None:
    """At the end of every month: on its last day."""
    whole = Cycle(unit.unit, unit.count)
    if whole == Cycle(Unit.DAY) and edge is Edge.END:
        return Repeat(walls=(Wall(whole, clock=Clock(23, 59, 59, grain=Unit.SECOND, full_day=True)),))
    if whole.grain is Unit.DAY or unit.unit not in {Unit.WEEK, Unit.MONTH, Unit.QUARTER, Unit.YEAR}:
        return None
    return Repeat(walls=(Wall(Nth(1 if edge is Edge.START else -1, Cycle(Unit.DAY), whole)),))


@grammar.rule("repeat", "every|each <month>")
def every_month(number: int) -> Repeat:
    """Every june."""
    return Repeat(walls=(Wall(Fields(month=number)),))


@grammar.rule("repeat", "<repeat> ,|and <month>|<season>", "<repeat> , and <month>|<season>", weight=0.3)
def more_months(repeat: Repeat, days: int | Calendar) -> Repeat | None:
    """Every april and october, every spring and autumn."""
    told = Fields(month=days) if isinstance(days, int) else days
    alike = (type(wall.days) is type(told) and wall == Wall(wall.days) for wall in repeat.walls)
    months = told.grain is not Unit.MONTH or all(
        wall.days.grain is Unit.MONTH for wall in repeat.walls if wall.days
    )
    return (
        replace(repeat, walls=(*repeat.walls, Wall(told))) if repeat.walls and months and all(alike) else None
    )
