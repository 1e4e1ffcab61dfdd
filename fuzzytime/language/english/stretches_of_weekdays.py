"""Hours and clock times on a stretch of weekdays: "monday to friday from 9 to 5", "mon-fri at noon"."""

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.calendar import Fields
from fuzzytime.language.meaning.expressions import Range, Repeat, Said, Wall
from fuzzytime.language.meaning.repeats_beside import narrowed_repeat, within_hours
from fuzzytime.requirement import Constraint

grammar = Grammar()


@grammar.rule("week stretch", "from? <weekday> to|-|through|thru|till|until <weekday>")
def week_stretch(first: int, last: int) -> tuple[int, ...]:
    """Monday to friday, beside hours: on each of these days."""
    return tuple((first + day) % 7 for day in range((last - first) % 7 + 1))


@grammar.rule("repeat", "every|each day ,? <week stretch>", weight=1.3)
def each_of_week(days: tuple[int, ...]) -> Repeat:
    """Every day from monday to friday."""
    return Repeat(walls=tuple(Wall(Fields(weekday=day)) for day in days))


@grammar.rule("repeat", "<said> ,? <week stretch>", weight=1.3)
def hours_of_week(said: Said, days: tuple[int, ...]) -> Repeat | None:
    """From 9 to 5, monday to friday."""
    return of_week(days, said)


@grammar.rule("repeat", "<week stretch> ,? <said>", weight=1.3)
def week_of_hours(days: tuple[int, ...], said: Said) -> Repeat | None:
    """Monday to friday from 9 to 5, mon-fri at noon."""
    return of_week(days, said)


def of_week(days: tuple[int, ...], said: Said) -> Repeat | None:
    """Give a repetition on some days of the week, at a clock time or within hours."""
    whole = Repeat(walls=tuple(Wall(Fields(weekday=day)) for day in days))
    time = said.time
    ends = (time.first, time.last) if isinstance(time, Range) else (time,)
    clocks = [end for end in ends if isinstance(end, Wall) and end.clock is not None and end.days is None]
    if len(clocks) != len(ends) or said.constraint in {Constraint.BEFORE, Constraint.AFTER} or said.hedges:
        return None
    if isinstance(time, Range):
        return within_hours(whole, clocks[0], clocks[1])
    return narrowed_repeat(whole, clocks[0]) if said.preposition is not None or not clocks[0].bare else None
