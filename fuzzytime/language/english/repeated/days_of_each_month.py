"""Days of each month, or of every other: "every first and third monday", "the 5th of every other month"."""

from dataclasses import replace

from fuzzytime.language.english.repeated.repeated_days import LONGEST_MONTH
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields, is_day_of_month
from fuzzytime.language.meaning.days.nested import Nth
from fuzzytime.language.meaning.days.workdays import Workday
from fuzzytime.language.meaning.expressions import Repeat, Wall
from fuzzytime.language.meaning.joined.repeats_beside import on_named_days
from fuzzytime.language.meaning.units import UnitWord
from fuzzytime.requirement import Unit

grammar = Grammar()

LAST = -1
MOST_WEEKDAYS = 5
"""How often a weekday is in one month, at most."""


@grammar.rule("place inside", "<ordinal>")
def nth_place(number: int) -> int:
    """The first, in "the first and third monday"."""
    return number


@grammar.rule("place inside", "last")
def last_place() -> int:
    """The last, in "the second and last monday"."""
    return LAST


@grammar.rule("places inside", "<place inside> ,|and the? <place inside>")
@grammar.rule("places inside", "<places inside> ,|and the? <place inside>")
@grammar.rule("places inside", "<places inside> , and the? <place inside>")
def places_inside(before: int | tuple[int, ...], last: int) -> tuple[int, ...] | None:
    """The first and third, the first, second and last."""
    places = before if isinstance(before, tuple) else (before,)
    return (*places, last) if 0 < places[-1] < last or (last == LAST and places[-1] > 0) else None


def _walls(places: tuple[int, ...], inner: Calendar, outer: Cycle) -> tuple[Wall, ...]:
    return tuple(Wall(Nth(place, inner, outer)) for place in places)


@grammar.rule("repeat", "every|each <places inside> <weekday>", "the <places inside> <weekdays>", weight=0.6)
def weekdays_of_month(places: tuple[int, ...], weekday: int) -> Repeat | None:
    """Every second and fourth friday: of each month."""
    return weekdays_of(places, Fields(weekday=weekday), Cycle(Unit.MONTH))


@grammar.rule("repeat", "every|each <place inside> <series>", weight=0.4)
def end_of_month(place: int, series: Calendar) -> Repeat | None:
    """Every last friday, every first monday, every 15th working day: of each month.

    But every second one is every other, and every third day one in three.
    """
    days = series.grain is Unit.DAY and (series == Cycle(Unit.DAY) or isinstance(series, Fields | Workday))
    ends = place in {1, LAST} or (isinstance(series, Workday) and place > MOST_WEEKDAYS)
    return Repeat(walls=_walls((place,), series, Cycle(Unit.MONTH))) if days and ends else None


@grammar.rule("repeat", "every|each <places inside> <series> of|in <whole>", weight=0.6)
def weekdays_of(places: tuple[int, ...], series: Calendar, outer: Calendar) -> Repeat | None:
    """Every first and third monday of the month."""
    several = isinstance(outer, Cycle) and series != outer
    if not isinstance(outer, Cycle) or not several or places[-1] > MOST_WEEKDAYS:
        return None
    return Repeat(walls=_walls(places, series, outer))


@grammar.rule(
    "repeat",
    "<repeat> on the? <places inside> <weekday>",
    "<repeat> on the? <place inside> <weekday>",
    weight=0.6,
)
def on_weekdays_of(repeat: Repeat, said: int | tuple[int, ...], weekday: int) -> Repeat | None:
    """Every other month on the first and third monday, every month on the last friday."""
    places = said if isinstance(said, tuple) else (said,)
    return on_named_days(repeat, _walls(places, Fields(weekday=weekday), Cycle(Unit.MONTH)))


@grammar.rule(
    "repeat", "the? <ordinal> of every|each <unit>", "every|each <unit> on the <ordinal>", weight=0.3
)
@grammar.rule("repeat", "on? the? <ordinal> of <repeat>", weight=0.2)
def day_of_every(first: object, second: object) -> Repeat | None:
    """The fifteenth of every month, the third of every other month."""
    number, unit = (first, second) if isinstance(first, int) else (second, first)
    if not isinstance(number, int) or not 1 <= number <= LONGEST_MONTH:
        return None
    if isinstance(unit, UnitWord):
        return Repeat(walls=(Wall(Fields(day=number)),)) if unit.unit is Unit.MONTH else None
    return on_named_days(unit, (Wall(Fields(day=number)),)) if isinstance(unit, Repeat) else None


@grammar.rule("repeat", "<repeat> ,|and on? the <ordinal>", weight=0.1)
def more_days_of_month(repeat: Repeat, number: int) -> Repeat | None:
    """Every month on the fifth and the twentieth."""
    walls = repeat.walls
    days = [wall.days.day or 0 for wall in walls if isinstance(wall.days, Fields) and wall == Wall(wall.days)]
    monthly = all(is_day_of_month(wall.days) for wall in walls)
    if not days or not monthly or len(days) < len(walls) or not days[-1] < number <= LONGEST_MONTH:
        return None
    return replace(repeat, walls=(*walls, Wall(Fields(day=number))))


@grammar.rule("repeat", "on? the? <ordinal> ,|and <repeat>", "the? <ordinal> , and <repeat>", weight=0.3)
def more_days_of_every(number: int, repeat: Repeat) -> Repeat | None:
    """The first and the fifteenth of every month, the first and third tuesday of every month."""
    days = [wall.days for wall in repeat.walls]
    if days and isinstance(days[0], Nth) and (0 < number < days[0].number or days[0].number == LAST):
        first = replace(repeat.walls[0], days=replace(days[0], number=number))
        return replace(repeat, walls=(first, *repeat.walls))
    monthly = all(is_day_of_month(day) for day in days)
    if not days or not monthly or not 1 <= number <= LONGEST_MONTH:
        return None
    return replace(repeat, walls=(replace(repeat.walls[0], days=Fields(day=number)), *repeat.walls))


@grammar.rule(
    "repeat", "every|each <ordinal> ,|and the? <ordinal>", "every|each <ordinal> of the? month", weight=0.3
)
def days_of_month(first: int, second: int | None = None) -> Repeat | None:
    """Every 1st and 15th, every third of the month."""
    days = [day for day in (first, second) if day is not None]
    if not all(1 <= day <= LONGEST_MONTH for day in days):
        return None
    return Repeat(walls=tuple(Wall(Fields(day=day)) for day in days))


@grammar.rule("repeat", "every|each <ordinal>", weight=-0.3)
def day_of_each_month(day: int) -> Repeat | None:
    """Every 15th: of each month."""
    return days_of_month(day)


@grammar.rule(
    "repeat", "on? the? <ordinal> <series> of <repeat>", "on? the? last <series> of <repeat>", weight=0.2
)
def nth_of_turns(
    first: int | Calendar, second: Calendar | Repeat, third: Repeat | None = None
) -> Repeat | None:
    """The second tuesday of every other month."""
    number, inner, turns = (LAST, first, second) if third is None else (first, second, third)
    outer = turns.walls[0].days if isinstance(turns, Repeat) and turns.walls else None
    if not isinstance(number, int) or not isinstance(inner, Calendar) or not isinstance(turns, Repeat):
        return None
    if not isinstance(outer, Cycle) or inner == outer:
        return None
    return on_named_days(turns, _walls((number,), inner, outer))
