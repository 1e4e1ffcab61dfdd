"""The cheapest path through time, where a job may be visited again at a price, only not twice in succession.

With prices λ, an arc of job i from slot t leads to slot t + d_i and costs c_i(t) + λ_i; idling is free. Let
V[t] be the cheapest way from slot 0 to slot t, J[t] the last job on it, and W[t] the cheapest way whose last
job is another. So what leads to slot t without doing job i last costs U_i[t], V[t] or W[t], and

    V[0] = 0,   V[t] = min(V[t − 1],  min over arcs that end at t of U_i[t − d_i] + c_i(t − d_i) + λ_i).

Two values for each slot are all that this memory takes (Christofides, Mingozzi and Toth, Networks 11 (1981)
145-164), and it lifts the bound far: without it paths repeat what satisfies best.

In a *block*, a stretch of slots no longer than the shortest job that ends in it, everything depends on
earlier blocks only. So a block is one matrix (job × slot): take, add, minimum over jobs, then a running
minimum for idling, and no loop over slots is left for the interpreter. A block is made longer than a few
short jobs: the rows of those are added again, until no way gets cheaper, which is soon, since few of them
follow one another on the cheapest ways through one block.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.problem.grid import Curve, Ints


class Arcs(NamedTuple):
    """Starts of jobs on one lane: arrays of one shape.

    ``gain`` is the cost of starting there less that of rejection.
    """

    job: Ints
    start: Ints
    end: Ints
    gain: Floats

    def select(self, keep: np.ndarray | slice) -> "Arcs":
        """Give some of the arcs, by a mask, by places, or a stretch of them."""
        return Arcs(self.job[keep], self.start[keep], self.end[keep], self.gain[keep])

    @classmethod
    def together(cls, *parts: "Arcs") -> "Arcs":
        """Put arcs together."""
        return cls(*(np.concatenate(columns) for columns in zip(*parts, strict=True)))


def arcs_of(curves: Sequence[Curve], durations: Ints) -> Arcs:
    """Give every start in the curves' slots that is possible.

    Jobs that are shorter than a slot get no arcs: they can be visited without taking time.
    """
    return _arcs_of(curves, durations, durations > 0)


def instants_of(curves: Sequence[Curve], durations: Ints) -> Arcs:
    """Give every possible start of the jobs that are shorter than a slot."""
    return _arcs_of(curves, durations, durations == 0)


def _arcs_of(curves: Sequence[Curve], durations: Ints, chosen: NDArray[np.bool_]) -> Arcs:
    sizes = [curve.gains.size if takes_part else 0 for curve, takes_part in zip(curves, chosen, strict=True)]
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

    def without(self, slots: Ints | slice, jobs: Ints) -> Floats:
        """Give the cheapest ways to slots on which other jobs than these come last."""
        return np.where(self.last[slots] == jobs, self.second[slots], self.cost[slots])


WIDE = 64
"""Slots of a wide block: fewer blocks cost less, longer chains of short jobs in one block cost more.

Fewer where jobs are mostly shorter than this: half of the rows are added once then.
"""

NARROW = 16
"""Blocks as long as the shortest jobs allow have so many slots on average, or wide ones are used."""


class _Table(NamedTuple):
    """Arcs that end in a block: a row for each job, a column for each slot, ∞ where there is none.

    ``costs`` is room for the ways along them and, in two rows more, for two ways known before;
    ``arriving`` is its part without these two, and ``jobs`` names the last job of each.
    """

    source: Ints
    weight: Floats
    job: Ints
    costs: Floats
    arriving: Floats
    jobs: Ints
    columns: Ints

    @classmethod
    def of(cls, source: Ints, weight: Floats, job: Ints) -> "_Table":
        """Make room."""
        height, width = source.shape
        costs = np.empty((height + 2, width))
        jobs = np.full(costs.shape, NOBODY)
        jobs[:height] = job
        return cls(source, weight, job, costs, costs[:-2], jobs, np.arange(width))

    def arrive(self, ways: Ways) -> None:
        """Write what the cheapest ways cost that do one of these arcs last and may idle then."""
        source, arriving = self.source, self.arriving
        if source.size:
            ways.cost.take(source, out=arriving, mode="clip")
            again = (ways.last.take(source, mode="clip") == self.job).ravel().nonzero()[0]
            if again.size:
                arriving.reshape(-1)[again] = ways.second[source.reshape(-1)[again]]
            np.add(arriving, self.weight, out=arriving)
            np.minimum.accumulate(arriving, axis=1, out=arriving)

    def merged(self, cost: Floats, last: Ints, second: Floats, other: Ints) -> Ways:
        """Give the best of what arrives and of two ways known before; what arrives is lost."""
        costs, jobs, columns = self.costs, self.jobs, self.columns
        costs[-2], costs[-1], jobs[-2], jobs[-1] = cost, second, last, other
        place = costs.argmin(axis=0) * columns.size + columns
        cheapest, chosen = costs.take(place), jobs.take(place)
        np.putmask(costs, jobs == chosen, np.inf)
        place = costs.argmin(axis=0) * columns.size + columns
        return Ways(cheapest, chosen, costs.take(place), jobs.take(place))


class _Block(NamedTuple):
    """A block's slots, the arcs of jobs that end in it, and those of them that may start in it, too."""

    past: int
    slots: slice
    whole: _Table
    near: _Table | None

    def reach(self, ways: Ways) -> None:
        """Write the cheapest ways to the slots of this block, those before it being known."""
        cost, last, second, other = ways
        past, slots, whole, near = self
        idling = cost[past], last[past], second[past], other[past]
        if near is not None:
            # What is near starts behind idling at first.
            cost[slots], last[slots], second[slots], other[slots] = idling
        whole.arrive(ways)
        found = whole.merged(*idling)
        cost[slots], last[slots], second[slots], other[slots] = found
        while near is not None:
            near.arrive(ways)
            if not (near.arriving < np.where(near.job == found.last, found.cost, found.second)).any():
                break
            found = near.merged(*found)
            cost[slots], last[slots], second[slots], other[slots] = found


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
        longest = max(int(durations.max(initial=1)), WIDE)
        self._bounds = block_bounds(1, slots, arcs.end, durations[arcs.job], longest)
        if slots < NARROW * (self._bounds.size - 1):
            wide = np.maximum(durations, min(WIDE, int(np.median(durations))))
            self._bounds = block_bounds(1, slots, arcs.end, wide[arcs.job], longest)
        width = np.diff(self._bounds)
        block = np.searchsorted(self._bounds, arcs.end, "right") - 1
        # Two tables for each block, each with a row for each job that has arcs there.
        belongs = 2 * block + (durations[arcs.job] < width[block])
        key = belongs * self._count + arcs.job
        heads = np.flatnonzero(np.diff(key, prepend=-1))
        rows, row_of_head = np.unique(key[heads], return_inverse=True)
        row_of_arc = np.repeat(row_of_head, np.diff(heads, append=key.size))
        row_table, row_job = np.divmod(rows, self._count)
        row_width = width[row_table // 2]
        offset = np.concatenate([[0], np.cumsum(row_width)])
        column = np.arange(offset[-1]) - np.repeat(offset[:-1], row_width)
        # Where a row has no arc its source only has to exist.
        source = np.repeat(self._bounds[row_table // 2] - durations[row_job], row_width) + column
        np.maximum(source, 0, out=source)
        self._gain = np.full(offset[-1], np.inf)
        self._gain[offset[row_of_arc] + arcs.end - self._bounds[block]] = arcs.gain
        self._job = np.repeat(row_job, row_width)
        self._weight = np.empty(offset[-1])
        self._prices = np.zeros(self._count)
        self._ways = Ways.nowhere(int(self._bounds[-1]))
        cuts = np.searchsorted(row_table, np.arange(2 * width.size + 1)).tolist()

        def table(block: int, low: int, high: int) -> _Table:
            shape, cells = (high - low, width[block]), slice(offset[low], offset[high])
            mine = source[cells].reshape(shape), self._weight[cells].reshape(shape)
            return _Table.of(*mine, row_job[low:high, None])

        self._blocks: list[_Block] = []
        for number, (begin, stop) in enumerate(pairwise(self._bounds.tolist())):
            first, middle, end = cuts[2 * number : 2 * number + 3]
            near = table(number, middle, end) if middle < end else None
            self._blocks.append(_Block(begin - 1, slice(begin, stop), table(number, first, end), near))

    def run(self, prices: Floats) -> Ways:
        """Give the cheapest ways to every slot; the next run overwrites them."""
        self._prices = prices
        np.add(self._gain, prices[self._job], out=self._weight)
        for block in self._blocks:
            block.reach(self._ways)
        cost, last, second, other = self._ways
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
