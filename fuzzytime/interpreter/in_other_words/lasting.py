"""How long a condition must have held: "when the pan has been hot for two minutes"."""

from dataclasses import replace

from fuzzytime.language import find_times
from fuzzytime.requirement import Constraint, Lasting, TimeRequirement


def with_lasting(requirement: TimeRequirement) -> TimeRequirement:
    """Give a requirement whose clause says for how long, with that length read."""
    anchor, condition = requirement.anchor, requirement.condition
    if condition is not None:
        return replace(requirement, condition=replace(condition, lasting=_lasting(condition.text)))
    if anchor is not None and anchor.target is None:
        return replace(requirement, anchor=replace(anchor, lasting=_lasting(anchor.text)))
    return requirement


def _lasting(text: str) -> Lasting | None:
    """Read the last "for …" of a clause, where a length of time stands behind it."""
    _, preposition, rest = text.rpartition(" for ")
    said = find_times(f"for {rest}", None).requirements if preposition else ()
    for part in said[:1]:
        if part.constraint is Constraint.FOR and part.number is not None and part.unit is not None:
            return Lasting(part.number, part.unit, part.fuzziness)
    return None
