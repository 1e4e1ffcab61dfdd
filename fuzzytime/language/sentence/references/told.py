"""What was told of instructions, by their positions: starts, lengths, which are repeated."""

from dataclasses import dataclass, field
from datetime import datetime

from fuzzytime.errors import FuzzytimeError
from fuzzytime.language.instruction import Instruction
from fuzzytime.requirement import SAID_WHEN, Anchor, Constraint, TimeRequirement
from fuzzytime.times import instant_after


@dataclass(slots=True)
class Told:
    """What a text told: ``starts``; lengths in seconds, the latest told last; how often what is ``repeated``.

    ``since`` is what those count from that are so long after something, None for the moment of speaking;
    ``ahead`` those that are so long before another, by position.
    ``above`` is what was told before the text: what is asked of both is answered by the text first.
    """

    above: "Told | None" = None
    starts: dict[int, datetime] = field(default_factory=dict)
    lasting: dict[int, float] = field(default_factory=dict)
    repeated: dict[int, TimeRequirement] = field(default_factory=dict)
    since: dict[int, Anchor | None] = field(default_factory=dict)
    ahead: dict[int, int] = field(default_factory=dict)

    def add(self, position: int, instruction: Instruction, now: datetime | None) -> None:
        """Add what an instruction tells of itself, or how long another goes on: "it takes an hour"."""
        start = start_of(instruction, now)
        if start is not None:
            self.starts[position] = start
        for part in instruction.requirements:
            if part.preposition == "after" and part.number:
                self.since[position] = part.anchor
            ahead = part.anchor if part.constraint is Constraint.BEFORE else None
            if ahead is not None and ahead.lag and ahead.target is not None:
                self.ahead[position] = ahead.target
        if instruction.day_of is not None:
            self.ahead[position] = instruction.day_of
        repetition = next((part for part in instruction.requirements if part.recurrence is not None), None)
        if repetition is not None:
            self.repeated[position] = repetition
        meant = position if instruction.length_of is None else instruction.length_of.target
        if instruction.duration is not None and meant is not None:
            self.lasting.pop(meant, None)
            self.lasting[meant] = instruction.duration

    def event_of(self, position: int) -> int:
        """Give what an instruction is so long before, or itself: all in a countdown are before one event."""
        if position in self.ahead:
            return self.event_of(self.ahead[position])
        return position if self.above is None else self.above.event_of(position)

    def start(self, position: int) -> datetime | None:
        """Give when an instruction begins, as far as it was told."""
        if self.above is None or position in self.starts:
            return self.starts.get(position)
        return self.above.start(position)

    def length(self, position: int) -> float | None:
        """Give how long an instruction goes on, in seconds, as far as it was told."""
        if self.above is None or position in self.lasting:
            return self.lasting.get(position)
        return self.above.length(position)

    def is_repeated(self, position: int) -> bool:
        """Whether an instruction was told to be repeated."""
        return self.repetition(position) is not None

    def repetition(self, position: int) -> TimeRequirement | None:
        """Give what says how often an instruction is repeated, as far as it was told."""
        if self.above is None or position in self.repeated:
            return self.repeated.get(position)
        return self.above.repetition(position)

    def last_going_on(self, before: int) -> int | None:
        """Give the instruction before a position whose length was told last; None without one."""
        place = next((place for place in reversed(self.lasting) if place < before), None)
        return place if place is not None or self.above is None else self.above.last_going_on(before)


def start_of(instruction: Instruction, now: datetime | None) -> datetime | None:
    """Give when something begins, at the earliest, where its words say when it is."""
    said = (part.earliest for part in instruction.requirements if part.constraint in SAID_WHEN)
    first = next((seconds for seconds in said if seconds is not None), None)
    try:
        return None if first is None or now is None else instant_after(now, first)
    except FuzzytimeError:  # beyond the year 9999
        return None
