"""Parts of the day up to some hour: "in the morning until half past eight"."""

from dataclasses import replace

from fuzzytime.language.english.intervals.ranges import range_of
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.meaning.expressions import Goal, Said, Wall
from fuzzytime.language.meaning.joined.beside import joined
from fuzzytime.language.meaning.times_of_day import Clock, Half
from fuzzytime.requirement import Constraint

grammar = Grammar()


@grammar.rule("said", "<wall> until|till|til|untill|up to? <clock>", weight=1.4)
def until_in_part(wall: Wall, clock: Clock) -> Said | None:
    """In the evening until nine, in the morning until 7:15; but "in the morning until two" is behind it."""
    part = wall.part
    if part is None or wall.clock is not None or part.meal or part.place or not clock.is_open:
        return None
    early, late = clock.candidates()
    last = joined(Wall(part=part), Wall(clock=clock))
    if last is None:
        return None
    if part.start < early <= part.end or part.start < late <= part.end:
        return range_of(Goal(wall), Goal(last))
    if part.half is Half.AM and 0 <= part.start - early < late - part.end:
        # A morning begins before most others: when, is not said.
        return Said(replace(last, days=wall.days), Constraint.BEFORE, "until")
    return None
