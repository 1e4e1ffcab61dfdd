"""Wishes joined: the paper's logical AND of satisfaction functions, and OR, kept as simple as they can be."""

from collections.abc import Iterator, Sequence

from fuzzytime.requirement import TimeRequirement
from fuzzytime.satisfaction import Either, SatisfactionFunction, product


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
    return product(first, second)


def _is_full(function: SatisfactionFunction) -> bool:
    best = function.best
    inside = min(max(best.low, 0.0), best.high)
    return float(function(inside)) == 1.0
