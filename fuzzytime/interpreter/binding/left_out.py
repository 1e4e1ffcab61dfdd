"""The order of skills once some of them are left out: of those behind them, and as they are numbered."""

from collections.abc import Iterable, Mapping
from dataclasses import replace

from fuzzytime.skills import Precedence


def renumbered(precedences: Iterable[Precedence], moved: Mapping[int, int]) -> tuple[Precedence, ...]:
    """Give the precedences between skills that are kept, of which ``moved`` tells the new positions."""
    return tuple(
        replace(entry, first=moved[entry.first], second=moved[entry.second])
        for entry in precedences
        if entry.first in moved and entry.second in moved
    )


def without(order: Iterable[Precedence], gone: int, *, also_before: bool) -> tuple[Precedence, ...]:
    """Give the order without a step that is not done: what came after it comes after those before it.

    Where ``also_before``, the step itself follows nothing any more.
    """
    entries = list(order)
    before = [entry for entry in entries if entry.second == gone]
    after = [entry for entry in entries if entry.first == gone]
    kept = [entry for entry in entries if entry.first != gone and (not also_before or entry.second != gone)]
    known = {(entry.first, entry.second) for entry in kept}
    joined = [
        Precedence(one.first, other.second, one.minimum_lag)
        for one in before
        for other in after
        if (one.first, other.second) not in known
    ]
    return (*kept, *joined)
