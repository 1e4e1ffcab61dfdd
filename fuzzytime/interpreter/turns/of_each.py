"""What is done once for each of several: "feed the calves after each milking", "muck out between dives"."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import Instruction
from fuzzytime.requirement import Constraint, Edge, TimeRequirement

Place = tuple[int, int]
"""The position of an instruction among all, and which of its skills is meant, from 0."""


@dataclass(frozen=True, slots=True)
class OfEach:
    """What an instruction says of each of several, and where these are, in the order of their times."""

    said: TimeRequirement
    turns: tuple[Place, ...]

    def times(self) -> Iterator[tuple[TimeRequirement, ...]]:
        """Give when each is: beside its turn, and on the near side of the next, or of the one before."""
        anchor = self.said.anchor
        if anchor is None:
            return
        constraint = self.said.constraint
        for number, place in enumerate(self.turns):
            before, behind = self.turns[:number][-1:], self.turns[number + 1 : number + 2]
            if constraint is Constraint.BETWEEN and not anchor.lag:
                if behind:
                    yield self._after(place), self._before(behind[0])
                continue
            here = replace(self.said, anchor=replace(anchor, target=place[0], turn=place[1]))
            others = [
                *(self._after(one) for one in before if constraint is Constraint.BEFORE),
                *(self._before(one) for one in behind if constraint is Constraint.AFTER),
            ]
            yield (here, *(others if not anchor.exact else ()))

    def _after(self, place: Place) -> TimeRequirement:
        return self._beside(place, Constraint.AFTER, Edge.END)

    def _before(self, place: Place) -> TimeRequirement:
        return self._beside(place, Constraint.BEFORE, Edge.START)

    def _beside(self, place: Place, constraint: Constraint, edge: Edge) -> TimeRequirement:
        """Give the same words as a bound at one of the turns alone."""
        anchor = self.said.anchor
        bound = anchor and replace(
            anchor, target=place[0], turn=place[1], each=(), edge=edge, lag=0.0, exact=False
        )
        return replace(self.said, constraint=constraint, anchor=bound, number=None, unit=None, fuzziness=())


def said_of_each(instruction: Instruction) -> TimeRequirement | None:
    """Give what an instruction says of each of several; None where it says nothing of that kind."""
    return next((p for p in instruction.requirements if p.anchor is not None and p.anchor.each), None)


def each_of(instruction: Instruction) -> tuple[int, ...]:
    """Give the instructions beside each of which one is done."""
    said = said_of_each(instruction)
    return () if said is None or said.anchor is None else said.anchor.each


def of_each(
    instruction: Instruction, before: Sequence[range], skills: Sequence[Interpreted]
) -> OfEach | None:
    """Give the turns beside which an instruction is done; None where its words name no such turns.

    ``before`` are the positions of the skills of all instructions so far.
    """
    said = said_of_each(instruction)
    if said is None or said.anchor is None:
        return None
    targets = [target for target in said.anchor.each if target < len(before)]
    places = [(target, turn) for target in targets for turn in range(len(before[target]))]
    begins: dict[Place, float] = {}
    latest = 0.0
    for place in places:
        # "First dive at nine", "second dive after the interval": without a time it is where it was said.
        begins[place] = latest = _begins(skills[before[place[0]][place[1]]]) or latest
    return OfEach(said, tuple(sorted(places, key=begins.__getitem__)))


def _begins(one: Interpreted) -> float:
    """Give when a skill begins, as far as its own time tells; 0 where it tells nothing."""
    return min(one.skill.named, default=max(0.0, one.skill.satisfaction.best.low))
