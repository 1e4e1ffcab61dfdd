"""Lengths and times that are told of another instruction: "it takes an hour", "it must be done by six"."""

from collections.abc import Iterator, Sequence

from fuzzytime.language.instruction import Operation, Remark, RemarkKind, Span
from fuzzytime.language.sentence.anchors import Anchors
from fuzzytime.language.sentence.operations import GOING
from fuzzytime.language.sentence.references import ALL, PRONOUNS
from fuzzytime.language.sentence.statements import TAKING
from fuzzytime.requirement import Anchor, Constraint, TimeRequirement

DONE = frozenset({Constraint.AT, Constraint.BEFORE, Constraint.BETWEEN})
"""How a time binds when something must be done."""


def length_of(
    operation: Operation | None, requirements: Sequence[TimeRequirement], text: str, anchors: Anchors
) -> Anchor | None:
    """Give the instruction of which another says how long it takes, and nothing else; None where it does not.

    The anchor has no target where no instruction so far is meant.
    """
    if operation is None or not operation.stated or not requirements:
        return None
    if any(part.constraint is not Constraint.FOR for part in requirements):
        return None
    anchor = anchors.lasting(operation.object, text) if operation.lemma in TAKING | GOING else None
    if anchor is None or (operation.lemma in GOING and anchor.target is None):
        return None
    return anchor


def time_of(
    operation: Operation | None, requirements: Sequence[TimeRequirement], text: str, anchors: Anchors
) -> Anchor | None:
    """Give the instruction of which another says when it must be done, and nothing else; None without one."""
    if operation is None or operation.negated or not requirements or anchors.position == 0:
        return None
    if any(part.constraint not in DONE or part.anchor is not None for part in requirements):
        return None
    if text.split(maxsplit=1)[0].lower() == operation.verb:
        # "Empty the bins by six" asks for it.
        return None
    said = " ".join(filter(None, (operation.verb, operation.object, operation.complement))).lower().split()
    if anchors.lexicon.results.isdisjoint(said):
        return None
    if text.split(maxsplit=1)[0].lower() in PRONOUNS | ALL:
        target: int | None = anchors.position - 1
    else:
        target = anchors.lasting(operation.object, text).target if operation.object else None
    if target is None or target >= anchors.position or not anchors.is_asked(target):
        return None
    return Anchor(text=text, object=operation.object, target=target)


def unknown_length(anchor: Anchor | None, span: Span) -> Iterator[Remark]:
    """Point at a length of which nothing is known."""
    if anchor is not None and anchor.target is None:
        message = f"{anchor.text!r} tells how long something takes, and no instruction so far is about that"
        yield Remark(RemarkKind.UNRESOLVED, span, message)
