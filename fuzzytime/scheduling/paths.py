"""The cheapest path through time, where a job may be visited again at a price, only not twice in succession.

With prices λ, an arc of job i from slot t leads to slot t + d_i and costs c_i(t) + λ_i; idling is free. Let
V[t] be the cheapest way from slot 0 to slot t, J[t] the last job on it, and W[t] the cheapest way whose last
job is another. So what leads to slot t without doing job i last costs U_i[t], V[t] or W[t], and

    V[0] = 0,   V[t] = min(V[t − 1],  min over arcs that end at t of U_i[t − d_i] + c_i(t − d_i) + λ_i).

Two values for each slot are all that this memory takes (Christofides, Mingozzi and Toth, Networks 11 (1981)
145-164), and it lifts the bound far: without it paths repeat what satisfies best.

In a *block*, a stretch of slots no longer than the shortest job that ends in it, everything depends on
earlier blocks only. So a block is one matrix (job × slot): take, add, minimum over jobs, then a running
minimum for idling, and no loop over slots is left for the interpreter.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.grid import Curve, Ints


class Arcs(NamedTuple):
    """Starts of jobs on one lane: arrays of one shape.

    ``gain`` is the cost of starting there less that of rejection.
    """

    job: Ints
    start: Ints
    end: Ints
    gain: Floats

    def select(self, keep: np.ndarray) -> "Arcs":
        """Give some of the arcs, by a mask or by places."""
        return Arcs(*(column[keep] for column in self))


def arcs_of(curves: Sequence[Curve], durations: Ints) -> Arcs:
    """Give every start in the curves' slots that is possible.

    Jobs that are shorter than a slot get no arcs: they can be visited without taking time.
    """
    sizes = [curve.gains.size if duration else 0 for curve, duration in zip(curves, durations, strict=True)]
    job = np.repeat(np.arange(len(curves)), sizes)
    pairs = [(curve, size) for curve, size in zip(curves, sizes, strict=True) if size]
    start = np.concatenate([np.empty(0, np.int64), *(curve.first + np.arange(size) for curve, size in pairs)])
    gain = np.concatenate([np.empty(0), *(curve.gains for curve, _ in pairs)])
    return Arcs(job, start, start + durations[job], gain).select(np.isfinite(gain))


def block_bounds(first: int, last: int, slot: Ints, duration: Ints, longest: int) -> Ints:
    """Cut the slots from first to last into blocks no longer than the shortest duration at a slot in them.

    Gives the blocks' first slots, and at the end the first slot beyond.
    """
    shortest = np.full(last + 2, longest)
    np.minimum.at(shortest, slot, np.minimum(duration, longest))
    widths, bounds = np.arange(1, longest + 1), [first]
    while bounds[-1] <= last:
        inside = np.minimum.accumulate(shortest[bounds[-1] : bounds[-1] + longest])
        bounds.append(bounds[-1] + int(np.count_nonzero(inside >= widths[: inside.size])))
    return np.array(bounds)


NOBODY = -1
"""Stands for the last job where nothing was done yet."""


class Ways(NamedTuple):
    """The cheapest way to each slot and its last job; the cheapest with another last job, and that job."""

    cost: Floats
    last: Ints
    second: Floats
    other: Ints

    @classmethod
    def nowhere(cls, slots: int) -> "Ways":
        """Give room for ways to so many slots, of which slot 0 is reached."""
        nobody = np.full(slots, NOBODY)
        return cls(np.zeros(slots), nobody, np.full(slots, np.inf), nobody - 1)

    def without(self, slots: Ints, jobs: Ints) -> Floats:
        """Give the cheapest ways to slots on which other jobs than these come last."""
        return np.where(self.last[slots] == jobs, self.second[slots], self.cost[slots])


class _Block(NamedTuple):
    """A block's slots, the matrices of its arcs, and the job of each row.

    ``scratch`` and ``names`` have two rows more: the two ways that come from the block before.
    """

    begin: int
    stop: int
    source: Ints
    weight: Floats
    jobs: Ints
    scratch: Floats
    names: Ints
    columns: Ints


class Paths:
    """The cheapest paths over one set of arcs, for any prices.

    Parameters
    ----------
    arcs
        Every duration at least one slot; sorted by job, then by start.
    durations : array of shape (jobs,)
        In slots.
    slots
        The last slot.
    """

    def __init__(self, arcs: Arcs, durations: Ints, slots: int) -> None:
        self.slots = slots
        self._arcs = arcs
        self._count = durations.size
        self._first_arc = np.searchsorted(arcs.job, np.arange(self._count + 1)).tolist()
        longest = int(durations.max(initial=1))
        self._bounds = block_bounds(1, slots, arcs.end, durations[arcs.job], max(longest, 1))
        width = np.diff(self._bounds)
        block = np.searchsorted(self._bounds, arcs.end, "right") - 1
        rows, row_of_arc = np.unique(block * self._count + arcs.job, return_inverse=True)
        row_block, row_job = np.divmod(rows, self._count)
        row_width = width[row_block]
        offset = np.concatenate([[0], np.cumsum(row_width)])
        column = np.arange(offset[-1]) - np.repeat(offset[:-1], row_width)
        # Where a row has no arc its source only has to exist.
        source = np.maximum(np.repeat(self._bounds[row_block] - durations[row_job], row_width) + column, 0)
        self._gain = np.full(offset[-1], np.inf)
        self._gain[offset[row_of_arc] + arcs.end - self._bounds[block]] = arcs.gain
        self._job = np.repeat(row_job, row_width)
        self._weight = np.empty(offset[-1])
        self._prices = np.zeros(self._count)
        self._ways = Ways.nowhere(int(self._bounds[-1]))
        first_row = np.searchsorted(row_block, np.arange(width.size + 1))
        self._blocks: list[_Block] = []
        for k, (begin, stop) in enumerate(zip(self._bounds[:-1], self._bounds[1:], strict=True)):
            low, high = first_row[k], first_row[k + 1]
            shape, cells = (high - low, width[k]), slice(offset[low], offset[high])
            self._blocks.append(
                _Block(
                    int(begin),
                    int(stop),
                    source[cells].reshape(shape),
                    self._weight[cells].reshape(shape),
                    row_job[low:high, None],
                    np.empty((high - low + 2, width[k])),
                    np.append(row_job[low:high], [NOBODY, NOBODY]),
                    np.arange(width[k]),
                )
            )

    def run(self, prices: Floats) -> Ways:
        """Give the cheapest ways to every slot; the next run overwrites them."""
        self._prices = prices
        np.add(self._gain, prices[self._job], out=self._weight)
        cost, last, second, other = self._ways
        for begin, stop, source, weight, jobs, scratch, names, columns in self._blocks:
            past = begin - 1
            scratch[-2], scratch[-1] = cost[past], second[past]
            names[-2], names[-1] = last[past], other[past]
            if source.shape[0]:
                arriving = scratch[:-2]
                cost.take(source, out=arriving, mode="clip")
                again = np.nonzero(last.take(source, mode="clip") == jobs)
                if again[0].size:
                    arriving[again] = second[source[again]]
                np.add(arriving, weight, out=arriving)
                np.minimum.accumulate(scratch, axis=1, out=scratch)
            best = scratch.argmin(axis=0)
            cost[begin:stop] = scratch[best, columns]
            chosen = last[begin:stop] = names[best]
            np.putmask(scratch, names[:, None] == chosen, np.inf)
            best = scratch.argmin(axis=0)
            second[begin:stop] = scratch[best, columns]
            other[begin:stop] = names[best]
        reached = slice(self.slots + 1)
        return Ways(cost[reached], last[reached], second[reached], other[reached])

    def path(self) -> list[tuple[int, int]]:
        """Give the jobs of the cheapest path of the last run, the last one first, and their start slots."""
        ways, arcs = self._ways, self._arcs
        found: list[tuple[int, int]] = []
        slot, job = self.slots, int(ways.last[self.slots])
        while job != NOBODY:
            first, stop = self._first_arc[job], self._first_arc[job + 1]
            stop = first + int(np.searchsorted(arcs.end[first:stop], slot, "right"))
            costs = ways.without(arcs.start[first:stop], np.array(job)) + arcs.gain[first:stop]
            slot = int(arcs.start[first + int(costs.argmin())])
            found.append((job, slot))
            job = int(ways.other[slot] if ways.last[slot] == job else ways.last[slot])
        return found


def ways_to_end(arcs: Arcs, durations: Ints, slots: int, prices: Floats) -> Ways:
    """Give the cheapest ways from each slot to the end, and their first jobs: time runs backward."""
    # Mirrored starts of one job descend where starts ascend.
    mirrored = Arcs(arcs.job, slots - arcs.end, slots - arcs.start, arcs.gain)
    order = np.lexsort((mirrored.start, mirrored.job))
    ways = Paths(mirrored.select(order), durations, slots).run(prices)
    return Ways(ways.cost[::-1], ways.last[::-1], ways.second[::-1], ways.other[::-1])
