"""Steps of a list, and what follows what among them."""

import math
from dataclasses import dataclass, field, replace

from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.language import content_words, shares_thing
from fuzzytime.requirement import Constraint, Edge, TimeRequirement
from fuzzytime.skills import Precedence

OWN_TIME = frozenset({Constraint.AT, Constraint.BETWEEN, Constraint.VAGUE})
"""What says when a step is, and not only when it is at the latest or at the earliest."""

SENTENCE_ENDS = frozenset(".;!?")


@dataclass(frozen=True, slots=True)
class Step:
    """A step: the position of its skill, what is known of it, and in a list the ``place`` of its words."""

    position: int
    interpreted: Interpreted
    place: int | None = None

    @property
    def timed(self) -> bool:
        """Whether it has a time of its own, and not only that of a line above."""
        return any(_is_own(part) and part.span[0] < part.span[1] for part in self.interpreted.requirements)

    @property
    def at_moment(self) -> bool:
        """Whether it is at a moment of its own, and not only by one, or in a stretch."""
        own = (part for part in self.interpreted.requirements if not is_anchored(part))
        return any(part.constraint is Constraint.AT for part in own)

    @property
    def times(self) -> set[tuple[float | None, float | None]]:
        """When it is to be done: "Saturday" for all that is asked for below it."""
        own = (part for part in self.interpreted.requirements if part.constraint in OWN_TIME)
        return {(part.earliest, part.latest) for part in own}

    def is_apart(self, other: "Step") -> bool:
        """Whether its time and that of another say which comes first: the same time for both does not."""
        said = (any(map(_is_own, one.interpreted.requirements)) for one in (self, other))
        return all(said) and self.times != other.times

    @property
    def ordered(self) -> bool:
        """Whether its words leave it where it stands: not beside, before, or at a distance of another.

        Before what comes later in its list it is anyhow.
        """
        return all(
            not is_anchored(part)
            or (part.constraint is Constraint.AFTER and part.anchor is not None and _is_behind(part))
            or self._comes_before(part)
            for part in self.interpreted.requirements
        )

    @property
    def beside(self) -> bool:
        """Whether it goes on beside a step before it: "meanwhile boil it", "while the glue sets"."""
        anchors = [
            (part.constraint, part.anchor)
            for part in self.interpreted.requirements
            if is_anchored(part) and part.anchor is not None and not part.anchor.exact
        ]
        return any(
            bound is Constraint.AT or (bound is Constraint.AFTER and anchor.edge is Edge.FREE)
            for bound, anchor in anchors
        )

    @property
    def inside(self) -> bool:
        """Whether it is done while what it counts from goes on: "after an hour stir it"."""
        anchors = [one.anchor for one in self.interpreted.requirements if is_anchored(one) and one.anchor]
        return any(
            one.exact and (one.share is not None or one.edge is Edge.START or one.lag < 0) for one in anchors
        )

    @property
    def last_of_turns(self) -> bool:
        """Whether it is one of so many turns that count from another, and goes on inside of none."""
        said = (part for part in self.interpreted.requirements if part.recurrence is not None)
        return any(
            is_anchored(part) and part.anchor and part.anchor.edge is Edge.END and not part.recurrence.endless
            for part in said
            if part.recurrence is not None
        )

    def goes_on(self, before: "Step") -> bool:
        """Whether it stands in the sentence of another, right behind that: "… and slice them"."""
        one, other = before.interpreted, self.interpreted
        if one.wish is not other.wish or one.instruction is None or other.instruction is None:
            return False
        reading = other.reading
        joint = "" if reading is None else reading.text[one.instruction.span[1] : other.instruction.span[0]]
        return bool(joint) and SENTENCE_ENDS.isdisjoint(joint)

    def _comes_before(self, part: TimeRequirement) -> bool:
        target = None if part.anchor is None or part.anchor.exact else part.anchor.target
        later = self.place is not None and target is not None and target > self.place
        return later and part.constraint is Constraint.BEFORE

    def precedence(self, following: "Step") -> Precedence:
        """Let another follow: once this is done, or once hands are free where it goes on for others."""
        skill = self.interpreted.skill
        waits = skill.time_until_done - skill.duration if self._leaves(following) else 0.0
        return Precedence(self.position, following.position, -waits)

    def precedence_until_due(self, following: "Step") -> Precedence:
        """Let another follow as late as it is due: what is opened stays open."""
        order, skill = self.precedence(following), self.interpreted.skill
        begin = min(skill.named, default=skill.satisfaction.best.low)
        latest = following.interpreted.skill.satisfaction.best.high
        if not math.isfinite(begin) or not math.isfinite(latest):
            return order
        lag = latest - begin - self.interpreted.skill.time_until_done
        return replace(order, wished_lag=lag) if lag >= order.minimum_lag else order

    def _leaves(self, following: "Step") -> bool:
        needed = self.interpreted.duration.needed_for
        operation, other = self.interpreted.operation, following.interpreted.operation
        if not (needed or self.beside) or operation is None or other is None:
            return False
        # "Charge the drill", "drill the holes"
        does = other.lemma in content_words(operation.object)
        return other.lemma not in needed and not does and not shares_thing(operation, other)


@dataclass(slots=True)
class Row:
    """The steps of one list that nothing follows yet, and those that may be needed later than by the next.

    ``meanwhile`` is the latest, where it goes on beside what is above, or inside of it. ``end`` is what it
    leads to at a moment: the last step that has one, or what is told in front of all or behind all ("dinner
    is at eight").
    """

    needed: list[Step] = field(default_factory=list)
    last: list[Step] = field(default_factory=list)
    precedences: list[Precedence] = field(default_factory=list)
    meanwhile: Step | None = None
    end: Step | None = None
    told: bool = False
    ahead: bool = False

    def lead_to(self, event: Step) -> None:
        """Take what is told to happen at a moment for what all steps lead to, unless a step follows it."""
        if event.at_moment and not self.ahead:
            self.end, self.told, self.ahead = event, True, not self.last

    def add(self, step: Step) -> None:
        """Add a step, behind those that nothing follows."""
        if self.told and not self.ahead:
            self.end, self.told = None, False
        if step.at_moment and not self.told:
            self.end = step
        left: list[Step] = []
        open_ends = {before.position for before in self.last}
        # "Meanwhile peel the carrots and slice them": both go on beside what is above.
        onward = self.meanwhile is not None and step.goes_on(self.meanwhile)
        for before in self.last:
            passed = onward and before is not self.meanwhile
            if not step.ordered or step.is_apart(before) or passed:
                left.append(before)
            else:
                self.precedences.append(before.precedence(step))
        if step.ordered:
            # What goes on meanwhile may be needed later than by the next: "preheat the oven".
            self.precedences += [
                before.precedence(step) for before in self.needed if before.position not in open_ends
            ]
        if step.interpreted.duration.needed_for or step.beside:
            self.needed.append(step)
        self.meanwhile = step if step.beside or step.inside or onward else None
        self.last = [*left, step]

    def close(self) -> None:
        """Let the last step wait for all that goes on beside others: "meanwhile boil the rice"."""
        for step in self.last[-1:]:
            beside = [one for one in self.needed if one.beside and one is not step and step.ordered]
            # What is said first of two counts.
            waited = [Precedence(one.position, step.position) for one in beside]
            self.precedences = [*waited, *self.precedences]
        if self.told and self.end is not None:
            self.precedences += [Precedence(step.position, self.end.position) for step in self.last]


def _is_own(part: TimeRequirement) -> bool:
    """Whether it says when something is, and counts from nothing else."""
    return part.constraint in OWN_TIME and not is_anchored(part)


def is_anchored(part: TimeRequirement) -> bool:
    """Whether a time counts from another instruction."""
    return part.anchor is not None and part.anchor.target is not None


def _is_behind(part: TimeRequirement) -> bool:
    return part.anchor is not None and part.anchor.edge is Edge.END and not part.anchor.exact


def is_asked(made: Interpreted) -> bool:
    """Whether something is asked for, once."""
    return made.asked and not made.repeats
