"""What somebody does in a list of steps is asked of that one: "Ana grates the cheese"."""

from dataclasses import replace

from fuzzytime.language import Instruction, Lexicon, Operation, Reading
from fuzzytime.requirement import Constraint


def asking_doers(reading: Reading, lexicon: Lexicon) -> Reading:
    """Give a reading in which who is told to do something, and not when, is asked to."""
    instructions = tuple(_asking(one, lexicon) for one in reading.instructions)
    return replace(reading, instructions=instructions)


def _asking(instruction: Instruction, lexicon: Lexicon) -> Instruction:
    operation = instruction.operation
    if operation is None or not _is_done_by_somebody(operation, lexicon) or instruction.length_of is not None:
        return instruction
    times = [part for part in instruction.requirements if part.constraint is not Constraint.FOR]
    if instruction.time_of is not None or any(part.t_spec is not None or part.recurrence for part in times):
        # "Ann leaves at six" tells of it.
        return instruction
    asked = replace(
        operation,
        verb=operation.lemma,
        object=operation.complement,
        complement=None,
        addressee=operation.object,
        stated=False,
    )
    return replace(instruction, operation=asked)


def _is_done_by_somebody(operation: Operation, lexicon: Lexicon) -> bool:
    """Whether it is told what somebody does who is named, and not what that one is, has, or comes to."""
    doing = lexicon.doing
    if not operation.stated or operation.attended or operation.negated or operation.verb == operation.lemma:
        return False
    if operation.lemma in doing.holding_true | doing.being | doing.arriving | doing.leaving:
        return False
    name = operation.object or ""
    known = lexicon.people | lexicon.workers
    return " " not in name and (name[:1].isupper() or name.lower() in known)
