"""From what a clause says ("when the frying pan is very hot") to a formula over the tables' variables."""

from dataclasses import dataclass, replace

from fuzzytime.context import Context
from fuzzytime.english import denies
from fuzzytime.requirement import Anchor, Condition
from fuzzytime.rulebook.logic.formula import Direction, Formula, Happened, Is, Not, Operator, Window
from fuzzytime.rulebook.logic.grammar import SOFTNESS
from fuzzytime.rulebook.tables.contents import Tables
from fuzzytime.rulebook.tables.variables import Term, Variable
from fuzzytime.rulebook.wording.joined import joined
from fuzzytime.rulebook.wording.lookup import UNIT_LENGTHS
from fuzzytime.rulebook.wording.measured import candidates
from fuzzytime.rulebook.wording.phrases import (
    event_named,
    in_numbers,
    is_of_another,
    names,
    naming,
    plain,
    ways_to_name,
    within,
)
from fuzzytime.rulebook.wording.thresholds import threshold, without


@dataclass(frozen=True, slots=True)
class Understood:
    """A clause with the subject and word that were found in it; its formula, or why there is none.

    ``tables`` are those that the formula speaks the terms of: a number in the clause adds one. ``composed``
    says that it has several parts, a number or a length: no rule for one of its words can stand for it.
    ``impossible`` says of what has no formula that it is never so; else nobody can tell.
    """

    condition: Condition
    tables: Tables
    formula: Formula | None
    reason: str | None = None
    notes: tuple[str, ...] = ()
    composed: bool = False
    impossible: bool = False


def condition_of(anchor: Anchor) -> Condition:
    """Give what an anchor that is no instruction says must be so."""
    return Condition(
        text=anchor.text, subject=anchor.object, lasting=anchor.lasting, comparisons=anchor.comparisons
    )


def understand(condition: Condition, tables: Tables, context: Context = Context.empty) -> Understood:
    """Find the variables, terms and events that a clause speaks of.

    What has been read (``context``) tells what a number is about where the clause does not name it.
    """
    if condition.contrary:
        said = replace(condition, contrary=False, negated=not condition.negated)
        understood = understand(said, tables, context)
        other = None if understood.formula is None else Not(understood.formula)
        return replace(understood, condition=condition, formula=other, composed=True)
    several = joined(condition, tables, context)
    if several is None:
        understood = _single(condition, tables, context)
    else:
        understood = Understood(
            condition,
            several.tables,
            several.formula,
            several.reason,
            several.notes,
            composed=True,
            impossible=several.impossible,
        )
    if understood.formula is None or condition.lasting is None:
        return understood
    lasting = condition.lasting
    softness = max((SOFTNESS.get(hedge, 0.0) for hedge in lasting.fuzziness), default=0.0)
    length = lasting.number * UNIT_LENGTHS[lasting.unit]
    window = Window(Operator.THROUGHOUT, Direction.LAST, length, softness, understood.formula)
    return replace(understood, formula=window, composed=True)


def can_be_told(condition: Condition, tables: Tables, context: Context) -> bool:
    """Whether readings can tell when a condition holds, or an event has happened."""
    return understand(condition, tables, context).formula is not None


def may_be_about(condition: Condition, tables: Tables) -> frozenset[str]:
    """Give the signals that the numbers of a clause may be about: readings will tell which."""
    found = frozenset[str]()
    for comparison in condition.comparisons:
        named = without(comparison, plain(condition.text))
        found |= candidates(comparison, named, condition.subject, tables)
    return found


def _single(condition: Condition, tables: Tables, context: Context) -> Understood:
    event = event_named(condition.text, tables)
    if event is not None:
        return Understood(condition, tables, Happened(event))
    if condition.comparisons:
        return _measured(condition, tables, context)
    if not condition.negated and denies(condition.text):
        condition = replace(condition, negated=True)
    if condition.subject is None or condition.word is None:
        return _by_text(condition, tables)
    if not within(plain(condition.subject), plain(condition.text)):
        # The subject was put for a pronoun, and "it rains" speaks of nothing that was named before.
        impersonal = _by_text(condition, tables)
        if impersonal.formula is not None:
            return impersonal
    return _by_parts(condition, condition.subject, condition.word, tables)


def _measured(condition: Condition, tables: Tables, context: Context) -> Understood:
    """Read a clause with a number: "the oven is above 150 degrees"."""
    comparison = condition.comparisons[0]
    named = without(comparison, plain(condition.text))
    found = threshold(comparison, named, condition.subject, tables, context, about=condition.subject or "")
    formula: Formula | None = found.atom
    if found.atom is not None and (condition.negated or denies(named)):
        formula = Not(found.atom)
    # What is said of the thing is the number: no rule for a word is about it.
    said = replace(condition, word=None, hedges=())
    return Understood(
        said,
        found.tables,
        formula,
        found.reason,
        found.notes,
        composed=True,
        impossible=found.impossible,
    )


def _by_parts(condition: Condition, subject: str, word: str, tables: Tables) -> Understood:
    named = [variable for variable in tables.variables.values() if names(variable, subject)]
    text = plain(condition.text)
    # The longest way to say it: "too hot" is not hot, and "dente" alone says nothing.
    ways = [
        (way, variable, term)
        for variable in named
        for term in variable.terms.values()
        for way in ways_to_name(term)
        if way == plain(word) or (plain(word) in way.split() and within(way, text))
    ]
    if ways:
        way, variable, term = max(ways, key=lambda row: len(row[0]))
        hedges = tuple(hedge for hedge in condition.hedges if hedge.lower() not in way.split())
        return _atom(replace(condition, hedges=hedges), variable, term, tables)
    if named:
        terms = dict.fromkeys(term for variable in named for term in variable.terms)
        return Understood(
            condition, tables, None, f"{subject!r} has no term {word!r} (known: {', '.join(terms)})"
        )
    return _by_text(condition, tables)


def _by_text(condition: Condition, tables: Tables) -> Understood:
    """Look for a variable's words and one of its terms in a clause of any form, the longest words first."""
    text = plain(condition.text)
    subject = condition.subject or ""
    meant = [
        one for one in tables.variables.values() if not is_of_another(in_numbers(ways_to_name(one)), subject)
    ]
    found = naming(meant, text, text)
    if found is None:
        return Understood(condition, tables, None, f"nothing tells {condition.text!r}")
    said = replace(condition, subject=found.subject, word=found.word, hedges=found.hedges(text, tables))
    return _atom(said, found.variable, found.term, tables)


def _atom(condition: Condition, variable: Variable, term: Term, tables: Tables) -> Understood:
    hedges = [hedge.lower() for hedge in condition.hedges]
    known = tuple(hedge for hedge in hedges if hedge in tables.term_hedges)
    notes = tuple(
        f"unknown hedge {hedge!r}: taken as none" for hedge in hedges if hedge not in tables.term_hedges
    )
    atom = Is(variable.name, term.name, known)
    return Understood(condition, tables, Not(atom) if condition.negated else atom, notes=notes)
