"""Wishes joined: the paper's logical AND of satisfaction functions, kept as simple as it can be."""

from fuzzytime.satisfaction import SatisfactionFunction, product


def both(first: SatisfactionFunction, second: SatisfactionFunction) -> SatisfactionFunction:
    """Give ψ₁·ψ₂; one that is full wherever the other is above 0 leaves the other as it is."""
    for one, other in ((first, second), (second, first)):
        window = other.support
        if not window.empty and one.best.low <= window.low and window.high <= one.best.high and _is_full(one):
            return other
    return product(first, second)


def _is_full(function: SatisfactionFunction) -> bool:
    best = function.best
    inside = min(max(best.low, 0.0), best.high)
    return float(function(inside)) == 1.0
