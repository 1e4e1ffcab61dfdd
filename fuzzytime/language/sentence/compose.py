"""The second pass: what a draft says, grounded and put together as a reading."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from fuzzytime.language.finding import ground_all
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.instruction import (
    Instruction,
    Operation,
    Question,
    Reading,
    Remark,
    RemarkKind,
    Span,
    StrictReading,
    Token,
)
from fuzzytime.language.meaning.expressions import Part as DayPart
from fuzzytime.language.meaning.expressions import Offset, Phrase, Wall
from fuzzytime.language.meaning.requirements import Grounded, Moment
from fuzzytime.language.sentence.clauses import Clause, clauses_of, inside
from fuzzytime.language.sentence.drafts import Draft, Part
from fuzzytime.language.sentence.labels import strict_reading
from fuzzytime.language.sentence.leftovers import leftovers
from fuzzytime.language.sentence.operations import Reader, action_of
from fuzzytime.language.sentence.references import content_words, resolved_object, target_of
from fuzzytime.language.sentence.tree import Tree
from fuzzytime.requirement import Anchor, Constraint, Edge, Reference, TimeRequirement

if TYPE_CHECKING:
    from fuzzytime.skills import FuzzyParameter

__all__ = ["Draft", "composed"]

TURNED = {
    Constraint.BEFORE: (Constraint.AFTER, "not before"),
    Constraint.AFTER: (Constraint.BEFORE, "not after"),
}
"""What "don't … before" asks for."""


def composed(draft: Draft, lexicon: Lexicon, given: Sequence[Operation | None]) -> Reading:
    """Put a reading together; ``given`` are the operations of the instructions before."""
    return _Composer(draft, lexicon, given).reading()


class _Composer:
    def __init__(self, draft: Draft, lexicon: Lexicon, given: Sequence[Operation | None]) -> None:
        self.draft = draft
        self.lexicon = lexicon
        self.moment = Moment(draft.now, lexicon.policy)
        self.given = list(given)
        self.remarks: list[Remark] = list(draft.remarks)
        self.questions: list[Question] = []
        self.explained: list[Span] = [phrase.span for phrase in draft.phrases]
        self.explained += [remark.span for remark in draft.remarks]

    def reading(self) -> Reading:
        """Read every part, then resolve what parts say of each other."""
        drafts = [self._sketch(part) for part in self._parts()]
        operations: list[Operation | None] = list(self.given)
        for sketch in drafts:
            if sketch.operation is not None:
                resolved = resolved_object(sketch.operation, operations)
                sketch.operation = replace(sketch.operation, object=resolved)
            operations.append(sketch.operation)
        instructions = tuple(
            self._instruction(sketch, len(self.given) + place, operations)
            for place, sketch in enumerate(drafts)
        )
        self.remarks += leftovers(self.draft.chart, self.explained, self.lexicon)
        tokens, strict = self._tokens()
        return Reading(
            text=self.draft.text,
            now=self.draft.now,
            instructions=instructions,
            tokens=tokens,
            strict=strict,
            remarks=tuple(sorted(self.remarks, key=lambda remark: remark.span)),
            questions=tuple(self.questions),
        )

    def _parts(self) -> list[Part]:
        """Give the parts; one that says only when is said of its neighbour: "At noon. Feed the cat."."""
        return list(self.draft.parts)

    # -- one part ------------------------------------------------------------------------------------------------------

    def _sketch(self, part: Part) -> _Sketch:
        first, end = part.segment.span
        phrases = [
            phrase for phrase in self.draft.phrases if first <= phrase.span[0] and phrase.span[1] <= end
        ]
        clauses = []
        if part.front is not None:
            clauses += self._clauses(part.front, first, part.offset, phrases)
        if part.tree.nodes:
            clauses += self._clauses(part.tree, part.offset, end, phrases)
        kept = [phrase for phrase in phrases if not inside(phrase.span, clauses)]
        self.explained += [clause.span for clause in clauses]
        sketch = _Sketch(part, kept, clauses)
        action = action_of(part.tree, self.lexicon)
        if action is not None:
            spans = (*(phrase.span for phrase in kept), *(clause.span for clause in clauses))
            times = [(a - part.offset, b - part.offset) for a, b in spans]
            reader = Reader(part.tree, self.lexicon, times)
            operation = reader.operation(action)
            a, b = operation.span
            sketch.operation = replace(operation, span=(a + part.offset, b + part.offset))
            sketch.parameters = reader.parameters(action)
            sketch.reference = action.reference
        return sketch

    def _clauses(self, tree: Tree, offset: int, end: int, phrases: Sequence[Phrase]) -> list[Clause]:
        """Give the clauses in a tree's stretch of text, with places in the whole text."""
        places = [p for p, word in enumerate(self.draft.chart.words) if offset <= word.start < end]
        start = places[0] if places else 0
        words = [self.draft.chart.words[place] for place in places]
        local_words = [Word(w.text, w.start - offset, w.end - offset, w.glued) for w in words]
        local = [
            replace(
                p, first=p.first - start, end=p.end - start, span=(p.span[0] - offset, p.span[1] - offset)
            )
            for p in phrases
            if offset <= p.span[0] < end
        ]
        found = clauses_of(tree, local_words, local, self.lexicon)
        return [
            replace(
                clause,
                span=(clause.span[0] + offset, clause.span[1] + offset),
                content=(clause.content[0] + offset, clause.content[1] + offset),
            )
            for clause in found
        ]

    # -- instructions ----------------------------------------------------------------------------------------------------

    def _instruction(
        self, sketch: "_Sketch", position: int, operations: Sequence[Operation | None]
    ) -> Instruction:
        times = ground_all(tuple(sketch.phrases), self.draft.text, self.moment)
        self.remarks += times.remarks
        self.questions += times.questions
        requirements: list[TimeRequirement] = []
        for phrase, grounded in _with_phrases(sketch.phrases, times.found):
            anchored = self._meal(phrase, grounded, position, operations)
            anchored = anchored or self._later(phrase, grounded, position)
            requirements.append(anchored or grounded.requirement)
        requirements += [self._of_clause(clause, position, operations) for clause in sketch.clauses]
        connected = self._of_connective(sketch, position)
        requirements += [connected] if connected is not None else []
        requirements.sort(key=lambda requirement: requirement.span)
        reference = sketch.reference
        operation = sketch.operation
        if operation is not None and operation.negated:
            requirements, operation = _turned(requirements, operation)
        return Instruction(
            span=sketch.part.segment.span,
            operation=operation,
            requirements=tuple(_referred(requirement, reference) for requirement in requirements),
            duration=next((g.duration for g in times.found if g.duration is not None), None),
            repeats=next((g.recurrence for g in times.found if g.recurrence is not None), None),
            fuzzy_parameters=sketch.parameters,
        )

    def _of_connective(self, sketch: "_Sketch", position: int) -> TimeRequirement | None:
        """Order by "then" or "meanwhile", to the instruction before."""
        segment = sketch.part.segment
        if segment.connective not in {"then", "meanwhile"} or position == 0:
            return None
        span = segment.connective_span
        self.explained.append(span)
        text = self.draft.text[slice(*span)].strip(" ,:")
        edge = Edge.END if segment.connective == "then" else Edge.START
        return TimeRequirement(
            text=text,
            span=(span[0], span[0] + len(text)),
            constraint=Constraint.AFTER if edge is Edge.END else Constraint.AT,
            preposition=segment.connective,
            anchor=Anchor(text=text, target=position - 1, edge=edge),
        )

    def _of_clause(
        self, clause: Clause, position: int, operations: Sequence[Operation | None]
    ) -> TimeRequirement:
        text = self.draft.text[slice(*clause.span)]
        others = [None if place == position else operation for place, operation in enumerate(operations)]
        target = target_of(clause, others, self.lexicon)
        condition = clause.condition
        if target is None and clause.kind in {"when", "until", "while"} and condition is not None:
            reference = Reference.FINISH if clause.kind == "until" else Reference.START
            return TimeRequirement(
                text=text,
                span=clause.span,
                constraint=Constraint.WHEN,
                preposition=clause.marker,
                condition=replace(condition, text=text),
                reference=reference,
            )
        if target is None:
            what = self.draft.text[slice(*clause.content)]
            message = f"{text!r} refers to {what!r}, and no instruction so far is about that"
            self.remarks.append(Remark(RemarkKind.UNRESOLVED, clause.span, message))
        return self._anchored(clause, text, target)

    def _anchored(self, clause: Clause, text: str, target: int | None) -> TimeRequirement:
        before = clause.kind in {"before", "until", "by the time"}
        constraint = Constraint.BEFORE if before else Constraint.AFTER
        if clause.kind == "while":
            constraint = Constraint.AT
        edge = Edge.START if before or clause.kind == "while" else Edge.END
        distance = clause.distance
        lag = 0.0 if distance is None else distance.seconds * (-1 if before else 1)
        anchor = Anchor(
            text=self.draft.text[slice(*clause.content)],
            verb=clause.verb,
            object=clause.object,
            target=target,
            edge=edge,
            lag=lag,
            exact=distance is not None,
        )
        return TimeRequirement(
            text=text,
            span=clause.span,
            constraint=constraint,
            preposition=clause.marker,
            fuzziness=() if distance is None else distance.hedges,
            number=None if distance is None else distance.number,
            unit=None if distance is None else distance.unit,
            anchor=anchor,
        )

    def _meal(
        self, phrase: Phrase, grounded: Grounded, position: int, operations: Sequence[Operation | None]
    ) -> TimeRequirement | None:
        """Give "before dinner" as a reference where an instruction before this one makes that dinner."""
        time = phrase.said.time
        part: DayPart | None = time.part if isinstance(time, Wall) and time.days is None else None
        if (
            part is None
            or not part.meal
            or phrase.said.constraint not in {Constraint.BEFORE, Constraint.AFTER}
        ):
            return None
        words = content_words(part.name)
        targets = [
            place
            for place, operation in enumerate(operations)
            if place != position and operation is not None and words <= content_words(operation.object)
        ]
        if not targets:
            return None
        edge = Edge.START if phrase.said.constraint is Constraint.BEFORE else Edge.END
        anchor = Anchor(text=part.name, object=part.name, target=targets[-1], edge=edge)
        return replace(
            grounded.requirement, anchor=anchor, t_spec=None, earliest=None, latest=None, grain=None
        )

    def _later(self, phrase: Phrase, grounded: Grounded, position: int) -> TimeRequirement | None:
        """Give "ten minutes later" as a distance from the instruction before in the same text."""
        time = phrase.said.time
        later = isinstance(time, Offset) and time.anchor is None and phrase.said.preposition == "later"
        if not later or position == len(self.given):
            return None
        lag = grounded.requirement.t_spec or 0.0
        anchor = Anchor(
            text=grounded.requirement.text, target=position - 1, edge=Edge.END, lag=lag, exact=True
        )
        found = replace(grounded.requirement, constraint=Constraint.AFTER, anchor=anchor)
        return replace(found, t_spec=None, earliest=None, latest=None)

    # -- the tree, for explanations ---------------------------------------------------------------------------------------

    def _tokens(self) -> tuple[tuple[Token, ...], StrictReading]:
        tokens: list[Token] = []
        strict = StrictReading()
        found = False
        for part in self.draft.parts:
            trees = [(part.front, part.segment.span[0], False)] if part.front is not None else []
            for tree, offset, main in (*trees, (part.tree, part.offset, True)):
                own, reading = strict_reading(tree, self.lexicon)
                base = len(tokens)
                tokens += [
                    replace(t, span=(t.span[0] + offset, t.span[1] + offset), head=t.head + base) for t in own
                ]
                if main and own and not found:
                    strict, found = reading.moved(base), True
        return tuple(tokens), strict


@dataclass
class _Sketch:
    """One instruction before its references are resolved."""

    part: Part
    phrases: list[Phrase]
    clauses: list[Clause]
    operation: Operation | None = None
    parameters: tuple[FuzzyParameter, ...] = ()
    reference: Reference = Reference.START


def _with_phrases(phrases: Sequence[Phrase], found: Sequence[Grounded]) -> list[tuple[Phrase, Grounded]]:
    """Pair what was grounded with its phrase, by place."""
    by_span = {phrase.span: phrase for phrase in phrases}
    return [(by_span[grounded.requirement.span], grounded) for grounded in found]


def _turned(
    requirements: Sequence[TimeRequirement], operation: Operation
) -> tuple[list[TimeRequirement], Operation]:
    """Read "don't open it before six" as: open it, not before six."""
    if not any(requirement.constraint in TURNED for requirement in requirements):
        return list(requirements), operation
    turned = []
    for requirement in requirements:
        if requirement.constraint in TURNED:
            constraint, preposition = TURNED[requirement.constraint]
            time = requirement.t_spec
            turned.append(
                replace(
                    requirement,
                    constraint=constraint,
                    preposition=preposition,
                    earliest=time if constraint is Constraint.AFTER else None,
                    latest=time if constraint is Constraint.BEFORE else None,
                )
            )
        else:
            turned.append(requirement)
    return turned, replace(operation, negated=False)


def _referred(requirement: TimeRequirement, reference: Reference) -> TimeRequirement:
    """Give a requirement the moment of the execution that its verb is about."""
    if (
        requirement.constraint in {Constraint.FOR, Constraint.EVERY, Constraint.WHEN}
        or reference is Reference.START
    ):
        return requirement
    return replace(requirement, reference=reference)
