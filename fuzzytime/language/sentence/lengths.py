"""Lengths told afterwards, of what is done by another instruction: "bake the bread. It takes an hour"."""

from collections.abc import Iterator, Sequence

from fuzzytime.language.instruction import Operation, Remark, RemarkKind, Span
from fuzzytime.language.sentence.anchors import Anchors
from fuzzytime.language.sentence.operations import TAKING
from fuzzytime.requirement import Anchor, Constraint, TimeRequirement


def tells_length(operation: Operation | None, requirements: Sequence[TimeRequirement]) -> bool:
    """Whether an instruction says of another how long it takes, and nothing else."""
    told = operation is not None and operation.stated and operation.lemma in TAKING
    return told and bool(requirements) and all(part.constraint is Constraint.FOR for part in requirements)


def length_of(operation: Operation | None, text: str, anchors: Anchors) -> Anchor:
    """Give the instruction that such words are about; without a target none so far is."""
    return anchors.lasting(None if operation is None else operation.object, text)


def unknown_length(anchor: Anchor, span: Span) -> Iterator[Remark]:
    """Point at a length of which nothing is known."""
    if anchor.target is None:
        message = f"{anchor.text!r} tells how long something takes, and no instruction so far is about that"
        yield Remark(RemarkKind.UNRESOLVED, span, message)
