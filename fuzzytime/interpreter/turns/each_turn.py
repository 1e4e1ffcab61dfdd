"""What follows each turn of something repeated: "every morning feed the cat, then walk the dog"."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import Instruction
from fuzzytime.requirement import Anchor, Constraint, Edge, Recurrence, TimeRequirement


@dataclass(frozen=True, slots=True)
class EachTurn:
    """The skills of a repetition that another follows turn by turn, and how it follows them."""

    target: int
    anchor: Anchor
    turns: Sequence[Interpreted]

    def times(
        self, repeated: TimeRequirement, _: Recurrence, __: float
    ) -> Iterator[tuple[TimeRequirement, ...]]:
        """Give when each is: behind its turn, and in the same stretch where that turn has one."""
        for place, turn in enumerate(self.turns):
            anchor = replace(self.anchor, turn=place)
            behind = replace(repeated, constraint=Constraint.AFTER, anchor=anchor, number=None)
            held = (_in_stretch(part, repeated) for part in turn.requirements if _is_stretch(part))
            yield (replace(behind, earliest=None, latest=None), *held)


def each_turn_of(
    instruction: Instruction, before: Sequence[range], skills: Sequence[Interpreted]
) -> EachTurn | None:
    """Give the turns that an instruction follows one by one; None where it follows none.

    ``before`` are the positions of the skills of all instructions so far.
    """
    repeated = next((part for part in instruction.requirements if part.recurrence is not None), None)
    anchor = None if repeated is None else repeated.anchor
    if anchor is None or anchor.target is None or anchor.edge is not Edge.END or anchor.exact:
        return None
    places = before[anchor.target] if anchor.target < len(before) else range(0)
    if not places:
        return None
    return EachTurn(anchor.target, anchor, [skills[place] for place in places])


def _is_stretch(part: TimeRequirement) -> bool:
    """Whether it is a stretch of time in which a turn of a repetition lies."""
    repeated = part.recurrence is not None and part.anchor is None
    return repeated and part.constraint is Constraint.BETWEEN


def _in_stretch(part: TimeRequirement, repeated: TimeRequirement) -> TimeRequirement:
    """Give the stretch of a turn as what the words of another ask for."""
    return replace(
        repeated,
        constraint=part.constraint,
        anchor=None,
        number=None,
        grain=part.grain,
        earliest=part.earliest,
        latest=part.latest,
    )
