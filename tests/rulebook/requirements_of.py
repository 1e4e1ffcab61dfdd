"""Requirements as the language station gives them, made by hand."""

from typing import Any

from fuzzytime.requirement import Condition, Constraint, TimeRequirement, Unit

SIZES = {Unit.SECOND: 1.0, Unit.MINUTE: 60.0, Unit.HOUR: 3600.0}


def said(constraint: Constraint, text: str = "", **fields: Any) -> TimeRequirement:  # noqa: ANN401
    return TimeRequirement(text=text, span=(0, len(text)), constraint=constraint, **fields)


def ahead(preposition: str, number: float, unit: Unit = Unit.MINUTE, *hedges: str) -> TimeRequirement:
    """ "In about ten minutes" and its like: a preposition, hedges, a number and a unit."""
    constraints = {
        "after": Constraint.AFTER,
        "before": Constraint.BEFORE,
        "before the next": Constraint.BEFORE,
    }
    return said(
        constraints.get(preposition, Constraint.AT),
        preposition=preposition,
        fuzziness=hedges,
        number=number,
        unit=unit,
        t_spec=number * SIZES[unit],
    )


def word(text: str, *hedges: str) -> TimeRequirement:
    return said(Constraint.VAGUE, text, word=text, fuzziness=hedges)


def when(
    text: str,
    subject: str | None = None,
    what: str | None = None,
    *hedges: str,
    preposition: str = "when",
    negated: bool = False,
) -> TimeRequirement:
    """ "When the pan is hot": a condition with its subject and what is said of it."""
    condition = Condition(text=text, subject=subject, word=what, hedges=hedges, negated=negated)
    return said(Constraint.WHEN, text, preposition=preposition, condition=condition)
