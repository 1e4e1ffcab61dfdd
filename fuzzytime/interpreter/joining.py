"""Wishes joined: the paper's logical AND of satisfaction functions, and OR, kept as simple as they can be."""

import math
from collections.abc import Iterator, Sequence

from fuzzytime.requirement import Constraint, TimeRequirement, Unit
from fuzzytime.satisfaction import Clipped, Either, Interval, Rectangle, SatisfactionFunction, product

CLOCKED = frozenset({Unit.HOUR, Unit.MINUTE, Unit.SECOND})
"""How fine clock times are."""


def either(functions: Sequence[SatisfactionFunction]) -> SatisfactionFunction:
    """Give max(ψ₁, ψ₂, …): one of several times is enough."""
    return functions[0] if len(functions) == 1 else Either(functions)


def with_alternatives(requirements: Sequence[TimeRequirement]) -> Iterator[range]:
    """Give the places of each time with those that may be kept instead of it: "at seven or at eight"."""
    begin = 0
    for place in range(1, len(requirements) + 1):
        if place == len(requirements) or not requirements[place].alternative:
            yield range(begin, place)
            begin = place


def is_day_of_another(requirements: Sequence[TimeRequirement], places: range) -> bool:
    """Whether a day says only of which day a clock time beside it is: "tomorrow, call Ann at eight"."""
    one = requirements[places.start]
    if len(places) > 1 or one.grain is not Unit.DAY or one.constraint is not Constraint.BETWEEN:
        return False
    first, end = one.earliest, one.latest
    named = (p.t_spec for p in requirements if p.constraint is Constraint.AT and p.grain in CLOCKED)
    return first is not None and end is not None and any(t is not None and first <= t < end for t in named)


def both(first: SatisfactionFunction, second: SatisfactionFunction) -> SatisfactionFunction:
    """Give ψ₁·ψ₂; one that is full wherever the other is above 0 leaves the other as it is."""
    for one, other in ((first, second), (second, first)):
        window = other.support
        if not window.empty and one.best.low <= window.low and window.high <= one.best.high and _is_full(one):
            return other
    for one, other in ((first, second), (second, first)):
        if isinstance(one, Either):
            # Each side may be open, where the product of the whole has no end.
            return either([both(part, other) for part in one.functions])
    within = first.support.intersection(second.support)
    return product(first, second) if math.isfinite(within.length) else _open_product(first, second, within)


def _open_product(
    first: SatisfactionFunction, second: SatisfactionFunction, within: Interval
) -> SatisfactionFunction:
    """Give ψ₁·ψ₂ of two that are above 0 together without end: full beyond all that bends them."""
    marks = (*first.kinks, *second.kinks)
    bent = Interval(min(marks), max(marks))
    parts: list[SatisfactionFunction] = [product(Clipped(first, bent), Clipped(second, bent))]
    parts += [Rectangle(-math.inf, bent.low)] * math.isinf(within.low)
    parts += [Rectangle(bent.high, math.inf)] * math.isinf(within.high)
    return Either(parts)


def _is_full(function: SatisfactionFunction) -> bool:
    best = function.best
    inside = min(max(best.low, 0.0), best.high)
    return float(function(inside)) == 1.0
