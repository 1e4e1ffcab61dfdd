"""How far from a time something is, in front of it and behind it: "before noon, at least an hour before"."""

from dataclasses import replace

from fuzzytime.language.meaning.days.relations import Away
from fuzzytime.language.meaning.expressions import Duration, Offset, Said, Wall
from fuzzytime.requirement import Constraint

HALFWAY = "halfway"
"""The time word that counts from the start of what was said to last."""

INTO = "into"
"""The preposition of times that count from the start of the instruction before."""

LATER, EARLIER = "later", "earlier"
"""The prepositions of times that count from what was said before, on and back."""

LEFT, LAST = "left", "last"
"""The prepositions of times that count back from the end of what goes on, or of what is named behind them.

"With ten minutes left", "for the last ten minutes of baking".
"""

UPPER = frozenset({"at most", "less than"})
LOWER = frozenset({"at least", "more than"})
BEYOND = "more than"
"""The hedge of distances that reach past the day that they end on: "more than two weeks before today"."""

SIDES = {EARLIER: Constraint.BEFORE, LATER: Constraint.AFTER}
"""The prepositions of distances from what was just named, and the side of it that they are on."""


def said_length(duration: Duration, constraint: Constraint, preposition: str | None) -> Said:
    """Give a length with what it is hedged by, as a preposition binds it: "in about ten minutes"."""
    return Said(_unhedged(duration), constraint, preposition, duration.hedges)


def said_offset(duration: Duration, preposition: str, direction: int = 1) -> Said:
    """Give what is so far off, with what the length is hedged by: "about ten minutes ago"."""
    return Said(Offset(_unhedged(duration), direction), None, preposition, duration.hedges)


def _unhedged(duration: Duration) -> Duration:
    """Give a length without its hedges."""
    return replace(duration, hedges=()) if duration.hedges else duration


def later_by(length: Duration, hedges: tuple[str, ...] = ()) -> Said:
    """Give so long after what was said before, with the hedges of the length behind others."""
    return said_offset(length.hedged(*hedges), LATER)


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


def distance_bound(said: Said) -> Constraint | None:
    """Give the bound that "at least an hour before noon" is; None for other times."""
    hedges, direction, time = set(said.hedges), 0, said.time
    if isinstance(time, Offset):
        hedges, direction = hedges | set(time.duration.hedges), time.direction
    elif isinstance(time, Wall) and isinstance(time.days, Away) and time.clock is None:
        direction = time.days.count
    if not direction or not LOWER & hedges:
        return None
    return Constraint.BEFORE if direction < 0 else Constraint.AFTER


def is_farther(said: Said) -> bool:
    """Whether it is past a whole day so far from another: "more than two weeks before today"."""
    return isinstance(said.time, Wall) and BEYOND in said.hedges and distance_bound(said) is not None
