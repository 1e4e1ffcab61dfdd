"""Minutes to an hour, or from one hour to another: "tomorrow ten to six", "open ten to six"."""

from dataclasses import replace

from fuzzytime.language.english.clock_times.minutes_past import NOON_HOUR, moved
from fuzzytime.language.english.intervals.ranges import from_hour_to
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.expressions import Said, Wall
from fuzzytime.language.meaning.joined.beside import joined, refined
from fuzzytime.language.meaning.times_of_day import Clock

grammar = Grammar()


@grammar.rule("said", "<wall> ,? <spoken minutes> to <wall>", weight=1.3)
def spoken_to_hour_on_day(day: Wall, minutes: float, hour: Wall) -> Said | None:
    """Tomorrow ten to six; but "tomorrow five to nine" may be four hours, as they follow each other."""
    clock = hour.clock
    if clock is None or clock.hour > minutes or day.clock is not None or (day.days or day.part) is None:
        return None
    found = moved(clock, -minutes)
    time = (
        None
        if found is None
        else joined(day, replace(hour, clock=replace(found, hours=clock.bare and minutes <= NOON_HOUR)))
    )
    return None if time is None else Said(time, None, None)


# Of what goes on for hours, and only there, these are from when to when.


grammar.rule("hours open", "<clock> to|till|til|until|- <clock>", weight=1.0)(from_hour_to)


@grammar.rule("hours open", "<clock> to|till|til|until|- <clock> ,? on? <wall>", weight=1.0)
def open_between_on(first: Clock, last: Clock, day: Wall) -> Said | None:
    """(work) ten to six tomorrow."""
    hours = from_hour_to(first, last)
    return None if hours is None or day.days is None else refined(hours, day)


@grammar.rule("hours open", "on? <wall> ,? <clock> to|till|til|until|- <clock>", weight=1.0)
def open_on_day_between(day: Wall, first: Clock, last: Clock) -> Said | None:
    """(open) tomorrow ten to six."""
    return open_between_on(first, last, day)


@grammar.rule("hours open", "<hours open> ,? <hedge_after>")
def open_about(hours: Said, hedge: str) -> Said:
    """(open) ten to six or so."""
    return replace(hours, hedges=(*hours.hedges, hedge))
