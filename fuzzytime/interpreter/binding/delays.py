"""So long "after" in a list of steps: "roast it for an hour", "after twenty minutes turn it"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import Instruction
from fuzzytime.requirement import Anchor, Constraint, Edge, TimeRequirement

AFTER = "after"


def since_the_step_before(
    instruction: Instruction, before: Sequence[range], skills: Sequence[Interpreted]
) -> Instruction:
    """Let so long "after" count from what was asked for right before, from its begin where that lasts longer.

    ``before`` are the positions of the skills of all instructions so far.
    """
    # What is done again and again goes on inside of what is meant: "roast it for an hour, basting it".
    once = (place for place in range(len(before) - 1, -1, -1) if len(before[place]) == 1)
    target = next(once, None)
    if target is None or instruction.operation is None or instruction.operation.stated:
        return instruction
    last = skills[before[target][0]]
    requirements = tuple(_counted(part, target, last) for part in instruction.requirements)
    return replace(instruction, requirements=requirements)


def _counted(part: TimeRequirement, target: int, last: Interpreted) -> TimeRequirement:
    if part.preposition != AFTER or part.unit is None or part.anchor is not None or part.t_spec is None:
        return part
    distance = part.t_spec
    edge = Edge.START if distance < last.skill.time_until_done else Edge.END
    anchor = Anchor(text=part.text, target=target, edge=edge, lag=distance, exact=True)
    return replace(
        part, constraint=Constraint.AFTER, anchor=anchor, t_spec=None, earliest=None, latest=None, grain=None
    )
