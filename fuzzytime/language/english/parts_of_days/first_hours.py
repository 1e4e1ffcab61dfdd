"""The first and the last hours of a day, or of a part of one: "the last hour of the day"."""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.calendar import Calendar
from fuzzytime.language.meaning.days.relations import Relative
from fuzzytime.language.meaning.expressions import Duration, Wall
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS, WHOLE_DAY, Half, Part
from fuzzytime.language.meaning.units import UnitWord
from fuzzytime.requirement import Unit

grammar = Grammar()


@grammar.rule("wall", "in|during|for|over? the? first <duration>|<unit> of the? <wall>", weight=1.2)
def beginning_of_part(length: Duration | UnitWord, wall: Wall) -> Wall | None:
    """In the first hour of the morning."""
    return _shortened(wall, length, last=False)


@grammar.rule("wall", "in|during|for|over? the? last|final <duration>|<unit> of the? <wall>", weight=1.2)
def ending_of_part(length: Duration | UnitWord, wall: Wall) -> Wall | None:
    """In the last half hour of lunch."""
    return _shortened(wall, length, last=True)


@grammar.rule("wall", "in|during|for|over? the? first <duration>|<unit> of the day", weight=1.2)
def beginning_of_the_day(length: Duration | UnitWord) -> Wall | None:
    """The first two hours of the day."""
    return _shortened(Wall(Relative(0)), length, last=False)


@grammar.rule("wall", "in|during|for|over? the? last|final <duration>|<unit> of the day", weight=1.2)
def ending_of_the_day(length: Duration | UnitWord) -> Wall | None:
    """The last hour of the day."""
    return _shortened(Wall(Relative(0)), length, last=True)


def _shortened(wall: Wall, length: Duration | UnitWord, *, last: bool) -> Wall | None:
    """Give so much of a day or of a part of one, from its start or to its end."""
    duration = length if isinstance(length, Duration) else Duration(((length.count, length.unit),))
    found = wall.part or _whole(wall.days)
    sure = duration.until is None and duration.terms[-1][1] in SUB_DAY
    sure = sure and (isinstance(length, Duration) or len(length.form) > 1)
    if found is None or wall.clock is not None or not sure:
        return None
    seconds = int(duration.seconds)
    if not 0 < seconds < found.end - found.start:
        return None
    start, end = (found.end - seconds, found.end) if last else (found.start, found.start + seconds)
    return replace(wall, part=replace(found, start=start, end=end, late=None), weak=False)


def _whole(days: Calendar | None) -> Part | None:
    """Give all of a day."""
    return Part(WHOLE_DAY, 0, DAY_SECONDS, Half.DAY) if days is not None and days.grain is Unit.DAY else None
