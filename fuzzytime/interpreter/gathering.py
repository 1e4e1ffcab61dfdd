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
from fuzzytime.language import LEAVING, Instruction, Reading, reported


@dataclass(slots=True)
class Gathering:
    """The skills of all wishes so far, and what was noted on the way."""

    maker: Maker
    links: Links
    rows: Rows
    skills: list[Interpreted] = field(default_factory=list)
    problems: list[Problem] = field(default_factory=list)
    ahead: list[tuple[SpokenWish, Instruction]] = field(default_factory=list)

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
                self._go_there(wish, reading, instruction, instruction.length_of.target)
            elif instruction.time_of is not None and not any(map(_is_asked, self.skills)):
                # "Everything must be done by six", said before anything is asked for.
                self.ahead.append((wish, instruction))
                places.append((instruction, range(0)))
            elif (timed := self._timed_by(instruction)) is not None:
                for place in timed:
                    self._time(place, instruction, wish)
                places.append((instruction, timed[-1:]))
            else:
                step = without_now(instruction) if listed and self.rows.begun else instruction
                places.append((step, self._made(wish, reading, step)))
                if listed:
                    self.rows.add(self.skills, places[-1][1])
                self._go_there(wish, reading, instruction, len(self.links.instructions))
            self.links.instructions.append(places[-1][1])
        if not listed:
            self.rows.join(reading, places, self.skills)
            for _, made in places:
                self.rows.await_arrival(made, self.skills)
                self.rows.resume(made, self.skills)

    def finish(self) -> None:
        """Let all be done by when words said so before anything was asked for."""
        for wish, instruction in self.ahead:
            if not any(map(_is_asked, self.skills)):
                what = "says when all must be done, and nothing is asked for"
                self.problems.append(problem_of(wish, ProblemKind.NOTHING_TO_DO, what, instruction.span))
            for place in range(len(self.skills)):
                self._time(place, instruction, wish)

    def _made(self, wish: SpokenWish, reading: Reading, instruction: Instruction) -> range:
        """Make an instruction's skills, and give their places."""
        inside = going_on(instruction, self.links.instructions, self.skills)
        made = _made(self.maker, wish, reading, instruction, self.problems, inside)
        if inside is not None and made:
            self.problems.append(_noted_inside(wish, instruction, inside))
        first = len(self.skills)
        self.skills += made
        return range(first, len(self.skills))

    def _timed_by(self, instruction: Instruction) -> range | None:
        """Give the skills of which an instruction tells when they must be done: "it must be done by six"."""
        told = instruction.time_of
        if told is None:
            return None
        if told.target is None:
            return range(len(self.skills))
        meant = self.links.skills_of(told.target)
        return meant if len(meant) == 1 and isinstance(self.skills[meant[0]].wish, SpokenWish) else None

    def _time(self, place: int, instruction: Instruction, wish: SpokenWish) -> None:
        """Let a skill be done by when an instruction tells, unless it was asked for later than that."""
        made = self.skills[place]
        if not _is_asked(made):
            return
        timed = self.maker.timed(made, instruction, wish.given)
        if timed.skill.satisfaction.support.empty and not made.skill.satisfaction.support.empty:
            said = " ".join(part.text for part in instruction.requirements)
            message = f"{made.skill.name} is asked for later than {said!r}, and keeps its time"
            self.problems.append(problem_of(wish, ProblemKind.NOTE, message, instruction.span))
            return
        self.skills[place] = timed

    def _go_there(
        self, wish: SpokenWish, reading: Reading, instruction: Instruction, target: int | None
    ) -> None:
        """Add the way to where something is done or happens, right before that."""
        meant = range(0) if target is None else self._skills_at(target)
        if instruction.way is None or target is None or not meant:
            return
        operation = self.skills[meant[0]].operation
        if operation is not None and operation.lemma in LEAVING:
            # "We leave at six, the drive takes an hour"
            self.skills[meant[0]] = self.maker.lasting(self.skills[meant[0]], instruction.way)
            return
        self.skills.append(self.maker.way(wish, reading, instruction, self.skills[meant[0]], target))

    def _skills_at(self, target: int) -> range:
        if target < len(self.links.instructions):
            return self.links.skills_of(target)
        return range(len(self.skills) - 1, len(self.skills)) if self.skills else range(0)

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


def _is_asked(made: Interpreted) -> bool:
    """Whether words ask for something to be done."""
    return made.operation is not None and not made.operation.stated and isinstance(made.wish, SpokenWish)


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
