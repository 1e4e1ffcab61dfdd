"""Repetitions: "every twenty minutes", "daily at nine", "on mondays", "every other friday", "twice a day"."""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields, Weekend
from fuzzytime.language.meaning.expressions import (
    UNIT_SECONDS,
    Coming,
    Duration,
    Offset,
    Part,
    Range,
    Repeat,
    Said,
    UnitWord,
    Wall,
)
from fuzzytime.language.meaning.nested import Nth
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()

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
    return of_unit(unit) if len(unit.form) > 1 else None


@grammar.rule("repeat", "every|each <duration>")
def every_so_long(duration: Duration) -> Repeat | None:
    """Every twenty minutes, every two days, every hour and a half."""
    if len(duration.terms) == 1 and duration.terms[0][1] not in SMALL and not duration.hedges:
        amount, unit = duration.terms[0]
        if amount == int(amount) and amount >= 1:
            return of_unit(UnitWord(unit, 1, unit.value), amount)
    return Repeat(duration) if duration.seconds > 0 and duration.until is None else None


@grammar.rule("repeat", "every|each <unit> and <fraction>", weight=0.1)
def every_and_a_half(unit: UnitWord, fraction: float) -> Repeat:
    """Every hour and a half."""
    return of_unit(unit, 1 + fraction)


@grammar.rule("repeat", "every|each other|second <unit>", weight=0.1)
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


@grammar.rule("repeat", "every|each other|second <weekday>", weight=0.1)
def every_other_weekday(number: int) -> Repeat:
    """Every other friday."""
    return Repeat(walls=(Wall(Fields(weekday=number)),), skip=2)


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


@grammar.rule("repeat", "weekday <part>|<parts>", "every|each weekday <part>", weight=0.2)
def weekday_part(part: Part) -> Repeat:
    """Weekday mornings."""
    return Repeat(walls=tuple(Wall(Fields(weekday=day), part) for day in range(5)))


@grammar.rule("repeat", "<weekday> <parts>", weight=0.2)
def weekly_part(number: int, part: Part) -> Repeat:
    """Tuesday afternoons."""
    return Repeat(walls=(Wall(Fields(weekday=number), part),))


@grammar.rule("repeat", "every|each <weekday> <part>", weight=0.1)
def every_weekday_part(number: int, part: Part) -> Repeat:
    """Every friday evening."""
    return Repeat(walls=(Wall(Fields(weekday=number), part),))


@grammar.rule("repeat", "every|each <date>", "every|each <feast>", weight=0.1)
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


@grammar.rule("repeat", "the? <ordinal> <weekday> of every|each month", weight=0.3)
def weekday_of_every(number: int, weekday: int) -> Repeat:
    """The first monday of every month."""
    return Repeat(walls=(Wall(Nth(number, Fields(weekday=weekday), Cycle(Unit.MONTH))),))


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


@grammar.rule("times", "<integer> times?")
def times(number: Integer) -> int | None:
    """Three times."""
    return number.value if 0 < number.value <= 1000 else None


@grammar.rule("repeat", "<times> a|an|per|every|each <unit>", "<times> daily", weight=0.1)
def so_often(number: int, unit: UnitWord | None = None) -> Repeat | None:
    """Twice a day, three times an hour."""
    if unit is not None and len(unit.form) == 1:
        return None
    length = UNIT_SECONDS[unit.unit] * unit.count if unit is not None else UNIT_SECONDS[Unit.DAY]
    if number == 1:
        return of_unit(unit or UnitWord(Unit.DAY, 1, "day"))
    return Repeat(Duration(((length / number, Unit.SECOND),)))


# -- with times, days and bounds ------------------------------------------------------------------------


@grammar.rule("repeat", "<repeat> at|on|in|around|,? the? <wall>", "<repeat> at <wall>", weight=0.2)
def repeat_at(repeat: Repeat, wall: Wall) -> Repeat | None:
    """Every day at nine, on mondays at 4pm, every day this week."""
    return narrowed_repeat(repeat, wall)


@grammar.rule("repeat", "<wall> ,|on? <repeat>", weight=0.2)
def clock_repeat(wall: Wall, repeat: Repeat) -> Repeat | None:
    """9am on sundays; but "two nights" are no nights at two."""
    return None if wall.bare else narrowed_repeat(repeat, wall)


@grammar.rule("repeat", "at|on|in <wall> ,|on? <repeat>", weight=0.2)
def at_repeat(wall: Wall, repeat: Repeat) -> Repeat | None:
    """At noon every day, at nine on weekdays."""
    return narrowed_repeat(repeat, wall)


def _named_days(repeat: Repeat, wall: Wall) -> Calendar | None:
    """Give the day that a period is said to have: every year on the 4th of july, every week on friday."""
    days = wall.days
    if len(repeat.walls) != 1 or repeat.skip != 1 or not isinstance(days, Fields) or days.fixed or wall.weak:
        return None
    period = repeat.walls[0].days
    if period == Cycle(Unit.YEAR) and days.month is not None:
        return days
    return days if period == Cycle(Unit.WEEK) and days.weekly else None


def narrowed_repeat(repeat: Repeat, wall: Wall) -> Repeat | None:
    """Give a repetition at a time of day, in a part of the day, or within days that are said beside it."""
    days = _named_days(repeat, wall)
    if days is not None:
        return replace(repeat, every=None, walls=(replace(wall, days=days),))
    if wall.days is not None and wall.clock is None and wall.part is None:
        if repeat.until is not None or repeat.starting is not None:
            return None
        return replace(repeat, starting=wall, until=wall)
    if wall.days is not None or not repeat.walls:
        return None
    walls = []
    for old in repeat.walls:
        if (old.clock and wall.clock) or (old.part and wall.part):
            return None
        clock = replace(wall.clock, bare=False, pair=False) if wall.clock else old.clock
        walls.append(replace(old, clock=clock, part=old.part or wall.part))
    return replace(repeat, walls=tuple(walls))


@grammar.rule("repeat", "<repeat> <said>", "<repeat> , <said>", weight=0.1)
def bounded(repeat: Repeat, said: Said) -> Repeat | None:
    """Every day until friday, every ten minutes from noon to two."""
    time = said.time
    if repeat.starting is not None or repeat.until is not None or isinstance(time, Repeat):
        return None
    if isinstance(time, Duration):
        return (
            replace(repeat, until=Offset(time))
            if said.constraint in {Constraint.FOR, Constraint.BEFORE}
            else None
        )
    if isinstance(time, Coming):
        return replace(repeat, until=Offset(time.duration))
    by_day = bool(repeat.walls) and isinstance(time, Range) and isinstance(time.first, Wall)
    if by_day and isinstance(time, Range) and isinstance(time.first, Wall) and time.first.clock is not None:
        # "Every weekday from 9 to 5": at the start of that stretch.
        return narrowed_repeat(repeat, replace(time.first, days=None))
    if said.constraint is Constraint.BEFORE:
        return replace(repeat, until=time)
    if said.constraint is Constraint.AFTER:
        return replace(repeat, starting=time)
    if said.constraint is Constraint.BETWEEN and isinstance(time, Range):
        return replace(repeat, starting=time.first, until=time.last)
    return None


@grammar.rule("said", "<repeat>", weight=0.1)
def repeated(repeat: Repeat) -> Said:
    """Every day at nine."""
    return Said(repeat, Constraint.EVERY)


@grammar.rule("said", "<preposition_at> <repeat>", weight=0.2)
def repeated_with_preposition(preposition: Preposition, repeat: Repeat) -> Said:
    """For wednesdays at two pm, by ten to eleven am daily."""
    return Said(repeat, Constraint.EVERY, preposition.name)


@grammar.rule("said", "by <repeat>", "before <repeat>", weight=0.2)
def repeated_deadline(repeat: Repeat) -> Said:
    """By ten to eleven am daily."""
    return Said(repeat, Constraint.EVERY, "by")
