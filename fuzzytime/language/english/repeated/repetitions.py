"""Repetitions by lengths of time: "every twenty minutes", "daily", "twice a day", "three times this week"."""

from dataclasses import replace

from fuzzytime.language.english.calendar.periods import WEEK_DAYS
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.calendar import Cycle
from fuzzytime.language.meaning.expressions import (
    Duration,
    Edge,
    HourMark,
    Offset,
    Range,
    Repeat,
    Rest,
    Said,
    Wall,
)
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.units import UNIT_SECONDS, Quantity, UnitWord
from fuzzytime.requirement import Constraint, Unit

FEW = (2, 3)
"""How many times "a couple" and "a few" are."""

grammar = Grammar()


def of_unit(unit: UnitWord, count: float = 1) -> Repeat:
    """Give every so many units."""
    if unit.unit in SUB_DAY or count != int(count):
        return Repeat(Duration(((count * unit.count, unit.unit),)))
    return Repeat(
        Duration(((count * unit.count, unit.unit),)), (Wall(Cycle(unit.unit)),), int(count) * unit.count
    )


@grammar.rule(
    "repeat", "once every|each <unit>", "every|each|per single? <unit>", "every|each and every|each <unit>"
)
def every(unit: UnitWord) -> Repeat | None:
    """Every day, each week."""
    # Every night is a part of every day.
    return of_unit(unit) if len(unit.form) > 1 and unit.form != "night" else None


@grammar.rule("repeat", "at|in <duration> -? intervals", "at intervals of <duration>", weight=0.4)
@grammar.rule("repeat", "once? every|each <duration>")
@grammar.rule("repeat", "at|in <duration> -? intervals", "at intervals of <duration>", weight=0.4)
def every_so_long(duration: Duration) -> Repeat | None:
    """Every twenty minutes, every two days, every hour and a half; at twenty minute intervals."""
    if len(duration.terms) == 1 and duration.terms[0][1] not in SUB_DAY and not duration.hedges:
        amount, unit = duration.terms[0]
        if amount == int(amount) and amount >= 1:
            return of_unit(UnitWord(unit, 1, unit.value), amount)
    if duration.until is not None:
        # "Every three to four hours": the middle.
        middle = (duration.seconds + duration.until.seconds) / 2
        return Repeat(Duration(((middle, Unit.SECOND),), duration.hedges)) if middle > 0 else None
    return Repeat(duration) if duration.seconds > 0 else None


@grammar.rule("repeat", "every|each <unit> and <fraction>", weight=0.1)
def every_and_a_half(unit: UnitWord, fraction: float) -> Repeat:
    """Every hour and a half."""
    return of_unit(unit, 1 + fraction)


@grammar.rule("mark of each hour", "the? top|start|beginning|end")
def at_the_top() -> int:
    """(at) the top (of every hour)."""
    return 0


@grammar.rule("mark of each hour", "the? bottom|middle")
def at_the_bottom() -> int:
    """(at) the bottom (of every hour)."""
    return 30


@grammar.rule("repeat", "at|on? <mark of each hour> of every|each hour", weight=0.6)
def at_mark_of_every_hour(minute: int) -> Repeat:
    """At the top of every hour."""
    return replace(hourly(), starting=HourMark(minute))


@grammar.rule(
    "repeat", "at? <minutes of clock>|<bare minutes of clock> past|after every|each hour", weight=0.6
)
def past_every_hour(minutes: float) -> Repeat:
    """At ten past every hour."""
    return at_mark_of_every_hour(int(minutes))


@grammar.rule(
    "repeat", "at? <minutes of clock>|<bare minutes of clock> to|before every|each hour", weight=0.6
)
def to_every_hour(minutes: float) -> Repeat:
    """At five to every hour."""
    return at_mark_of_every_hour(60 - int(minutes))


@grammar.rule("repeat", "every|each other|second <unit>", "on|in? alternate <unit>", weight=0.1)
def every_other(unit: UnitWord) -> Repeat:
    """Every other day."""
    return of_unit(unit, 2)


@grammar.rule("repeat", "every|each <ordinal> <unit>", weight=0.4)
def every_nth(number: int, unit: UnitWord) -> Repeat | None:
    """Every third day."""
    return of_unit(unit, number) if number > 0 else None


@grammar.rule("repeat", "q <integer> -? <unit>", weight=0.5)
def as_prescribed(number: Integer, unit: UnitWord) -> Repeat | None:
    """Q4h, as prescriptions have it."""
    return of_unit(unit, number.value) if number.value > 0 else None


@grammar.rule("repeat", "a? daily", "everyday", "day in day out", "each day of the week")
@grammar.rule("repeat", "24 / 7", "around|round the clock", weight=1.0)
def daily() -> Repeat:
    """Daily."""
    return of_unit(UnitWord(Unit.DAY, 1, "day"))


@grammar.rule("repeat", "<integer> -? hourly", weight=0.5)
def so_many_hourly(number: Integer) -> Repeat | None:
    """Two-hourly; but "do 4 hourly checks" is four of them."""
    return of_unit(UnitWord(Unit.HOUR, 1, "hour"), number.value) if number.value > 0 else None


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


@grammar.rule("repeat", "on an? <repeat> basis", weight=0.5)
def on_a_basis(often: Repeat) -> Repeat:
    """On a daily basis."""
    return often


@grammar.rule("so many each", "a|an|per <unit>")
def so_many_each(unit: UnitWord) -> Said | None:
    """(Two tablets) a day: what is counted is done each day."""
    return None if unit.unit in SUB_DAY or len(unit.form) == 1 else Said(of_unit(unit), Constraint.EVERY)


@grammar.rule("times", "once", "one time")
def once() -> int:
    """Once."""
    return 1


@grammar.rule("times", "thrice")
def thrice() -> int:
    """Thrice."""
    return 3


@grammar.rule("times", "twice")
def twice() -> int:
    """Twice."""
    return 2


@grammar.rule("few", "<integer>")
@grammar.rule("times", "<integer> times|x", "x <integer>")
def times(number: Integer) -> int | None:
    """Three times, 3x, x3; two (a day), but "two every night" is a clock time."""
    return number.value if 0 < number.value <= 1000 else None


@grammar.rule("times", "<quantity> times", weight=-0.2)
def a_few_times(number: Quantity) -> int | None:
    """A couple of times, a few times; how many are several is not said."""
    return int(number.value) if number.hedges and number.value in FEW else None


@grammar.rule("times", "<integer>|<times> or|to|- <times>", weight=0.4)
def about_so_many_times(least: Integer | int, most: int) -> int | None:
    """Two or three times, 2-3 times, once or twice: as often as it may be."""
    fewer = least if isinstance(least, int) else least.value
    return most if 0 < fewer < most else None


@grammar.rule("repeat", "<few> a|an|per <unit>", weight=0.1)
@grammar.rule("repeat", "<times> a|an|per|every|each|/ <unit>", "<times> daily", weight=0.6)
def so_often(number: int, unit: UnitWord | None = None) -> Repeat | None:
    """Twice a day, three times an hour."""
    if unit is not None and len(unit.form) == 1:
        return None
    length = UNIT_SECONDS[unit.unit] * unit.count if unit is not None else UNIT_SECONDS[Unit.DAY]
    if number == 1:
        return of_unit(unit or UnitWord(Unit.DAY, 1, "day"))
    days = unit is None or unit.unit not in SUB_DAY
    # "Twice a day": once in each half of it, and at no moment.
    return Repeat(Duration(((length / number, Unit.SECOND),)), shared=days)


@grammar.rule("repeat", "<times> <repeat>", weight=0.6)
def so_often_in(number: int, often: Repeat) -> Repeat | None:
    """Twice weekly, three times monthly."""
    units = (UnitWord(unit, 1, unit.value) for unit in (Unit.HOUR, Unit.WEEK, Unit.MONTH, Unit.YEAR))
    unit = next((one for one in units if of_unit(one) == often), None)
    return None if unit is None else so_often(number, unit)


@grammar.rule("repeat", "<integer> x <unit>", weight=0.5)
def so_often_typed(number: Integer, unit: UnitWord) -> Repeat | None:
    """2x day, 3x week."""
    often = times(number)
    return None if often is None or unit.unit in SUB_DAY else so_often(often, unit)


@grammar.rule("repeat", "<integer> days a|per|every|each|/ week", weight=0.9)
def on_so_many_days(number: Integer) -> Repeat | None:
    """Three days a week: so often, and not for so long; seven are all of them."""
    if number.value == WEEK_DAYS:
        return of_unit(UnitWord(Unit.DAY, 1, "day"))
    often = 0 < number.value < WEEK_DAYS
    return so_often(int(number.value), UnitWord(Unit.WEEK, 1, "week")) if often else None


@grammar.rule("repeat", "<times> <wall>|<rest>", weight=0.5)
def so_often_within(number: int, within: Wall | Rest) -> Repeat | None:
    """Twice today, three times this week: once in each share of it."""
    timed = isinstance(within, Wall) and (within.clock is not None or within.days is None)
    if number == 1 or timed:
        return None
    return Repeat(times=number, starting=within, until=within)


WITHIN = frozenset({"on", "in", "at", "during", "over"})
"""Prepositions of a stretch in which something is done so often: "twice at night"."""


@grammar.rule("repeat", "<times> ,? <said>", weight=0.5)
def so_often_by(number: int, said: Said) -> Repeat | None:
    """Three times before lunch, twice between two and four, twice on friday, twice in the afternoon."""
    time = said.time
    if isinstance(time, Wall) and said.preposition in WITHIN and not said.hedges:
        part = time.part is not None and not time.part.meal and time.clock is None and time.days is None
        many = number > 1 and part
        return Repeat(times=number, starting=time, until=time) if many else so_often_within(number, time)
    if number == 1 or said.lasting is not None:
        return None
    if said.constraint is Constraint.BETWEEN and isinstance(time, Range):
        return Repeat(times=number, starting=time.first, until=time.last)
    if said.constraint is not Constraint.BEFORE or not isinstance(time, Wall):
        return None
    begins = Offset(Duration(((0, Unit.SECOND),)), -1, time)
    return Repeat(times=number, until=begins if said.edge is Edge.START else time)


@grammar.rule("said", "for? <duration> a|an|per|every|each <unit>", weight=0.6)
def so_long_each(duration: Duration, unit: UnitWord) -> Said | None:
    """For twenty minutes a day: each day, and how long."""
    longer = UNIT_SECONDS[unit.unit] * unit.count > duration.seconds and unit.unit not in SUB_DAY
    if not longer or len(unit.form) == 1:
        return None
    lasting = replace(duration, hedges=())
    return Said(of_unit(unit), Constraint.EVERY, "for", duration.hedges, lasting=lasting)
