"""Days side by side, of which each will do: "today or tomorrow", "monday or tuesday or wednesday"."""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.meaning.calendar import Calendar, Cycle, Fields
from fuzzytime.language.meaning.days.relations import Away, Deictic, Relative, Which
from fuzzytime.language.meaning.expressions import Range, Said, Wall
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.units import UnitWord
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()


@grammar.rule("said", "either? <preposition_at>? <wall> ,? or maybe|perhaps|on? <wall>", weight=0.9)
def either_day(preposition: Preposition | None, first: Wall, second: Wall) -> Said | None:
    """Today or tomorrow, on saturday or sunday: days side by side are one stretch."""
    if preposition is not None and preposition.name not in {"sometime", "on", "for"}:
        return None
    if any(wall.part is not None or wall.clock is not None or wall.weak for wall in (first, second)):
        return None
    day, other = first.days, second.days
    if day is None or not _is_behind(day, other):
        return None
    return Said(Range(first, Wall(Away(1, Unit.DAY, day))), Constraint.BETWEEN, "sometime")


@grammar.rule("said", "<said> ,? or maybe|perhaps|on? <wall>", weight=0.9)
def another_day(days: Said, wall: Wall) -> Said | None:
    """Monday or tuesday or wednesday."""
    stretch = days.time if days.preposition == "sometime" else None
    if not isinstance(stretch, Range) or not isinstance(stretch.first, Wall) or Wall(wall.days) != wall:
        return None
    last = stretch.last.days if isinstance(stretch.last, Wall) else None
    first = stretch.first.days
    if not isinstance(last, Away) or not isinstance(first, Fields) or first.weekday is None:
        return None
    if not _is_behind(Fields(weekday=(first.weekday + last.count) % 7), wall.days):
        return None
    return replace(days, time=replace(stretch, last=Wall(replace(last, count=last.count + 1))))


@grammar.rule("said", "this <unit> or|and next <unit>?", "this <unit> or|and the next|following", weight=1.2)
def this_or_the_next(unit: UnitWord, again: UnitWord | None = None) -> Said | None:
    """This week or next."""
    if unit.unit in SUB_DAY or unit.unit is Unit.DAY or (again is not None and again.unit is not unit.unit):
        return None
    first, last = (Wall(Deictic(which, Cycle(unit.unit))) for which in (Which.THIS, Which.NEXT))
    return Said(Range(first, last), Constraint.BETWEEN, "sometime")


@grammar.rule("said", "a day <days>", "a day in|of|during <days>", weight=0.5)
def a_day_of(days: Calendar) -> Said | None:
    """A day next week; but "twice a day next week" is so often."""
    return None if days.grain is Unit.DAY else Said(Wall(days))


def _is_behind(day: Calendar, other: Calendar | None) -> bool:
    """Whether a day is the one behind another."""
    if isinstance(other, Relative):
        known = isinstance(day, Relative) and other.days == day.days + 1
        return day.grain is Unit.DAY and (other.days == 1 if other.onward else known)
    if isinstance(day, Fields) and isinstance(other, Fields) and day.weekly and other.weekly:
        return other.weekday == ((day.weekday or 0) + 1) % 7
    return False
