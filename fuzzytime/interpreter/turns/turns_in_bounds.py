"""Turns of what is repeated until, or once, something else is: "turn him every two hours until the handover".

How often that is can be told only where it is known when the other is.
"""

import math
from collections.abc import Sequence

from fuzzytime.interpreter.binding.left_out import renumbered
from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.skills import Precedence


def turns_out_of_bounds(skills: Sequence[Interpreted], precedences: Sequence[Precedence]) -> frozenset[int]:
    """Give the positions of turns that would begin once what bounds them is there, or before that is over.

    Of turns that are all out of bounds, the first is not among them, so that its loss is told.
    """
    beyond = {
        turn
        for entry in precedences
        for turn in (entry.first, entry.second)
        if _is_bounded(skills[turn]) and _is_out(entry, turn, skills)
    }
    turns: dict[tuple[str, int], list[int]] = {}
    for place, one in enumerate(skills):
        if one.repeats:
            turns.setdefault((one.wish.identifier, id(one.instruction)), []).append(place)
    return frozenset(beyond.difference(places[0] for places in turns.values() if beyond.issuperset(places)))


def without(
    positions: frozenset[int], skills: Sequence[Interpreted], binding: Sequence[Sequence[Precedence]]
) -> tuple[list[Interpreted], list[tuple[Precedence, ...]]]:
    """Leave out the skills at some positions, and what binds them."""
    kept = [place for place in range(len(skills)) if place not in positions]
    moved = {place: new for new, place in enumerate(kept)}
    left = [renumbered(precedences, moved) for precedences in binding]
    return [skills[place] for place in kept], left


def _is_bounded(one: Interpreted) -> bool:
    """Whether it is a turn of what words bind to something else, and no identifier does."""
    anchors = (part.anchor for part in one.requirements if part.recurrence is None)
    bounds = (anchor for anchor in anchors if anchor is not None and anchor.target is not None)
    return one.repeats and not one.wish.after and any(not anchor.exact for anchor in bounds)


def _is_out(entry: Precedence, turn: int, skills: Sequence[Interpreted]) -> bool:
    """Whether a turn begins on the wrong side of what it is bound to."""
    first, second = skills[entry.first], skills[entry.second]
    if first.wish.identifier == second.wish.identifier and first.instruction is second.instruction:
        return False
    begin, other = _begins(first), _begins(second)
    if begin is None or other is None or entry.maximum_lag < math.inf:
        return False
    if turn == entry.first:
        return begin + entry.minimum_lag >= other
    return other < begin + first.skill.time_until_done + entry.minimum_lag


def _begins(one: Interpreted) -> float | None:
    """Give the start that was named, or the earliest that satisfies best; None where no time was said."""
    if one.skill.named:
        return max(one.skill.named)
    begin = one.skill.satisfaction.best.low
    return begin if 0 < begin < math.inf else None
