"""From what was said about one moment of an execution to start times (the paper's section III-A)."""

import math

from fuzzytime.requirement import Reference
from fuzzytime.satisfaction import Interval, SatisfactionFunction, averaged, points_of
from fuzzytime.times import format_duration


def over_starts(
    function: SatisfactionFunction, reference: Reference, duration: float, elapsed: float, horizon: float
) -> SatisfactionFunction:
    """Give ψ over start times of an execution, in seconds.

    What is said of its finish is ψ(t) = ψ_said(t + elapsed); what is said of all of it is the mean of ψ_said
    over the duration, where it has no end within the horizon behind its beginning.
    """
    if reference is Reference.FINISH:
        return function.shifted(-elapsed)
    if reference is Reference.THROUGHOUT and duration > 0:
        support = function.support
        last = support.high if support.high < math.inf else max(support.low, 0.0) + horizon + duration
        within = support.intersection(Interval(-duration, last))
        bounded = function if within == function.support else points_of(function, function.kinks, within)
        return averaged(bounded, duration)
    return function


def reason_for_never(
    said: SatisfactionFunction, over: SatisfactionFunction, reference: Reference, elapsed: float
) -> str | None:
    """Say why no start from now on satisfies; None where one does."""
    if _satisfiable(over):
        return None
    if reference is Reference.FINISH and _satisfiable(said):
        left = format_duration(said.support.high)
        return f"cannot finish in time: it takes {format_duration(elapsed)}, and {left} are left"
    if said.support.empty:
        return "never: no time satisfies"
    return f"too late: the last time that would satisfy was {format_duration(-said.support.high)} ago"


def _satisfiable(function: SatisfactionFunction) -> bool:
    return function.support.high > 0 or bool(function(0.0) > 0)
