"""How far from a time something is, where that is said behind it: "before noon, at least an hour before"."""

from dataclasses import replace

from fuzzytime.language.meaning.expressions import EARLIER, LATER, Offset, Said, Wall
from fuzzytime.requirement import Constraint

SIDES = {EARLIER: Constraint.BEFORE, LATER: Constraint.AFTER}
"""The prepositions of distances from what was just named, and the side of it that they are on."""


def far_off(named: Said, distance: Said) -> Said | None:
    """Give a time as if the distance stood in front of it: "at the latest ten minutes before noon".

    None where it is on the other side, or is no distance.
    """
    time, side = distance.time, SIDES.get(distance.preposition or "")
    if side is None or named.constraint is not side or not isinstance(named.time, Wall):
        return None
    if not isinstance(time, Offset) or time.anchor is not None:
        return None
    hedges = (*named.hedges, *distance.hedges)
    far = replace(time, anchor=named.time)
    return replace(named, time=far, constraint=distance.constraint, preposition=None, hedges=hedges)
