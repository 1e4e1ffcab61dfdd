"""From one instruction, read, to the fuzzy skills it asks for."""

from dataclasses import dataclass, replace
from datetime import datetime
from itertools import islice

from fuzzytime.interpreter.bounding import due_then, from_there_on, is_due_on_day, within_its_ends
from fuzzytime.interpreter.how_long import HowLong
from fuzzytime.interpreter.in_other_words.at_its_hours import at_its_hours, turn_at_its_hours
from fuzzytime.interpreter.in_other_words.lasting import with_lasting
from fuzzytime.interpreter.in_other_words.retold import (
    amid_its_hours,
    from_to,
    going_to,
    occurrence,
    until_then,
    waiting_until,
)
from fuzzytime.interpreter.in_other_words.waits import with_waits, without_readings
from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.interpreter.joining import both
from fuzzytime.interpreter.offered import Offered
from fuzzytime.interpreter.request import WITHOUT_END, DirectWish, Request, SpokenWish, Wish
from fuzzytime.interpreter.turns.behind import Behind
from fuzzytime.interpreter.turns.each_turn import EachTurn
from fuzzytime.interpreter.turns.inside import GoingOn
from fuzzytime.interpreter.turns.of_each import OfEach
from fuzzytime.interpreter.turns.planned import planned_until, planned_windows
from fuzzytime.language import Instruction, Lexicon, Operation, Reading
from fuzzytime.requirement import Constraint, Recurrence, Reference, TimeRequirement
from fuzzytime.rulebook import OperationDuration, Resolution, Rulebook
from fuzzytime.satisfaction import SatisfactionFunction
from fuzzytime.scheduling import THRESHOLD
from fuzzytime.skills import FuzzySkill
from fuzzytime.times import seconds_between

MAX_OCCURRENCES = 100
"""How many occurrences of one repetition are planned at most."""

AT_ONCE = 1.0
"""Seconds that two starts may be apart, and still are the same."""

LEFT_OUT = 20
"""Among how many coming occurrences one is looked for that is not left out."""


@dataclass(frozen=True, slots=True)
class Maker:
    """Makes skills of instructions by a rulebook and the words it reads, on the timeline of a request."""

    rulebook: Rulebook
    lexicon: Lexicon
    request: Request

    @property
    def how_long(self) -> HowLong:
        """What tells how long things take."""
        return HowLong(self.rulebook, self.lexicon)

    def direct(self, wish: DirectWish) -> Interpreted:
        """Make the skill of a wish without words."""
        given = seconds_between(self.request.now, wish.given)
        duration = self.how_long.given(wish, None)
        function = wish.satisfaction.shifted(given) if given else wish.satisfaction
        function, named = self._moved(wish, function, ())
        skill = self._skill(wish, wish.name, function, duration).starting_near(*named)
        reason = "its satisfaction is 0 at every time" if function.support.empty else ""
        return Interpreted(
            identifier=wish.identifier, wish=wish, skill=skill, duration=duration, reason=reason
        )

    def spoken(
        self,
        wish: SpokenWish,
        reading: Reading,
        instruction: Instruction,
        inside: GoingOn | Behind | EachTurn | None = None,
        beside: OfEach | None = None,
    ) -> list[Interpreted]:
        """Make an instruction's skill, or one for each occurrence of a repetition within the horizon.

        Where it is repeated ``inside`` something that goes on, or behind something, each counts from that,
        or from its turn of something else that is repeated. Where it is done once ``beside`` each of several,
        each counts from one of these.

        Raises
        ------
        FuzzytimeError
            If a context reading is of no declared signal, or a duration impossible.
        """
        instruction = at_its_hours(instruction, wish.given, self.lexicon)
        instruction = waiting_until(from_to(instruction, reading, wish.given, self.lexicon), self.lexicon)
        told = (p for p in instruction.requirements if p.constraint is not Constraint.FOR)
        known = without_readings(list(told), wish.given, self.request, self.lexicon)
        said = [with_waits(part, self.rulebook, self.request) for part in known]
        once = tuple(part for part in said if part.constraint is not Constraint.EVERY)
        if beside is not None:
            rest = tuple(part for part in said if part.anchor != beside.said.anchor)
            return [
                self._interpreted(wish, reading, instruction, (*time, *rest))
                for time in islice(beside.times(), MAX_OCCURRENCES)
            ]
        repeated = next((part for part in said if part.recurrence is not None), None)
        if repeated is None or repeated.recurrence is None:
            return [self._interpreted(wish, reading, instruction, once)]
        recurrence = repeated.recurrence.spaced(self.how_long.of(wish, instruction).hands_on)
        if isinstance(inside, EachTurn) or (inside is not None and recurrence.interval is not None):
            rest = tuple(part for part in once if part.anchor is None or part.anchor.target != inside.target)
            times = inside.times(repeated, recurrence, planned_until(self.request, wish, recurrence))
            return [
                self._interpreted(wish, reading, instruction, (*time, *rest))
                for time in islice(times, MAX_OCCURRENCES)
            ]
        return self._occurrences(wish, reading, instruction, repeated, recurrence, once)

    def _occurrences(
        self,
        wish: SpokenWish,
        reading: Reading,
        instruction: Instruction,
        repeated: TimeRequirement,
        recurrence: Recurrence,
        once: tuple[TimeRequirement, ...],
    ) -> list[Interpreted]:
        """Make a skill for each occurrence of a repetition; those that nothing satisfies are left out."""
        operation = instruction.operation
        # "I have a class every day from nine to ten"
        whole = operation is not None and operation.stated and recurrence.spans

        def occurring(start: float, end: float) -> Interpreted:
            once_done = replace(instruction, duration=end - start) if whole else instruction
            time = occurrence(repeated, start, start if whole else end)
            time = turn_at_its_hours(time, operation, wish.given, self.lexicon)
            return self._interpreted(wish, reading, once_done, (time, *once))

        windows = planned_windows(self.request, wish, recurrence, self.lexicon.policy)
        made = [occurring(start, end) for start, end in windows[:MAX_OCCURRENCES]]
        made = [one for one in made if self._is_near(one)] or made[:1]
        # "Every hour but not at noon" leaves noon out; what none can satisfy is one loss, not a hundred.
        left = [one for one in made if not one.reason]
        if left or self.request.horizon is not None or not once:
            return left or made[:1]
        # "Every monday except this monday" has one behind it.
        further = (occurring(start, end) for start, end in recurrence.coming(LEFT_OUT))
        return [one for one in further if not one.reason][:1] or made[:1]

    def _is_near(self, made: Interpreted) -> bool:
        """Whether an occurrence may begin within the horizon, where one is given."""
        window = made.skill.satisfaction.acceptable(THRESHOLD)
        return self.request.horizon is None or not window.low > self.request.horizon

    def _interpreted(
        self,
        wish: SpokenWish,
        reading: Reading,
        instruction: Instruction,
        requirements: tuple[TimeRequirement, ...],
        duration: OperationDuration | None = None,
    ) -> Interpreted:
        """Make a skill with these times, and with the length that the instruction says, or the one given."""
        operation = instruction.operation
        duration = duration or self.how_long.of(wish, instruction)
        given = seconds_between(self.request.now, wish.given)
        own = [part for part in requirements if part.anchor is None or part.anchor.target is None]
        resolutions = [
            within_its_ends(self._resolved(part, operation, duration), part, duration, -given) for part in own
        ]
        offered = Offered.of(own, resolutions, given)
        usual = offered.named or amid_its_hours(operation, requirements, given)
        function, named = self._moved(wish, offered.satisfaction, usual)
        reason, waits = offered.why_never()
        if not reason and function.support.empty:
            reason = "what is said about its time contradicts itself"
        skill = self._skill(wish, operation.name if operation is not None else wish.text, function, duration)
        ends = until_then(instruction, self.lexicon)
        if ends is not None:
            # How long it takes otherwise, by a table, says nothing then.
            skill = replace(skill, until=ends + given, elapsed=skill.duration)
        return Interpreted(
            identifier=wish.identifier,
            wish=wish,
            skill=replace(
                skill,
                fuzzy_parameters=instruction.fuzzy_parameters,
                parameters=_parameters(operation),
                by_the_clock=bool(requirements) and not any(map(_is_told, requirements)),
            ).starting_near(*named),
            duration=duration,
            reading=reading,
            instruction=instruction,
            requirements=requirements,
            resolutions=tuple(resolutions) if requirements else (self.rulebook.untimed(),),
            reason=reason,
            waits=waits,
        )

    def _resolved(
        self, requirement: TimeRequirement, operation: Operation | None, duration: OperationDuration
    ) -> Resolution:
        resolution = self._looked_up(requirement, operation, duration)
        if not is_due_on_day(requirement, self.lexicon):
            return resolution
        deadline = replace(requirement, constraint=Constraint.BEFORE, earliest=None)
        return due_then(resolution, self._looked_up(deadline, operation, duration))

    def _looked_up(
        self, requirement: TimeRequirement, operation: Operation | None, duration: OperationDuration
    ) -> Resolution:
        return self.rulebook.resolve(
            with_lasting(requirement),
            self.request.context,
            verb=operation.going if operation is not None else None,
            duration=duration.hands_on,
            elapsed=duration.elapsed,
            horizon=self.request.horizon or WITHOUT_END,
        )

    def _moved(
        self, wish: Wish, function: SatisfactionFunction, named: tuple[float, ...]
    ) -> tuple[SatisfactionFunction, tuple[float, ...]]:
        """Move ψ and the starts that were named as the wish was moved."""
        if wish.moved is None:
            return function, named
        by = wish.moved.by
        function, named = function.shifted(by), tuple(time + by for time in named)
        if wish.moved.to is None:
            return function, named
        to = seconds_between(self.request.now, wish.moved.to)
        if any(abs(time - to) < AT_ONCE for time in named):
            # "In about ten minutes", ten minutes later, is as vague as before.
            return function, named
        return both(function, from_there_on(function, to, later=by >= 0)), (to,)

    def _skill(
        self, wish: Wish, name: str, function: SatisfactionFunction, duration: OperationDuration
    ) -> FuzzySkill:
        return FuzzySkill(
            name=name,
            satisfaction=function,
            duration=duration.hands_on,
            elapsed=duration.elapsed,
            priority=wish.priority,
            agent=wish.agent,
        )

    def way(
        self, wish: SpokenWish, reading: Reading, instruction: Instruction, to: Interpreted, target: int
    ) -> Interpreted:
        """Make the skill of going where something is done or happens, in time for that."""
        going = going_to(instruction, to.skill.name, target, attended=to.attended)
        return self._interpreted(wish, reading, going, going.requirements)

    def lengthened(self, made: Interpreted, length: float, *, alone: bool) -> Interpreted:
        """Give a skill with what was told afterwards of how long it goes on."""
        longer = self.how_long.lasting(made, length, alone=alone)
        wish, reading, instruction = made.wish, made.reading, made.instruction
        if not isinstance(wish, SpokenWish) or reading is None or instruction is None:
            return longer
        again = self._interpreted(wish, reading, instruction, made.requirements, longer.duration)
        function = again.skill.satisfaction
        return replace(longer, skill=replace(longer.skill, satisfaction=function))

    def timed(self, made: Interpreted, told: Instruction, given: datetime) -> Interpreted:
        """Give a skill with what was told afterwards of when it must be done, at another moment perhaps."""
        wish, reading, instruction = made.wish, made.reading, made.instruction
        if not isinstance(wish, SpokenWish) or reading is None or instruction is None:
            return made
        since = seconds_between(wish.given, given)
        begins = told.operation is not None and told.operation.phrase in self.lexicon.doing.starting
        named = Reference.START if begins else Reference.FINISH
        more = [
            replace(part.shifted(since), reference=named, reference_said=True) for part in told.requirements
        ]
        said = {part.text for part in more}
        before = (
            part
            for part in made.requirements
            if part.text not in said or part.constraint is not Constraint.BEFORE
        )
        again = self._interpreted(wish, reading, instruction, (*before, *more))
        skill = replace(again.skill, duration=made.skill.duration, elapsed=made.skill.elapsed)
        return replace(again, skill=skill, duration=made.duration)


def _is_told(requirement: TimeRequirement) -> bool:
    """Whether a requirement names a moment, or something that tells when: "after nine", "once it is dry"."""
    named = (requirement.t_spec, requirement.condition, requirement.anchor)
    return named != (None, None, None)


def _parameters(operation: Operation | None) -> dict[str, str]:
    if operation is None:
        return {}
    said = {
        "verb": operation.verb,
        "object": operation.object,
        "place": operation.place,
        "manner": operation.manner,
        "purpose": operation.purpose,
    }
    return {part: words for part, words in said.items() if words}
