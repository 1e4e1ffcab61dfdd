"""Labels: a dynamic program over time and the set of jobs done, pruned by a bound on what is to come.

A label (t, S, cost) is a partial schedule that ends by slot t with the jobs S done. S knows a job only
while its window is open: a job holds one of 64 bits from its first start to its last, or to that of the
last job that must come after it. When it closes, its price λ is paid if it was not done, the bit is
cleared, and labels that have become equal are one. With

    cost(label) = base + Σ over done jobs of (c + λ) + Σ over closed jobs not done of λ

and B the cheapest path to the end at the same prices (`fuzzytime.scheduling.bound.paths`) that does not begin
with a job of S, every schedule that continues a label costs at least cost + B[t]: labels for which that
reaches the threshold are dropped. So a schedule that is found is optimal, and where none is found every
schedule costs at least the threshold, unless something else was cut off: by the width of a beam, or for want
of room.

Labels come in blocks of slots no longer than the shortest job that starts in them: a matrix (slot × set), and
a job is added to all slots and sets of a block at once. Sets are many and slots few, so that what is done to
a row at a time is done to many numbers. Tanaka, Fujikuma and Araki, An exact algorithm for
single-machine scheduling without machine idle time, J. Sched. 12 (2009) 575-593, prune in the same way.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.bound.paths import Arcs, Ways, block_bounds, ways_to_end
from fuzzytime.scheduling.exact.memory import Masks, Remember, last_needed, memory_of_open
from fuzzytime.scheduling.exact.merging import Piece, merged
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import Ints

LONGEST_BLOCK = 64

ROUNDING = 1e-9


class _Move(NamedTuple):
    """A job's starts in one block, from a row on: their costs with its price, and B behind them."""

    job: int
    row: int
    cost: Floats
    ahead: Floats


class _Ahead(NamedTuple):
    """The cheapest ways from each slot to the end, the bits of their first jobs, and the second cheapest."""

    cost: Floats
    first: Masks
    second: Floats

    @classmethod
    def of(cls, beyond: Ways, bounds: Ints, opens: Ints, bits: Masks) -> "_Ahead":
        """Lay ways to the end over blocks; what opens later may share its bit, and gives none."""
        size = int(bounds[-1])
        block = np.repeat(np.arange(bounds.size - 1), np.diff(bounds))[: beyond.last.size]
        known = (beyond.last >= 0) & (opens[beyond.last] <= block)
        cost, second, first = np.zeros(size), np.zeros(size), np.zeros(size, np.uint64)
        cost[: known.size], second[: known.size] = beyond.cost, beyond.second
        first[: known.size] = np.where(known, bits[beyond.last], 0)
        return cls(cost, first, second)

    def at(self, masks: Masks, begin: int, stop: int) -> Floats:
        """Give for each slot, for each set, what the rest costs at least: its first job is not done yet."""
        done = (self.first[begin:stop, None] & masks) != 0
        return np.where(done, self.second[begin:stop, None], self.cost[begin:stop, None])


@dataclass(frozen=True, slots=True, eq=False)
class Found:
    """What a run found: the cost and start slots of the best schedule below its threshold, −1 if rejected.

    ``exact`` says that no schedule below the threshold was cut off: the one found, if any, is the best.
    """

    exact: bool
    cost: float = np.inf
    starts: Ints | None = None


class Labels:
    """The program over one lane's arcs.

    Parameters
    ----------
    arcs
        Starts that are left, every duration at least one slot.
    durations : array of shape (jobs,)
        In slots.
    slots
        The last slot.
    prices : array of shape (jobs,)
        λ.
    base
        The cost of rejecting everything, less all prices.
    before
        For each job those that must be done before it.
    remember
        What labels know of the jobs done.
    """

    def __init__(
        self,
        arcs: Arcs,
        durations: Ints,
        slots: int,
        prices: Floats,
        base: float,
        before: Sequence[Sequence[int]],
        remember: Remember = memory_of_open,
    ) -> None:
        self.arcs, self.durations, self.prices = arcs, durations, prices
        count, duration = durations.size, durations[arcs.job]
        longest = min(LONGEST_BLOCK, int(durations.max(initial=1)))
        self.bounds = block_bounds(0, slots, arcs.start, duration, longest)
        self.blocks = self.bounds.size - 1
        beyond = ways_to_end(arcs, durations, slots, prices)
        block = np.searchsorted(self.bounds, arcs.start, "right") - 1
        opens, closes = np.full(count, self.blocks), np.full(count, -1)
        np.minimum.at(opens, arcs.job, block)
        np.maximum.at(closes, arcs.job, block)
        self.memory = remember(opens, last_needed(closes, before), self.blocks, prices)
        bit = self.memory.of_job
        self.ahead = _Ahead.of(beyond, self.bounds, opens, bit)
        # What has no bit is rejected: for want of starts, or, incomplete, for want of bits.
        self.base = base + float(self.memory.prices[bit == 0].sum())
        self.needed = [np.bitwise_or.reduce(bit[list(firsts)], initial=np.uint64(0)) for firsts in before]
        possible = [bool(bit[job]) and all(bit[first] for first in before[job]) for job in range(count)]
        self.limit = np.inf
        self.history: list[tuple[Masks, Floats] | None] = []
        self.moves: list[list[_Move]] = [[] for _ in range(self.blocks)]
        order = np.lexsort((arcs.start, arcs.job, block))
        ordered, key = arcs.select(order), (block * count + arcs.job)[order]
        cuts = np.flatnonzero(np.concatenate([[True], key[1:] != key[:-1], [True]]))
        for low, high in pairwise(cuts.tolist() if key.size else ()):
            number, job = divmod(int(key[low]), count)
            if possible[job]:
                self.moves[number].append(self._move(ordered.select(slice(low, high)), job, number, beyond))

    def _move(self, arcs: Arcs, job: int, number: int, beyond: Ways) -> _Move:
        first, end = int(arcs.start[0]), int(arcs.end[0])
        cost = np.full(int(arcs.start[-1]) - first + 1, np.inf)
        cost[arcs.start - first] = arcs.gain + self.prices[job]
        after = beyond.without(slice(end, end + cost.size), np.array(job))
        return _Move(job, first - int(self.bounds[number]), cost, after)

    def run(self, threshold: float, watch: Stopwatch, cells: int, width: int | None = None) -> Found:
        """Search the best schedule that costs less than a threshold.

        Parameters
        ----------
        threshold
            For the cost.
        watch
            Asked before each job that is added to a block.
        cells
            Numbers to be written at most, the measure of time and memory.
        width
            Sets that are kept in each block at most; None for all.
        """
        limit = self.limit = threshold - self.base
        exact, used = self.memory.complete, 0
        history = self.history = [None] * self.blocks
        arriving: list[list[Piece]] = [[] for _ in range(self.blocks)]
        arriving[0].append(Piece(np.zeros(1, np.uint64), np.zeros((1, 1)), 0, -1))
        for number in range(self.blocks):
            if not arriving[number]:
                continue
            begin, stop = int(self.bounds[number]), int(self.bounds[number + 1])
            masks, cost = merged(arriving[number], self.memory, number, stop - begin)
            arriving[number] = []
            total = cost + self.ahead.at(masks, begin, stop)
            alive = np.flatnonzero((total < limit).any(axis=0))
            if width is not None and alive.size > width:
                alive = np.sort(np.argpartition(total.min(axis=0), width - 1)[:width])
                exact = False
            if not alive.size:
                continue
            masks, cost = masks[alive], cost.take(alive, axis=1)
            used += cost.size
            history[number] = masks, cost
            waiting = (total[-1, alive] < limit).nonzero()[0]
            if number + 1 < self.blocks and waiting.size:
                arriving[number + 1].append(Piece(masks[waiting], cost[-1:, waiting], 0, number))
            for move in self.moves[number]:
                if used > cells or watch.is_over():
                    return Found(exact=False)
                sets, rows, after = self.done(move, masks, cost, limit)
                used += after.size
                for block, row, here in self.landings(number, move, rows):
                    piece, arrived = after[here], sets
                    if piece.shape[0] < after.shape[0]:
                        some = np.flatnonzero(np.isfinite(piece).any(axis=0))
                        piece, arrived = piece.take(some, axis=1), sets[some]
                    if arrived.size:
                        reached = masks[arrived] | self.memory.of_job[move.job]
                        arriving[block].append(Piece(reached, piece, row, number))
        return self._best(limit, exact=exact)

    def done(self, move: _Move, masks: Masks, cost: Floats, limit: float) -> tuple[Ints, slice, Floats]:
        """Add a job to the labels of a block that may do it: sets, rows, costs, inf above the limit."""
        bit, needed = self.memory.of_job[move.job], self.needed[move.job]
        sets = ((masks & (bit | needed)) == needed).nonzero()[0]
        after = cost[move.row : move.row + move.cost.size].take(sets, axis=1)
        after += move.cost[:, None]
        below = after < (limit - move.ahead)[:, None]
        rows = below.any(axis=1).nonzero()[0]
        if not rows.size:
            return sets[:0], slice(0, 0), np.empty((0, 0))
        low, high = int(rows[0]), int(rows[-1]) + 1
        some = below.any(axis=0).nonzero()[0]
        after = np.where(below[low:high].take(some, axis=1), after[low:high].take(some, axis=1), np.inf)
        return sets[some], slice(move.row + low, move.row + high), after

    def landings(self, number: int, move: _Move, rows: slice) -> Iterator[tuple[int, int, slice]]:
        """Tell where a job that starts in some rows of a block ends.

        Gives the block, the row there from which on, and the part of the rows that ends in it.
        """
        end = int(self.bounds[number]) + rows.start + int(self.durations[move.job])
        size, done = rows.stop - rows.start, 0
        block = int(np.searchsorted(self.bounds, end, "right")) - 1
        while done < size:
            taken = min(size - done, int(self.bounds[block + 1]) - end)
            yield block, end - int(self.bounds[block]), slice(done, done + taken)
            end, done, block = end + taken, done + taken, block + 1

    def _best(self, limit: float, *, exact: bool) -> Found:
        """Give the best label of the last block."""
        _, final = self.last()
        column = int(final.argmin()) if final.size else 0
        if not final.size or final[column] >= limit:
            return Found(exact)
        return Found(exact, float(final[column] + self.base), self.traced(column))

    def last(self) -> tuple[Masks, Floats]:
        """Give the sets with which the last run came to the end, and what each costs, less the base."""
        masks, cost = self.history[-1] or (np.empty(0, np.uint64), np.empty((1, 0)))
        return masks, cost[-1] + self.memory.closed(self.blocks - 1, self.blocks, masks)[1]

    def traced(self, column: int) -> Ints:
        """Give the start slots of one of the last sets, −1 for what is not done: back along equal costs."""
        starts = np.full(self.durations.size, -1, np.int64)
        slack = ROUNDING * max(1.0, float(self.prices.max(initial=0.0)))
        block, row = self.blocks - 1, -1
        while True:
            masks, cost = self.history[block] or (np.empty(0, np.uint64), np.empty((0, 0)))
            value = cost[row, column] + slack
            # At the first slot with this cost something arrived.
            row = int((cost[:, column] <= value).argmax())
            slot = int(self.bounds[block]) + row
            if slot == 0:
                return starts
            for job, origin, past_row, added in self._arrivals(block, row, slot):
                bit = self.memory.of_job[job] if job is not None else np.uint64(0)
                needed = self.needed[job] if job is not None else np.uint64(0)
                past, past_cost = self.history[origin] or (masks, cost)
                after, extra = self.memory.closed(origin, block, past | bit)
                same = (after == masks[column]) & ((past & (bit | needed)) == needed)
                same &= past_cost[past_row] + added + extra <= value
                if same.any():
                    block, row, column = origin, past_row, int(same.argmax())
                    if job is not None:
                        starts[job] = slot - self.durations[job]
                    break
            else:  # pragma: no cover - every label has a predecessor
                raise RuntimeError("a label without a predecessor")

    def _arrivals(self, block: int, row: int, slot: int) -> Iterator[tuple[int | None, int, int, float]]:
        """Give what may arrive at a slot: idling over a block's edge (no job), or a job that ends there."""
        if row == 0 and self.history[block - 1] is not None:
            yield None, block - 1, -1, 0.0
        origins = np.searchsorted(self.bounds, slot - self.durations, "right") - 1
        for origin in np.unique(origins[origins >= 0]).tolist():
            for move in self.moves[origin] if self.history[origin] is not None else ():
                place = slot - int(self.durations[move.job] + self.bounds[origin])
                if origins[move.job] == origin and move.row <= place < move.row + move.cost.size:
                    yield move.job, origin, place, float(move.cost[place - move.row])
