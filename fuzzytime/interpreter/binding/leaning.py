"""Lines that lean on each other are steps in order without numbers: a recipe, how to put up a shelf.

A line leans on those above it if it goes on where they end ("then", "meanwhile", "once it is dry"), or names
nothing of its own ("bake", "let it stand"). A list of chores, of which one or two do, is none.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field

from fuzzytime.interpreter.binding.steps import is_anchored
from fuzzytime.language import Instruction, Lexicon, Reading, content_words
from fuzzytime.requirement import Constraint, TimeRequirement

FEWEST = 4
"""Lines that ask for something, at least, behind the first."""

LEANING = 3
"""One line of so many leans, at least, behind the first."""

ABOUT_THE_SAME = 2
"""One of so many leans, is about a thing that was named above ("drain the potatoes"), or says how long."""

TIMED = 3
"""Less than one of so many says when, by itself: else the times say the order."""

NO_TIME = frozenset({Constraint.FOR, Constraint.WHEN})
"""What says how long something takes, or what it waits for."""


@dataclass(slots=True)
class _Lines:
    """What was counted of the lines so far; ``asked`` are the positions of what is asked for."""

    read: int = 0
    count: int = 0
    leaning: int = 0
    same: int = 0
    timed: int = 0
    asked: dict[int, frozenset[str]] = field(default_factory=dict)
    seen: int = 0

    def add(self, reading: Reading, lexicon: Lexicon) -> None:
        """Count a line, and take note of what it asks for."""
        asked = [(place, one) for place, one in enumerate(reading.instructions, self.seen) if _is_asked(one)]
        self.seen += len(reading.instructions)
        self.read += bool(reading.instructions)
        self.timed += any(_is_timed(part) for one in reading.instructions for part in one.requirements)
        if not asked:
            return
        first = asked[0][1]
        leans = self._goes_on(first) or _names_nothing(first, lexicon)
        known = frozenset().union(*self.asked.values())
        self.count += 1
        self.leaning += leans
        lasts = any(one.duration is not None for _, one in asked)
        self.same += leans or lasts or not known.isdisjoint(_words(first))
        self.asked.update((place, _words(one)) for place, one in asked)

    def _goes_on(self, instruction: Instruction) -> bool:
        """Whether its time counts from what a line above asks for, or waits for a state of that."""
        said = [part.anchor.target for part in instruction.requirements if part.anchor is not None]
        for part in instruction.requirements:
            said += [] if part.condition is None else [part.condition.target, part.condition.about]
        return any(target in self.asked for target in said)

    @property
    def are_steps(self) -> bool:
        """Whether enough of them lean on each other."""
        following = self.count - 1
        enough = LEANING * self.leaning >= following and ABOUT_THE_SAME * self.same >= following
        return following >= FEWEST and enough and TIMED * self.timed < self.read


def lean_on_each_other(readings: Sequence[Reading], lexicon: Lexicon) -> bool:
    """Whether the lines of a file are steps in the order said."""
    lines = _Lines()
    for reading in readings:
        lines.add(reading, lexicon)
    return lines.are_steps


def _is_asked(instruction: Instruction) -> bool:
    told = instruction.length_of or instruction.time_of
    return instruction.operation is not None and instruction.operation.is_asked and told is None


def _names_nothing(instruction: Instruction, lexicon: Lexicon) -> bool:
    """Whether what is done has nothing of its own, and needs it: what it is done with stands above."""
    operation = instruction.operation
    if operation is None or operation.again:
        return operation is not None
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


def _is_timed(part: TimeRequirement) -> bool:
    """Whether words say by themselves when: at a moment, by or from one on, or how often."""
    return part.constraint not in NO_TIME and not is_anchored(part)
