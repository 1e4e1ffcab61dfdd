"""Whether a time behind a clause is when its event is: "before the guests arrive at seven"."""

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.meaning.expressions import Duration, Offset, Phrase, Repeat, TimeWord, Wall
from fuzzytime.language.meaning.instants import SUB_DAY
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.requirement import MOMENTS, Constraint

OVER = frozenset({"after", "when"})
"""Clauses that wait for the end of something, or for what becomes so."""

AHEAD = frozenset({"before"})
"""Clauses that name what something is to be done before."""


def happens(clause: Clause, lexicon: Lexicon) -> bool:
    """Whether something happens: "when it opens", "when I get in"; not "when it is hot"."""
    subject = None if clause.condition is None else clause.condition.subject
    return clause.verb not in {*lexicon.doing.being, None} or (
        subject in lexicon.closed.personal_pronouns and clause.verb != "be"
    )


def is_apart(phrase: Phrase, kind: str) -> bool:
    """Whether a time at the end of a clause is no part of it, as in "when it has been hot for a minute"."""
    within = kind == "if" and phrase.said.preposition == "within"
    lasting = phrase.said.constraint is Constraint.FOR or within
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
    if kind in OVER | AHEAD and distance is None and time.clock is None and time.part is None:
        return False
    days = distance is not None and all(unit not in SUB_DAY for _, unit in distance.terms)
    return distance is None or (time.days if days else time.clock) is not None
