"""Turns that count from what comes before them: "stain it for 20 minutes, then rinse it three times"."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from fuzzytime.interpreter.binding.delays import is_over, last_once
from fuzzytime.interpreter.in_other_words.retold import turn
from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import Instruction
from fuzzytime.requirement import Constraint, Edge, Recurrence, TimeRequirement


@dataclass(frozen=True, slots=True)
class Behind:
    """The instruction, by its position among all, behind which turns begin, the first so much later.

    Of turns it is the last: "wash twice, a minute each, rinse twice, a minute each".
    """

    target: int
    turn: int
    later: float = 0.0

    def times(
        self, repeated: TimeRequirement, recurrence: Recurrence, until: float
    ) -> Iterator[tuple[TimeRequirement]]:
        """Give the turns' times, each at its distance from the end of what is before them."""
        for start, _ in recurrence.windows(until):
            yield (turn(repeated, self.target, Edge.END, self.later + start, of=self.turn or None),)


def behind_of(
    instruction: Instruction, before: Sequence[range], skills: Sequence[Interpreted], *, stepwise: bool
) -> Behind | None:
    """Give what turns come behind; None where they have a time of their own, or follow nothing.

    It is what words name ("then"), or the latest that was asked for of the same thing: "fold it four times".
    In steps that follow each other it is the latest that is over. ``before`` are the positions of the skills
    of all instructions so far.
    """
    repeated = next((part for part in instruction.requirements if part.recurrence is not None), None)
    recurrence = None if repeated is None else repeated.recurrence
    if recurrence is None or recurrence.interval is None:
        return None
    counted = not recurrence.endless
    # What is counted begins at once, and all else so long behind: "every hour after the meeting".
    begin = 0.0 if counted else recurrence.interval
    if recurrence.windows(recurrence.interval)[:1] != ((begin, begin),):
        return None
    operation = instruction.operation
    target = next((p.anchor.target for p in instruction.requirements if _follows(p) and p.anchor), None)
    if target is None and counted and operation is not None and operation.again:
        target = _about(operation.object, before, skills)
    if target is None and counted and stepwise:
        # "Stain it for five minutes, wash three times, two minutes each"
        target = last_once(before, skills)
    if target is None or not 0 <= target < len(before) or not is_over(before[target], skills):
        return None
    one = skills[before[target][-1]]
    if one.operation is None or (counted and one.stated):
        return None
    # "Fold the dough. Repeat three times, half an hour apart"
    again = counted and operation is not None and operation.again and operation.lemma == one.operation.lemma
    return Behind(target, len(before[target]) - 1, recurrence.interval if again else 0.0)


def _about(thing: str | None, before: Sequence[range], skills: Sequence[Interpreted]) -> int | None:
    """Give the latest instruction that asks for something to be done with a thing."""
    for target in range(len(before) - 1, -1, -1):
        operations = [skills[place].operation for place in before[target]]
        if any(one is not None and not one.stated and one.object == thing for one in operations):
            return target
    return None


def _follows(part: TimeRequirement) -> bool:
    """Whether it says that something is done once another is: "then"."""
    anchor = part.anchor
    behind = anchor is not None and anchor.target is not None and anchor.edge is Edge.END
    return behind and part.constraint is Constraint.AFTER and anchor is not None and not anchor.lag
