"""Which signals a requirement looks at, read or not: those whose next reading may change its ψ."""

from collections.abc import Iterator
from dataclasses import replace

from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.rulebook.resolving.beside import measured_from_event
from fuzzytime.rulebook.resolving.evidence import signals_of
from fuzzytime.rulebook.resolving.inference import matching
from fuzzytime.rulebook.tables.contents import Tables
from fuzzytime.rulebook.wording.sentences import condition_of, may_be_about, understand


def signals_for(requirement: TimeRequirement, verb: str | None, tables: Tables) -> frozenset[str]:
    """Give the signals and events of a requirement's own condition and of the rules that speak about it."""
    return frozenset(_signals(requirement, verb, tables))


def _signals(requirement: TimeRequirement, verb: str | None, tables: Tables) -> Iterator[str]:
    for rule in matching(requirement, verb, tables):
        if rule.condition is not None:
            yield from signals_of(rule.condition, tables)
    if requirement.condition is not None:
        own = understand(requirement.condition, tables)
        if own.formula is not None:
            yield from signals_of(own.formula, own.tables)
        else:
            yield from may_be_about(requirement.condition, tables)
    anchor = measured_from_event(requirement, tables).anchor
    if anchor is not None and anchor.target is None:
        # A time beside an event or a state is resolved as the clause that names it.
        clause = condition_of(anchor)
        yield from _signals(
            replace(requirement, constraint=Constraint.WHEN, condition=clause, anchor=None), verb, tables
        )
