"""On which side of what it names a clause binds what is to be done."""

from fuzzytime.language.sentence.clause import Clause
from fuzzytime.requirement import Constraint

FIRST = frozenset({"before", "until", "by the time"})
"""Clauses whose instruction comes first."""

BINDING = {"while": Constraint.AT, "within": Constraint.BETWEEN}
"""Clauses that are neither before nor after alone."""


def side_of(clause: Clause) -> Constraint:
    """Give on which side of what it names a clause binds; within a time after it where that is bound."""
    before = clause.kind in FIRST
    if clause.side is not None and (before or clause.side is Constraint.AFTER):
        return clause.side
    if clause.side is not None:
        return Constraint.BETWEEN
    return BINDING.get(clause.kind, Constraint.BEFORE if before else Constraint.AFTER)
