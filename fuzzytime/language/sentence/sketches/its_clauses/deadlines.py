"""Deadlines of what must be so: "unless I call before six", "if it isn't fixed within the hour"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.meaning.expressions import Coming, Duration, Edge, Offset, Phrase, Said
from fuzzytime.language.meaning.joined.distances import later_by
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.requirement import Constraint

DEADLINE = "deadline of a clause"
"""The rule of such a time."""


def with_deadlines(
    clauses: Sequence[Clause],
    phrases: Sequence[Phrase],
    text: str,
    main: int,
    lexicon: Lexicon,
    *,
    follows: bool,
) -> tuple[list[Clause], list[Phrase]]:
    """Give clauses with the deadlines right behind them, and from when on it is known that one has passed.

    Whether he has not come by six is known at six: what is to be done if so is done after it, where no other
    time is said. What is to be done begins at ``main``; behind it, "if he comes by six" bounds that too.
    A length within which it must be so counts from what it ``follows`` in the same text.
    """
    found: list[Clause] = []
    passed: list[Phrase] = []
    for clause in clauses:
        deadline = next((phrase for phrase in phrases if _is_of(clause, phrase, text, lexicon)), None)
        if deadline is None or not (_denies(clause, lexicon) or deadline.span[1] <= main):
            found.append(clause)
            continue
        found.append(replace(clause, span=(clause.span[0], max(clause.span[1], deadline.span[1]))))
        timed = any(p is not deadline and p.said.constraint is not Constraint.FOR for p in phrases)
        if _denies(clause, lexicon) and not timed:
            passed.append(_passed(deadline, later=follows))
    return found, passed


def _passed(deadline: Phrase, *, later: bool) -> Phrase:
    """Give from when on a deadline has passed."""
    said, time = deadline.said, deadline.said.time
    length = time.duration if isinstance(time, (Offset, Coming)) else time
    if _is_length(said) and isinstance(length, Duration):
        # "Ring the bell; if nobody answers within ten minutes, ring again"
        known = later_by(length) if later else Said(Offset(length), Constraint.AFTER, "after")
    else:
        known = replace(said, constraint=Constraint.AFTER, preposition="after", edge=Edge.START)
    return replace(deadline, said=known, rule=DEADLINE)


def _is_length(said: Said) -> bool:
    """Whether something must be so within a length of time."""
    time = said.time
    counted = isinstance(time, Duration) or (isinstance(time, (Offset, Coming)) and time.direction > 0)
    return said.preposition == "within" and counted and not (isinstance(time, Offset) and time.anchor)


def _is_of(clause: Clause, phrase: Phrase, text: str, lexicon: Lexicon) -> bool:
    """Whether a deadline stands right behind what must be so, or in it."""
    inside = clause.content[0] < phrase.span[0] and phrase.span[1] <= clause.content[1]
    if inside and _is_length(phrase.said):
        return clause.kind == "if" and _denies(clause, lexicon)
    behind = clause.span[1] <= phrase.span[0] and not text[clause.span[1] : phrase.span[0]].strip()
    return clause.kind == "if" and behind and phrase.said.constraint is Constraint.BEFORE


def _denies(clause: Clause, lexicon: Lexicon) -> bool:
    """Whether it is about what has not come to be."""
    condition = clause.condition
    if condition is None:
        return False
    # "If nobody has come by six"
    nobody = not (lexicon.closed.negative_pronouns | {"no", "no-one"}).isdisjoint(
        (condition.subject or "").lower().split()[:1]
    )
    return condition.negated != nobody
