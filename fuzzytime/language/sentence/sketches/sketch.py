"""One instruction before it is grounded: its part of a draft, its times and clauses, what is to be done."""

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation, Order, Remark, Span
from fuzzytime.language.meaning.expressions import Duration, Phrase, Repeat, Said
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.segments.drafts import Draft
from fuzzytime.language.sentence.segments.further.same_doers import are_joints, tells_more
from fuzzytime.language.sentence.segments.waiting import Part
from fuzzytime.language.sentence.sketches.happening import happening, moved_to_new_time
from fuzzytime.language.sentence.sketches.its_times.own_times import own_times
from fuzzytime.language.sentence.sketches.its_times.referred import referred
from fuzzytime.language.sentence.sketches.its_times.said_of_time import SaidOfTime, said_of_time
from fuzzytime.language.sentence.sketches.telling import of_which, telling_alone, with_name, with_told
from fuzzytime.language.sentence.trees.named import topic_of
from fuzzytime.language.sentence.verbs.meant.actions import Action, action_of, says_how_things_are
from fuzzytime.language.sentence.verbs.operations.amounts import parameters_of
from fuzzytime.language.sentence.verbs.operations.operations import Reader
from fuzzytime.requirement import Constraint, Reference

if TYPE_CHECKING:
    from fuzzytime.skills import FuzzyParameter


@dataclass(frozen=True, slots=True, kw_only=True)
class Sketch:
    """One instruction: its part of the draft, its times and clauses, what is to be done.

    ``references`` gives, for each of its times, which moment of the execution the words say it is about;
    ``named`` are the times that are none of what is to be done, which ``remarks`` name; ``headed`` are the
    clauses of a line above, ``way`` is how long it takes to go there, and ``joints`` are the words that
    joined its times to others of the same thing, or are times of what is done before it; ``denial`` is what
    is said of the orders before it that one "don't" denies with it; ``again`` is how many times what stands
    before it is done again; ``doubted`` says that it is no instruction, and ``past`` that it tells what was.
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
    again: int | None = None
    doubted: bool = False
    past: bool = False

    @property
    def lexicon(self) -> Lexicon:
        """The words of its language."""
        return self.part.lexicon

    @property
    def heard(self) -> list[Span]:
        """The stretches of its times and clauses."""
        return [*(phrase.span for phrase in self.phrases), *(clause.span for clause in self.clauses)]

    @property
    def asks(self) -> bool:
        """Whether something is to be done, and is not only told or denied."""
        return self.operation is not None and self.operation.is_asked

    @property
    def times(self) -> list[Phrase]:
        """Its times that say when, and not for how long."""
        return [phrase for phrase in self.phrases if phrase.said.constraint is not Constraint.FOR]

    @property
    def is_open(self) -> bool:
        """Whether something is asked for, and not when."""
        return self.asks and not self.clauses and not self.times

    @property
    def repeats(self) -> bool:
        """Whether one of its times is a repetition."""
        return any(isinstance(phrase.said.time, Repeat) for phrase in self.phrases)

    def keeping(self, keeps: Callable[[Phrase], bool]) -> "Sketch":
        """Give the same with some of its times."""
        kept = [place for place, phrase in enumerate(self.phrases) if keeps(phrase)]
        return replace(
            self,
            phrases=tuple(self.phrases[place] for place in kept),
            references=tuple(self.references[place] for place in kept),
        )

    def without_times(self) -> "Sketch":
        """Give the same without its times, which are of what is done before it."""
        spans = tuple(phrase.span for phrase in self.phrases)
        return replace(self, phrases=(), references=(), joints=(*self.joints, *spans))

    def also(self, *phrases: Phrase, about: Reference | None = None) -> "Sketch":
        """Give the same with further times behind its own."""
        references = (*self.references, *(about for _ in phrases))
        return replace(self, phrases=(*self.phrases, *phrases), references=references)

    def telling(self, phrases: Collection[Phrase], told: Said) -> "Sketch":
        """Give the same, where some of its times say together what is told."""
        return replace(
            self,
            phrases=tuple(
                replace(phrase, said=phrase.said.borrowing(told)) if phrase in phrases else phrase
                for phrase in self.phrases
            ),
        )

    def reaching(self, other: "Sketch") -> "Sketch":
        """Give the same up to the end of another."""
        segment = self.part.segment
        whole = replace(segment, span=(segment.span[0], other.part.segment.span[1]))
        return replace(self, part=replace(self.part, segment=whole))

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


STOP = ";"
"""What stands between two steps that are told apart, in place of their joint."""


def are_steps(first: Sketch, second: Sketch, text: str, apart: str) -> bool:
    """Whether two sketches are steps that a text joins, and that its stops tell ``apart``: "maths, break"."""
    joined = are_joints(text_between(first, second, text), first.lexicon)
    return joined and text_between(first, second, apart).strip() == STOP


def sketch_of(draft: Draft, part: Part) -> Sketch:
    """Sketch one part of a draft."""
    first, end = part.segment.span
    phrases = [phrase for phrase in draft.phrases if first <= phrase.span[0] and phrase.span[1] <= end]
    said = said_of_time(draft, part, phrases)
    named = Sketch(
        part=part,
        phrases=tuple(said.phrases),
        clauses=tuple(said.clauses),
        references=(None,) * len(said.phrases),
        operation=telling_alone(draft, part) or happening(draft, part, said.phrases, said.clauses),
        remarks=tuple(said.remarks),
    )
    moved = moved_to_new_time(part, said.phrases)
    if moved is not None:
        return replace(named, operation=moved)
    if named.operation is not None or part.segment.verbless:
        return named
    action = _action_of(part, said, timed=bool(phrases or said.clauses))
    return named if action is None else _asked(draft, part, said, action)


def _action_of(part: Part, said: SaidOfTime, *, timed: bool) -> Action | None:
    """Give the verb that says what is to be done; None where none does."""
    action = _untimed(part, action_of(part.tree, told=tells_more(part)), said.phrases)
    if action is None or not (timed or not says_how_things_are(part.tree, action.place)):
        return None
    verb = part.tree.nodes[action.place].start + part.offset
    # "…, then every two minutes until it thickens", "a short walk before the nurse comes at eleven"
    spans = (*(clause.span for clause in said.clauses), *(phrase.span for phrase in said.phrases))
    return None if any(first < verb < end for first, end in spans) else action


def _asked(draft: Draft, part: Part, said: SaidOfTime, action: Action) -> Sketch:
    """Sketch a part whose verb says what is to be done, with the times that are about that."""
    times = own_times(draft, part, said, action)
    reader = Reader(part.tree, [part.local(span) for span in times.covered])
    operation = with_told(draft, part, as_remembered(reader.operation(action)))
    operation = of_which(draft.text, with_name(part, operation, action), times.of_things)
    topic = topic_of(part.tree)
    operation = operation if topic is None else replace(operation, object=topic)
    phrases, clauses, references = referred(part, times, action, operation)
    return Sketch(
        part=part,
        phrases=phrases,
        clauses=clauses,
        references=references,
        operation=replace(
            operation.moved(part.offset), addressee=part.segment.addressee or operation.addressee
        ),
        parameters=parameters_of(reader, action),
        named=times.named,
        remarks=times.remarks,
    )


def order_of(draft: Draft, part: Part) -> Order | None:
    """Give where an instruction comes among all: "first, open the windows", "make the coffee last"."""
    if part.segment.connective == Order.FIRST:
        return Order.FIRST
    first, end = part.segment.span
    return next((order for span, order in draft.orders if first <= span[0] < end), None)


def _untimed(part: Part, action: Action | None, phrases: Sequence[Phrase]) -> Action | None:
    """Give the verb below one that is about time: "take your time peeling them", "spend an hour cleaning"."""
    closed = part.lexicon.closed
    if action is None:
        return None
    timed = {place for p in phrases for place in part.at(p.span)}
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
    spends = part.tree.nodes[action.place].lemma in part.lexicon.doing.spent and taken <= timed
    spends = spends and not timed.isdisjoint(taken.union(part.tree.children(action.place, "npadvmod")))
    if spends:
        verbs = (place for place in verbs if place > action.place)
    found = next(verbs, None) if spends or action.place in timed else None
    return action if found is None else replace(action, place=found)


def as_remembered(operation: Operation) -> Operation:
    """Give what "don't forget" asks for where it names a thing, and no verb: to remember it.

    "Don't forget" alone names nothing to be done.
    """
    named = operation.object is not None or operation.place is not None
    if operation.lemma != "forget" or not operation.negated or operation.stated or not named:
        return operation
    return replace(operation, verb="remember", lemma="remember", negated=False)
