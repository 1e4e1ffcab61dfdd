"""Sets of jobs, what lags bind to them, and which of their states are needed.

Of a job in a set S that a lag binds to one outside, an *open* job, the start has to be known: the other may
only start from some to some other slots behind it. Nothing else of how S was done matters.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.problem.grid import Ints
from fuzzytime.scheduling.problem.jobs import Lag

Bools = NDArray[np.bool_]

LONG_AGO = -(1 << 40)
"""Stands for a start on which nothing depends any more: whoever must follow it closely has lost it."""


class Bond(NamedTuple):
    """An open job, by its place among the open ones, binds another: ``low`` to ``high`` slots behind it.

    Where it ``must`` come, the open job was in vain without it.
    """

    place: int
    job: int
    low: float
    high: float
    must: bool


class JobSet(NamedTuple):
    """A set of jobs by its bits, with its open jobs, their bonds, and the jobs outside.

    Those are ``ready`` of which all that must come first are inside.
    """

    done: int
    opened: list[int]
    bonds: list[Bond]
    outside: list[int]
    ready: list[int]

    @classmethod
    def of(cls, done: int, durations: Sequence[int], lags: Sequence[Lag]) -> "JobSet":
        """Tell what lags bind to a set of jobs of some durations."""
        crossing = [lag for lag in lags if (done >> lag.first ^ done >> lag.second) & 1]
        opened = sorted({lag.first if done >> lag.first & 1 else lag.second for lag in crossing})
        bonds = [
            Bond(opened.index(lag.first), lag.second, lag.low, lag.high, must=False)
            if done >> lag.first & 1
            else Bond(opened.index(lag.second), lag.first, -lag.high, -lag.low, must=True)
            for lag in crossing
        ]
        outside = [job for job in range(len(durations)) if not done >> job & 1]
        # What takes no time may start with another on one agent only if it comes first.
        waiting = {
            lag.second
            for lag in lags
            if (lag.low > 0 or (lag.low == 0 and durations[lag.second] > 0)) and not done >> lag.first & 1
        }
        return cls(done, opened, bonds, outside, [job for job in outside if job not in waiting])

    def had_better_start_soon(self, job: int, lags: Sequence[Lag]) -> bool:
        """Tell whether nothing outside gains anything if a job of those outside starts later."""
        binding = [lag for lag in lags if job in {lag.first, lag.second}]
        others = [(lag, lag.second if lag.first == job else lag.first) for lag in binding]
        return all(
            self.done >> other & 1 or (other == lag.second and lag.high == np.inf) for lag, other in others
        )


class States(NamedTuple):
    """States of one set of jobs, a row for each.

    ``free`` has the slots from which on agents are free, ascending within a lane; ``opened`` the starts of
    open jobs. The others tell which job came last, when, on which lane, and the row of the set without it.
    """

    free: Ints
    opened: Ints
    cost: Floats
    job: Ints
    start: Ints
    lane: Ints
    before: Ints

    def select(self, keep: Ints) -> "States":
        """Give some of the states."""
        return States._make(column[keep] for column in self)

    @classmethod
    def together(cls, pieces: Sequence["States"]) -> "States":
        """Put states of a set together."""
        return cls._make(np.concatenate(columns) for columns in zip(*pieces, strict=True))


def needed(states: States, pinned: Bools) -> Ints:
    """Give the states to go on with: where all moments but one are the same, the cheapest with most room.

    Agents had better be free soon. Who must follow an open job closely may do so for longer where that starts
    later; where it is ``pinned``, of shape (states, open jobs), something else must not start as late.
    """
    kept, rank = np.arange(states.cost.size), np.unique(states.cost, return_inverse=True)[1]
    moments, agents = np.column_stack([states.free, -states.opened]), states.free.shape[1]
    for column in range(moments.shape[1]):
        rows, price = moments[kept], rank[kept]
        value, others = rows[:, column], [*np.delete(rows, column, axis=1).T]
        if column >= agents:
            others.append(np.where(pinned[kept, column - agents], value, LONG_AGO))
        order = np.lexsort((price, value, *others))
        is_new = np.zeros(order.size, bool)
        for other in others:
            is_new[1:] |= np.diff(other[order]) != 0
        # The first of a group lies below all before it.
        shifted = price[order] - np.cumsum(is_new) * price.size
        is_better = np.append(True, shifted[1:] < np.minimum.accumulate(shifted)[:-1])[: order.size]
        kept = np.sort(kept[order[is_better]])
    return kept
