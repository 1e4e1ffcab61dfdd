"""On which side of what it names a clause binds what is to be done."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Duration, Phrase
from fuzzytime.language.meaning.joined.distances import UPPER
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.requirement import Constraint

FIRST = frozenset({"before", "until", "by the time"})
"""Clauses whose instruction comes first."""

BEHIND = frozenset({"after", "when"})
"""Clauses whose instruction follows what they name."""

BINDING = {"while": Constraint.AT, "within": Constraint.BETWEEN}
"""Clauses that are neither before nor after alone."""


SIDES = {
    "no later than": Constraint.BEFORE,
    "until": Constraint.BEFORE,
    "by": Constraint.BEFORE,
    "not before": Constraint.AFTER,
    "from": Constraint.AFTER,
    "starting": Constraint.AFTER,
}
"""Prepositions before a distance, and on which side of it something must be."""

LONGEST = 4
"""Words of such a preposition, at most."""


def sided(distance: Phrase, words: Sequence[Word], lexicon: Lexicon) -> tuple[Constraint | None, Phrase]:
    """Give on which side of a distance something must be, by the words before it: "no later than"."""
    for first in range(max(0, distance.first - LONGEST), distance.first):
        for piece in lexicon.pieces(words, first):
            side = SIDES.get(piece.value.name) if piece.category.startswith("preposition") else None
            if side is not None and piece.end == distance.first:
                span = (words[first].start, distance.span[1])
                return side, replace(distance, first=first, span=span)
    return None, distance


def at_most_after(kind: str, distance: Duration) -> Constraint | None:
    """Give the side of a distance that is the longest: "no more than five minutes after the bell"."""
    longest = kind in BEHIND and not UPPER.isdisjoint(distance.hedges) and distance.until is None
    return Constraint.BEFORE if longest else None


def side_of(clause: Clause) -> Constraint:
    """Give on which side of what it names a clause binds; within a time after it where that is bound."""
    before = clause.kind in FIRST
    if clause.side is not None and (before or clause.side is Constraint.AFTER):
        return clause.side
    if clause.side is not None:
        return Constraint.BETWEEN
    return BINDING.get(clause.kind, Constraint.BEFORE if before else Constraint.AFTER)
