"""How far from what was just named something is: "before they arrive, at least an hour before".

Such a distance counts from the clause or the time right in front of it, and not from another instruction.
"""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.language.meaning.expressions import Duration, Offset, Phrase, Said
from fuzzytime.language.meaning.joined.distances import EARLIER, LATER, SIDES, far_off
from fuzzytime.language.sentence.clauses.clause import Clause
from fuzzytime.language.sentence.clauses.clause_sides import at_most_after

MARKS = " ,;:–—-("
"""What may stand between the two."""

JOINTS = frozenset({"", "and", "but", "so"})

KINDS = {EARLIER: frozenset({"before", "by the time"}), LATER: frozenset({"after", "when"})}
"""The clauses that say the same side."""


def with_distances(
    clauses: Sequence[Clause], phrases: Sequence[Phrase], text: str
) -> tuple[list[Clause], list[Phrase]]:
    """Give clauses and times with the distances that stand right behind them."""
    told, times = list(clauses), list(phrases)
    for phrase in phrases:
        length = _distance(phrase.said)
        if length is None:
            continue
        side = phrase.said.preposition or ""
        clause = next((c for c in told if _stands_behind(phrase, c.span[1], text)), None)
        if clause is not None and clause.distance is None and clause.kind in KINDS[side]:
            told[told.index(clause)] = _far(clause, phrase, length)
            times.remove(phrase)
            continue
        named = next((p for p in times if _stands_behind(phrase, p.span[1], text)), None)
        far = None if named is None else far_off(named.said, phrase.said)
        if named is not None and far is not None:
            span = (named.span[0], phrase.span[1])
            times[times.index(named)] = replace(named, said=far, end=phrase.end, span=span)
            times.remove(phrase)
    return told, times


def _distance(said: Said) -> Duration | None:
    """Give how far off a time is that counts from what was named; None for other times."""
    time = said.time
    if not isinstance(time, Offset) or time.anchor is not None or said.preposition not in SIDES:
        return None
    return replace(time.duration, hedges=(*said.hedges, *time.duration.hedges))


def _stands_behind(phrase: Phrase, end: int, text: str) -> bool:
    between = text[end : phrase.span[0]]
    return phrase.span[0] > end and between.strip(MARKS).lower() in JOINTS and between != " "


def _far(clause: Clause, phrase: Phrase, length: Duration) -> Clause:
    """Give a clause as if the distance stood in front of it: "at least an hour before they arrive"."""
    kind = "after" if clause.kind == "when" else clause.kind
    side = phrase.said.constraint or at_most_after(kind, length)
    span = (clause.span[0], phrase.span[1])
    return replace(clause, kind=kind, distance=length, side=side, span=span)
