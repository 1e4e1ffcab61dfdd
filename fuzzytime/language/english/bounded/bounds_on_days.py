"""Bounds and stretches beside the day that they are on: "tomorrow before 5 pm", "but not before ten"."""

from dataclasses import replace

from fuzzytime.language.english.intervals.ranges import between
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.meaning.days.relations import Relative, days_away
from fuzzytime.language.meaning.expressions import Duration, Edge, Ending, Goal, Range, Said, Wall
from fuzzytime.language.meaning.joined.beside import joined, refined
from fuzzytime.requirement import Constraint, Unit

grammar = Grammar()


@grammar.rule("said", "<said> at|on|of|,|in? the? <wall>", "<said> , on the? <wall>", weight=0.1)
def range_on_day(said: Said, wall: Wall) -> Said | None:
    """Between 3 and 5 on friday; but who is picked up "from school on friday" is picked up there."""
    return None if _is_from_place(said) else refined(said, wall)


def _is_from_place(said: Said) -> bool:
    """Whether it says where, and not since when: "from school"."""
    part = said.wall.part
    return said.preposition == "from" and part is not None and part.place


@grammar.rule("said", "<wall> , <said>", "<wall> <said>", "<preposition_at> <wall> ,? <said>", weight=0.1)
def day_and_bound(first: Preposition | Wall, second: Wall | Said, third: Said | None = None) -> Said | None:
    """Tomorrow before 5pm, tomorrow evening by seven, friday between 1PM and 4 PM.

    What is due by then may be done on a day before; "tomorrow before five" is tomorrow.
    """
    wall, said = (first, second) if third is None else (second, third)
    if not isinstance(wall, Wall) or not isinstance(said, Said):
        return None
    dated = said.wall.days is not None
    if isinstance(first, Preposition) and first.name == "in" and wall.part is None:
        # "In december before the 10th"
        wall = replace(wall, weak=False)
    if isinstance(first, Preposition) and first.name == "for" and dated:
        # "The rota for next week by thursday": what it is for, and a deadline.
        return None
    if _is_from_place(said):
        # "Pick up sam wednesday from school": where, and not since when.
        return None
    if wall.weak and wall.part is not None:
        # "Eat lunch by one": a meal beside a bound is what is to be done.
        return None
    until = said.preposition == "before" or (wall.part is not None and said.preposition == "no later than")
    bound = refined(said, wall)
    return _on_day(bound, wall) if until and bound is not None else bound


@grammar.rule("day away", "in <duration> time?", "in <duration> '|'s time")
def day_away(duration: Duration) -> Wall | None:
    """In two days: the day, and no hour of it."""
    away = None if duration.hedges else days_away(duration, Relative(0), 1)
    return None if away is None else Wall(away)


@grammar.rule("said", "<day away> ,? <said>", "<said> ,? <day away>", weight=0.8)
def beside_day_away(*both: Wall | Said) -> Said | None:
    """In two days by five, from two to four in a week, in the evening in three days."""
    said = next((one for one in both if isinstance(one, Said)), None)
    wall = next((one for one in both if isinstance(one, Wall)), None)
    if said is None or wall is None:
        return None
    first = said.time.first if isinstance(said.time, Range) else said.time
    if not isinstance(first, Wall) or first.days is not None:
        return None
    plain = said.constraint is None and isinstance(said.time, Wall) and not first.bare
    time = joined(first, wall) if plain else None
    return refined(said, wall) if time is None else replace(said, time=time)


@grammar.rule("said", "<wall> ,? but|and <preposition_after> <goal>", weight=0.6)
def day_from(wall: Wall, after: Preposition, goal: Goal) -> Said | None:
    """Tomorrow, but not before ten; next week, but not before friday: from then to the end of that."""
    said, day = refined(Said(goal.time, Constraint.AFTER, after.name, goal.hedges), wall), wall.days
    if said is None or day is None or not isinstance(said.time, Wall):
        return None
    if day.grain is not Unit.DAY and said.time.clock is not None:
        return None
    over: Wall | Ending = Ending(Edge.END, day)
    if wall.part is not None:
        # "This afternoon, but not before three"
        over = replace(wall, part=replace(wall.part, start=wall.part.end))
    return replace(said, time=Range(said.time, over), constraint=Constraint.BETWEEN)


@grammar.rule("said", "<said> ,? but|and <preposition_after> <goal>", weight=0.9)
def before_but_after(said: Said, after: Preposition, goal: Goal) -> Said | None:
    """Tomorrow before noon, but not before ten: from the second to the first."""
    if said.constraint is not Constraint.BEFORE or not isinstance(said.time, Wall) or said.time.clock is None:
        return None
    clocked = goal.wall.clock is not None
    return between(goal, Goal(said.time, said.hedges)) if clocked and after.name != "since" else None


@grammar.rule("said", "<wall> ,? but|and <preposition_before> <goal>", weight=0.6)
def day_until(wall: Wall, before: Preposition, goal: Goal) -> Said | None:
    """Tomorrow, but before ten: from when that day begins to then."""
    said = refined(Said(goal.time, Constraint.BEFORE, before.name, goal.hedges), wall)
    return None if said is None or wall.days is None else _on_day(said, wall)


def _on_day(bound: Said, wall: Wall) -> Said:
    """Let a bound hold on its day, or in its part of it, and not before that too."""
    time = bound.time
    if bound.within is not None and isinstance(time, Wall) and time.days is not None:
        # "Next week | tuesday before ten"
        return replace(bound, within=replace(bound.within, days=time.days))
    if wall.days is None or not isinstance(time, Wall):
        return bound
    if wall.days.grain is not Unit.DAY:
        # "Next week before friday"
        return bound if time.days == wall.days else replace(bound, within=wall)
    # "Tomorrow morning before nine"; but "tomorrow before breakfast"
    part = wall.part if wall.part is not None or time.clock is None else time.part
    # "Wednesday | next week before ten": the day of both
    return replace(bound, within=Wall(time.days or wall.days, part, zone=wall.zone))
