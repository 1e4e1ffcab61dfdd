"""What is in the morning behind the part of the day that was said before: "pack tonight, leave at five"."""

from collections.abc import Sequence

from fuzzytime.language.meaning.days.relations import Relative
from fuzzytime.language.meaning.expressions import Said
from fuzzytime.language.meaning.times_of_day import NOON, Half, Part
from fuzzytime.language.sentence.sketches.sketch import Sketch


def is_morning_after(said: Said, before: Part) -> bool:
    """Whether it is in a morning, without its day, behind a part of the day that was said before.

    "Pack tonight, leave at five am"
    """
    part, clock = said.wall.part, said.wall.clock
    if said.wall.days is not None:
        return False
    if part is None:
        return before.half.is_late and clock is not None and clock.half is Half.AM
    return part.end <= NOON and (before.half.is_late or part.end <= before.start)


def part_before(sketch: Sketch, said: Said) -> Part | None:
    """Give the part of the day behind which a morning is; of what happens on a day to come, none.

    "The party is tomorrow evening, buy drinks in the morning" is before it.
    """
    operation = sketch.operation
    happens = operation is not None and operation.stated and said.wall.days not in {None, Relative(0)}
    return None if happens else said.wall.part


def follows_night(sketches: Sequence[Sketch], place: int) -> bool:
    """Whether an instruction is in the morning behind the part of the day that was said last before it."""
    before = ((one, phrase.said) for one in sketches[:place][::-1] for phrase in one.phrases[::-1])
    said = (part_before(one, said) for one, said in before)
    last = next((part for part in said if part is not None), None)
    return last is not None and any(is_morning_after(one.said, last) for one in sketches[place].phrases)
