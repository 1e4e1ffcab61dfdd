"""Time as a network: what is remembered of the past, slot by slot, and the cheapest ways through.

A node is a slot together with a *memory*: which of some jobs, the remembered ones, have been done. An arc
starts a job, or idles for a slot. A way from the beginning to the last slot is a schedule in which every
remembered job is done at most once, and every other job any number of times, at a price λ a time:

    F(t + d_i, S + i) = min over arcs of F(t, S) + c_i(t) + λ_i,     F(t + 1, S) ≤ F(t, S).

The nodes of one memory in neighbouring slots make a row; the rows of a stretch of slots no longer than the
shortest job that ends there make a block. All arcs into a block come from earlier ones, so that a block is a
few operations on matrices, and idling is a running minimum along rows.
"""

from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.grid import Curve, Ints

Masks = NDArray[np.uint64]

IDLE = -1
"""In place of a job: an arc that waits."""

LONGEST_BLOCK = 128


@dataclass(frozen=True, slots=True, eq=False)
class Block:
    """The rows of a stretch of slots, and the arcs that end in them.

    Arcs come in bundles: of one job, from one row to one row, one arc for each column of the block.

    Parameters
    ----------
    number
        Which of the stretches.
    begin, width
        Its first slot, and how many.
    masks : array of shape (rows,)
        What each row remembers.
    first_row, first_node
        Where its rows and nodes stand among all.
    job, source, target : arrays of shape (bundles,)
        Of each bundle the job, the row among all that it comes from, the row of the block that it leads to;
        in the order of the last.
    heads : array of shape (rows,)
        Each row's first bundle.
    origin : array of shape (bundles, width)
        The node each arc comes from.
    cost : array of shape (bundles, width)
        c, inf where there is no arc.
    """

    number: int
    begin: int
    width: int
    masks: Masks
    first_row: int
    first_node: int
    job: Ints
    source: Ints
    target: Ints
    heads: Ints
    origin: Ints
    cost: Floats

    @property
    def nodes(self) -> slice:
        """The block's nodes among all."""
        return slice(self.first_node, self.first_node + self.masks.size * self.width)


class _Part(NamedTuple):
    """A block with its parts of the network's arrays, of its bundles' shape and of its rows'."""

    block: Block
    cost: Floats
    weight: Floats
    reach: Floats
    forward: Floats
    backward: Floats


class Step(NamedTuple):
    """A job on a way, and the slot it starts in."""

    job: int
    slot: int


class Network:
    """Blocks in the order of time, and what is known of the cheapest ways.

    Node 0, which is row 0, is the beginning; the last node is the end.

    Parameters
    ----------
    blocks
        At least one; the last one's last row ends in the last slot.
    bounds : array of shape (stretches + 1,)
        First slots of the stretches, those without a block included.
    durations : array of shape (jobs,)
        In slots.
    """

    def __init__(self, blocks: list[Block], bounds: Ints, durations: Ints) -> None:
        self.blocks = blocks
        self.bounds = bounds
        self.durations = durations
        size = blocks[-1].nodes.stop
        self.row_nodes = np.concatenate(
            [[0], *(block.first_node + block.width * np.arange(block.masks.size) for block in blocks)]
        )
        self.row_stretches = np.concatenate(
            [[0], *(np.full(block.masks.size, block.number) for block in blocks)]
        )
        self.forward = np.full(size, np.inf)
        self.backward = np.full(size, np.inf)
        self._jobs = np.concatenate([block.job for block in blocks])
        self._widths = np.repeat([block.width for block in blocks], [block.job.size for block in blocks])
        # One array for all arcs, of which the blocks' are views: prices are added in one operation.
        self._cost = np.concatenate([block.cost.ravel() for block in blocks])
        self._weight = np.empty_like(self._cost)
        scratch = np.empty(max(block.cost.size for block in blocks))
        self._parts: list[_Part] = []
        end = 0
        for block in blocks:
            begin, end, shape = end, end + block.cost.size, block.cost.shape
            self._parts.append(
                _Part(
                    block,
                    self._cost[begin:end].reshape(shape),
                    self._weight[begin:end].reshape(shape),
                    scratch[: block.cost.size].reshape(shape),
                    self.forward[block.nodes].reshape(-1, block.width),
                    self.backward[block.nodes].reshape(-1, block.width),
                )
            )
        self._first_nodes = [block.first_node for block in blocks]

    @property
    def arcs(self) -> int:
        """How many arcs there is room for."""
        return self._cost.size

    def _price(self, prices: Floats) -> None:
        bundles = np.append(prices, 0.0)[self._jobs]
        np.add(self._cost, np.repeat(bundles, self._widths), out=self._weight)

    def run_forward(self, prices: Floats) -> float:
        """Work out the cheapest way from the beginning to every node; give what that to the end costs.

        Parameters
        ----------
        prices : array of shape (jobs,)
            λ; 0 for remembered jobs.
        """
        self._price(prices)
        value = self.forward
        value[0] = 0.0
        for block, _, weight, reach, here, _ in self._parts:
            value.take(block.origin, out=reach, mode="clip")
            np.add(reach, weight, out=reach)
            if block.heads.size == 1:
                np.minimum.reduce(reach, axis=0, out=here[0])
            else:
                np.minimum.reduceat(reach, block.heads, axis=0, out=here)
            np.minimum.accumulate(here, axis=1, out=here)
        return float(value[-1])

    def run_backward(self, prices: Floats) -> float:
        """Work out the cheapest way from every node to the end; give what that from the beginning costs."""
        self._price(prices)
        value = self.backward
        value.fill(np.inf)
        value[-1] = 0.0
        for block, _, weight, reach, _, here in reversed(self._parts):
            early = here[:, ::-1]
            np.minimum.accumulate(early, axis=1, out=early)
            here.take(block.target, axis=0, out=reach, mode="clip")
            np.add(reach, weight, out=reach)
            np.minimum.at(value, block.origin.ravel(), reach.ravel())
        return float(value[0])

    def fix(self, limit: float) -> int:
        """Delete arcs through which no way costs less than a limit, by the last runs; give how many are left."""
        left = 0
        for block, cost, weight, through, _, beyond in self._parts:
            self.forward.take(block.origin, out=through, mode="clip")
            through += weight
            through += beyond[block.target]
            dear = through >= limit
            cost[dear] = np.inf
            left += dear.size - int(np.count_nonzero(dear))
        return left

    def cheapest_way(self) -> list[Step]:
        """Give the jobs of a cheapest way by the last run forward, last first."""
        steps = []
        value = self.forward
        node = value.size - 1
        while node:
            block, _, weight, _, _, _ = self._parts[bisect_right(self._first_nodes, node) - 1]
            row, column = divmod(node - block.first_node, block.width)
            first = node - column
            column = int((value[first : node + 1] <= value[node]).argmax())
            low = block.heads[row]
            high = block.heads[row + 1] if row + 1 < block.heads.size else block.job.size
            origin = block.origin[low:high, column]
            bundle = int((value[origin] + weight[low:high, column]).argmin())
            job = int(block.job[low + bundle])
            if job != IDLE:
                steps.append(Step(job, block.begin + column - int(self.durations[job])))
            node = int(origin[bundle])
        return steps

    def starts(self) -> list[Ints]:
        """Give for each job the slots, ascending, in which an arc of it starts."""
        found: list[list[Ints]] = [[] for _ in self.durations]
        for part in self._parts:
            block, alive = part.block, np.isfinite(part.cost)
            for job in np.unique(block.job).tolist():
                if job != IDLE:
                    columns = np.flatnonzero(alive[block.job == job].any(axis=0))
                    found[job].append(columns + block.begin - self.durations[job])
        return [np.unique(np.concatenate(parts)) if parts else np.empty(0, np.int64) for parts in found]

    def parts(self) -> Iterator[tuple[Block, Floats, Floats]]:
        """Give each block with the costs of its arcs, and its nodes' costs to the end by the last run."""
        for part in self._parts:
            yield part.block, part.cost, part.backward


def stretches(curves: list[Curve], durations: Ints, slots: int) -> Ints:
    """Cut the slots into stretches no longer than the shortest job that ends in them; give their bounds."""
    shortest = np.full(slots + 2, LONGEST_BLOCK)
    for curve, duration in zip(curves, durations.tolist(), strict=True):
        ends = shortest[curve.first + duration : curve.stop + duration]
        np.minimum(ends, duration, out=ends)
    widths = np.arange(1, LONGEST_BLOCK + 1)
    bounds = [0]
    while bounds[-1] <= slots:
        inside = np.minimum.accumulate(shortest[bounds[-1] : bounds[-1] + LONGEST_BLOCK])
        bounds.append(bounds[-1] + max(1, int(np.count_nonzero(inside >= widths[: inside.size]))))
    bounds[-1] = slots + 1
    return np.array(bounds)


def forgetful(curves: list[Curve], durations: Ints, slots: int) -> Network:
    """Give the network that remembers nothing: one row a block, a node a slot.

    Parameters
    ----------
    curves
        Gains of each job, of at least one slot's duration, by start slot.
    durations : array of shape (jobs,)
        In slots.
    slots
        The last slot.
    """
    bounds = stretches(curves, durations, slots)
    blocks = []
    for number, (begin, end) in enumerate(zip(bounds[:-1].tolist(), bounds[1:].tolist(), strict=True)):
        bundles = [_idle(number, bounds)]
        for job, (curve, duration) in enumerate(zip(curves, durations.tolist(), strict=True)):
            first, stop = max(curve.first + duration, begin), min(curve.stop + duration, end)
            if first < stop:
                bundles += _bundles(job, curve, duration, first, stop, begin, end, bounds)
        job_column, source, cost = (list(column) for column in zip(*bundles, strict=True))
        shifts = np.array([durations[job] if job != IDLE else 1 for job in job_column])
        # Node k + 1 is slot k: the beginning, node 0, lies before them.
        origin = begin + 1 + np.arange(end - begin) - shifts[:, None]
        blocks.append(
            Block(
                number,
                begin,
                end - begin,
                np.zeros(1, np.uint64),
                number + 1,
                begin + 1,
                np.array(job_column),
                np.array(source),
                np.zeros(len(bundles), np.int64),
                np.zeros(1, np.int64),
                np.maximum(origin, 0),
                np.array(cost),
            )
        )
    return Network(blocks, bounds, durations)


def _idle(number: int, bounds: Ints) -> tuple[int, int, Floats]:
    """Give the arc that idles into a block's first slot from the last one before it."""
    cost = np.full(int(bounds[number + 1] - bounds[number]), np.inf)
    cost[0] = 0.0
    return IDLE, number, cost


def _bundles(
    job: int, curve: Curve, duration: int, first: int, stop: int, begin: int, end: int, bounds: Ints
) -> list[tuple[int, int, Floats]]:
    """Give a job's bundles that end in slots from first to stop, one for each block they come from."""
    found = []
    while first < stop:
        source = int(np.searchsorted(bounds, first - duration, "right")) - 1
        until = min(stop, int(bounds[source + 1]) + duration)
        cost = np.full(end - begin, np.inf)
        cost[first - begin : until - begin] = curve.gains[first - duration - curve.first : until - duration - curve.first]
        found.append((job, source + 1, cost))
        first = until
    return found
