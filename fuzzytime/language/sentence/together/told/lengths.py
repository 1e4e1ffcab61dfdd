"""Lengths and times that are told of another instruction: "it takes an hour", "it must be done by six"."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from fuzzytime.language.finding import ground_all
from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import words_of
from fuzzytime.language.instruction import Instruction, Operation, Remark, RemarkKind, Span
from fuzzytime.language.meaning.expressions import Duration
from fuzzytime.language.meaning.grounded.moment import Moment
from fuzzytime.language.meaning.joined.distances import later_by
from fuzzytime.language.meaning.required.requirements import Grounded
from fuzzytime.language.sentence.references.anchors import Anchors
from fuzzytime.language.sentence.segments.told.asides import Aside
from fuzzytime.language.sentence.sketches.sketch import Sketch
from fuzzytime.requirement import Anchor, Constraint, Reference, TimeRequirement

DONE = frozenset({Constraint.AT, Constraint.BEFORE, Constraint.BETWEEN})
"""How a time binds when something must be done."""


def length_of(
    operation: Operation | None, requirements: Sequence[TimeRequirement], text: str, anchors: Anchors
) -> Anchor | None:
    """Give the instruction of which another says how long it takes, and nothing else; None where it does not.

    The anchor has no target where no instruction so far is meant.
    """
    doing = anchors.lexicon.doing
    if operation is None or not requirements:
        return None
    if any(part.constraint is not Constraint.FOR for part in requirements):
        return None
    if not operation.stated:
        # "Soak the seeds, they have to soak for three hours"
        same = operation.again and anchors.is_same_as_before(operation)
        return Anchor(text=text, target=anchors.position - 1) if same else None
    if anchors.goes_on(operation):
        # "We're on at nine and play for an hour"
        return Anchor(text=text, target=anchors.position - 1)
    taking, running = doing.taking, doing.running
    anchor = anchors.lasting(operation.object, text) if operation.lemma in taking | running else None
    # What only runs was set going, or just happens.
    if anchor is None or (operation.lemma in running and anchor.target is None):
        return None
    return anchor


def time_of(
    operation: Operation | None, requirements: Sequence[TimeRequirement], text: str, anchors: Anchors
) -> Anchor | None:
    """Give the instruction of which another says when it must be done, and nothing else; None without one.

    The anchor has no target where all that was asked for is meant: "everything must be done by six".
    """
    closed = anchors.lexicon.closed
    if operation is None or operation.negated or not requirements:
        return None
    asked = (place for place in range(anchors.position - 1, -1, -1) if anchors.is_asked(place))
    target: int | None
    if _is_needed(operation, text, anchors.lexicon):
        same = (
            place
            for place in asked
            if (one := anchors.operation_at(place))
            and (not operation.again or one.object == operation.object)
        )
        bound = all(part.constraint in DONE and not part.anchor for part in requirements)
        target = next(same, None) if bound else None
        return None if target is None else Anchor(text=text, object=operation.object, target=target)
    if any(part.constraint not in DONE or not _may_bound(part) for part in requirements):
        return None
    # As in "friday: clean the oven".
    words = (text.removeprefix(requirements[0].text).lstrip(" :,–-") or text).lower().split()
    obliged = " ".join(words[:2]) in anchors.lexicon.beside.obliged
    if words[0] == operation.verb and not obliged:
        # "Empty the bins by six" asks for it.
        return None
    said = " ".join(filter(None, (operation.verb, operation.object, operation.complement))).lower().split()
    if anchors.lexicon.results.isdisjoint(said) and not _must_be_so(operation, words, anchors):
        return None
    if (
        words[0] in closed.wholes
        or words[:2] == ["the", "lot"]
        or (words[0] in closed.first_person and anchors.lexicon.beside.over.issuperset(said))
    ):
        # "We must be finished by six"
        return Anchor(text=text, object=operation.object)
    if words[0] in closed.anaphors | closed.universal_pronouns or obliged:
        target = next(asked, None)
    else:
        target = anchors.lasting(operation.object, text).target if operation.object else None
    if target is None or target >= anchors.position or not anchors.is_asked(target):
        return None
    return Anchor(text=text, object=operation.object, target=target)


def _must_be_so(operation: Operation, words: Sequence[str], anchors: Anchors) -> bool:
    """Whether what was asked for before must make it so, or be done: "paint it, it has to be dry by six"."""
    closed = anchors.lexicon.closed
    before = anchors.operation_at(anchors.position - 1) if anchors.position else None
    obliged = words[0] in closed.anaphors and closed.verbs_of_obligation.issuperset(words[1:2])
    if before is None or not before.is_asked or not obliged:
        return False
    is_so = operation.lemma == "be" and operation.place is None and operation.object is not None
    impersonal = anchors.lexicon.impersonal.issuperset((operation.object or "").lower().split())
    return before.lemma == operation.lemma or (is_so and not impersonal)


def _is_needed(operation: Operation | None, text: str, lexicon: Lexicon) -> bool:
    """Whether somebody needs then what was named before: "charge the bike, I need it at seven"."""
    if operation is None or operation.negated or operation.lemma not in lexicon.doing.needing:
        return False
    # "Ann needs them by five"
    said = pairwise(word.text for word in words_of(text))
    needing, things = lexicon.asides["needing"], lexicon.closed.anaphors
    return operation.again or any(verb in needing and thing in things for verb, thing in said)


def due_when_needed(
    requirements: list[TimeRequirement], operation: Operation | None, text: str, lexicon: Lexicon
) -> list[TimeRequirement]:
    """Give when something is needed as when it must be done at the latest."""
    if not _is_needed(operation, text, lexicon):
        return requirements
    at = {Constraint.AT, Constraint.BEFORE}
    return [
        replace(
            part, constraint=Constraint.BEFORE, earliest=None, reference=Reference.FINISH, reference_said=True
        )
        if part.constraint in at
        else part
        for part in requirements
    ]


def _may_bound(part: TimeRequirement) -> bool:
    """Whether it is a time, or before something that was told: "before the guests come"."""
    return part.anchor is None or (part.constraint is Constraint.BEFORE and not part.anchor.exact)


def second_ones(times: Sequence[Grounded]) -> Iterator[Remark]:
    """Say which lengths, and which repetitions, of one thing are not used: all that differ from the first."""
    lengths = [(one.requirement, one.duration) for one in times if one.duration is not None]
    series = [(one.requirement, one.recurrence) for one in times if one.recurrence is not None]
    for kind, said in (("lengths", lengths), ("repetitions", series)):
        for required, meant in said[1:]:
            if meant != said[0][1]:
                message = f"{required.text!r} is not used: of two {kind} of one thing, the first is taken"
                yield Remark(RemarkKind.POLICY, required.span, message)


def unknown_length(anchor: Anchor | None, span: Span) -> Iterator[Remark]:
    """Point at a length of which nothing is known."""
    if anchor is not None and anchor.target is None:
        message = f"{anchor.text!r} tells how long something takes, and no instruction so far is about that"
        yield Remark(RemarkKind.UNRESOLVED, span, message)


def lengths_in_front(asides: Sequence[Aside], first: int, text: str) -> Iterator[Remark]:
    """Point at lengths that are told before the ``first`` character of an order: "give it a week, then …"."""
    for aside in asides:
        if aside.span[1] <= first:
            yield from unknown_length(Anchor(text=text[slice(*aside.span)].strip(" .,!")), aside.span)


def told_alone(aside: Aside, text: str, given: int, moment: Moment) -> Instruction:
    """Give the length that is all that a line tells, of the last of the instructions ``given`` before it."""
    said, length = text[slice(*aside.span)], aside.length.said.time
    seconds = length.seconds if isinstance(length, Duration) else None
    return Instruction(
        span=aside.span,
        operation=None,
        requirements=ground_all((aside.length,), text, moment).requirements,
        duration=None if aside.way else seconds,
        length_of=Anchor(text=said.strip(" .,!"), target=given - 1 if given else None),
        way=seconds if aside.way else None,
        alone=aside.left,
    )


def waited(
    sketches: list[Sketch], asides: Sequence[Aside], given: Sequence[Operation | None]
) -> list[Sketch]:
    """Let the first instruction come as long after the last one ``given`` as its aside in front says.

    Where that one is done for so many minutes ("bake the bread"), the length may be its own: it is left.
    """
    if not sketches or not asides:
        return sketches
    (aside, *_), first = asides, sketches[0]
    segment, length = first.part.segment, aside.length.said.time
    leads = aside.span[1] <= segment.span[0] and segment.connective == "then" and not aside.way
    before = given[-1] if given else None
    cooked = before is not None and before.lemma in first.lexicon.timing | first.lexicon.timing_alone
    if not leads or cooked or not isinstance(length, Duration):
        return sketches
    waits = replace(aside.length, said=later_by(length), span=aside.span)
    segment = replace(segment, span=(aside.span[0], segment.span[1]), connective="")
    return [replace(first.under([waits]), part=replace(first.part, segment=segment)), *sketches[1:]]
