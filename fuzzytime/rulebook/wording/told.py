"""The reading under which is so what somebody tells: "the pan is hot", "the timer rings"."""

import math

from fuzzytime.context import Context, Reading
from fuzzytime.requirement import Condition
from fuzzytime.rulebook.logic.formula import Happened, Is, Not
from fuzzytime.rulebook.tables.contents import Tables
from fuzzytime.rulebook.tables.variables import Source, Term
from fuzzytime.rulebook.wording.sentences import understand


def reading_told(condition: Condition, tables: Tables, context: Context) -> Reading | None:
    """Give the reading, now, under which a condition holds; None where no single one makes it so.

    What is hot is taken as just hot, what is told in numbers as these, and an event as happening.
    """
    understood = understand(condition, tables, context)
    formula = understood.formula
    if isinstance(formula, Happened):
        return Reading(formula.event, 0.0)
    denied = isinstance(formula, Not)
    atom = formula.part if isinstance(formula, Not) else formula
    if not isinstance(atom, Is):
        return None
    variable = understood.tables.variables[atom.variable]
    if variable.source is not Source.OF:
        return None
    value = _outside(variable.terms[atom.term]) if denied else _inside(variable.terms[atom.term])
    return None if value is None else Reading(variable.signal, 0.0, value, variable.unit)


def _inside(term: Term) -> float | None:
    """Give the first value of which a term is fully true."""
    _, full, end, _ = term.corners
    return next((corner for corner in (full, end) if math.isfinite(corner)), None)


def _outside(term: Term) -> float | None:
    """Give the last value before a term begins to be true, or the first behind."""
    rise, _, _, fall = term.corners
    return next((corner for corner in (rise, fall) if math.isfinite(corner)), None)
