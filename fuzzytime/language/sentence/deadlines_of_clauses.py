"""Deadlines of what must be so: "unless I call before six", "if she isn't back by noon"."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.meaning.expressions import Edge, Phrase
from fuzzytime.language.sentence.clause import Clause
from fuzzytime.language.sentence.statements import NOBODY
from fuzzytime.requirement import Constraint

DEADLINE = "deadline of a clause"
"""The rule of such a time."""


def with_deadlines(
    clauses: Sequence[Clause], phrases: Sequence[Phrase], text: str, main: int
) -> tuple[list[Clause], list[Phrase]]:
    """Give clauses with the deadlines right behind them, and from when on it is known that one has passed.

    Whether he has not come by six is known at six: what is to be done if so is done after it, where no other
    time is said. What is to be done begins at ``main``; behind it, "if he comes by six" bounds that too.
    """
    found: list[Clause] = []
    passed: list[Phrase] = []
    for clause in clauses:
        deadline = next((phrase for phrase in phrases if _is_of(clause, phrase, text)), None)
        if deadline is None or not (_denies(clause) or deadline.span[1] <= main):
            found.append(clause)
            continue
        found.append(replace(clause, span=(clause.span[0], deadline.span[1])))
        timed = any(p is not deadline and p.said.constraint is not Constraint.FOR for p in phrases)
        if _denies(clause) and not timed:
            passed.append(_passed(deadline))
    return found, passed


def _passed(deadline: Phrase) -> Phrase:
    """Give from when on a deadline has passed."""
    known = replace(deadline.said, constraint=Constraint.AFTER, preposition="after", edge=Edge.START)
    return replace(deadline, said=known, rule=DEADLINE)


def _is_of(clause: Clause, phrase: Phrase, text: str) -> bool:
    """Whether a deadline stands right behind what must be so."""
    behind = clause.span[1] <= phrase.span[0] and not text[clause.span[1] : phrase.span[0]].strip()
    return clause.kind == "if" and behind and phrase.said.constraint is Constraint.BEFORE


def _denies(clause: Clause) -> bool:
    """Whether it is about what has not come to be."""
    condition = clause.condition
    if condition is None:
        return False
    # "If nobody has come by six"
    nobody = not (NOBODY | {"no", "no-one"}).isdisjoint((condition.subject or "").lower().split()[:1])
    return condition.negated != nobody
