"""What is prepared, and for what: "the bus leaves at 8:05, so be there by 8"."""

from collections.abc import Sequence

from fuzzytime.language.instruction import Instruction
from fuzzytime.language.meaning.times_of_day import DAY_SECONDS
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import Constraint


def due_of(
    text: str, before: Sequence[Sketch], sketch: Sketch, instructions: Sequence[Instruction]
) -> float | None:
    """Give when in seconds that happens which an instruction prepares, by those before it; None for none."""
    words = text[: sketch.part.segment.span[0]].lower().split()
    # "The train goes at five past nine, be on the platform by nine"
    bounded = any(phrase.said.constraint is Constraint.BEFORE for phrase in sketch.phrases)
    if not before or (words[-1:] != ["so"] and not bounded) or before[-1].operation is None:
        return None
    asked = sketch.operation is None or not sketch.operation.stated
    if not before[-1].operation.stated or not asked:
        # "Story at seven, lights out by half past" is one after the other.
        return None
    said = [requirement.earliest for requirement in instructions[-1].requirements]
    repeats = instructions[-1].repeats
    said += repeats.occurrences(DAY_SECONDS)[:1] if repeats is not None else ()
    return next((seconds for seconds in said if seconds is not None), None)
