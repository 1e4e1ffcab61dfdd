"""The meeting of language and rulebook: from wishes to fuzzy skills, with everything an explanation needs."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from datetime import datetime

from fuzzytime.context import Context
from fuzzytime.errors import FuzzytimeError, InstructionError
from fuzzytime.interpreter.horizon import horizon_of, within_horizon
from fuzzytime.interpreter.interpretation import Interpretation, Interpreted, Problem, ProblemKind
from fuzzytime.interpreter.references import Links, link
from fuzzytime.interpreter.request import DirectWish, Request, SpokenWish, Wish
from fuzzytime.language import Instruction, Language, Reading, RemarkKind
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.rulebook import OperationDuration, Resolution, Rulebook
from fuzzytime.satisfaction import SatisfactionFunction, product
from fuzzytime.skills import FuzzySkill
from fuzzytime.times import seconds_between

MAX_OCCURRENCES = 100
"""How many occurrences of one repetition are planned; more would fill any day."""

_FAULTS = {RemarkKind.NOT_UNDERSTOOD, RemarkKind.UNRESOLVED}


@dataclass(frozen=True, slots=True)
class Interpreter:
    """Language and rulebook together.

    >>> from fuzzytime.context import Context
    >>> interpreter = Interpreter.shipped()
    >>> skill = interpreter.skill("Place the steak in about ten minutes!", duration=240.0)
    >>> skill.name, skill.satisfaction.best.low <= 600 <= skill.satisfaction.best.high
    ('place the steak', True)
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
        """Turn one instruction into one fuzzy skill.

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
            If it holds no instruction or several, or words about time that are not understood.
        """
        wish = SpokenWish(text=text, given=now or datetime.min, hands_on=duration, elapsed=duration)
        reading = self.language.read(text, now=now)
        for problem in _remarked(reading, wish):
            raise InstructionError(problem.message, text, problem.span or (0, len(text)))
        if len(reading.instructions) != 1:
            raise InstructionError(
                f"a skill must be one instruction, got {len(reading.instructions)}", text, (0, len(text))
            )
        instruction = reading.instructions[0]
        made = self._skills(wish, reading, instruction, Request(now=wish.given, wishes=(wish,), context=context))
        if len(made) != 1:
            raise InstructionError(f"a skill must happen once, got {len(made)} occurrences", text, instruction.span)
        return made[0].skill

    def interpret(self, request: Request) -> Interpretation:
        """Turn all wishes of a request into fuzzy skills on one timeline, with what binds them.

        What cannot be understood becomes a problem, and the rest goes on.

        Raises
        ------
        FuzzytimeError
            If a wish names an identifier that there is none of, or identifiers repeat.
        """
        links = Links()
        skills: list[Interpreted] = []
        problems: list[Problem] = []
        readings = iter(self._readings(request, problems))
        for wish in request.wishes:
            made: list[Interpreted] = []
            if isinstance(wish, DirectWish):
                made = [_direct(wish, request)]
            elif isinstance(wish, SpokenWish) and (reading := next(readings)) is not None:
                faults = _remarked(reading, wish)
                problems += faults + _noted(reading, wish)
                for instruction in reading.instructions:
                    parts: list[Interpreted] = []
                    if not _spoiled(instruction, reading, faults):
                        parts = self._instruction(wish, reading, instruction, request, problems)
                    links.add_instruction(range(len(skills) + len(made), len(skills) + len(made) + len(parts)))
                    made += parts
            skills += made
            links.add_wish(wish, range(len(skills) - len(made), len(skills)))
        skills = _identified(skills)
        skills, precedences = link(skills, links, request, self.rulebook, problems)
        horizon = horizon_of(skills, request)
        skills = [within_horizon(skill, horizon, explicit=request.horizon is not None) for skill in skills]
        problems += [_note(skill, note) for skill in skills for part in skill.resolutions for note in part.notes]
        return Interpretation(
            skills=tuple(skills), precedences=precedences, problems=tuple(problems), horizon=horizon
        )

    # -- reading --------------------------------------------------------------------------------------------

    def _readings(self, request: Request, problems: list[Problem]) -> list[Reading | None]:
        """Read all spoken wishes together; where one is refused, one by one."""
        spoken = [wish for wish in request.wishes if isinstance(wish, SpokenWish)]
        try:
            return list(self.language.read_all([(wish.text, wish.given) for wish in spoken]))
        except InstructionError:
            return self._readings_one_by_one(spoken, problems)

    def _readings_one_by_one(
        self, spoken: Sequence[SpokenWish], problems: list[Problem]
    ) -> list[Reading | None]:
        readable: list[Reading | None] = []
        good: list[SpokenWish] = []
        for wish in spoken:
            try:
                self.language.read(wish.text, now=wish.given)
                good.append(wish)
            except InstructionError as error:
                problems.append(_problem(wish, ProblemKind.UNREADABLE, error.message, error.span))
        # References cross texts, so that the good ones are read together once more.
        together = iter(self.language.read_all([(wish.text, wish.given) for wish in good]))
        for wish in spoken:
            readable.append(next(together) if wish in good else None)
        return readable

    # -- one instruction ------------------------------------------------------------------------------------

    def _instruction(
        self, wish: SpokenWish, reading: Reading, instruction: Instruction, request: Request, problems: list[Problem]
    ) -> list[Interpreted]:
        operation = instruction.operation
        if operation is None:
            words = reading.text[slice(*instruction.span)]
            message = f"says no operation to do: {words!r}" if words.strip() else "says no operation to do"
            problems.append(_problem(wish, ProblemKind.NOTHING_TO_DO, message, instruction.span))
            return []
        if operation.negated:
            message = "asks for something not to be done, which needs no time in a plan"
            problems.append(_problem(wish, ProblemKind.NOTHING_TO_DO, message, operation.span))
            return []
        try:
            return self._skills(wish, reading, instruction, request)
        except FuzzytimeError as error:
            problems.append(_problem(wish, ProblemKind.UNREADABLE, str(error), instruction.span))
            return []

    def _skills(
        self, wish: SpokenWish, reading: Reading, instruction: Instruction, request: Request
    ) -> list[Interpreted]:
        """Make the instruction's skill, or one for each occurrence of a repetition."""
        given = seconds_between(request.now, wish.given)
        said = tuple(r for r in instruction.requirements if r.constraint is not Constraint.FOR)
        repeated = [r for r in said if r.constraint is Constraint.EVERY]
        once = tuple(r for r in said if r.constraint is not Constraint.EVERY)
        if not repeated or repeated[0].recurrence is None:
            return [self._skill(wish, reading, instruction, once, given, request)]
        until = (request.horizon or HORIZON_OF_REPETITIONS) - given
        times = repeated[0].recurrence.occurrences(until)[:MAX_OCCURRENCES]
        return [
            self._skill(wish, reading, instruction, (_occurrence(repeated[0], time), *once), given, request)
            for time in times
        ]

    def _skill(
        self,
        wish: SpokenWish,
        reading: Reading,
        instruction: Instruction,
        requirements: tuple[TimeRequirement, ...],
        given: float,
        request: Request,
    ) -> Interpreted:
        operation = instruction.operation
        duration = self._duration(wish, instruction)
        unbound = tuple(r for r in requirements if r.anchor is None or r.anchor.target is None)
        resolutions = tuple(
            self.rulebook.resolve(
                requirement,
                request.context,
                verb=operation.lemma if operation is not None else None,
                duration=duration.hands_on,
                elapsed=duration.elapsed,
            )
            for requirement in unbound
        )
        satisfaction = self.rulebook.untimed().satisfaction
        reason = next((r.reason for r in resolutions if r.reason), "")
        for index, (requirement, resolution) in enumerate(zip(unbound, resolutions, strict=True)):
            # A condition and an event count from the readings' now; everything else from when it was said.
            by = 0.0 if requirement.condition is not None or requirement.anchor is not None else given
            part = resolution.satisfaction.shifted(by)
            satisfaction = part if index == 0 else _both(satisfaction, part)
        if not reason and satisfaction.support.empty:
            reason = "what is asked of its time contradicts itself" if len(resolutions) > 1 else "no start satisfies"
        skill = FuzzySkill(
            name=operation.name if operation is not None else wish.text,
            satisfaction=satisfaction,
            duration=duration.hands_on,
            fuzzy_parameters=instruction.fuzzy_parameters,
            parameters=_parameters(instruction),
            elapsed=duration.elapsed,
            priority=wish.priority,
            agent=wish.agent,
        )
        return Interpreted(
            identifier=wish.identifier,
            wish=wish,
            skill=skill,
            duration=duration,
            reading=reading,
            instruction=instruction,
            requirements=requirements,
            resolutions=resolutions or (self.rulebook.untimed(),) * (not requirements),
            reason=reason,
        )

    def _duration(self, wish: Wish, instruction: Instruction) -> OperationDuration:
        """Take what is given, else what is said ("for eight minutes"), else the table's.

        What is said is how long it goes on. The table knows whether that needs hands: eggs that boil for
        eight minutes leave the cook free.
        """
        operation = instruction.operation
        table = self.rulebook.duration_of(
            operation.lemma if operation is not None else None, operation.object if operation is not None else None
        )
        if wish.hands_on is not None or wish.elapsed is not None:
            hands_on = wish.hands_on if wish.hands_on is not None else min(table.hands_on, wish.elapsed or 0.0)
            elapsed = wish.elapsed if wish.elapsed is not None else max(table.elapsed, hands_on)
            return OperationDuration(hands_on=hands_on, elapsed=elapsed, source="given", assumed=False)
        if instruction.duration is not None:
            unattended = table.known and table.elapsed > table.hands_on
            hands_on = min(table.hands_on, instruction.duration) if unattended else instruction.duration
            return OperationDuration(
                hands_on=hands_on, elapsed=instruction.duration, source="said", assumed=False
            )
        return table
