"""What later rule files change under the rows of earlier ones: units, terms, and what is an event."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from types import MappingProxyType

from fuzzytime.context.units import convert
from fuzzytime.errors import FuzzytimeError
from fuzzytime.rulebook.logic.formula import Is, nodes
from fuzzytime.rulebook.tables.contents import Tables
from fuzzytime.rulebook.tables.variables import Source, Term, Variable
from fuzzytime.rulebook.tables.vocabulary import Vocabulary


@dataclass(frozen=True, slots=True)
class Clash:
    """A row of a later file, by section and name, that an earlier row cannot live with, and why."""

    section: str
    name: str
    message: str


def clashes(tables: Tables, names: Vocabulary) -> Iterator[Clash]:
    """Find what rows of earlier files miss where those of later ones were laid over them.

    ``names`` are those that all files declare, whatever mistakes their rows have.
    """
    refused = dict[str, str]()
    for variable in tables.variables.values():
        reason = _why_refused(variable, names)
        if reason:
            refused.setdefault(variable.signal, reason)
    for signal, reason in refused.items():
        yield Clash("signals", signal, reason)
    missed: dict[tuple[str, str], list[str]] = {}
    for rule in tables.rules.values():
        for atom in nodes(rule.condition) if rule.condition is not None else ():
            if isinstance(atom, Is) and atom.term not in names.terms[atom.variable]:
                missed.setdefault((atom.variable, atom.term), []).append(f"{rule.name!r} ({rule.place})")
    for (variable_name, term), rules in missed.items():
        asking = f"the rule {rules[0]} asks" if len(rules) == 1 else f"the rules {' and '.join(rules)} ask"
        yield Clash("variables", variable_name, f"must have the term {term!r}, for which {asking}")


def _why_refused(variable: Variable, names: Vocabulary) -> str:
    """Say what a signal must be for a variable to look at it; nothing where it is."""
    who = f"the variable {variable.name!r} ({variable.place})"
    event = variable.signal in names.events
    if event and variable.source is not Source.SINCE:
        return f"must not be an event, as {who} looks at its values"
    if not event and variable.source is Source.SINCE:
        return f"must be an event, as {who} counts from it"
    try:
        in_unit(variable, names.units.get(variable.signal))
    except FuzzytimeError:
        return f"must be measured in what converts to {variable.unit!r}, as {who} is"
    return ""


def in_units_of_signals(tables: Tables) -> Tables:
    """Give the tables with the terms of each variable in the unit that its signal has."""
    variables = {
        name: in_unit(variable, tables.signals[variable.signal].unit)
        if variable.signal in tables.signals
        else variable
        for name, variable in tables.variables.items()
    }
    return replace(tables, variables=MappingProxyType(variables))


def in_unit(variable: Variable, unit: str | None) -> Variable:
    """Give a variable with its terms in another unit of its signal.

    Raises
    ------
    FuzzytimeError
        If the unit does not measure the same.
    """
    before = variable.unit
    if before == unit or variable.source is Source.SINCE:
        return variable
    if before is None or unit is None:
        raise FuzzytimeError(f"a value in {before!r} cannot be converted to {unit!r}")
    zero = convert(0.0, before, unit) if variable.source is Source.RATE_OF else 0.0

    def converted(term: Term) -> Term:
        rise, full, end, fall = (convert(corner, before, unit) - zero for corner in term.corners)
        return replace(term, corners=(rise, full, end, fall))

    terms = {name: converted(term) for name, term in variable.terms.items()}
    return replace(variable, unit=unit, terms=MappingProxyType(terms))
