"""One instruction before it is grounded: its part of a draft, its times and clauses, what is to be done."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation, Order, Remark, RemarkKind, Span, overlap
from fuzzytime.language.meaning.expressions import Duration, Phrase, Range, TimeWord
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.clauses.times_of_events import AHEAD, OVER
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.same_doers import tells_more
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.sketches.deadlines_of_clauses import DEADLINE
from fuzzytime.language.sentence.sketches.elsewhere import aim_of, elsewhere, is_of_subject, reason_of
from fuzzytime.language.sentence.sketches.of_things import of_things
from fuzzytime.language.sentence.sketches.retimed import by_that_day, is_there, on_that_day, put_off
from fuzzytime.language.sentence.sketches.said_of_time import DATED, said_of_time
from fuzzytime.language.sentence.sketches.telling import (
    of_something_else,
    of_which,
    telling_alone,
    times_told,
    with_name,
    with_told,
)
from fuzzytime.language.sentence.verbs.actions import (
    Action,
    action_of,
    says_how_things_are,
)
from fuzzytime.language.sentence.verbs.amounts import parameters_of
from fuzzytime.language.sentence.verbs.due_by_then import due_by_then
from fuzzytime.language.sentence.verbs.happenings import happening_at, happens
from fuzzytime.language.sentence.verbs.moments import reference_of
from fuzzytime.language.sentence.verbs.named_deeds import chores_at, deed_at
from fuzzytime.language.sentence.verbs.named_moments import named_moment
from fuzzytime.language.sentence.verbs.operations import Reader
from fuzzytime.language.sentence.verbs.put_there import put_there
from fuzzytime.language.sentence.verbs.remembered import as_remembered
from fuzzytime.requirement import Constraint, Reference

if TYPE_CHECKING:
    from fuzzytime.skills import FuzzyParameter


LEAVE = "leave"


@dataclass(frozen=True, slots=True, kw_only=True)
class Sketch:
    """One instruction: its part of the draft, its times and clauses, what is to be done.

    ``references`` gives, for each of its times, which moment of the execution the words say it is about;
    ``named`` are the times that are none of what is to be done, which ``remarks`` name; ``headed`` are the
    clauses of a line above, ``way`` is how long it takes to go there, and ``joints`` are the words that
    joined its times to others of the same thing; ``denial`` is what is said of the orders before it that one
    "don't" denies with it; ``doubted`` says that it is no instruction, and ``past`` that it tells what was.
    """

    part: Part
    phrases: tuple[Phrase, ...]
    clauses: tuple[Clause, ...]
    references: tuple[Reference | None, ...]
    operation: Operation | None = None
    parameters: tuple["FuzzyParameter", ...] = ()
    named: tuple[Phrase, ...] = ()
    remarks: tuple[Remark, ...] = ()
    headed: tuple[Clause, ...] = ()
    way: Duration | None = None
    joints: tuple[Span, ...] = ()
    denial: str = ""
    doubted: bool = False
    past: bool = False

    @property
    def heard(self) -> list[Span]:
        """The stretches of its times and clauses."""
        return [*(phrase.span for phrase in self.phrases), *(clause.span for clause in self.clauses)]

    @property
    def asks(self) -> bool:
        """Whether something is to be done, and is not only told or denied."""
        return self.operation is not None and self.operation.is_asked

    def under(self, phrases: Sequence[Phrase], clauses: Sequence[Clause] = ()) -> "Sketch":
        """Give the same with times and clauses from elsewhere before its own."""
        return replace(
            self,
            phrases=(*phrases, *self.phrases),
            clauses=(*clauses, *self.clauses),
            references=(*(None for _ in phrases), *self.references),
        )

    @property
    def reference(self) -> Reference | None:
        """What its clauses are about, where its times say so."""
        return self.references[0] if self.references else None


def text_between(first: Sketch, second: Sketch, text: str) -> str:
    """Give what stands between the parts of two sketches."""
    return text[first.part.segment.span[1] : second.part.segment.span[0]]


def sketch_of(draft: Draft, part: Part, lexicon: Lexicon) -> Sketch:
    """Sketch one part of a draft."""
    first, end = part.segment.span
    phrases = [phrase for phrase in draft.phrases if first <= phrase.span[0] and phrase.span[1] <= end]
    said = said_of_time(draft, part, phrases, lexicon)
    kept, clauses, left_out, excepted = said.phrases, said.clauses, said.left_out, said.remarks
    named = Sketch(
        part=part,
        phrases=tuple(kept),
        clauses=tuple(clauses),
        references=(None,) * len(kept),
        operation=telling_alone(draft, part) or _happening(draft, part, kept, clauses, lexicon),
        remarks=tuple(excepted),
    )
    if named.operation is not None or part.segment.verbless:
        return named
    meant = action_of(part.tree, lexicon, told=tells_more(part))
    action = _untimed(part, meant, kept, lexicon)
    if action is None or not (phrases or clauses or not says_how_things_are(part.tree, action.place)):
        return named
    verb = part.tree.nodes[action.place].start + part.offset
    if any(clause.span[0] < verb < clause.span[1] for clause in clauses) and part.segment.connective:
        # "…, then every two minutes until it thickens"
        return named
    things = of_things(part, kept, action)
    others = elsewhere(part, kept, action, lexicon, told=bool(clauses))
    things = [phrase for phrase in things if phrase not in others]
    told = ((aim_of(part, kept, action), "what it is for"), (reason_of(part, kept, action), "why"))
    aims = [(span, what) for span, what in told if span is not None]
    of_aims = [phrase for phrase in kept if any(overlap(phrase.span, aim) for aim, _ in aims)]
    for aim, what in aims:
        others, things = ([p for p in found if not overlap(p.span, aim)] for found in (others, things))
        kept = [phrase for phrase in kept if not overlap(phrase.span, aim)]
        clauses = [clause for clause in clauses if not overlap(clause.span, aim)]
        message = f"{draft.text[slice(*aim)]!r} is {what}, and not when to do it"
        excepted.append(Remark(RemarkKind.POLICY, aim, message))
    kept = [phrase for phrase in kept if phrase not in (*others, *things)]
    heard = [*(phrase.span for phrase in kept), *(clause.span for clause in clauses)]
    spans = (*heard, *left_out, *draft.unfinished, *(aim for aim, _ in aims), *(p.span for p in things))
    reader = Reader(part.tree, lexicon, [(a - part.offset, b - part.offset) for a, b in spans])
    operation = with_told(draft, part, as_remembered(reader.operation(action)))
    operation = of_which(draft.text, with_name(part, operation, action), things)
    clauses = [
        replace(clause, reference=_reference_at(part, clause.span, action, lexicon)) for clause in clauses
    ]
    a, b = operation.span
    if not operation.negated:
        kept = [by_that_day(phrase, clauses) for phrase in kept]
    references = [_reference(part, phrase, action, lexicon, clauses) for phrase in kept]
    if is_there(operation, lexicon):
        kept = [on_that_day(phrase) for phrase in kept]
    if not operation.negated and {operation.lemma, operation.phrase} & lexicon.moving:
        kept = [put_off(phrase) for phrase in kept]
    if _is_gone(operation, lexicon):
        references = [None if one is Reference.THROUGHOUT else one for one in references]
    if operation.stated:
        # "The shop is closed between ten and eleven" is so all that time.
        ranges = [isinstance(phrase.said.time, Range) for phrase in kept]
        references = [None if spans else one for one, spans in zip(references, ranges, strict=True)]
    return Sketch(
        part=part,
        phrases=tuple(kept),
        clauses=tuple(clauses),
        references=tuple(references),
        operation=replace(
            operation,
            span=(a + part.offset, b + part.offset),
            addressee=part.segment.addressee or operation.addressee,
        ),
        parameters=parameters_of(reader, action),
        named=tuple(sorted((*others, *things, *of_aims, *times_told(draft, part)), key=lambda p: p.span)),
        remarks=(*excepted, *(of_something_else(draft.text, phrase) for phrase in (*others, *things))),
    )


def _is_gone(operation: Operation, lexicon: Lexicon) -> bool:
    """Whether "leave" is to go: "leave the house between seven and eight" is no "leave the lamp on"."""
    if operation.phrase != LEAVE or operation.complement is not None:
        return False
    if operation.object is None:
        return operation.place is not None and operation.place.lower().startswith(("for ", "to "))
    return operation.place is None and operation.object.lower().split()[-1] in lexicon.beside.sites


def order_of(draft: Draft, part: Part) -> Order | None:
    """Give where an instruction comes among all: "first, open the windows", "make the coffee last"."""
    if part.segment.connective == Order.FIRST:
        return Order.FIRST
    first, end = part.segment.span
    return next((order for span, order in draft.orders if first <= span[0] < end), None)


def _happening(
    draft: Draft, part: Part, phrases: Sequence[Phrase], clauses: Sequence[Clause], lexicon: Lexicon
) -> Operation | None:
    """Give what happens at a time, or after something else, where no verb says what is to be done."""
    root = part.tree.root
    if not part.tree.nodes:
        return None
    timed = phrases or clauses
    places = [place for phrase in phrases for place in _at(part, phrase)]
    put = put_there(part.tree, places, lexicon)
    if put is not None and not part.segment.verbless:
        return _moved(put, part)
    due = {place for p in phrases for place in _at(part, p) if p.said.constraint is Constraint.BEFORE}
    moments = {place for p in phrases for place in _at(part, p) if p.said.preposition == "at"}
    so = due_by_then(part.tree, due, moments, places, lexicon)
    if so is not None and not clauses and not part.segment.verbless:
        return _moved(so, part)
    if part.segment.verbless or not timed:
        return None
    named = None if clauses else named_moment(part.tree, phrases, lexicon, part.offset)
    if named is not None:
        return _moved(named, part)
    if not happens(part.tree, phrases, lexicon):
        heard = [*places, *(place for clause in clauses for place in _at(part, clause))]
        deed = deed_at(part.tree, places, phrases, lexicon)
        deed = deed or chores_at(part.tree, heard, phrases, lexicon, led=bool(clauses))
        return None if deed is None else _moved(deed, part)
    if any(root in _at(part, phrase) for phrase in phrases if isinstance(phrase.said.time, TimeWord)):
        # "No rush, but …" is no rush hour.
        return None
    said = (*(p.span for p in phrases), *(clause.span for clause in clauses), *draft.unfinished)
    names = Reader(part.tree, lexicon, [(a - part.offset, b - part.offset) for a, b in said])
    found = happening_at(root, part.tree, phrases, names, lexicon)
    return _moved(found, part)


def _moved(operation: Operation, part: Part) -> Operation:
    """Give what a tree says its place in the text."""
    first, end = operation.span
    return replace(operation, span=(first + part.offset, end + part.offset))


def _at(part: Part, said: Phrase | Clause) -> Sequence[int]:
    """Give the places of a time, or of a clause about one, in the tree of a part."""
    return list(part.tree.at(said.span[0] - part.offset, said.span[1] - part.offset))


def _untimed(part: Part, action: Action | None, phrases: Sequence[Phrase], lexicon: Lexicon) -> Action | None:
    """Give the verb below one that is about time: "take your time peeling them", "spend an hour cleaning"."""
    closed = lexicon.closed
    if action is None:
        return None
    timed = {place for p in phrases for place in part.tree.at(*(a - part.offset for a in p.span))}
    denying = {place for place, node in enumerate(part.tree.nodes) if node.lower in closed.negators}
    if denying and denying <= timed:
        # "Not until next week call the plumber": it is the time that is denied.
        action = replace(action, negated=False)
    if any(
        part.tree.nodes[p].lower in closed.anaphors for p in part.tree.children(action.place, "nsubj", "expl")
    ):
        # "It takes twenty minutes to get there"
        return action
    nodes = enumerate(part.tree.nodes)
    verbs = (place for place, node in nodes if node.is_verb and place not in timed)
    taken = set(part.tree.children(action.place, "dobj"))
    # "Take the bins out tonight to help mum": it is no time that is taken.
    spends = part.tree.nodes[action.place].lemma in lexicon.doing.spent and taken <= timed
    spends = spends and not timed.isdisjoint(taken.union(part.tree.children(action.place, "npadvmod")))
    if spends:
        verbs = (place for place in verbs if place > action.place)
    found = next(verbs, None) if spends or action.place in timed else None
    return action if found is None else replace(action, place=found)


def _reference(
    part: Part, phrase: Phrase, action: Action, lexicon: Lexicon, clauses: Sequence[Clause]
) -> Reference | None:
    """Give which moment a time is about, by the verb nearest above it: "so that it finishes by noon"."""
    if phrase.rule in {DATED, DEADLINE}:
        # What its clause is about starts or ends then, not what is to be done.
        return action.reference
    if any(clause.kind in OVER | AHEAD and clause.span[1] + 1 == phrase.span[0] for clause in clauses):
        # "Lock up when everyone has left on friday"
        return action.reference
    if action.reference is Reference.FINISH and is_of_subject(part, phrase, action):
        # "Staff meeting at 3.30, should be done by half four"
        return None
    return _reference_at(part, phrase.span, action, lexicon)


def _reference_at(part: Part, span: Span, action: Action, lexicon: Lexicon) -> Reference | None:
    """Give which moment words in a stretch are about, by the verb nearest above them."""
    first, end = (place - part.offset for place in span)
    for place in part.tree.at(first, end):
        for above in part.tree.above(place):
            if above == action.place:
                return action.reference
            inside = first <= part.tree.nodes[above].start < end
            if part.tree.nodes[above].is_verb and not inside:
                return reference_of(part.tree, above, lexicon) or action.reference
    return action.reference
