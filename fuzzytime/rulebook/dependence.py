"""Which signals a requirement looks at, read or not: those whose next reading may change its ψ."""

from collections.abc import Iterator
from dataclasses import replace

from fuzzytime.requirement import Condition, Constraint, TimeRequirement
from fuzzytime.rulebook.beside import measured_from_event
from fuzzytime.rulebook.formula import Formula
from fuzzytime.rulebook.inference import matching, signals_of
from fuzzytime.rulebook.sentences import understand
from fuzzytime.rulebook.tables import Tables


def signals_for(requirement: TimeRequirement, verb: str | None, tables: Tables) -> frozenset[str]:
    """Give the signals and events of a requirement's own condition and of the rules that speak about it."""
    return frozenset(
        name for formula in _formulas(requirement, verb, tables) for name in signals_of(formula, tables)
    )


def _formulas(requirement: TimeRequirement, verb: str | None, tables: Tables) -> Iterator[Formula]:
    for rule in matching(requirement, verb, tables):
        if rule.condition is not None:
            yield rule.condition
    if requirement.condition is not None:
        own = understand(requirement.condition, tables).formula
        if own is not None:
            yield own
    anchor = measured_from_event(requirement, tables).anchor
    if anchor is not None and anchor.target is None:
        # A time beside an event or a state is resolved as the clause that names it.
        clause = Condition(text=anchor.text)
        yield from _formulas(
            replace(requirement, constraint=Constraint.WHEN, condition=clause, anchor=None), verb, tables
        )
