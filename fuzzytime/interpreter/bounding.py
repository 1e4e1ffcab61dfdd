"""A satisfaction function bounded anew: by where it was moved to, and by how long what it begins takes."""

import math
from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.interpreter.interpretation import WITHIN
from fuzzytime.language import Lexicon
from fuzzytime.requirement import Constraint, Reference, TimeRequirement, Unit
from fuzzytime.rulebook import OperationDuration, Resolution
from fuzzytime.satisfaction import Either, SatisfactionFunction, Trapezoid

BETWEEN = "between"
"""The preposition of two ends."""


def from_there_on(function: SatisfactionFunction, to: float, *, later: bool) -> SatisfactionFunction:
    """Give what a start that ψ is moved to leaves: none sooner, or none later, but as vaguely as ψ begins.

    What may begin at any time from now on, as "soon", begins nowhere vaguely, and does not begin sooner.
    """
    support, best = function.support, function.best
    vague = best.low - support.low if later else support.high - best.high
    if isinstance(function, Either) or not math.isfinite(vague):
        vague = 0.0
    if later:
        return Trapezoid(to - vague, to, math.inf, math.inf)
    return Trapezoid(-math.inf, -math.inf, to, to + vague)


def within_its_ends(
    resolution: Resolution, part: TimeRequirement, duration: OperationDuration, now: float
) -> Resolution:
    """Let all of what has two ends lie between them, if how long it takes was told and it fits.

    "Paint the fence between two and four for an hour" begins by three; later, it satisfies the less the more
    of it is behind the end, and is not lost. Without a length that was told, or with one that is longer, the
    ends bound when it begins. Times, and ``now``, count from when it was said.
    """
    function, length = resolution.satisfaction, duration.elapsed
    begun = part.reference_said or part.reference is not Reference.START
    told = part.preposition == BETWEEN or (part.recurrence is not None and part.recurrence.spans)
    begin, end = part.earliest, part.latest
    if not told or begun or duration.assumed or begin is None or end is None:
        return resolution
    if not isinstance(function, Trapezoid) or end - max(now, begin) < length:
        return resolution
    rise_start, full_start, full_end, fall_end = function.corners
    last = max(full_start, full_end - length)
    corners = (rise_start, full_start, last, fall_end)
    return replace(resolution, satisfaction=Trapezoid(*corners), notes=(*resolution.notes, WITHIN))


def to_its_end(day: TimeRequirement, resolution: Resolution, others: Sequence[TimeRequirement]) -> Resolution:
    """Let a day count in full to its end where another time says by when on it: "thursday, before bed".

    Alone, its evening satisfies less.
    """
    first, end = day.earliest, day.latest
    if day.grain is not Unit.DAY or day.constraint is not Constraint.BETWEEN or first is None or end is None:
        return resolution
    due = (
        part.latest for part in others if part.constraint is Constraint.BEFORE and part.grain is not Unit.DAY
    )
    bounded = any(last is not None and first < last <= end for last in due)
    return _ending(resolution, end, end) if bounded else resolution


def is_due_on_day(part: TimeRequirement, lexicon: Lexicon) -> bool:
    """Whether a time is a deadline on a day that is said elsewhere: "Friday:", then "by six"."""
    due = part.constraint is Constraint.BETWEEN and part.preposition in lexicon.deadlines
    return due and part.earliest is not None


def due_then(resolution: Resolution, due: Resolution) -> Resolution:
    """Let what is ``due`` on a day begin as that does, and end as a deadline."""
    deadline = due.satisfaction
    return _ending(resolution, *deadline.corners[2:]) if isinstance(deadline, Trapezoid) else resolution


def _ending(resolution: Resolution, full_end: float, fall_end: float) -> Resolution:
    """Let ψ begin as it does, and end there; as it was where it begins behind that."""
    function = resolution.satisfaction
    if not isinstance(function, Trapezoid):
        return resolution
    rise_start, full_start, _, _ = function.corners
    if full_start > full_end:
        return resolution
    return replace(resolution, satisfaction=Trapezoid(rise_start, full_start, full_end, fall_end))
