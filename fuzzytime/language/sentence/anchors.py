"""Times that depend on another instruction: "five minutes before you serve", "ten minutes later", "then"."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation
from fuzzytime.language.meaning.calendar import Calendar
from fuzzytime.language.meaning.expressions import HALFWAY, LEFT, Offset, Phrase, TimeWord, Wall
from fuzzytime.language.meaning.expressions import Edge as Bound
from fuzzytime.language.sentence.clause import Clause
from fuzzytime.language.sentence.clause_sides import FIRST, side_of
from fuzzytime.language.sentence.content_words import content_words
from fuzzytime.language.sentence.references import (
    ARRIVING,
    BE,
    BEGINNING,
    ENDING,
    PRONOUNS,
    Mentions,
    best_of,
    comes,
    is_done_with,
    waits_for,
)
from fuzzytime.requirement import Anchor, Constraint, Edge, TimeRequirement

AT_THE_END = "at the end"
"""The time word that is about the end of what goes on."""

ORDERING = {
    "afterwards": Constraint.AFTER,
    AT_THE_END: Constraint.AFTER,
    "beforehand": Constraint.BEFORE,
    "then": Constraint.AT,
    "meanwhile": Constraint.AT,
}
"""The time words that are about the instruction before it."""

BACK = frozenset({"it", "that", "this"})
"""Words for an event that is the instruction before."""

BESIDE = frozenset({"during", "over", "with", "at"})
"""Prepositions of what goes on: "during lunch"."""

END = frozenset({"the end", "the very end"})
"""Words for the end of what goes on."""

COMING_BACK = frozenset({"they", "he", "she", "it"})
SPEAKERS = frozenset({"we", "i", "you"})
LEAVING = frozenset(
    ["leave", "go", "drive", "depart", "travel", "walk", "cycle", "ride", "fly", "head", "sail"]
)
"""What leads somewhere: who leaves gets there."""

NEAR = 50
"""How many instructions back somebody's coming is looked for."""

HOUR = "time"
"""The end of the name of when a meal is: "lunchtime"."""

WITHIN = "within"
INTO = "into"
"""The preposition of times that count from the start of the instruction before."""

INSIDE = frozenset({LEFT, HALFWAY})
"""The prepositions of times that are inside something else, and nothing without that."""

COUNTED: dict[str | None, Constraint] = {
    "later": Constraint.AFTER,
    "earlier": Constraint.BEFORE,
    INTO: Constraint.AFTER,
    LEFT: Constraint.AFTER,
}
"""The prepositions that count from the instruction before: "ten minutes later", "ten minutes before that"."""


@dataclass(frozen=True, slots=True)
class Anchors:
    """What one instruction's words may refer to: the operations of all others.

    ``position`` is its own, ``first`` that of the first instruction of its text, and ``own`` are the
    operations of that text. Those of what was said after it are meant only where it ``awaits`` them, and
    where nothing said before is meant. ``day`` is that of a line above.
    """

    position: int
    first: int
    own: Sequence[Operation | None]
    mentions: Mentions
    lexicon: Lexicon
    awaits: bool = False
    day: Calendar | None = None

    def about(self, clause: Clause) -> str | None:
        """Give what an instruction before is about that a clause is about too; None where there is none."""
        target = self.target_of(clause)
        if target is None or target >= self.position:
            return None
        operation = self._operation(target)
        return None if operation is None else operation.object

    def target_of(self, clause: Clause) -> int | None:
        """Give the position of the instruction that a clause is about, None where there is none."""
        here = [(self.first + place, operation) for place, operation in enumerate(self.own)]
        beside = [(place, operation) for place, operation in reversed(here) if place != self.position]
        # Of equals the nearest: among those before it the last, among those behind the first.
        last = self.position - 1
        condition = clause.condition
        if condition is not None and condition.subject == "you" and condition.word in self.lexicon.results:
            # "Text me when you are finished"
            return last if last >= 0 and not condition.negated else None
        if self._is_done_soon(clause):
            # "Add the carrots an hour before it's done"
            return self._going_on()
        over = condition is not None and condition.word in self.lexicon.results
        over = over and condition is not None and condition.subject in BACK
        happens = (over or clause.verb in BEGINNING | ENDING) and last >= 0 and self._is_stated(last)
        if (clause.is_event or happens) and (over or (clause.object or "").lower() in BACK) and last >= 0:
            # "The meeting starts at three, remind me ten minutes before it", "… before it starts"
            return last
        if clause.is_event and (clause.object or "").lower() in END and self.mentions.lasting:
            # "Add the hops 15 minutes before the end"
            return self._going_on()
        target = best_of(clause, chain(beside, self._given(clause)), self.lexicon)
        if target is None and condition is not None and condition.subject in COMING_BACK | SPEAKERS:
            target = self._arrival(clause)
        if target is not None or not self.awaits:
            return target
        return best_of(clause, self._coming(clause), self.lexicon)

    def _is_done_soon(self, clause: Clause) -> bool:
        """Whether a distance counts back from the end of what goes on: "five minutes before it is ready"."""
        condition = clause.condition
        if (
            clause.kind not in FIRST
            or clause.distance is None
            or condition is None
            or not self.mentions.lasting
        ):
            return False
        return condition.subject in BACK and condition.word in self.lexicon.results

    def _arrival(self, clause: Clause) -> int | None:
        """Give the latest that comes, of whoever "they" are: "before they arrive".

        Who speaks comes where the latest journey leads: "when we get there".
        """
        if clause.verb not in ARRIVING and not clause.is_there:
            return None
        if clause.condition is not None and clause.condition.subject in SPEAKERS:
            goes = ((place, one.lemma) for place, one in self._just_before())
            return next((place for place, lemma in goes if lemma in LEAVING), None)
        return next((place for place, happening in self._just_before() if comes(happening)), None)

    def _just_before(self) -> Iterator[tuple[int, Operation]]:
        for place in range(self.position - 1, max(-1, self.position - NEAR), -1):
            operation = self._operation(place)
            if operation is not None:
                yield place, operation

    def _given(self, clause: Clause) -> Iterator[tuple[int, Operation | None]]:
        for place in self.mentions.named_by(clause, range(self.first), backwards=True):
            yield place, self.mentions.operations[place]

    def _coming(self, clause: Clause) -> Iterator[tuple[int, Operation | None]]:
        coming = range(self.first + len(self.own), len(self.mentions.operations))
        for place in self.mentions.named_by(clause, coming, backwards=False):
            yield place, self.mentions.operations[place]

    def done_with(self, thing: str | None) -> int | None:
        """Give the latest instruction before it that is about a thing; None for none, and for a person."""
        words = content_words(thing.split()[-1] if thing else None) - PRONOUNS
        if not words or words & self.lexicon.persons:
            return None
        for place in range(self.position - 1, self.first - 1, -1):
            if is_done_with(self._operation(place), words):
                return place
        return self.mentions.touching(words, self.first)

    def lasting(self, thing: str | None, text: str) -> Anchor:
        """Give the instruction that a thing is of: "the bread takes an hour"; without one, that before it."""
        words = content_words(thing)
        if words and not words <= PRONOUNS:
            named = Clause("length", "", (0, 0), (0, 0), object=thing, is_event=True)
            return Anchor(text=text, object=thing, target=self.target_of(named))
        return Anchor(text=text, target=self.position - 1 if self.position else None)

    def of_clause(self, clause: Clause, text: str, what: str, target: int | None) -> TimeRequirement:
        """Give the requirement of a clause that names another instruction, or an event."""
        before = clause.kind in FIRST
        together = clause.kind == "while"
        distance = clause.distance
        lag = 0.0 if distance is None else distance.seconds * (-1 if before else 1)
        if clause.takes is not None and not before:
            lag += clause.takes.seconds
        edge = Edge.START if before or together or clause.kind == "into" else Edge.END
        edge = edge if clause.takes is None or edge is Edge.START else Edge.FREE
        if clause.edge is not None:
            edge = clause.edge
        elif (clause.object or "").lower() in END or self._is_done_soon(clause):
            edge = Edge.END
        elif target is not None and self._is_stated(target):
            # "When the meeting starts", "before the film ends"
            edge = Edge.START if clause.verb in BEGINNING else Edge.END if clause.verb in ENDING else edge
        anchor = Anchor(
            text=what,
            verb=clause.verb,
            object=clause.object,
            target=target,
            edge=edge,
            lag=lag,
            exact=clause.kind == HALFWAY
            or clause.beside is not None
            or (distance is not None and clause.kind != "within" and clause.side is None),
            share=0.5 if clause.kind == HALFWAY else None,
        )
        return TimeRequirement(
            text=text,
            span=clause.span,
            constraint=side_of(clause),
            preposition=clause.marker,
            fuzziness=(clause.beside,) if clause.beside else () if distance is None else distance.hedges,
            number=None if distance is None else distance.number,
            unit=None if distance is None else distance.unit,
            anchor=anchor,
        )

    def is_asked(self, target: int) -> bool:
        """Whether an instruction asks for something to be done."""
        operation = self._operation(target)
        return operation is not None and not operation.stated

    def is_same_as_before(self, operation: Operation) -> bool:
        """Whether the instruction before asks for the very same."""
        before = self._operation(self.position - 1) if self.position else None
        same = before is not None and not before.stated and before.lemma == operation.lemma
        return same and before is not None and before.object == operation.object

    def goes_on(self, operation: Operation) -> bool:
        """Whether what is told is what something with a time does then, told right before in its text."""
        before = self._operation(self.position - 1) if self.position > self.first else None
        begins = before is not None and before.stated and before.lemma in BEGINNING | {BE}
        return begins and before is not None and before.object == operation.object

    def _operation(self, target: int) -> Operation | None:
        place = target - self.first
        return self.own[place] if 0 <= place < len(self.own) else self.mentions.operations[target]

    def _is_stated(self, target: int) -> bool:
        operation = self._operation(target)
        return operation is not None and operation.stated

    def of_phrase(self, phrase: Phrase, requirement: TimeRequirement) -> TimeRequirement:
        """Give a requirement of the grammar as a reference, where it is one."""
        found = self._meal(phrase, requirement) or self._later(phrase, requirement)
        return found or self._upon_arrival(requirement) or requirement

    def _upon_arrival(self, requirement: TimeRequirement) -> TimeRequirement | None:
        """Count "within an hour" from when that comes which it is about: "the truck comes at ten, …"."""
        operation = self._operation(self.position)
        if requirement.preposition != WITHIN or requirement.t_spec is None or operation is None:
            return None
        for place, happening in self._just_before():
            if waits_for(operation, happening):
                anchor = Anchor(text=requirement.text, target=place, lag=requirement.t_spec)
                return _only(requirement, anchor, Constraint.BETWEEN)
        return None

    def _meal(self, phrase: Phrase, requirement: TimeRequirement) -> TimeRequirement | None:
        """Read "before dinner", "an hour before dinner" as a reference where another makes that dinner."""
        time, constraint, lag = phrase.said.time, phrase.said.constraint, 0.0
        if isinstance(time, Offset) and time.anchor is not None:
            lag = time.direction * time.duration.seconds
            time, constraint = time.anchor, Constraint.BEFORE if lag < 0 else Constraint.AFTER
        part = time.part if isinstance(time, Wall) and time.days in {None, self.day} else None
        if part is not None and not part.meal and part.name.endswith(HOUR):
            # "Call her at lunchtime"
            part = replace(part, name=part.name.removesuffix(HOUR), meal=True)
        beside = requirement.text.split()[0].lower() in BESIDE
        if phrase.said.beside:
            constraint = Constraint.BEFORE if phrase.said.edge is Bound.START else Constraint.AFTER
        if part is None or not part.meal or part.place:
            return None
        if not beside and constraint not in {Constraint.BEFORE, Constraint.AFTER}:
            return None
        words = content_words(part.name)
        own = [
            self.first + place
            for place, operation in enumerate(self.own)
            if operation is not None and words <= content_words(operation.object)
        ]
        targets = [place for place in own if place != self.position]
        target = targets[-1] if targets else self.mentions.about(words, self.first)
        if target is None:
            return None
        constraint = Constraint.AT if beside or constraint is None else constraint
        edge = Edge.END if constraint is Constraint.AFTER else Edge.START
        just = phrase.said.beside and constraint is Constraint.BEFORE
        anchor = Anchor(
            text=part.name, object=part.name, target=target, edge=edge, lag=lag, exact=lag != 0 or just
        )
        return _only(requirement, anchor, constraint)

    def _later(self, phrase: Phrase, requirement: TimeRequirement) -> TimeRequirement | None:
        """Read "ten minutes later" as a distance from the instruction before, in the same text or another.

        "Afterwards" is after it and "before that" before it, at whatever distance.
        """
        time = phrase.said.time
        if isinstance(time, TimeWord) and time.word in ORDERING and self.position > 0:
            constraint = ORDERING[time.word]
            edge = Edge.END if constraint is Constraint.AFTER else Edge.START
            target = self._going_on() if time.word == AT_THE_END else self.position - 1
            anchor = Anchor(text=requirement.text, target=target, edge=edge)
            return _only(replace(requirement, word=None), anchor, constraint)
        if phrase.said.preposition == HALFWAY and self.position > 0:
            anchor = Anchor(text=requirement.text, target=self._going_on(), share=0.5, exact=True)
            return _only(requirement, anchor, Constraint.AFTER)
        side = (
            COUNTED.get(phrase.said.preposition) if isinstance(time, Offset) and time.anchor is None else None
        )
        if side is None or self.position == 0:
            return None
        edge = Edge.START if side is Constraint.BEFORE or phrase.said.preposition == INTO else Edge.END
        lag = requirement.t_spec or 0.0
        target = self._going_on() if phrase.said.preposition == LEFT else self.position - 1
        anchor = Anchor(text=requirement.text, target=target, edge=edge, lag=lag, exact=True)
        return _only(requirement, anchor, side)

    def _going_on(self) -> int:
        """Give the latest instruction that was said to go on for some time, or that right before."""
        before = [place for place in self.mentions.lasting if place < self.first]
        return self.position - 1 if self.position > self.first or not before else before[-1]


def _only(requirement: TimeRequirement, anchor: Anchor, constraint: Constraint) -> TimeRequirement:
    """Give a requirement that counts from another instruction alone."""
    return replace(
        requirement, constraint=constraint, anchor=anchor, t_spec=None, earliest=None, latest=None, grain=None
    )
