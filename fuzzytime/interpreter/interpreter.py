"""The meeting of language and rulebook: from wishes to fuzzy skills, with everything an explanation needs."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import datetime

from fuzzytime.context import Context
from fuzzytime.errors import FuzzytimeError, InstructionError
from fuzzytime.interpreter.horizon import horizon_of, within_horizon
from fuzzytime.interpreter.in_order import Rows, free_of_circles, without_now
from fuzzytime.interpreter.interpretation import Interpretation, Interpreted, Problem, ProblemKind
from fuzzytime.interpreter.making import Maker
from fuzzytime.interpreter.references import Links, link
from fuzzytime.interpreter.remarks import is_spoiled, notes_of, problem_of, remarks_of
from fuzzytime.interpreter.request import DirectWish, Request, SpokenWish
from fuzzytime.language import Instruction, Language, Reading, check_length
from fuzzytime.rulebook import Rulebook
from fuzzytime.skills import FuzzySkill


@dataclass(frozen=True, slots=True)
class Interpreter:
    """Language and rulebook together.

    >>> interpreter = Interpreter.shipped()
    >>> skill = interpreter.skill("Place the steak in about ten minutes!", duration=240.0)
    >>> skill.name, skill.satisfaction([300, 600, 1200]).round(1).tolist()
    ('place the steak', [1.0, 1.0, 0.5])
    """

    language: Language
    rulebook: Rulebook

    @classmethod
    def shipped(cls) -> "Interpreter":
        """Give the interpreter of the shipped tables, in the everyday profile."""
        return cls(Language.shipped(), Rulebook.shipped())

    def skill(
        self,
        text: str,
        *,
        duration: float | None = None,
        context: Context = Context.empty,
        now: datetime | None = None,
    ) -> FuzzySkill:
        """Turn one instruction into one fuzzy skill, on the timeline that starts when it is given.

        Parameters
        ----------
        text
            The instruction.
        duration
            Seconds that it takes; None takes what is said, else the table's.
        context
            Readings, in seconds relative to the instruction.
        now
            When it is given; needed for clock times only.

        Raises
        ------
        InstructionError
            If it is not exactly one instruction, or holds words about time that are not understood.
        """
        given = now if now is not None else datetime.min  # noqa: DTZ901 - no moment: nothing is counted from it
        wish = SpokenWish(text=text, given=given, hands_on=duration, elapsed=duration)
        reading = self.language.read(text, now=now)
        for problem in remarks_of(reading, wish):
            if problem.kind is ProblemKind.NOT_UNDERSTOOD:
                raise InstructionError(problem.message, text, problem.span or (0, len(text)))
        operations = [part.operation for part in reading.instructions if part.operation is not None]
        if len(operations) != 1:
            raise InstructionError(
                f"a skill must be one operation, got {len(operations)}", text, (0, len(text))
            )
        maker = Maker(self.rulebook, Request(now=given, wishes=(wish,), context=context))
        made = maker.spoken(wish, reading, reading.instructions[0])
        if len(made) != 1:
            raise InstructionError(f"a skill must happen once, got {len(made)} times", text, (0, len(text)))
        return made[0].skill

    def interpret(self, request: Request) -> Interpretation:
        """Turn all wishes of a request into fuzzy skills on one timeline, with what binds them.

        What cannot be understood becomes a problem, and the rest goes on.

        Raises
        ------
        FuzzytimeError
            If a wish refers to an identifier that there is none of, or the context is not as declared.
        """
        admitted = request.context.admitted(self.rulebook.signals)
        request = request.named()
        maker = Maker(self.rulebook, request)
        links = Links(frozenset(wish.identifier for wish in request.wishes))
        rows = Rows(request.in_order)
        problems: list[Problem] = []
        skills: list[Interpreted] = []
        readings = iter(self._readings(request, problems))
        for wish in request.wishes:
            if isinstance(wish, DirectWish):
                skills.append(maker.direct(wish))
            elif isinstance(wish, SpokenWish):
                for instruction, reading in self._readable(next(readings), wish, admitted, problems):
                    if instruction.length_of is not None:
                        links.instructions.append(_lengthened(maker, skills, instruction, links))
                        continue
                    listed = rows.holds(reading)
                    step = without_now(instruction) if listed and rows.begun else instruction
                    made = _made(maker, wish, reading, step, problems)
                    if listed:
                        rows.add(step, made, len(skills))
                    links.instructions.append(range(len(skills), len(skills) + len(made)))
                    skills += made
        skills, precedences, unresolved = link(_identified(skills), links, self.rulebook)
        order = free_of_circles(rows.kept(), precedences)
        following = {entry.second for entry in order}
        skills = [replace(one, in_order=place in following) for place, one in enumerate(skills)]
        horizon = horizon_of(skills, request)
        skills = [within_horizon(interpreted, horizon, request) for interpreted in skills]
        for interpreted in skills:
            problems += notes_of(interpreted)
        return Interpretation(
            skills=tuple(skills),
            precedences=precedences,
            order=order,
            problems=(*problems, *unresolved),
            horizon=horizon,
        )

    def _readings(self, request: Request, problems: list[Problem]) -> list[Reading | None]:
        """Read all spoken wishes together, because they refer to each other; None where one is refused."""
        spoken = [wish for wish in request.wishes if isinstance(wish, SpokenWish)]
        good = [_is_read(wish, problems) for wish in spoken]
        kept = [(wish.text, wish.given) for wish, fine in zip(spoken, good, strict=True) if fine]
        readings = iter(self.language.read_all(kept))
        return [next(readings) if fine else None for fine in good]

    def _readable(
        self, reading: Reading | None, wish: SpokenWish, context: Context, problems: list[Problem]
    ) -> Sequence[tuple[Instruction, Reading]]:
        """Give a reading's instructions after noting its remarks."""
        if reading is None:
            return ()
        told = self._told_by_readings(reading, context)
        remarks = [
            remark
            for remark in remarks_of(reading, wish)
            if remark.kind is not ProblemKind.UNRESOLVED or remark.span not in told
        ]
        problems += remarks
        if not reading.instructions and not remarks:
            problems.append(problem_of(wish, ProblemKind.NOTHING_TO_DO, "says nothing to do"))
        return [(instruction, reading) for instruction in reading.instructions]

    def _told_by_readings(self, reading: Reading, context: Context) -> set[tuple[int, int]]:
        """Give the words that refer to no instruction but to what readings tell: "after the timer rings"."""
        return {
            requirement.span
            for instruction in reading.instructions
            for requirement in instruction.requirements
            if requirement.anchor is not None
            and requirement.anchor.target is None
            and self.rulebook.tells(requirement.anchor, context)
        }


def _lengthened(maker: Maker, skills: list[Interpreted], instruction: Instruction, links: Links) -> range:
    """Let skills go on for as long as an instruction tells ("it takes an hour"), and give their places.

    Who refers to these words means what they are about.
    """
    told, length = instruction.length_of, instruction.duration
    if told is None or told.target is None or length is None:
        return range(0)
    meant = links.skills_of(told.target)
    for place in meant:
        skills[place] = maker.lasting(skills[place], length)
    return meant


def _is_read(wish: SpokenWish, problems: list[Problem]) -> bool:
    """Say whether a wish's text is read at all; where it is not, say why."""
    try:
        check_length(wish.text)
    except InstructionError as error:
        refused = replace(wish, text=error.text)
        problems.append(problem_of(refused, ProblemKind.UNREADABLE, error.message, error.span))
        return False
    return True


def _made(
    maker: Maker, wish: SpokenWish, reading: Reading, instruction: Instruction, problems: list[Problem]
) -> list[Interpreted]:
    """Make an instruction's skills; where there is none to make, say why."""
    operation = instruction.operation
    if is_spoiled(instruction, reading, remarks_of(reading, wish)):
        return []
    if operation is None or operation.negated:
        what = "says a time but nothing to do" if operation is None else "asks for something not to be done"
        problems.append(problem_of(wish, ProblemKind.NOTHING_TO_DO, what, instruction.span))
        return []
    try:
        made = maker.spoken(wish, reading, instruction)
    except FuzzytimeError as error:
        problems.append(problem_of(wish, ProblemKind.UNREADABLE, str(error), instruction.span))
        return []
    if not made:
        problems.append(
            problem_of(wish, ProblemKind.NOTHING_TO_DO, "does not occur within the horizon", instruction.span)
        )
    return made


def _identified(skills: Sequence[Interpreted]) -> list[Interpreted]:
    """Give every skill an identifier of its own: its wish's, and further skills of one eggs.2, eggs.3."""
    taken = {interpreted.identifier for interpreted in skills}
    seen: Counter[str] = Counter()
    identified = []
    for interpreted in skills:
        name = interpreted.identifier
        seen[name] += 1
        if seen[name] > 1:
            name = f"{name}.{seen[name]}"
            while name in taken:
                name += "'"
            taken.add(name)
        identified.append(replace(interpreted, identifier=name))
    return identified
