"""Times of one instruction that exclude each other."""

from collections.abc import Iterator, Sequence

from fuzzytime.language.instruction import Remark, RemarkKind
from fuzzytime.requirement import Constraint, TimeRequirement

SAID_WHEN = frozenset({Constraint.AT, Constraint.BETWEEN})
"""How a time binds that says when something is done."""

BINDING = SAID_WHEN | {Constraint.BEFORE, Constraint.AFTER}
"""How a time binds that may exclude another."""


def contradictions(requirements: Sequence[TimeRequirement]) -> Iterator[Remark]:
    """Point at a second time that excludes the first, for the same thing: "at six … at eight"."""
    said = [r for r in requirements if r.constraint in BINDING and r.anchor is None]
    for place, other in enumerate(said):
        for first in said[:place]:
            sooner = Constraint.AFTER in {first.constraint, other.constraint} and (first.word or other.word)
            # "As early as possible, but not before eight"
            if not sooner and other.reference is first.reference and _is_apart(first, other):
                message = f"{other.text!r} is another time than {first.text!r}, for the same thing to be done"
                yield Remark(RemarkKind.NOT_UNDERSTOOD, other.span, message)
                break


def _is_apart(one: TimeRequirement, other: TimeRequirement) -> bool:
    """Whether no moment is in both."""
    starts = [time for time in (one.earliest, other.earliest) if time is not None]
    ends = [time for time in (one.latest, other.latest) if time is not None]
    return bool(starts) and bool(ends) and max(starts) > min(ends)
