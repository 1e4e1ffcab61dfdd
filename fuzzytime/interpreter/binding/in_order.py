"""Steps in the order said: a recipe, a script, a numbered list.

A step follows the one before it once that is done, unless its words say another order ("meanwhile",
"before that", "every ten minutes"). Where two have different times of their own, these say their order. The
order of a list is looser than one in words: it gives way where it would keep a step from its own time, and
what follows a step that cannot be done goes on without it.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

from fuzzytime.interpreter.binding.procedures import procedures
from fuzzytime.interpreter.binding.steps import Row, Step, is_anchored, is_asked
from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import (
    Instruction,
    Lexicon,
    Order,
    Reading,
    comes,
    content_words,
    shares_thing,
    undoes,
)
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.skills import Precedence

NOW = "now"
AT_ONCE = frozenset({"immediately", "right now"})
ON_THE_WAY = "on the way"


@dataclass(slots=True)
class Rows:
    """The lists of a request: all of it where its order holds, else each numbered list.

    ``arrived`` gives for each word the latest that comes which it names, ``latest`` for each thing the latest
    that is to be done with it; ``asked`` is what was asked for last of all, ``journey`` who leaves last,
    ``ends`` what lists lead to.
    """

    in_order: bool
    row: Row = field(default_factory=Row)
    number: int | None = None
    precedences: list[Precedence] = field(default_factory=list)
    ends: list[int] = field(default_factory=list)
    arrived: dict[str, int] = field(default_factory=dict)
    latest: dict[str, int] = field(default_factory=dict)
    asked: Step | None = None
    journey: int | None = None

    def holds(self, reading: Reading) -> bool:
        """Whether what a text says stands in a row; a list that counts from the beginning is a new one."""
        step = reading.step
        if step is not None and not self.in_order and self.number is not None and step <= self.number:
            self._close()
        self.number = step if step is not None else self.number
        return self.in_order or step is not None

    @property
    def begun(self) -> bool:
        """Whether there is a step to follow."""
        return bool(self.row.last)

    def add(self, skills: Sequence[Interpreted], places: range, instruction: int) -> None:
        """Add what an instruction, by its place, asks for; what happens, or again and again, is no step.

        Of what is done so many times behind another, the last is: "fold it three times, half an hour apart".
        """
        if not places:
            return
        step = Step(places[-1], skills[places[-1]], instruction)
        if is_asked(step.interpreted) or step.last_of_turns:
            self.row.add(step)
        elif step.interpreted.stated:
            self.row.lead_to(step)

    def follow(self, first: int, second: int, skills: Sequence[Interpreted]) -> None:
        """Let what is done again follow what was asked for last."""
        self.precedences.append(Step(first, skills[first]).precedence(Step(second, skills[second])))

    def join(
        self,
        reading: Reading,
        made: Sequence[tuple[Instruction, range]],
        skills: Sequence[Interpreted],
        lexicon: Lexicon,
    ) -> None:
        """Let what one sentence joins by "and" follow, where it goes on with the same thing, or with none.

        Behind a comma alone, only what leaves its thing unsaid follows: "boil the rice, drain, serve". Three
        steps or more are a procedure: "take off at ten, circle the field, land".
        """
        for steps in procedures(reading, made, skills, lexicon):
            row = Row()
            for step in steps:
                if _waits(step, lexicon):
                    # Who waits follows as ``_pause`` says.
                    self.precedences += row.precedences
                    row = Row()
                else:
                    row.add(step)
            self.precedences += row.precedences
        for (first, before), (second, after) in pairwise(made):
            between = reading.text[first.span[1] : second.span[0]].strip()
            joined = between.strip(" ,").lower() == "and" and _goes_on_with(first, second)
            joined = joined or (between == "," and _leaves_out(first, second, lexicon))
            if joined and len(before) == len(after) == 1:
                one, other = (Step(place, skills[place]) for place in (before[0], after[0]))
                if other.ordered and not other.timed:
                    self.precedences.append(one.precedence(other))
        for last in range(len(made)):
            self._enclose(made[: last + 1], skills, lexicon)
        for _, places in made:
            self._await_arrival(places, skills, lexicon)
            self._resume(places, skills, lexicon)
            self._pause(places, skills, lexicon)

    def _enclose(
        self, made: Sequence[tuple[Instruction, range]], skills: Sequence[Interpreted], lexicon: Lexicon
    ) -> None:
        """Let be between what is said before the last undoes an earlier: "open it, let her in, shut it"."""
        *before, (closing, _) = made
        opened = next(
            (p for p in reversed(range(len(before))) if _shuts(closing, before[p][0], lexicon)), None
        )
        if opened is None or any(len(places) != 1 for _, places in made[opened:]):
            return
        first, *inside, last = (Step(places[0], skills[places[0]]) for _, places in made[opened:])
        if last.ordered and not (first.at_moment and last.at_moment):
            # "Open the vents at nine, shut them by five"
            self.precedences.append(first.precedence_until_due(last))
        for step in inside:
            if is_asked(step.interpreted) and step.ordered:
                pairs = ((first, step), (step, last))
                # Of two with times of their own, the times say which comes first.
                self.precedences += [a.precedence(b) for a, b in pairs if not (a.timed and b.timed)]

    def _resume(self, made: Sequence[int], skills: Sequence[Interpreted], lexicon: Lexicon) -> None:
        """Let what is done with "it" follow what was asked for of the same thing before.

        What was loaded is unloaded where the way behind it leads.
        """
        operation = skills[made[0]].operation if made else None
        if operation is None or operation.stated:
            return
        if operation.lemma in lexicon.doing.leaving and operation.is_asked:
            self.journey = made[0]
        if operation.object is None:
            return
        before = self._latest_about(operation.object)
        if operation.again and before is not None and len(made) == 1:
            one, other = Step(before, skills[before]), Step(made[0], skills[made[0]])
            if not other.timed and all(map(_may_follow, other.interpreted.requirements)):
                there = self._arrival_of(one, other, lexicon, skills)
                self.precedences.append(one.precedence(other) if there is None else there.precedence(other))
        if not any(skills[place].repeats for place in made):
            self.latest[operation.object] = made[-1]

    def _arrival_of(
        self, one: Step, other: Step, lexicon: Lexicon, skills: Sequence[Interpreted]
    ) -> Step | None:
        """Give the journey between loading and unloading something, if there is one."""
        loaded, undone = one.interpreted.operation, other.interpreted.operation
        if self.journey is None or self.journey < one.position or loaded is None or undone is None:
            return None
        carried = loaded.phrase in lexicon.doing.loading and undoes(undone, loaded, lexicon)
        return Step(self.journey, skills[self.journey]) if carried else None

    def _pause(self, made: Sequence[int], skills: Sequence[Interpreted], lexicon: Lexicon) -> None:
        """Let who waits do so right behind what was asked for before, and what comes next follow on that."""
        steps = [Step(place, skills[place]) for place in made if is_asked(skills[place])]
        if len(steps) != 1:
            return
        (step,), before = steps, self.asked
        self.asked = step
        waits = before is not None and (_waits(step, lexicon) or _waits(before, lexicon))
        if before is not None and waits and step.ordered and not step.timed:
            # "Heat the plate, wait three minutes": who waits does so while it heats.
            skill = before.interpreted.skill
            lag = skill.duration - skill.time_until_done
            self.precedences.append(Precedence(before.position, step.position, lag, wished_lag=lag))

    def _latest_about(self, thing: str) -> int | None:
        """Give the latest that was asked for of a thing, or of who is given it: "Leo", of "Leo a bath"."""
        words = thing.split()
        known = (" ".join(words[:end]) for end in range(len(words), 0, -1))
        return next((self.latest[name] for name in known if name in self.latest), None)

    def _await_arrival(self, made: Sequence[int], skills: Sequence[Interpreted], lexicon: Lexicon) -> None:
        """Let what can be done only with what comes wait for that, unless it has a time of its own."""
        if len(made) != 1:
            return
        step = Step(made[0], skills[made[0]])
        operation = step.interpreted.operation
        if operation is None:
            return
        if comes(operation, lexicon):
            self.arrived.update(dict.fromkeys(content_words(operation.object), made[0]))
            return
        if step.timed or any(part.anchor is not None for part in step.interpreted.requirements):
            return
        words = content_words(operation.object) | content_words(operation.place)
        latest = max((self.arrived[word] for word in words & self.arrived.keys()), default=None)
        if latest is not None and not operation.stated:
            self.precedences.append(Precedence(latest, made[0]))

    def kept(self) -> tuple[Precedence, ...]:
        """Give the order of all lists."""
        self._close()
        return tuple(self.precedences)

    def _close(self) -> None:
        self.row.close()
        self.precedences += self.row.precedences
        self.ends += [] if self.row.end is None else [self.row.end.position]
        self.row = Row()


def of_places(skills: Sequence[Interpreted]) -> Iterator[Precedence]:
    """Give the order that words ask for among all: "do the windows first", "make the coffee last".

    Where two have times of their own, these say their order, unless they are the same.
    """
    steps = [Step(place, one) for place, one in enumerate(skills) if is_asked(one)]
    for step in steps:
        order = _order_of(step)
        for other in steps if order is not None else ():
            apart = step.is_apart(other)
            if other.position != step.position and not apart and _order_of(other) is not order:
                first, second = (step, other) if order is Order.FIRST else (other, step)
                yield first.precedence(second)


def _order_of(step: Step) -> Order | None:
    return None if step.interpreted.operation is None else step.interpreted.operation.order


def _waits(step: Step, lexicon: Lexicon) -> bool:
    """Whether a step is to wait, and for nothing but time: "wait three minutes"."""
    operation = step.interpreted.operation
    waits = operation is not None and operation.lemma in lexicon.doing.waiting and operation.object is None
    return waits and not any(part.condition or part.anchor for part in step.interpreted.requirements)


def without_now(instruction: Instruction) -> Instruction:
    """Give a step without "now" at its begin, and "immediately": in a row they say no more than "then"."""
    kept = tuple(part for part in instruction.requirements if not _says_now(part, instruction))
    return replace(instruction, requirements=kept)


def _says_now(part: TimeRequirement, instruction: Instruction) -> bool:
    first = part.word == NOW and part.span[0] == instruction.span[0]
    return part.preposition is None and (first or part.word in AT_ONCE)


def _goes_on_with(first: Instruction, second: Instruction) -> bool:
    one, other = first.operation, second.operation
    if one is None or other is None or one.stated or other.stated:
        return False
    # "…, and pick up a pizza on the way back"
    onward = (other.place or "").startswith(ON_THE_WAY)
    return onward or other.object is None or shares_thing(one, other)


def _leaves_out(first: Instruction, second: Instruction, lexicon: Lexicon) -> bool:
    """Whether what is to be done has no thing of its own, and needs one: it is that of the one before.

    Of two that are each said to last, the second comes behind as well: "knead ten minutes, rest an hour".
    """
    one, other = first.operation, second.operation
    if one is None or other is None or one.stated or other.stated:
        return False
    if first.duration is not None and second.duration is not None and other.object is None:
        return True
    if one.object is None:
        return False
    return other.object is None and other.place is None and other.lemma not in lexicon.needing_nothing


def _shuts(closing: Instruction, opening: Instruction, lexicon: Lexicon) -> bool:
    """Whether an instruction undoes another with the same thing, which it calls "it"."""
    one, other = opening.operation, closing.operation
    if one is None or other is None or not other.again or one.object != other.object:
        return False
    return undoes(other, one, lexicon)


def _may_follow(part: TimeRequirement) -> bool:
    """Whether words leave open what something comes after: they name no other, or one that comes later."""
    later = part.anchor is not None and part.constraint is Constraint.BEFORE and not part.anchor.exact
    return later or not is_anchored(part)
