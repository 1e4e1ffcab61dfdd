"""Bounds that deny the other side of a time: "not after six", "not a minute sooner than noon"."""

from fuzzytime.language.english.bounded.bounds import deadline
from fuzzytime.language.grammar.chart import Grammar
from fuzzytime.language.grammar.lexicon import Preposition
from fuzzytime.language.meaning.expressions import Edge, Goal, Said
from fuzzytime.language.meaning.units import UnitWord
from fuzzytime.requirement import Constraint

grammar = Grammar()

DENIED = frozenset({"until", "before"})
"""Prepositions of a time in front of which something is not to be done."""


@grammar.rule("denial", "not|never even|ever?", "under|in no circumstances", "on no account")
def denial() -> str:
    """Never, under no circumstances."""
    return "not"


@grammar.rule("margin", "a|an|one single? <unit>", "a|one single? moment", "any|much", "too much")
def margin(_unit: UnitWord | None = None) -> str:
    """(not) a minute (later), (not) any (sooner)."""
    return "any"


@grammar.rule(
    "preposition_before",
    "<denial> <margin>? later than|then",
    "<denial> <margin>? after|past|beyond",
)
def not_later_than(_denial: str, _margin: str | None) -> Preposition:
    """Never past, not any later than, not one minute after."""
    return Preposition("no later than", Constraint.BEFORE, Edge.LAST)


@grammar.rule(
    "preposition_after",
    "<denial> <margin>? earlier|sooner than|then",
    "<denial> <margin>? before",
)
def not_earlier_than(_denial: str, _margin: str | None) -> Preposition:
    """Never before, not any sooner than, not a second earlier than."""
    return Preposition("not before", Constraint.AFTER, Edge.START)


@grammar.rule("said", "<preposition_before> <goal> ,? at the? very? earliest|soonest", weight=1.0)
def not_until_at_the_earliest(preposition: Preposition, goal: Goal) -> Said | None:
    """(don't start) until noon at the earliest: what denies it makes that a bound from below."""
    return deadline(preposition, goal) if preposition.name in DENIED else None
