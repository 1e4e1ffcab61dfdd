"""The cheapest path through time, where a job may be visited any number of times at a price.

With prices λ, an arc of job i from slot t leads to slot t + d_i and costs c_i(t) + λ_i; idling is free:

    V[0] = 0,   V[t] = min(V[t − 1],  min over arcs that end at t of V[t − d_i] + c_i(t − d_i) + λ_i).

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


class _Block(NamedTuple):
    """A block's slots, the matrices of its arcs, and the job of each row."""

    begin: int
    stop: int
    source: Ints
    weight: Floats
    scratch: Floats
    jobs: Ints


class Paths:
    """The cheapest paths over one set of arcs, for any prices.

    Parameters
    ----------
    arcs
        Every duration at least one slot.
    durations : array of shape (jobs,)
        In slots.
    slots
        The last slot.
    """

    def __init__(self, arcs: Arcs, durations: Ints, slots: int) -> None:
        self.slots = slots
        self._count = durations.size
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
        self._value = np.zeros(self._bounds[-1])
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
                    np.empty(shape),
                    row_job[low:high],
                )
            )

    def run(self, prices: Floats) -> Floats:
        """Give V of every slot; the next run overwrites it."""
        np.add(self._gain, prices[self._job], out=self._weight)
        value = self._value
        for begin, stop, source, weight, scratch, _ in self._blocks:
            here = value[begin:stop]
            if not source.shape[0]:
                here[:] = value[begin - 1]
                continue
            value.take(source, out=scratch, mode="clip")
            np.add(scratch, weight, out=scratch)
            np.minimum.reduce(scratch, axis=0, out=here)
            here[0] = min(here[0], value[begin - 1])
            np.minimum.accumulate(here, out=here)
        return value[: self.slots + 1]

    def visits(self) -> Floats:
        """Tell how often the cheapest path of the last run visits each job."""
        value, slot = self._value, self.slots
        descent = -value[self._bounds[1:] - 1]  # V never rises
        count = np.zeros(self._count)
        while value[slot] < 0:
            begin, stop, source, weight, _, jobs = self._blocks[int(np.searchsorted(descent, -value[slot]))]
            column = int((value[begin:stop] <= value[slot]).argmax())
            row = int((value[source[:, column]] + weight[:, column]).argmin())
            slot = int(source[row, column])
            count[jobs[row]] += 1
        return count


def values_to_end(arcs: Arcs, durations: Ints, slots: int, prices: Floats) -> Floats:
    """Give what the cheapest path from each slot to the end costs: time runs backward."""
    mirrored = Arcs(arcs.job, slots - arcs.end, slots - arcs.start, arcs.gain)
    return Paths(mirrored, durations, slots).run(prices)[::-1].copy()
