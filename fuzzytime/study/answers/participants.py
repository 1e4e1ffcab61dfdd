"""What participants answered, and who of them counts."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Floats
from fuzzytime.study.answers.subjective import SubjectiveSatisfaction
from fuzzytime.study.asking.design import Design


class Origin(StrEnum):
    """Where a participant's answers came from."""

    PAGE = "page"
    SIMULATED = "simulated"
    IMPORTED = "imported"


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Participant:
    """One person and all that was answered.

    Parameters
    ----------
    name
        A random identifier; a person's own name is never asked for.
    group
        The actor that the questions were about.
    order
        Keys of the instructions in the order in which they were shown.
    curves
        For each instruction answered, satisfactions of shape (samples,) at the design's times.
    demographics
        Answers by question; those left open are missing.
    control
        The answer on the control question's scale, None while it is open.
    finished
        Whether the last page was reached.
    excluded
        The reason why somebody excluded this participant, None where nobody did.
    """

    name: str
    group: str
    order: tuple[str, ...]
    curves: Mapping[str, Floats]
    demographics: Mapping[str, str] = field(default_factory=dict)
    control: int | None = None
    origin: Origin = Origin.PAGE
    finished: bool = True
    excluded: str | None = None


@dataclass(frozen=True, slots=True)
class SetAside:
    """A participant who does not count, and why."""

    name: str
    reason: str


@dataclass(frozen=True, slots=True, eq=False)
class Answers:
    """A study's design and its participants.

    >>> from fuzzytime.study import Design
    >>> Answers(Design.shipped(), ()).counted
    ()
    """

    design: Design
    participants: tuple[Participant, ...]

    @property
    def set_aside(self) -> tuple[SetAside, ...]:
        """Who does not count: the excluded, those who left instructions open, those who did not attend."""
        found = ((person.name, self._reason(person)) for person in self.participants)
        return tuple(SetAside(name, reason) for name, reason in found if reason)

    @property
    def counted(self) -> tuple[Participant, ...]:
        """Who counts: everybody who is not set aside."""
        return tuple(person for person in self.participants if not self._reason(person))

    @property
    def head_count(self) -> str:
        """How many count, and of several groups how many of each: ``8 participants (4 robot, 4 person)``."""
        number = len(self.counted)
        people = f"{number} participant{'s' * (number != 1)}"
        of_each = ", ".join(f"{len(self.members(group))} {group}" for group in self.design.groups)
        return f"{people} ({of_each})" if len(self.design.groups) > 1 else people

    def members(self, group: str | None) -> tuple[Participant, ...]:
        """Give the participants of a group, or of all, who count."""
        return tuple(person for person in self.counted if group in (None, person.group))

    def subjective(self, group: str | None = None) -> dict[str, SubjectiveSatisfaction]:
        """Give Ψ_I by the key of I, over a group or over all; in each, row i is the same participant.

        Raises
        ------
        FuzzytimeError
            If nobody counts.
        """
        members = self.members(group)
        if not members:
            whom = f"of the group {group!r} " if group else ""
            aside = f"; {len(self.set_aside)} are set aside" if self.set_aside else ""
            raise FuzzytimeError(f"no participant {whom}has answered every instruction attentively{aside}")
        times = self.design.timeline.times
        return {
            instruction.key: SubjectiveSatisfaction(
                times, np.array([person.curves[instruction.key] for person in members])
            )
            for instruction in self.design.instructions
        }

    def _reason(self, person: Participant) -> str:
        if person.excluded is not None:
            return f"excluded: {person.excluded}"
        open_ones = [
            instruction.key
            for instruction in self.design.instructions
            if instruction.key not in person.curves
        ]
        if open_ones:
            count = len(self.design.instructions)
            return f"answered {count - len(open_ones)} of {count} instructions"
        missed = inattentive(self.design, person)
        if missed:
            return f"attention check: nothing drawn around the time of {', '.join(missed)}"
        return ""


def inattentive(design: Design, person: Participant) -> tuple[str, ...]:
    """Give the instructions in which a curve is 0 everywhere near the time that they specify."""
    if design.attention is None:
        return ()
    times = design.timeline.times
    missed = []
    for instruction in design.instructions:
        curve = person.curves.get(instruction.key)
        near = np.abs(times - instruction.t_spec) <= design.attention
        if curve is not None and not (curve[near] > 0).any():
            missed.append(instruction.key)
    return tuple(missed)
