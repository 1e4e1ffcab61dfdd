"""Times of one instruction that stand for each other, or exclude each other."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from fuzzytime.language.instruction import Operation, Remark, RemarkKind, Span
from fuzzytime.requirement import BOUNDS, SAID_WHEN, Constraint, TimeRequirement

BINDING = SAID_WHEN | BOUNDS
"""How a time binds that may exclude another."""


def not_used(text: str, span: Span) -> Remark:
    """Say that a time which "or" joins to another is left out."""
    return Remark.noted(text, span, "is not used: of times joined by 'or', the first is taken")


def offered(
    requirements: Sequence[TimeRequirement], operation: Operation | None, text: str
) -> tuple[list[TimeRequirement], list[Remark]]:
    """Give what is required with the alternatives that can be, and say which are left out.

    Nothing stands for a time that counts from another instruction, and of what happens nobody chooses.
    Bounds that do not exclude each other hold both: of "before seven in the morning or after ten at night"
    the hours between.
    """
    found: list[TimeRequirement] = []
    remarks: list[Remark] = []
    for requirement in requirements:
        if not requirement.alternative or not found:
            found.append(replace(requirement, alternative=False))
            continue
        first = found[-1]
        stated = operation is not None and operation.stated
        if stated:
            remarks.append(not_used(text, requirement.span))
            continue
        bounded = {first.constraint, requirement.constraint} == BOUNDS
        alternative = not requirement.denied and (not bounded or _is_apart(first, requirement))
        found.append(replace(requirement, alternative=alternative))
        if Constraint.WHEN in {first.constraint, requirement.constraint}:
            remarks.append(_where_nothing_tells(first, requirement))
    return found, [*remarks, *_contradictions(found)]


def _where_nothing_tells(first: TimeRequirement, second: TimeRequirement) -> Remark:
    """Say which of two times is kept where nothing tells of the other, which is what must be so."""
    state, time = (first, second) if first.constraint is Constraint.WHEN else (second, first)
    message = f"{time.text!r} is kept where nothing tells {state.text!r}"
    return Remark(RemarkKind.POLICY, state.span, message)


def _contradictions(requirements: Sequence[TimeRequirement]) -> Iterator[Remark]:
    """Point at a second time that excludes the first, for the same thing: "at six … at eight"."""
    said: list[list[TimeRequirement]] = []
    for requirement in requirements:
        if requirement.alternative and said:
            said[-1].append(requirement)
        elif requirement.constraint in BINDING and requirement.anchor is None:
            said.append([requirement])
    for place, others in enumerate(said):
        other = others[0]
        for first, *more in said[:place]:
            if all(_excludes(one, another) for one in (first, *more) for another in others):
                message = f"{other.text!r} is another time than {first.text!r}, for the same thing to be done"
                yield Remark(RemarkKind.NOT_UNDERSTOOD, other.span, message)
                break


def _excludes(first: TimeRequirement, other: TimeRequirement) -> bool:
    """Whether what is done at one time of two is not done at the other."""
    # "As early as possible, but not before eight"
    sooner = Constraint.AFTER in {first.constraint, other.constraint} and (first.word or other.word)
    return not sooner and other.reference is first.reference and _is_apart(first, other)


def _is_apart(one: TimeRequirement, other: TimeRequirement) -> bool:
    """Whether no moment is in both."""
    starts = [time for time in (one.earliest, other.earliest) if time is not None]
    ends = [time for time in (one.latest, other.latest) if time is not None]
    return bool(starts) and bool(ends) and max(starts) > min(ends)
