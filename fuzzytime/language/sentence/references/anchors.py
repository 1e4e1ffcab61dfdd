"""Times that depend on another instruction: "five minutes before you serve", "ten minutes later", "then"."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace
from datetime import datetime
from itertools import chain

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation
from fuzzytime.language.meaning.calendar import Calendar
from fuzzytime.language.meaning.joined.distances import HALFWAY
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.clauses.clause_sides import FIRST, side_of
from fuzzytime.language.sentence.references.likeness import best_of
from fuzzytime.language.sentence.references.mentions import (
    Mentions,
    comes,
    comes_back,
    comes_by_name,
    is_done_with,
    owners_in,
)
from fuzzytime.language.sentence.references.told import Told
from fuzzytime.language.sentence.trees.content_words import content_words
from fuzzytime.requirement import Anchor, Constraint, Edge, TimeRequirement

NEAR = 50
"""How many instructions back somebody's coming is looked for."""


@dataclass(frozen=True, slots=True)
class Anchors:
    """What one instruction's words may refer to: the operations of all others.

    ``position`` is its own, ``first`` that of the first instruction of its text, and ``own`` are the
    operations of that text. Those of what was said after it are meant only where it ``awaits`` them, and
    where nothing said before is meant. ``day`` is that of a line above, ``told`` what was told of times so
    far, ``now`` when that is said.
    """

    position: int
    first: int
    own: Sequence[Operation | None]
    mentions: Mentions
    awaits: bool = False
    day: Calendar | None = None
    told: Told = field(default_factory=Told)
    now: datetime | None = None

    @property
    def lexicon(self) -> Lexicon:
        """The words of the language."""
        return self.mentions.lexicon

    def target_of(self, clause: Clause) -> int | None:
        """Give the position of the instruction that a clause is about, None where there is none."""
        closed, doing, condition = self.lexicon.closed, self.lexicon.doing, clause.condition
        here = [(self.first + place, operation) for place, operation in enumerate(self.own)]
        beside = [(place, operation) for place, operation in reversed(here) if place != self.position]
        # Of equals the nearest: among those before it the last, among those behind the first.
        last = self.position - 1
        subject = None if condition is None else condition.subject
        if condition is not None and subject == "it" and condition.word in self.lexicon.impersonal:
            # "Get some milk, shut the vents before it gets dark"
            return None
        over = condition is not None and condition.word in self.lexicon.results
        if condition is not None and over and clause.object is None and clause.is_through(self.lexicon):
            # "Text me when you are finished", "load out once we're done"
            return last if last >= 0 and not condition.negated else None
        if self._is_done_soon(clause):
            # "Add the carrots an hour before it's done"
            return self.going_on()
        thing = (clause.object or "").lower()
        over = over and subject in closed.singular_anaphors
        phases = doing.beginning | doing.ending
        happens = (over or clause.verb in phases) and last >= 0 and self._is_stated(last)
        about_it = over or thing in closed.singular_anaphors
        if about_it and last >= 0 and (clause.is_event or happens):
            # "The meeting starts at three, remind me ten minutes before it", "… before it starts"
            return last
        if clause.is_event and thing in self.lexicon.beside.the_end and self.said_to_last() is not None:
            # "Add the hops 15 minutes before the end"
            return self.going_on()
        whose = self._whose(clause)
        given = self._given(clause, every=bool(whose))
        target = best_of(clause, chain(beside, given), self.lexicon, whose)
        if target is None and subject in closed.third_person | closed.first_and_second_person:
            target = self._arrival(clause)
        if target is not None or not self.awaits:
            return target
        return best_of(clause, self._coming(clause), self.lexicon)

    def called(self, words: str) -> int | None:
        """Give the instruction that is called just so, whatever else words may say: "before the crew call".

        That is the latest before it, or else the first of its text, or of those it ``awaits``.
        """
        named = content_words(words)
        if not named:
            return None
        last = len(self.mentions.operations) if self.awaits else self.first + len(self.own)
        places = (*range(self.position - 1, -1, -1), *range(self.position + 1, last))
        said = ((place, self.operation_at(place)) for place in places)
        return next(
            (p for p, one in said if one and not one.negated and content_words(one.name) == named), None
        )

    def _is_done_soon(self, clause: Clause) -> bool:
        """Whether a distance counts back from the end of what goes on: "five minutes before it is ready"."""
        condition = clause.condition
        counted = clause.kind in FIRST and clause.distance is not None and self.said_to_last() is not None
        return (
            counted
            and condition is not None
            and condition.subject in self.lexicon.closed.singular_anaphors
            and condition.word in self.lexicon.results
        )

    def _is_over(self, clause: Clause) -> bool:
        """Whether a clause is about the end of what it names: "ten minutes before the roast is done"."""
        condition = clause.condition
        said = condition is not None and (condition.word,) in self.lexicon.conversation["finished"]
        return clause.kind in FIRST and (said or self._is_done_soon(clause))

    def _arrival(self, clause: Clause) -> int | None:
        """Give the latest that comes, of whoever "they" are: "before they arrive".

        Who speaks comes where the latest journey leads: "when we get there".
        """
        doing = self.lexicon.doing
        if clause.verb not in doing.arriving and not clause.is_there(self.lexicon):
            return None
        subject = None if clause.condition is None else clause.condition.subject
        if subject in self.lexicon.closed.first_and_second_person:
            here = [(self.first + place, one) for place, one in enumerate(self.own) if one is not None]
            back = (place for place, one in (*here, *self.just_before()) if comes_back(one, self.lexicon))
            known = next(back, None)
            if known is not None:
                return known
            return next((place for place, one in self.just_before() if one.lemma in doing.leaving), None)
        lexicon, told = self.lexicon, list(self.just_before())
        coming = (place for place, one in told if comes(one, lexicon) or comes_by_name(one, lexicon))
        return next(coming, None)

    def just_before(self) -> Iterator[tuple[int, Operation]]:
        """Give the instructions before it, the latest first, that are not long ago."""
        for place in range(self.position - 1, max(-1, self.position - NEAR), -1):
            operation = self.operation_at(place)
            if operation is not None:
                yield place, operation

    def _whose(self, clause: Clause) -> frozenset[str]:
        """Give what an instruction is about, that a clause is of: "his walk", "walking him"; else nothing."""
        closed, operation = self.lexicon.closed, next(iter(self.own[self.position - self.first :]), None)
        first = (clause.object or "").lower().partition(" ")[0]
        of_it = first in (closed.possessives - closed.first_person_possessives) | closed.third_person_objects
        return content_words(operation.object) if of_it and operation is not None else frozenset()

    def _given(self, clause: Clause, *, every: bool) -> Iterator[tuple[int, Operation | None]]:
        for place in self.mentions.named_by(clause, range(self.first), backwards=True, every=every):
            yield place, self.mentions.operations[place]

    def _coming(self, clause: Clause) -> Iterator[tuple[int, Operation | None]]:
        coming = range(self.first + len(self.own), len(self.mentions.operations))
        for place in self.mentions.named_by(clause, coming, backwards=False):
            yield place, self.mentions.operations[place]

    def done_with(self, thing: str | None) -> int | None:
        """Give the latest instruction before it that is about a thing; None for none, and for a person."""
        words = content_words(thing.split()[-1] if thing else None) - self.lexicon.closed.anaphors
        if not words or words & self.lexicon.persons:
            return None
        owners = owners_in(thing)
        for place in range(self.position - 1, self.first - 1, -1):
            if is_done_with(self.operation_at(place), words, owners):
                return place
        return self.mentions.touching(words, self.first, owners)

    def done_with_it(self, pronoun: str) -> int | None:
        """Give the instruction right before it, where that is about what the same pronoun stands for."""
        before = self.operation_at(self.position - 1) if self.position else None
        same = before is not None and not before.negated and (before.object or "").lower() == pronoun
        return self.position - 1 if same else None

    def lasting(self, thing: str | None, text: str) -> Anchor:
        """Give the instruction that a thing is of: "the bread takes an hour"; without one, that before it."""
        words = content_words(thing)
        if words and not words <= self.lexicon.closed.anaphors:
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
        elif (clause.object or "").lower() in self.lexicon.beside.the_end or self._is_over(clause):
            edge = Edge.END
        elif target is not None and self._is_stated(target):
            # "When the meeting starts", "before the film ends"
            edge = self._edge_of_phase(clause.verb) or edge
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

    def _edge_of_phase(self, verb: str | None) -> Edge | None:
        """Give the edge of what happens that a verb is about; None where it is about neither."""
        doing = self.lexicon.doing
        if verb in doing.beginning:
            return Edge.START
        return Edge.END if verb in doing.ending else None

    def is_asked(self, target: int) -> bool:
        """Whether an instruction asks for something to be done."""
        operation = self.operation_at(target)
        return operation is not None and not operation.stated

    def is_same_as_before(self, operation: Operation) -> bool:
        """Whether the instruction before asks for the very same."""
        before = self.operation_at(self.position - 1) if self.position else None
        same = before is not None and not before.stated and before.lemma == operation.lemma
        return same and before is not None and before.object == operation.object

    def goes_on(self, operation: Operation) -> bool:
        """Whether what is told is what something with a time does then, told right before in its text."""
        before = self.operation_at(self.position - 1) if self.position > self.first else None
        beginning = self.lexicon.doing.beginning_or_being
        begins = before is not None and before.stated and before.lemma in beginning
        return begins and before is not None and before.object == operation.object

    def operation_at(self, target: int) -> Operation | None:
        """Give the operation of an instruction by its position."""
        place = target - self.first
        return self.own[place] if 0 <= place < len(self.own) else self.mentions.operations[target]

    def _is_stated(self, target: int) -> bool:
        return (operation := self.operation_at(target)) is not None and operation.stated

    def before_list(self) -> int:
        """Give the instruction before all that the same words ask for, as a list of times does; or -1."""
        own, before = self.operation_at(self.position), self.position - 1
        while before >= self.first and own is not None:
            other = self.operation_at(before)
            if other is None or other.span != own.span:
                break
            before -= 1
        return before

    def counted_down_from(self) -> int:
        """Give what all in a countdown count from: what was told to happen, or else what the one before does.

        "An hour before: heat the oven. Ten minutes before: set the table"
        """
        before = self.told.event_of(self.position - 1)
        places = (place for place in range(before, -1, -1) if self._is_stated(place))
        return next((place for place in places if self.told.start(place) is not None), before)

    def said_to_last(self) -> int | None:
        """Give the latest instruction before it that was said to go on for some time; None without one."""
        return self.told.last_going_on(self.position)

    def going_on(self) -> int:
        """Give the latest instruction that was said to go on for some time, or that right before."""
        before = self.said_to_last()
        here = before is not None and (before >= self.first or self.position == self.first)
        return before if before is not None and here else self.position - 1


def only_counted(requirement: TimeRequirement, anchor: Anchor, constraint: Constraint) -> TimeRequirement:
    """Give a requirement that counts from another instruction alone."""
    return replace(
        requirement, constraint=constraint, anchor=anchor, t_spec=None, earliest=None, latest=None, grain=None
    )
