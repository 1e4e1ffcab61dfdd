"""Bounds and stretches beside the day that they are on: "tomorrow before 5 pm", "but not before ten"."""

from dataclasses import replace

from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.meaning.beside import refined
from fuzzytime.language.meaning.expressions import Edge, Ending, Goal, Range, Said, Wall
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()


@grammar.rule("said", "<said> at|on|of|,|in? the? <wall>", weight=0.1)
def range_on_day(said: Said, wall: Wall) -> Said | None:
    """Between 3 and 5 on friday."""
    return refined(said, wall)


@grammar.rule("said", "<wall> , <said>", "<wall> <said>", "<preposition_at> <wall> ,? <said>", weight=0.1)
def day_and_bound(first: Preposition | Wall, second: Wall | Said, third: Said | None = None) -> Said | None:
    """Tomorrow before 5pm, tomorrow evening by seven, friday between 1PM and 4 PM."""
    wall, said = (first, second) if third is None else (second, third)
    if not isinstance(wall, Wall) or not isinstance(said, Said):
        return None
    dated = isinstance(said.time, Wall) and said.time.days is not None
    if isinstance(first, Preposition) and first.name == "for" and dated:
        # "The rota for next week by thursday": what it is for, and a deadline.
        return None
    # "Eat lunch by one": a meal beside a bound is what is to be done.
    return None if wall.weak and wall.part is not None else refined(said, wall)


@grammar.rule("said", "<wall> ,? but|and <preposition_after> <goal>", weight=0.6)
def day_from(wall: Wall, after: Preposition, goal: Goal) -> Said | None:
    """Tomorrow, but not before ten: from then to the end of that day."""
    return _rest_of_day(wall, Said(goal.time, Constraint.AFTER, after.name, goal.hedges))


@grammar.rule("said", "<wall> ,? but|and <preposition_before> <goal>", weight=0.6)
def day_until(wall: Wall, before: Preposition, goal: Goal) -> Said | None:
    """Tomorrow, but before ten: from when that day begins to then."""
    return _rest_of_day(wall, Said(goal.time, Constraint.BEFORE, before.name, goal.hedges))


def _rest_of_day(wall: Wall, bound: Said) -> Said | None:
    """Give what a bound leaves of a day; None where no day is named, or the bound does not go with it."""
    said, day = refined(bound, wall), wall.days
    if said is None or day is None or day.grain is not Unit.DAY or not isinstance(said.time, Wall):
        return None
    later = bound.constraint is Constraint.AFTER
    first, last = (said.time, Ending(Edge.END, day)) if later else (Ending(Edge.START, day), said.time)
    return replace(said, time=Range(first, last), constraint=Constraint.BETWEEN)
