"""Lines that lean on each other are steps in order without numbers: a recipe, how to put up a shelf.

A line leans on those above it if it goes on where they end ("then", "meanwhile", "once it is dry"), or names
nothing of its own ("bake", "let it stand"). A list of chores, of which one or two do, is none.

Times by the clock say another order, but neither those that bound all of it ("serve at seven") nor parts of
the day that follow each other ("in the evening mix the dough", "next morning shape it").
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

from fuzzytime.interpreter.binding.steps import is_anchored
from fuzzytime.language import Instruction, Lexicon, Reading, RemarkKind, Steps, content_words
from fuzzytime.requirement import Constraint, TimeRequirement

NO_TIME = frozenset({Constraint.FOR, Constraint.WHEN})
"""What says how long something takes, or what it waits for."""


@dataclass(slots=True)
class _Lines:
    """What was counted of the lines so far; ``asked`` are the positions of what is asked for."""

    read: int = 0
    count: int = 0
    leaning: int = 0
    same: int = 0
    linked: int = 0
    timed: int = 0
    lasting: int = 0
    last_timed: bool = False
    begun: float = 0.0
    asked: dict[int, frozenset[str]] = field(default_factory=dict)
    seen: int = 0
    needing: bool = False

    def add(self, reading: Reading, lexicon: Lexicon) -> None:
        """Count a line, and take note of what it asks for."""
        asked = [(place, one) for place, one in enumerate(reading.instructions, self.seen) if _is_asked(one)]
        self.seen += len(reading.instructions)
        self.needing |= not reading.instructions and any(
            one.kind is RemarkKind.TOLD for one in reading.remarks
        )
        self.read += bool(reading.instructions)
        self.last_timed = any(self._is_timed(one, reading) for one in reading.instructions)
        self.timed += self.last_timed
        if not asked:
            return
        first = asked[0][1]
        leans = self._goes_on(first) or _names_nothing(first, lexicon)
        lasts = any(one.duration is not None for _, one in asked)
        known = frozenset().union(*self.asked.values())
        self.count += 1
        self.lasting += lasts
        self.leaning += leans
        self.same += leans or lasts or not known.isdisjoint(_words(first))
        self.linked += leans or any(not known.isdisjoint(_words(one)) for _, one in asked)
        self.asked.update((place, _words(one)) for place, one in asked)

    def _goes_on(self, instruction: Instruction) -> bool:
        """Whether its time counts from what a line above asks for, or waits for a state of that."""
        said = [part.anchor.target for part in instruction.requirements if part.anchor is not None]
        for part in instruction.requirements:
            said += [] if part.condition is None else [part.condition.target, part.condition.about]
        return any(target in self.asked for target in said)

    def _is_timed(self, instruction: Instruction, reading: Reading) -> bool:
        """Whether words say by themselves when: not those for all, nor what goes on inside a line."""
        if instruction.time_of is not None:
            return False
        said = [part for part in instruction.requirements if part.constraint not in NO_TIME]
        inside = len(reading.instructions) > 1
        return any(not is_anchored(part) and self._says_when(part, inside=inside) for part in said)

    def _says_when(self, part: TimeRequirement, *, inside: bool) -> bool:
        """Whether a time says where its line stands, and not only where those above it end."""
        if part.constraint is Constraint.BETWEEN and part.earliest is not None:
            # "Next morning" goes on where "in the evening" stands above it.
            before, self.begun = self.begun, max(self.begun, part.earliest)
            return part.earliest < before
        delayed = part.constraint is Constraint.AFTER and part.unit is not None
        return not delayed and not (inside and part.constraint is Constraint.EVERY)

    def are_steps(self, least: Steps) -> bool:
        """Whether enough of them lean on each other."""
        following = self.count - 1
        some = least.leaning * self.leaning >= following and least.same * self.same >= following
        # Half of them say how long, as a protocol does: "put the cells on ice for two minutes".
        long = least.same * self.lasting >= self.count
        most = (self.leaning >= least.least or long) and least.same * self.linked >= following
        # "Serve at seven" bounds them all.
        untimed = least.timed * (self.timed - self.last_timed) < self.read
        # What is needed is told above a recipe alone.
        enough = following >= least.lines and (some or most)
        lasting = not self.timed and least.lasting <= self.lasting == self.count
        return untimed and (enough or lasting or (self.needing and following > 1))


def lean_on_each_other(readings: Sequence[Reading], lexicon: Lexicon) -> bool:
    """Whether the lines of a file are steps in the order said."""
    lines = _Lines()
    for reading in readings:
        lines.add(reading, lexicon)
    return lines.are_steps(lexicon.policy.steps)


def _is_asked(instruction: Instruction) -> bool:
    told = instruction.length_of or instruction.time_of
    return instruction.operation is not None and instruction.operation.is_asked and told is None


def _names_nothing(instruction: Instruction, lexicon: Lexicon) -> bool:
    """Whether what is done has nothing of its own, and needs it: what it is done with stands above."""
    operation = instruction.operation
    if operation is None or operation.again:
        return operation is not None
    if operation.lemma in lexicon.doing.waiting and instruction.duration is not None:
        # Who waits has begun something.
        return True
    if operation.place is not None and not lexicon.closed.it_or_them.isdisjoint(operation.place.split()):
        # "Attach the sides to it"
        return True
    if operation.object or operation.complement:
        return False
    # "Incubate at 56 degrees", "go to the shop"
    needs = lexicon.alone - lexicon.intransitive
    return operation.lemma in needs or not (operation.place or operation.lemma in lexicon.needing_nothing)


def _words(instruction: Instruction) -> frozenset[str]:
    operation = instruction.operation
    return (
        frozenset() if operation is None else content_words(operation.object) | content_words(operation.place)
    )
