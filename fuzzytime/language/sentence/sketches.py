"""Instructions before they are grounded: operation, times and clauses of each part of a draft."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.instruction import Operation, Remark, RemarkKind, Span
from fuzzytime.language.meaning.expressions import (
    Duration,
    Edge,
    Offset,
    Phrase,
    Repeat,
    Said,
    TimeWord,
    Wall,
)
from fuzzytime.language.sentence.actions import Action, action_of, reference_of
from fuzzytime.language.sentence.amounts import parameters_of
from fuzzytime.language.sentence.clauses import Clause, clauses_of
from fuzzytime.language.sentence.cuts import AGAIN
from fuzzytime.language.sentence.drafts import Draft
from fuzzytime.language.sentence.operations import Reader
from fuzzytime.language.sentence.segments import ARTICLES
from fuzzytime.language.sentence.tree import Tree
from fuzzytime.language.sentence.waiting import Part
from fuzzytime.requirement import Constraint, Reference

if TYPE_CHECKING:
    from fuzzytime.skills import FuzzyParameter

ADDED = frozenset({"and", "&", ",", "again", "once", "more", "also"})
OFFERED = frozenset({"or"})
BOUNDS = {
    "when": (None, "at"),
    "before": (Constraint.BEFORE, "before"),
    "by the time": (Constraint.BEFORE, "by"),
    "until": (Constraint.BEFORE, "until"),
    "after": (Constraint.AFTER, "after"),
}
"""How the time of an event binds what is said to be at, before or after it."""

DATED = "clause"
"""The rule of a phrase that is a clause with a time of its own."""

STARTS = frozenset({None, Constraint.AT, Constraint.BETWEEN, Constraint.AFTER})
"""How a time binds that is about the first of two operations done in one go; a deadline is about the last."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Sketch:
    """One instruction: its part of the draft, its times and clauses, what is to be done.

    ``references`` gives, for each of its times, which moment of the execution the words say it is about.
    """

    part: Part
    phrases: tuple[Phrase, ...]
    clauses: tuple[Clause, ...]
    references: tuple[Reference | None, ...]
    operation: Operation | None = None
    parameters: tuple["FuzzyParameter", ...] = ()

    @property
    def reference(self) -> Reference | None:
        """What its clauses are about, where its times say so."""
        return self.references[0] if self.references else None


def sketches_of(draft: Draft, lexicon: Lexicon) -> tuple[list[Sketch], list[Remark]]:
    """Sketch the instructions of a draft; two times joined by "and" make two of one."""
    found: list[Sketch] = []
    remarks: list[Remark] = []
    sketches = _repeated(_led([_sketch(draft, part, lexicon) for part in draft.parts]), draft.text, lexicon)
    for whole in _shared(sketches, draft.text, lexicon):
        for phrases, dropped in _alternatives(draft, whole.phrases):
            kept = [whole.phrases.index(phrase) for phrase in phrases]
            found.append(replace(whole, phrases=phrases, references=tuple(whole.references[k] for k in kept)))
            for phrase in dropped:
                text = draft.text[slice(*phrase.span)]
                message = f"{text!r} is not used: of times joined by 'or', the first is taken"
                remarks.append(Remark(RemarkKind.POLICY, phrase.span, message))
    return found, remarks


def _led(sketches: list[Sketch]) -> list[Sketch]:
    """Give times that stand alone before "then" to what is done then: "not for ten minutes, but then …"."""
    led: list[Sketch] = []
    for sketch in sketches:
        before, segment = led[-1] if led else None, sketch.part.segment
        alone = before is not None and before.operation is None and bool(before.phrases)
        if before is not None and alone and segment.connective in {"then", "first"}:
            whole = (before.part.segment.span[0], segment.span[1])
            led[-1] = replace(
                sketch,
                part=replace(sketch.part, segment=replace(segment, span=whole, connective="")),
                phrases=(*before.phrases, *sketch.phrases),
                clauses=(*before.clauses, *sketch.clauses),
                references=(*(None for _ in before.phrases), *sketch.references),
            )
        else:
            led.append(sketch)
    return led


def _repeated(sketches: list[Sketch], text: str, lexicon: Lexicon) -> list[Sketch]:
    """Let a length of time alone behind "then" be of what was done before: "then five minutes on high"."""
    repeated: list[Sketch] = []
    for sketch in sketches:
        before, part = repeated[-1].operation if repeated else None, sketch.part
        first = part.tree.nodes[:1]
        lasts = any(phrase.said.constraint is Constraint.FOR for phrase in sketch.phrases)
        spans = ((node.start + part.offset, node.end + part.offset) for node in part.tree.nodes)
        said = [span for span in spans if not any(_overlap(span, p.span) for p in sketch.phrases)]
        rest = text[said[0][0] : said[-1][1]] if said else None
        turned = before is not None and sketch.phrases and _particle_alone(rest, lexicon)
        if before is not None and turned:
            repeated.append(replace(sketch, operation=replace(before, particle=turned)))
        elif (
            before is not None and sketch.phrases and rest is not None and set(rest.lower().split()) <= AGAIN
        ):
            # "Ring the bell at six, then again at seven"
            repeated.append(replace(sketch, operation=before))
        elif sketch.operation is not None or before is None:
            repeated.append(sketch)
        elif not sketch.phrases:
            # "Dust the hall, then the stairs"
            thing = part.segment.connective == "then" and first and first[0].lower in ARTICLES
            repeated.append(
                replace(sketch, operation=replace(before, object=rest, place=None))
                if thing and before.object is not None
                else sketch
            )
        elif part.segment.connective == "then" and lasts:
            repeated.append(replace(sketch, operation=replace(before, place=rest or before.place)))
        elif (
            rest is not None
            and before.object is not None
            and (part.segment.verbless or (first and first[0].lower in ARTICLES))
        ):
            # "Feed the cat at eight and the dog at nine"
            repeated.append(replace(sketch, operation=replace(before, object=rest, place=None)))
        else:
            repeated.append(sketch)
    return repeated


def _particle_alone(text: str | None, lexicon: Lexicon) -> str | None:
    """Give the particle that is all that is said of a verb: "switch it on at six and off again at eight"."""
    words = [] if text is None else text.lower().split()
    said = [word for word in words if word not in AGAIN]
    return said[0] if len(said) == 1 and said[0] in lexicon.particles else None


def _shared(sketches: list[Sketch], text: str, lexicon: Lexicon) -> list[Sketch]:
    """Let a verb alone share the object and the start of the next: "rinse and drain the rice at noon"."""
    shared = list(sketches)
    for place in range(len(shared) - 1, 0, -1):
        first, second = shared[place - 1], shared[place]
        if not second.part.segment.shares(text) or first.operation is None or second.operation is None:
            continue
        operation = first.operation
        if operation.object is None and operation.lemma not in lexicon.intransitive:
            operation = replace(operation, object=second.operation.object)
        first = replace(first, operation=operation)
        if not first.phrases and all(phrase.said.constraint in STARTS for phrase in second.phrases):
            first = replace(first, phrases=second.phrases, references=second.references)
            second = replace(second, phrases=(), references=())
        shared[place - 1 : place + 1] = [first, second]
    return shared


def _sketch(draft: Draft, part: Part, lexicon: Lexicon) -> Sketch:
    first, end = part.segment.span
    phrases = [phrase for phrase in draft.phrases if first <= phrase.span[0] and phrase.span[1] <= end]
    clauses: list[Clause] = []
    if part.front is not None:
        clauses += _clauses(draft, part.front, (first, part.offset), phrases, lexicon)
    if part.tree.nodes:
        clauses += _clauses(draft, part.tree, (part.offset, end), phrases, lexicon)
    clauses = [clause for clause in clauses if not any(_overlap(clause.content, u) for u in draft.unfinished)]
    kept = [phrase for phrase in phrases if not any(_overlap(phrase.span, c.span) for c in clauses)]
    kept += [_dated(draft, clause, clause.time) for clause in clauses if clause.time is not None]
    clauses = [clause for clause in clauses if clause.time is None]
    kept.sort(key=lambda phrase: phrase.span)
    action = None if part.segment.verbless else _untimed(part, action_of(part.tree, lexicon), kept)
    if action is None:
        references = (None,) * len(kept)
        return Sketch(part=part, phrases=tuple(kept), clauses=tuple(clauses), references=references)
    spans = (*(phrase.span for phrase in kept), *(clause.span for clause in clauses), *draft.unfinished)
    reader = Reader(part.tree, lexicon, [(a - part.offset, b - part.offset) for a, b in spans])
    operation = reader.operation(action)
    a, b = operation.span
    return Sketch(
        part=part,
        phrases=tuple(kept),
        clauses=tuple(clauses),
        references=tuple(_reference(part, phrase, action, lexicon) for phrase in kept),
        operation=replace(
            operation,
            span=(a + part.offset, b + part.offset),
            addressee=part.segment.addressee or operation.addressee,
        ),
        parameters=parameters_of(reader, action),
    )


def _untimed(part: Part, action: Action | None, phrases: Sequence[Phrase]) -> Action | None:
    """Give the verb below one that is about time itself: "take your time peeling the potatoes"."""
    if action is None:
        return None
    timed = {place for p in phrases for place in part.tree.at(*(a - part.offset for a in p.span))}
    nodes = enumerate(part.tree.nodes)
    verbs = (place for place, node in nodes if node.is_verb and place not in timed)
    found = next(verbs, None) if action.place in timed else None
    return action if found is None else replace(action, place=found)


def _dated(draft: Draft, clause: Clause, time: Phrase) -> Phrase:
    """Give the time of an event that has one: "before the guests arrive at seven" is before seven."""
    constraint, preposition = BOUNDS[clause.kind]
    said = replace(time.said, constraint=constraint, preposition=preposition, edge=Edge.START)
    if clause.distance is not None and isinstance(time.said.time, Wall):
        direction = 1 if constraint is Constraint.AFTER else -1
        distance = Offset(replace(clause.distance, hedges=()), direction, time.said.time)
        said = Said(distance, None, None, clause.distance.hedges)
    places = [
        place
        for place, word in enumerate(draft.scanned.words)
        if clause.span[0] <= word.start < clause.span[1]
    ]
    return Phrase(said, places[0], places[-1] + 1, clause.span, DATED)


def _overlap(one: Span, other: Span) -> bool:
    return one[0] < other[1] and other[0] < one[1]


def _reference(part: Part, phrase: Phrase, action: Action, lexicon: Lexicon) -> Reference | None:
    """Give which moment a time is about, by the verb nearest above it: "so that it finishes by noon"."""
    if phrase.rule == DATED:
        # What its clause is about starts or ends then, not what is to be done.
        return action.reference
    first, end = (place - part.offset for place in phrase.span)
    for place in part.tree.at(first, end):
        for above in part.tree.above(place):
            if above == action.place:
                return action.reference
            if part.tree.nodes[above].is_verb:
                return reference_of(part.tree, above, lexicon) or action.reference
    return action.reference


def _clauses(
    draft: Draft, tree: Tree, span: Span, phrases: Sequence[Phrase], lexicon: Lexicon
) -> list[Clause]:
    """Give the clauses in a tree's stretch of text, with places in the whole text."""
    offset, end = span
    places = [place for place, word in enumerate(draft.scanned.words) if offset <= word.start < end]
    start = places[0] if places else 0
    words = [draft.scanned.words[place] for place in places]
    local_words = [replace(word, start=word.start - offset, end=word.end - offset) for word in words]
    local, named = (
        [
            replace(
                p, first=p.first - start, end=p.end - start, span=(p.span[0] - offset, p.span[1] - offset)
            )
            for p in found
            if offset <= p.span[0] < end
        ]
        for found in (phrases, draft.naming)
    )
    return [clause.moved(offset) for clause in clauses_of(tree, local_words, local, lexicon, named)]


# -- several times --------------------------------------------------------------------------------------


def _alternatives(
    draft: Draft, phrases: tuple[Phrase, ...]
) -> list[tuple[tuple[Phrase, ...], tuple[Phrase, ...]]]:
    """Give the times of each instruction that is meant, with those that are left out.

    "At seven and at six" asks for two, "at seven or at eight" for one; "tomorrow, by noon" is one time.
    """
    for place in range(len(phrases) - 1):
        group = [phrases[place]]
        joints: set[str] = set()
        for following in phrases[place + 1 :]:
            between = {word.text for word in draft.scanned.words[group[-1].end : following.first]}
            if not between or between - ADDED - OFFERED or not (_is_when(group[-1]) and _is_when(following)):
                break
            group.append(following)
            joints |= between
        if len(group) > 1 and joints & (ADDED | OFFERED) - {","}:
            rest = tuple(phrase for phrase in phrases if phrase not in group)
            if joints & OFFERED:
                return [((*rest, group[0]), tuple(group[1:]))]
            return [(tuple(sorted((*rest, one), key=lambda phrase: phrase.span)), ()) for one in group]
    return [(phrases, ())]


def _is_when(phrase: Phrase) -> bool:
    """Whether it is a time at which something may be done, and not a bound, a length or a repetition."""
    said = phrase.said
    if isinstance(said.time, (Duration, TimeWord)):
        return (said.constraint or getattr(said.time, "constraint", None)) is Constraint.AT
    return said.constraint in {None, Constraint.AT, Constraint.BETWEEN} and not isinstance(said.time, Repeat)
