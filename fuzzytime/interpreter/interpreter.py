"""The meeting of language and rulebook: from wishes to fuzzy skills, with everything an explanation needs."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from datetime import datetime

from fuzzytime.context import Context
from fuzzytime.errors import InstructionError
from fuzzytime.interpreter.asked import by_agents
from fuzzytime.interpreter.binding.circles import free_of_circles
from fuzzytime.interpreter.binding.delays import is_of_what_is_made
from fuzzytime.interpreter.binding.doers import asking_doers
from fuzzytime.interpreter.binding.giving_way import giving_way
from fuzzytime.interpreter.binding.in_order import Rows, of_places
from fuzzytime.interpreter.binding.leaning import lean_on_each_other
from fuzzytime.interpreter.binding.led_to import shortly_before
from fuzzytime.interpreter.binding.opened import of_opened
from fuzzytime.interpreter.binding.prepared import of_prepared
from fuzzytime.interpreter.binding.references import Links, link
from fuzzytime.interpreter.binding.same_things import of_things
from fuzzytime.interpreter.binding.timetables import of_timetables
from fuzzytime.interpreter.gathering import Gathering
from fuzzytime.interpreter.horizon import horizon_of, within_horizon
from fuzzytime.interpreter.in_other_words.by_the_sky import told_by_the_sky
from fuzzytime.interpreter.in_other_words.in_full import in_full
from fuzzytime.interpreter.in_other_words.retold import behind_ends
from fuzzytime.interpreter.interpretation import Interpretation, Problem, ProblemKind
from fuzzytime.interpreter.making import Maker
from fuzzytime.interpreter.remarks import notes_of, problem_of, remarks_of
from fuzzytime.interpreter.request import DirectWish, Request, SpokenWish
from fuzzytime.interpreter.told_anew import as_they_happened
from fuzzytime.interpreter.turns.passing import in_passing
from fuzzytime.interpreter.turns.turns_in_bounds import turns_out_of_bounds, without
from fuzzytime.language import Language, Reading, check_length, with_words
from fuzzytime.language.instruction import Span, overlap
from fuzzytime.requirement import TimeRequirement
from fuzzytime.rulebook import Rulebook
from fuzzytime.rulebook.tables.documents import shipped_tables
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
        return cls.joining(Language.shipped(), Rulebook.shipped())

    @classmethod
    def joining(cls, language: Language, rulebook: Rulebook) -> "Interpreter":
        """Give the interpreter of a language and tables, whose own words of time it understands as well."""
        tables, shipped = rulebook.tables, shipped_tables(rulebook.profile)
        hedges = [name for name in tables.time_hedges if name not in shipped.time_hedges]
        prepositions = {
            name: None if row.own is not None else tables.models[row.model].constraint
            for name, row in tables.prepositions.items()
            if name not in shipped.prepositions
        }
        clauses = {name: row.model for name, row in tables.clauses.items() if name not in shipped.clauses}
        words = [name for name in tables.words if name not in shipped.words]
        return cls(with_words(language, words, hedges, prepositions, clauses), rulebook)

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
        request = Request(now=given, wishes=(wish,), context=context)
        maker = Maker(self.rulebook, self.language.lexicon, request)
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
        request = in_full(request.named(), self.language)
        names = frozenset(wish.identifier for wish in request.wishes)
        maker = Maker(self.rulebook, self.language.lexicon, request)
        problems: list[Problem] = []
        readings = self._readings(request, problems)
        asking = [one and asking_doers(one, self.language.lexicon) for one in readings]
        rows = Rows(request.in_order or self._are_steps(request, asking))
        readings = [
            step if rows.in_order or (one and one.step is not None) else one
            for one, step in zip(readings, asking, strict=True)
        ]
        gathered = Gathering(maker, Links(names), rows, problems=problems)
        for wish, reading in zip(request.wishes, readings, strict=True):
            if isinstance(wish, DirectWish):
                gathered.direct(wish)
            elif isinstance(wish, SpokenWish) and reading is not None:
                told = gathered.news(wish, reading)
                reading_left = _without_remarks(reading, told)
                if reading_left.instructions or not told:
                    listed = rows.in_order or reading.step is not None
                    self._remark(reading_left, wish, admitted, problems, listed=listed)
                gathered.spoken(wish, reading_left, told)
        gathered.finish()
        skills, called = by_agents(as_they_happened(gathered.skills, request.started), request)
        skills = giving_way(skills, self.language.lexicon, request.agents)
        skills, passing = in_passing(skills, self.rulebook, request.agents, gathered.links)
        problems += (*called, *passing)
        skills, precedences, unresolved = link(
            skills, gathered.links, self.rulebook, request.now, request.agents
        )
        prepared = tuple(of_prepared(skills, self.language.lexicon))
        opened = of_opened(skills, self.language.lexicon)
        kept = (*gathered.rows.kept(), *of_places(skills), *prepared, *opened)
        order = (*kept, *of_things(skills, self.language.lexicon), *of_timetables(skills, prepared))
        order = free_of_circles(order, precedences)
        skills = shortly_before(skills, gathered.rows.ends, (*precedences, *order), self.language.lexicon)
        out = turns_out_of_bounds(skills, precedences)
        dropped = {skills[place].identifier for place in out}
        problems += (one for one in unresolved if one.identifier not in dropped)
        skills, (precedences, order) = without(out, skills, (precedences, order))
        skills = behind_ends(skills, (*precedences, *order))
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
            problems=tuple(problems),
            horizon=horizon,
        )

    def _readings(self, request: Request, problems: list[Problem]) -> list[Reading | None]:
        """Read all spoken wishes together, as they refer to each other; None where one is not read."""
        read = {
            place: (wish.text, wish.given)
            for place, wish in enumerate(request.wishes)
            if isinstance(wish, SpokenWish) and _is_read(wish, problems)
        }
        readings = dict(zip(read, self.language.read_all(list(read.values())), strict=True))
        return [readings.get(place) for place in range(len(request.wishes))]

    def _are_steps(self, request: Request, readings: Sequence[Reading | None]) -> bool:
        """Whether the lines of a file, and nothing beside them, lean on each other."""
        listed = all(wish.line is not None for wish in request.wishes)
        read = [reading for reading in readings if reading is not None]
        return listed and lean_on_each_other(read, self.language.lexicon)

    def _remark(
        self,
        reading: Reading,
        wish: SpokenWish,
        context: Context,
        problems: list[Problem],
        *,
        listed: bool,
    ) -> None:
        """Note a reading's remarks, and that it says nothing to do where it does not.

        In a ``listed`` step, what no step names is what is made.
        """
        told = self._told_by_readings(reading, context)
        if listed:
            times = (part for one in reading.instructions for part in one.requirements)
            told |= {part.span for part in times if is_of_what_is_made(part, self.language.lexicon)}
        remarks = [
            remark
            for remark in remarks_of(reading, wish)
            if remark.kind is not ProblemKind.UNRESOLVED or remark.span not in told
        ]
        problems += remarks
        if not reading.instructions and not remarks:
            problems.append(problem_of(wish, ProblemKind.NOTHING_TO_DO, "says nothing to do"))

    def _by_the_sky(self, requirement: TimeRequirement, reading: Reading) -> bool:
        """Whether the calendar tells when words are so: "before it gets dark"."""
        given = reading.now
        return (
            given is not None and told_by_the_sky(requirement, (), given, self.language.lexicon) is not None
        )

    def _told_by_readings(self, reading: Reading, context: Context) -> set[tuple[int, int]]:
        """Give the words that refer to no instruction but to what readings tell: "after the timer rings"."""
        return {
            requirement.span
            for instruction in reading.instructions
            for requirement in instruction.requirements
            if requirement.anchor is not None
            and requirement.anchor.target is None
            and (self.rulebook.tells(requirement.anchor, context) or self._by_the_sky(requirement, reading))
        }


def _is_read(wish: SpokenWish, problems: list[Problem]) -> bool:
    """Say whether a wish's text is read at all; where it is not, say why."""
    try:
        check_length(wish.text)
    except InstructionError as error:
        refused = replace(wish, text=error.text)
        problems.append(problem_of(refused, ProblemKind.UNREADABLE, error.message, error.span))
        return False
    return True


def _without_remarks(reading: Reading, told: Iterable[Span]) -> Reading:
    """Give a reading without what it remarks on words that are understood otherwise."""
    kept = [one for one in reading.remarks if not any(overlap(one.span, span) for span in told)]
    return replace(reading, remarks=tuple(kept))
