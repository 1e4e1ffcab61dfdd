"""Lines of a list of steps that only bound it: "start no later than five", "deadline 4 pm"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import Instruction, Lexicon, Reading
from fuzzytime.requirement import Anchor, Constraint

BY = "by"


def bounding(instruction: Instruction, reading: Reading, lexicon: Lexicon) -> Instruction:
    """Give an instruction that is all of a line as one that tells of all steps when they are done, or begin.

    Nothing is named that begins then, or is due.
    """
    said = instruction.requirements
    if _takes(instruction, lexicon):
        return replace(instruction, length_of=Anchor(text=reading.text))
    if len(reading.instructions) > 1 or not said or instruction.duration is not None:
        return instruction
    if any(part.anchor or part.condition or part.recurrence for part in said):
        return instruction
    operation = instruction.operation
    needed = operation is not None and operation.is_asked and operation.lemma in lexicon.doing.needing
    if needed:
        # "I need the car at two"
        said = tuple(
            replace(part, preposition=BY, constraint=Constraint.BEFORE, earliest=None) for part in said
        )
    due = operation is None and all(part.constraint is Constraint.BEFORE for part in said)
    if not due and not needed and not _starts(instruction, lexicon):
        return instruction
    return replace(instruction, time_of=Anchor(text=reading.text), requirements=said)


def bound_by(instruction: Instruction, skills: Sequence[Interpreted], lexicon: Lexicon) -> range:
    """Give the positions of the skills that it tells of: all, or the first where it says when that begins."""
    asked = (place for place, one in enumerate(skills) if one.asked)
    first = next(asked, 0)
    return range(first, first + 1) if _starts(instruction, lexicon) else range(len(skills))


def _takes(instruction: Instruction, lexicon: Lexicon) -> bool:
    """Whether it says how long all takes: "should take less than an hour"."""
    operation = instruction.operation
    if operation is None or operation.stated or operation.lemma not in lexicon.doing.taking:
        return False
    return instruction.duration is not None and not (
        operation.object or operation.place or operation.complement
    )


def _starts(instruction: Instruction, lexicon: Lexicon) -> bool:
    """Whether it says of nothing but all there is that it begins: "start by five"."""
    operation = instruction.operation
    if operation is None or not operation.is_asked or operation.phrase not in lexicon.doing.starting:
        return False
    return not (operation.object or operation.place or operation.complement or operation.purpose)
