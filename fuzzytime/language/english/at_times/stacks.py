"""Times said side by side: "tomorrow morning at six am", "friday, march 6th, 17:30"."""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.numerals import Integer
from fuzzytime.language.meaning.calendar import Calendar, Fields, is_weekday
from fuzzytime.language.meaning.days.relations import Relative, days_away
from fuzzytime.language.meaning.expressions import Duration, Wall
from fuzzytime.language.meaning.joined.beside import joined
from fuzzytime.language.meaning.times_of_day import Clock, Half
from fuzzytime.requirement import Unit

grammar = Grammar()

ROUND = 5
"""Hours whose numbers may as well be minutes to the hour behind them are multiples of it."""


@grammar.rule("wall", "<wall> <wall>", weight=0.1)
def side_by_side(first: Wall, second: Wall) -> Wall | None:
    """Tomorrow morning six am; but "tues 10 march 6" is on the tenth."""
    date, clock = second.days, first.clock
    dated = isinstance(date, Fields) and date.month is not None and date.day is not None
    number = clock is not None and clock.grain is Unit.HOUR and clock.half is None
    return None if dated and number and is_weekday(first.days) else joined(first, second)


@grammar.rule(
    "wall",
    "<wall> at|on|of|for|@|,|- <wall>",
    "<wall> , at|on|@ <wall>",
    "<wall> - - <wall>",
    weight=0.1,
)
def stacked(first: Wall, second: Wall) -> Wall | None:
    """Tomorrow at six, friday march fifteenth nine am, morning of the 15th."""
    return joined(first, second)


@grammar.rule("wall", "<wall> ,? in <wall>", weight=0.1)
def stacked_in(first: Wall, second: Wall) -> Wall | None:
    """Friday in three weeks; but "the last sunday in march six pm" is no sixth."""
    dated = isinstance(second.days, Fields) and second.days.day is not None
    return None if dated else joined(first, second)


@grammar.rule("wall", "<wall> at|@ <wall>", "<wall> , at|@ <wall>", weight=0.15)
def stacked_clock(first: Wall, second: Wall) -> Wall | None:
    """The 20th at 10: a number behind "at" is a clock time."""
    if second.clock is None:
        return None
    return joined(first, replace(second, clock=_behind_at(second.clock)))


def _behind_at(clock: Clock) -> Clock:
    """Give a clock time behind "at", whose number may be minutes: "the 19th at ten to six" is no range."""
    if not (clock.bare or clock.minutes or clock.hours):
        return clock
    return replace(clock, bare=False, minutes=clock.bare and clock.hour % ROUND == 0, hours=False)


@grammar.rule("wall", "<wall> at|@ <clock>", "<wall> , at|@ <clock>", weight=0.3)
def stacked_digits(first: Wall, clock: Clock) -> Wall | None:
    """Friday at 2030: no year."""
    if first.clock is not None or not clock.bare or clock.grain is not Unit.MINUTE:
        return None
    return joined(first, Wall(clock=replace(clock, bare=False)))


@grammar.rule("wall", "<wall> of <wall>", weight=0.4)
def part_of_part(first: Wall, second: Wall) -> Wall | None:
    """The small hours of sunday morning: of two parts of a morning, the first."""
    inner, outer = first.part, second.part
    if inner is None or outer is None or first.days or first.clock or second.clock or second.days is None:
        return None
    early = outer.half is Half.AM and inner.end <= outer.end and not (inner.meal or inner.is_point)
    return replace(second, part=inner) if early else None


@grammar.rule("wall", "<date> t <clock> z?", weight=0.5)
def iso(days: Calendar, clock: Clock) -> Wall:
    """2026-03-05T14:30."""
    return Wall(days, clock=replace(clock, full_day=True, bare=False))


@grammar.rule("wall", "<wall> the <date>|<weak date>", "<wall> ( <date> )", weight=0.15)
def stacked_date(first: Wall, second: Calendar) -> Wall | None:
    """Tuesday the 19th."""
    return joined(first, Wall(second))


@grammar.rule("wall", "<wall> ( <weak date>|<days> )", "<wall> ( <days> ) -", weight=0.15)
def in_brackets(first: Wall, second: Calendar) -> Wall | None:
    """Friday (3/13), may 22 (fri)."""
    dated = first.days is not None and first.clock is None and second.grain is Unit.DAY
    return joined(first, Wall(second)) if dated else None


@grammar.rule("wall", "<weekday> / <date>|<weak date>", weight=0.15)
def weekday_slash_date(weekday: int, date: Calendar) -> Wall | None:
    """Fri/jun 19."""
    return joined(Wall(Fields(weekday=weekday)), Wall(date)) if date.grain is Unit.DAY else None


@grammar.rule("wall", "<weekday> <integer>", "<weekday> the <integer>", weight=0.0)
def weekday_and_day(weekday: int, day: Integer) -> Wall | None:
    """Monday 21."""
    return Wall(Fields(day=day.value, weekday=weekday)) if 12 < day.value <= 31 else None


@grammar.rule("wall", "<wall> at <clock behind at>", weight=0.2)
def wall_at_clock(wall: Wall, clock: Clock) -> Wall | None:
    """Monday at 2.30."""
    return joined(wall, Wall(clock=clock))


@grammar.rule(
    "wall", "in <duration> time? ,? at|on? <wall>", "in <duration> '|'s time ,? at|on? <wall>", weight=0.3
)
def after_days_at(duration: Duration, wall: Wall) -> Wall | None:
    """In seven days at 5pm, in three days on friday."""
    away = days_away(duration, Relative(0), 1)
    return None if away is None or wall.bare else joined(Wall(away), wall)


@grammar.rule(
    "wall", "in <duration> time? ,? at <clock>", "in <duration> '|'s time ,? at <clock>", weight=0.5
)
def after_days_at_number(duration: Duration, clock: Clock) -> Wall | None:
    """In two days at five, in a week at 1330; "in three days at ten to six" is no range."""
    return after_days_at(duration, Wall(clock=_behind_at(clock)))
