"""Repetitions: "every twenty minutes", "daily at nine", "on mondays", "every other friday", "twice a day"."""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields, Weekend
from fuzzytime.language.meaning.expressions import (
    UNIT_SECONDS,
    Duration,
    Repeat,
    UnitWord,
    Wall,
)
from fuzzytime.language.meaning.nested import Nth
from fuzzytime.language.meaning.times_of_day import Part
from fuzzytime.requirement import Unit

grammar = Grammar()

LONGEST_MONTH = 31

SMALL = frozenset({Unit.SECOND, Unit.MINUTE, Unit.HOUR})


def of_unit(unit: UnitWord, count: float = 1) -> Repeat:
    """Give every so many units."""
    if unit.unit in SMALL or count != int(count):
        return Repeat(Duration(((count * unit.count, unit.unit),)))
    return Repeat(
        Duration(((count * unit.count, unit.unit),)), (Wall(Cycle(unit.unit)),), int(count) * unit.count
    )


@grammar.rule("repeat", "every|each|per single? <unit>", "every|each and every|each <unit>")
def every(unit: UnitWord) -> Repeat | None:
    """Every day, each week."""
    # Every night is a part of every day.
    return of_unit(unit) if len(unit.form) > 1 and unit.form != "night" else None


@grammar.rule("repeat", "every|each <duration>")
def every_so_long(duration: Duration) -> Repeat | None:
    """Every twenty minutes, every two days, every hour and a half."""
    if len(duration.terms) == 1 and duration.terms[0][1] not in SMALL and not duration.hedges:
        amount, unit = duration.terms[0]
        if amount == int(amount) and amount >= 1:
            return of_unit(UnitWord(unit, 1, unit.value), amount)
    if duration.until is not None:
        # "Every three to four hours": the middle.
        middle = (duration.seconds + duration.until.seconds) / 2
        return Repeat(Duration(((middle, Unit.SECOND),), duration.hedges)) if middle > 0 else None
    return Repeat(duration) if duration.seconds > 0 else None


@grammar.rule("repeat", "at|in <duration> -? intervals", "at intervals of <duration>", weight=0.4)
def at_intervals(duration: Duration) -> Repeat | None:
    """At twenty minute intervals."""
    return every_so_long(duration)


@grammar.rule("repeat", "every|each <unit> and <fraction>", weight=0.1)
def every_and_a_half(unit: UnitWord, fraction: float) -> Repeat:
    """Every hour and a half."""
    return of_unit(unit, 1 + fraction)


@grammar.rule("repeat", "every|each other|second <unit>", "on|in? alternate <unit>", weight=0.1)
def every_other(unit: UnitWord) -> Repeat:
    """Every other day."""
    return of_unit(unit, 2)


@grammar.rule("repeat", "every|each <ordinal> <unit>", weight=0.4)
def every_nth(number: int, unit: UnitWord) -> Repeat | None:
    """Every third day."""
    return of_unit(unit, number) if number > 0 else None


@grammar.rule("repeat", "every|each single? <weekday>", "on? <weekdays>", "every <weekdays>")
def every_weekday(number: int) -> Repeat:
    """Every monday, on sundays."""
    return Repeat(walls=(Wall(Fields(weekday=number)),))


@grammar.rule(
    "repeat",
    "every|each other|second|alternate <weekday>",
    "on? alternate <weekday>|<weekdays>",
    "on? every other <weekdays>",
    weight=0.4,
)
def every_other_weekday(number: int) -> Repeat:
    """Every other friday."""
    return Repeat(walls=(Wall(Fields(weekday=number)),), skip=2)


@grammar.rule("repeat", "every|each <ordinal> <weekday>", weight=0.5)
def every_nth_weekday(number: int, weekday: int) -> Repeat | None:
    """Every third thursday."""
    return Repeat(walls=(Wall(Fields(weekday=weekday)),), skip=number) if 1 < number < 100 else None


@grammar.rule("repeat", "<repeat> ,|and|or <weekday>|<weekdays>")
def more_weekdays(repeat: Repeat, number: int) -> Repeat | None:
    """Every monday and thursday, on mondays and fridays."""
    if not repeat.walls or any(not isinstance(wall.days, Fields) or wall.clock for wall in repeat.walls):
        return None
    return replace(repeat, walls=(*repeat.walls, Wall(Fields(weekday=number))))


@grammar.rule(
    "repeat",
    "on? weekdays|workdays",
    "every|each weekday|workday",
    "every|each working|work|business day",
    "on? business|working|work days",
)
def weekdays() -> Repeat:
    """On weekdays."""
    return Repeat(walls=tuple(Wall(Fields(weekday=day)) for day in range(5)))


@grammar.rule("repeat", "on? weekends", "every|each weekend", "all weekends", "at weekends")
def weekends() -> Repeat:
    """On weekends."""
    return Repeat(walls=(Wall(Weekend()),))


@grammar.rule("repeat", "every|each single? <part>|<meal>", "in? the? <parts>", "on <parts>")
def every_part(part: Part) -> Repeat:
    """Every morning, in the evenings."""
    return Repeat(walls=(Wall(Cycle(Unit.DAY), part),))


@grammar.rule("repeat", "every|each other|second <part>", "on? alternate <parts>", weight=0.3)
def every_other_part(part: Part) -> Repeat:
    """Every other morning."""
    return Repeat(walls=(Wall(Cycle(Unit.DAY), part),), skip=2)


@grammar.rule("repeat", "every|each <part> and|& <part>", weight=0.3)
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
    "weekday list", "<weekday list> ,|and|&|or <weekday>", "<weekday list> , and <weekday>", weight=0.1
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


@grammar.rule("repeat", "every|each <month>")
def every_month(number: int) -> Repeat:
    """Every june."""
    return Repeat(walls=(Wall(Fields(month=number)),))


@grammar.rule(
    "repeat", "the? <ordinal> of every|each <unit>", "every|each <unit> on the <ordinal>", weight=0.3
)
def day_of_every(first: int | UnitWord, second: UnitWord | int) -> Repeat | None:
    """The fifteenth of every month."""
    number, unit = (first, second) if isinstance(first, int) else (second, first)
    if not isinstance(number, int) or not isinstance(unit, UnitWord) or unit.unit is not Unit.MONTH:
        return None
    return Repeat(walls=(Wall(Fields(day=number)),))


@grammar.rule("repeat", "the? <ordinal> ,|and|& <repeat>", "the? <ordinal> , and <repeat>", weight=0.3)
def more_days_of_every(number: int, repeat: Repeat) -> Repeat | None:
    """The first and the fifteenth of every month."""
    days = [wall.days for wall in repeat.walls]
    monthly = all(isinstance(day, Fields) and day == Fields(day=day.day) for day in days)
    plain = repeat.skip == 1 and all(wall.clock is None and wall.part is None for wall in repeat.walls)
    if not days or not monthly or not plain or not 1 <= number <= LONGEST_MONTH:
        return None
    return replace(repeat, walls=(Wall(Fields(day=number)), *repeat.walls))


@grammar.rule(
    "repeat", "every|each <ordinal> ,|and|& the? <ordinal>", "every|each <ordinal> of the? month", weight=0.3
)
def days_of_month(first: int, second: int | None = None) -> Repeat | None:
    """Every 1st and 15th, every third of the month."""
    days = [day for day in (first, second) if day is not None]
    if not all(1 <= day <= LONGEST_MONTH for day in days):
        return None
    return Repeat(walls=tuple(Wall(Fields(day=day)) for day in days))


@grammar.rule(
    "repeat",
    "<repeat> ,? except|but|excluding|bar|save for|not? on|at? <weekday list>|<weekdays>|<off>",
    "<repeat> ,? and? not on|at? <weekday list>|<weekdays>|<off>",
    weight=0.6,
)
def except_on(repeat: Repeat, days: tuple[int, ...] | int) -> Repeat | None:
    """Every day except sundays, on weekdays but friday."""
    left_out = days if isinstance(days, tuple) else (days,)
    fields = [wall.days for wall in repeat.walls]
    if fields == [Cycle(Unit.DAY)] and repeat.skip == 1 and repeat.starting is None and repeat.until is None:
        walls = tuple(replace(repeat.walls[0], days=Fields(weekday=day)) for day in range(7))
    else:
        walls = repeat.walls
    kept = tuple(
        wall for wall in walls if isinstance(wall.days, Fields) and wall.days.weekday not in {None, *left_out}
    )
    return replace(repeat, every=None, walls=kept) if kept and len(kept) < len(walls) else None


@grammar.rule("off", "weekends", "the? weekend")
def off() -> tuple[int, ...]:
    """Weekends, as what is left out of a repetition."""
    return (5, 6)


@grammar.rule(
    "repeat",
    "the? <ordinal> <series> of every|each <series>",
    "the? last <series> of every|each <series>",
    weight=0.3,
)
def nth_of_every(first: int | Calendar, second: Calendar, third: Calendar | None = None) -> Repeat | None:
    """The first monday of every month, the last day of each year."""
    number, inner, outer = (-1, first, second) if third is None else (first, second, third)
    if not isinstance(number, int) or not isinstance(inner, Calendar) or not isinstance(outer, Cycle):
        return None
    return Repeat(walls=(Wall(Nth(number, inner, outer)),)) if inner != outer else None


@grammar.rule("repeat", "a? daily", "a? nightly", "everyday", "day in day out", "each day of the week")
def daily() -> Repeat:
    """Daily."""
    return of_unit(UnitWord(Unit.DAY, 1, "day"))


@grammar.rule("repeat", "24 / 7", "around|round the clock", weight=1.0)
def always() -> Repeat:
    """24/7: day by day."""
    return daily()


@grammar.rule("repeat", "an? hourly")
def hourly() -> Repeat:
    """Hourly."""
    return of_unit(UnitWord(Unit.HOUR, 1, "hour"))


@grammar.rule("repeat", "a? weekly")
def weekly() -> Repeat:
    """Weekly."""
    return of_unit(UnitWord(Unit.WEEK, 1, "week"))


@grammar.rule("repeat", "a? fortnightly|biweekly", "a? bi - weekly")
def fortnightly() -> Repeat:
    """Fortnightly."""
    return of_unit(UnitWord(Unit.WEEK, 2, "fortnight"))


@grammar.rule("repeat", "of? a? monthly")
def monthly() -> Repeat:
    """Monthly."""
    return of_unit(UnitWord(Unit.MONTH, 1, "month"))


@grammar.rule("repeat", "a? quarterly")
def quarterly() -> Repeat:
    """Quarterly."""
    return of_unit(UnitWord(Unit.MONTH, 3, "quarter"))


@grammar.rule("repeat", "a? yearly|annually|annual")
def yearly() -> Repeat:
    """Yearly."""
    return of_unit(UnitWord(Unit.YEAR, 1, "year"))


@grammar.rule("times", "once")
def once() -> int:
    """Once."""
    return 1


@grammar.rule("times", "twice")
def twice() -> int:
    """Twice."""
    return 2


@grammar.rule("times", "<integer> times")
def times(number: Integer) -> int | None:
    """Three times."""
    return number.value if 0 < number.value <= 1000 else None


@grammar.rule("few", "<integer>")
def few(number: Integer) -> int | None:
    """Two (a day); but "two every night" is a clock time."""
    return times(number)


@grammar.rule(
    "repeat", "<times> a|an|per|every|each <unit>", "<times> daily", "<few> a|an|per <unit>", weight=0.1
)
def so_often(number: int, unit: UnitWord | None = None) -> Repeat | None:
    """Twice a day, three times an hour."""
    if unit is not None and len(unit.form) == 1:
        return None
    length = UNIT_SECONDS[unit.unit] * unit.count if unit is not None else UNIT_SECONDS[Unit.DAY]
    if number == 1:
        return of_unit(unit or UnitWord(Unit.DAY, 1, "day"))
    days = unit is None or unit.unit not in SMALL
    # "Twice a day": once in each half of it, and at no moment.
    return Repeat(Duration(((length / number, Unit.SECOND),)), shared=days)
