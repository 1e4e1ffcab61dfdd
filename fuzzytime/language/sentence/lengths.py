"""Lengths told afterwards, of what is done by another instruction: "bake the bread. It takes an hour"."""

from collections.abc import Iterator, Sequence

from fuzzytime.language.instruction import Operation, Remark, RemarkKind, Span
from fuzzytime.language.sentence.anchors import Anchors
from fuzzytime.language.sentence.operations import GOING, TAKING
from fuzzytime.requirement import Anchor, Constraint, TimeRequirement


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


def unknown_length(anchor: Anchor | None, span: Span) -> Iterator[Remark]:
    """Point at a length of which nothing is known."""
    if anchor is not None and anchor.target is None:
        message = f"{anchor.text!r} tells how long something takes, and no instruction so far is about that"
        yield Remark(RemarkKind.UNRESOLVED, span, message)
