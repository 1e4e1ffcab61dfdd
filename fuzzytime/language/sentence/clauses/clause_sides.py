"""On which side of what it names a clause binds what is to be done, and whether it says when that is."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.grammar.words import Word
from fuzzytime.language.meaning.expressions import Duration, Offset, Phrase, Repeat, TimeWord, Wall
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.meaning.joined.distances import LEFT, UPPER
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.requirement import MOMENTS, Constraint

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

AHEAD = frozenset({"before"})
"""Clauses that name what something is to be done before."""


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


def happens(clause: Clause, lexicon: Lexicon) -> bool:
    """Whether something happens: "when it opens", "when I get in"; not "when it is hot"."""
    subject = None if clause.condition is None else clause.condition.subject
    # "When Sue gets in at one"
    goes = clause.where is not None or subject in lexicon.closed.personal_pronouns
    return clause.verb not in {*lexicon.doing.being, None} or (
        goes and clause.verb in lexicon.doing.getting - {"be"}
    )


def is_apart(phrase: Phrase, kind: str) -> bool:
    """Whether a time at the end of a clause is no part of it, as in "when it has been hot for a minute"."""
    within = kind == "if" and phrase.said.preposition == "within"
    lasting = phrase.said.constraint is Constraint.FOR or within
    if phrase.said.preposition == LEFT:
        # "When the roast has ten minutes left"
        return True
    return not lasting and not isinstance(phrase.said.time, (Offset, Repeat, TimeWord))


def dates(phrase: Phrase, distance: Duration | None, kind: str) -> bool:
    """Whether a time is when an event is: neither a bound nor a length; to count from it, it is a moment.

    Where days are counted, a clock time alone is that of what is to be done on the day. What is over on
    a day is over at no moment of it that is known: "after the show on Saturday". Nor does an event begin when
    its day does: "before the show on Saturday".
    """
    time = phrase.said.time
    if not isinstance(time, Wall) or phrase.said.constraint not in MOMENTS:
        return False
    if kind in BEHIND | AHEAD and distance is None and time.clock is None and time.part is None:
        return False
    days = distance is not None and all(unit not in SUB_DAY for _, unit in distance.terms)
    return distance is None or (time.days if days else time.clock) is not None
