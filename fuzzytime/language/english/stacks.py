"""Times said side by side: "tomorrow morning at six am", "friday, march 6th, 17:30"."""

from dataclasses import replace

from fuzzytime.language.english.days import from_anchor
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.calendar import Calendar, Fields
from fuzzytime.language.meaning.expressions import Duration, Wall
from fuzzytime.language.meaning.relations import Relative, narrowed, same_day
from fuzzytime.language.meaning.times_of_day import Clock

grammar = Grammar()


def _is_ordinal(wall: Wall) -> bool:
    """Whether it is a day of the month alone, which may be an ordinal of anything."""
    days = wall.days
    return wall.weak and isinstance(days, Fields) and days == Fields(day=days.day) and wall.clock is None


def joined(first: Wall, second: Wall) -> Wall | None:
    """Give two wall-clock expressions as one, or None where they say the same thing twice."""
    # "Dinner on thursday" is a thing with its time; "tomorrow lunch" is a time.
    if (first.bare and second.bare) or (first.weak and first.part is not None):
        return None
    if second.weak and second.part is not None and second.part.place:
        return None
    # "The second on friday" is another thing's; "friday the second" is a day.
    if _is_ordinal(first) and isinstance(second.days, Fields) and second.days.weekly:
        return None
    # "The first twenty minutes" is no day at eight in the evening.
    if (first.weak and second.bare) or (first.bare and second.weak):
        return None
    days: Calendar | None = first.days or second.days
    if first.days is not None and second.days is not None:
        # A day said again is taken at its word: the date.
        if same_day(first.days, second.days):
            days = second.days
        elif same_day(second.days, first.days):
            days = first.days
        else:
            days = narrowed(first.days, second.days)
        if days is None:
            return None
    if (first.part and second.part) or (first.clock and second.clock):
        return None
    clock, part = first.clock or second.clock, first.part or second.part
    if clock is not None and part is not None and clock.full_day and not part.is_near(clock.seconds):
        # "At sunup, noon and sundown" are three.
        return None
    if clock is not None:
        clock = replace(clock, bare=False, pair=False)
    weak = first.weak and second.weak
    return Wall(days, part, clock, first.zone or second.zone, weak)


@grammar.rule(
    "wall", "<wall> <wall>", "<wall> at|on|in|of|for|@|,|- <wall>", "<wall> , at|on|in <wall>", weight=0.1
)
def stacked(first: Wall, second: Wall) -> Wall | None:
    """Tomorrow at six, friday march fifteenth nine am, morning of the 15th."""
    return joined(first, second)


@grammar.rule("wall", "<wall> at|@ <wall>", "<wall> , at <wall>", weight=0.15)
def stacked_clock(first: Wall, second: Wall) -> Wall | None:
    """The 20th at 10: a number behind "at" is a clock time."""
    if second.clock is None:
        return None
    return joined(first, replace(second, clock=replace(second.clock, bare=False)))


@grammar.rule("wall", "<date> t <clock> z?", weight=0.5)
def iso(days: Calendar, clock: Clock) -> Wall:
    """2026-03-05T14:30."""
    return Wall(days, clock=replace(clock, full_day=True, bare=False))


@grammar.rule("wall", "<wall> the <date>|<weak date>", "<wall> ( <date> )", weight=0.15)
def stacked_date(first: Wall, second: Calendar) -> Wall | None:
    """Tuesday the 19th."""
    return joined(first, Wall(second))


@grammar.rule("wall", "<weekday> <integer>", "<weekday> the <integer>", weight=0.0)
def weekday_and_day(weekday: int, day: object) -> Wall | None:
    """Monday 21."""
    number = getattr(day, "value", 0)
    return Wall(Fields(day=number, weekday=weekday)) if 12 < number <= 31 else None


@grammar.rule("wall", "<wall> at <clock behind at>", weight=0.2)
def wall_at_clock(wall: Wall, clock: Clock) -> Wall | None:
    """Monday at 2.30."""
    return joined(wall, Wall(clock=clock))


@grammar.rule(
    "wall", "in <duration> time? ,? at|on? <wall>", "in <duration> '|'s time ,? at|on? <wall>", weight=0.3
)
def after_days_at(duration: Duration, wall: Wall) -> Wall | None:
    """In seven days at 5pm, in three days on friday."""
    away = from_anchor(duration, Relative(0), 1)
    return None if away is None or wall.bare else joined(Wall(away), wall)
