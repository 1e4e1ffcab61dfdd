"""Wishes one after the other, each made into skills by what was said before it."""

from dataclasses import dataclass, field

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter.in_order import Rows, without_now
from fuzzytime.interpreter.inside import GoingOn, going_on
from fuzzytime.interpreter.interpretation import Interpreted, Problem, ProblemKind
from fuzzytime.interpreter.making import Maker
from fuzzytime.interpreter.references import Links
from fuzzytime.interpreter.remarks import is_spoiled, problem_of, remarks_of
from fuzzytime.interpreter.request import DirectWish, SpokenWish
from fuzzytime.language import Instruction, Reading, reported


@dataclass(slots=True)
class Gathering:
    """The skills of all wishes so far, and what was noted on the way."""

    maker: Maker
    links: Links
    rows: Rows
    skills: list[Interpreted] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)

    def direct(self, wish: DirectWish) -> None:
        """Add the skill of a wish without words."""
        self.skills.append(self.maker.direct(wish))

    def spoken(self, wish: SpokenWish, reading: Reading) -> None:
        """Add the skills of a wish in words."""
        listed = self.rows.holds(reading)
        places: list[tuple[Instruction, range]] = []
        for instruction in reading.instructions:
            if instruction.length_of is not None:
                places.append((instruction, self._lengthened(instruction)))
            elif (place := self._timed_by(instruction)) is not None:
                self.skills[place] = self.maker.timed(self.skills[place], instruction, wish.given)
                places.append((instruction, range(place, place + 1)))
            else:
                step = without_now(instruction) if listed and self.rows.begun else instruction
                places.append((step, self._made(wish, reading, step)))
                if listed:
                    self.rows.add(self.skills, places[-1][1])
            self.links.instructions.append(places[-1][1])
        if not listed:
            self.rows.join(reading, places, self.skills)
            for _, made in places:
                self.rows.await_arrival(made, self.skills)

    def _made(self, wish: SpokenWish, reading: Reading, instruction: Instruction) -> range:
        """Make an instruction's skills, and give their places."""
        inside = going_on(instruction, self.links.instructions, self.skills)
        made = _made(self.maker, wish, reading, instruction, self.problems, inside)
        if inside is not None and made:
            self.problems.append(_noted_inside(wish, instruction, inside))
        first = len(self.skills)
        self.skills += made
        return range(first, len(self.skills))

    def _timed_by(self, instruction: Instruction) -> int | None:
        """Give the skill of which an instruction tells when it must be done: "it must be done by six"."""
        told = instruction.time_of
        meant = range(0) if told is None or told.target is None else self.links.skills_of(told.target)
        return meant[0] if len(meant) == 1 and isinstance(self.skills[meant[0]].wish, SpokenWish) else None

    def _lengthened(self, instruction: Instruction) -> range:
        """Let skills go on for as long as an instruction tells ("it takes an hour"), and give their places.

        Who refers to these words means what they are about.
        """
        told, length = instruction.length_of, instruction.duration
        if told is None or told.target is None or length is None:
            return range(0)
        meant = self.links.skills_of(told.target)
        for place in meant:
            self.skills[place] = self.maker.lasting(self.skills[place], length)
        return meant


def _noted_inside(wish: SpokenWish, instruction: Instruction, inside: GoingOn) -> Problem:
    """Say that a repetition without an end is over with what goes on."""
    said = next(part for part in instruction.requirements if part.recurrence is not None)
    message = f"{said.text!r} is as long as this goes on: {inside.name}"
    return problem_of(wish, ProblemKind.NOTE, message, said.span, wish.identifier)


def _made(
    maker: Maker,
    wish: SpokenWish,
    reading: Reading,
    instruction: Instruction,
    problems: list[Problem],
    inside: GoingOn | None,
) -> list[Interpreted]:
    """Make an instruction's skills; where there is none to make, say why."""
    operation = instruction.operation
    if is_spoiled(instruction, reading, remarks_of(reading, wish)):
        return []
    if reported(reading) is not None:
        what = "tells what was done, and asks for nothing"
        problems.append(problem_of(wish, ProblemKind.NOTHING_TO_DO, what, instruction.span))
        return []
    if operation is None or operation.negated:
        what = "says a time but nothing to do" if operation is None else "asks for something not to be done"
        problems.append(problem_of(wish, ProblemKind.NOTHING_TO_DO, what, instruction.span))
        return []
    try:
        made = maker.spoken(wish, reading, instruction, inside)
    except FuzzytimeError as error:
        problems.append(problem_of(wish, ProblemKind.UNREADABLE, str(error), instruction.span))
        return []
    if not made:
        problems.append(
            problem_of(wish, ProblemKind.NOTHING_TO_DO, "does not occur within the horizon", instruction.span)
        )
    return made
