"""Remembering more: the same network with more jobs that are done at most once.

A network that forgets whether job i was done lets ways do it twice. To remember it, every row splits in two:
one for the pasts with i, one for those without. Only what is reached from the beginning is built, and only
while it can still be part of a way below the limit, by the cheapest way to the end that the old network knows:
the better the bound, the smaller what follows. A job is remembered no longer than it matters: from its first
end to its last start, or to that of the last job that must come after it. Ibaraki and Nakamura, A dynamic
programming method for single machine scheduling, Eur. J. Oper. Res. 76 (1994) 72-82; Tanaka, Fujikuma and
Araki, An exact algorithm for single-machine scheduling without machine idle time, J. Sched. 12 (2009) 575-593.
"""

from collections.abc import Iterable, Sequence

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.grid import Ints
from fuzzytime.scheduling.network import Block, Masks, Network

BITS = 64


class TooLargeError(FuzzytimeError):
    """A network would have more arcs than there is memory for."""


class Memory:
    """Which jobs are remembered, by which bit, in which stretches.

    Parameters
    ----------
    network
        Gives the stretches, and by its arcs when each job can be done.
    before
        For each job those that must be done before it.
    """

    def __init__(self, network: Network, before: Sequence[Sequence[int]]) -> None:
        starts = network.starts()
        pairs = zip(starts, network.durations.tolist(), strict=True)
        first_end = [int(slots[0]) + duration if slots.size else 0 for slots, duration in pairs]
        last_start = [int(slots[-1]) if slots.size else -1 for slots in starts]
        self.repeats = [start >= end for start, end in zip(last_start, first_end, strict=True)]
        for job, firsts in enumerate(before):
            for first in firsts:
                last_start[first] = max(last_start[first], last_start[job])
        self.before = before
        self.bits = np.zeros(len(before) + 1, np.uint64)  # the last stands for idling
        self.kept = np.zeros(network.bounds.size - 1, np.uint64)
        # Idling, the last, is never remembered.
        self.begins = np.append(np.searchsorted(network.bounds, first_end, "right") - 1, 0)
        self.ends = np.append(np.searchsorted(network.bounds, last_start, "right"), 0)

    def add(self, jobs: Iterable[int]) -> list[int]:
        """Remember jobs for which there is a bit left; give those."""
        added = []
        for job in jobs:
            span = slice(int(self.begins[job]), int(self.ends[job]))
            taken = int(np.bitwise_or.reduce(self.kept[span], initial=np.uint64(0)))
            free = next((bit for bit in range(BITS) if not taken >> bit & 1), None)
            if free is not None and not self.bits[job]:
                self.bits[job] = np.uint64(1 << free)
                self.kept[span] |= self.bits[job]
                added.append(job)
        return added

    def still_kept(self, until: int) -> Masks:
        """Give for each stretch its bits that are kept in a later one, of the same jobs."""
        kept = np.zeros_like(self.kept)
        for job in np.flatnonzero(self.bits[:-1]).tolist():
            if self.ends[job] > until:
                kept[self.begins[job] : self.ends[job]] |= self.bits[job]
        return kept


def remembering(
    network: Network, memory: Memory, added: Sequence[int], prices: Floats, limit: float, most: int, width: int | None = None
) -> Network | None:
    """Give the network that remembers more jobs, or None where no way below the limit is left.

    Parameters
    ----------
    network
        Its last run backward must have been by the same prices.
    memory
        With the added jobs in it.
    added
        Jobs whose price falls to 0, as they are remembered from now on, or cannot be done twice.
    prices : array of shape (jobs,)
        λ before.
    limit
        For the cost of ways by the new prices.
    most
        Arcs, at most.

    Raises
    ------
    TooLargeError
        If there are more.
    """
    growth = _Growth(network, memory, added, prices, limit, width)
    blocks: list[Block] = []
    size = 0
    for block, cost, backward in network.parts():
        made = growth.split(block, cost, backward)
        if made is not None:
            blocks.append(made)
            size += made.cost.size
            if size > most:
                raise TooLargeError(f"a network of more than {most} arcs")
    # The end must be reached, by a row that remembers nothing more.
    if not blocks or blocks[-1].number != network.blocks[-1].number:
        return None
    return Network(blocks, network.bounds, network.durations)


class _Growth:
    """Splits a network's rows, block by block."""

    def __init__(
        self,
        network: Network,
        memory: Memory,
        added: Sequence[int],
        prices: Floats,
        limit: float,
        width: int | None,
    ) -> None:
        self.width = width
        self.old = network
        self.memory = memory
        self.limit = limit
        self.added = list(added)
        self.lost = np.array([prices[job] for job in added])
        new_prices = prices.copy()
        new_prices[self.added] = 0.0
        self.priced = np.append(new_prices, 0.0)
        rows = network.row_nodes.size
        self.first = np.zeros(rows, np.int64)  # of each old row: its first new row, and how many
        self.count = np.zeros(rows, np.int64)
        self.count[0] = 1
        self.masks = np.zeros(1024, np.uint64)  # of each new row
        self.nodes = np.zeros(1024, np.int64)  # of each new row: its first node
        self.value = np.zeros(1024)  # of each new node: the cheapest way to it
        self.rows = self.size = 1

    def split(self, block: Block, cost: Floats, backward: Floats) -> Block | None:
        """Give what becomes of a block, or None where nothing is left of it."""
        alive = np.isfinite(cost).any(axis=1)
        bundle = np.repeat(np.flatnonzero(alive), self.count[block.source[alive]])
        if not bundle.size:
            return None
        # The new rows of a bundle's old source follow each other.
        counts = self.count[block.source[alive]]
        within = np.arange(bundle.size) - np.repeat(np.cumsum(counts) - counts, counts)
        source = self.first[block.source[bundle]] + within
        job, masks = block.job[bundle], self.masks[source]
        stretch = self.old.row_stretches[block.source[bundle]]
        fits = self._fits(job, masks, stretch)
        bundle, source, job, masks, stretch = (
            column[fits] for column in (bundle, source, job, masks, stretch)
        )
        if not bundle.size:
            return None
        masks &= self.memory.still_kept(block.number)[stretch]
        masks |= np.where(self.memory.ends[job] > block.number, self.memory.bits[job], np.uint64(0))
        old_target = block.target[bundle]
        order = np.lexsort((masks, old_target))
        bundle, source, job, masks, old_target = (
            column[order] for column in (bundle, source, job, masks, old_target)
        )
        leads = np.append(True, (masks[1:] != masks[:-1]) | (old_target[1:] != old_target[:-1]))
        shift = self.nodes[source] - self.old.row_nodes[block.source[bundle]]
        origin = block.origin[bundle] + shift[:, None]
        np.clip(origin, 0, self.size - 1, out=origin)
        arcs = cost[bundle]
        reach = self.value.take(origin)
        reach += arcs
        reach += self.priced[job][:, None]
        beyond = backward[old_target[leads]] - self._owed(block.number, masks[leads])[:, None]
        target = np.cumsum(leads) - 1
        dear = reach + beyond[target] >= self.limit
        arcs[dear] = np.inf
        reach[dear] = np.inf
        heads = np.flatnonzero(leads)
        value = np.minimum.reduceat(reach, heads, axis=0)
        np.minimum.accumulate(value, axis=1, out=value)
        total = value + beyond
        value[total >= self.limit] = np.inf
        if self.width is not None and heads.size > self.width:
            worst = np.argpartition(total.min(axis=1), self.width)[self.width :]
            value[worst] = np.inf
        return self._kept(block, bundle, source, target, masks[leads], old_target[leads], origin, arcs, value)

    def _fits(self, job: Ints, masks: Masks, stretch: Ints) -> np.ndarray:
        """Tell which pasts let a job start: it is not done, and what must come before it is."""
        memory = self.memory
        fits = ((masks & memory.bits[job]) == 0) | (stretch < memory.begins[job])
        for second, firsts in enumerate(memory.before):
            for first in firsts:
                if memory.bits[first]:
                    done = ((masks & memory.bits[first]) != 0) & (stretch >= memory.begins[first])
                    fits &= done | (job != second)
        return np.asarray(fits)

    def _owed(self, number: int, masks: Masks) -> Floats:
        """Give the prices that the old costs to the end may hold for jobs that are not done yet."""
        owed = np.zeros(masks.size)
        for job, price in zip(self.added, self.lost, strict=True):
            if number >= self.memory.ends[job]:
                continue
            known = number >= self.memory.begins[job]
            owed += np.where(masks & self.memory.bits[job], 0.0, price) if known else price
        return owed

    def _kept(
        self,
        block: Block,
        bundle: Ints,
        source: Ints,
        target: Ints,
        masks: Masks,
        old_target: Ints,
        origin: Ints,
        arcs: Floats,
        value: Floats,
    ) -> Block | None:
        """Make the new block of the rows that are reached, and note where they are."""
        rows = np.isfinite(value).any(axis=1)
        if not rows.any():
            return None
        bundles = rows[target] & np.isfinite(arcs).any(axis=1)
        place = np.cumsum(rows) - 1
        target = place[target[bundles]]
        masks, old_target, value = masks[rows], old_target[rows], value[rows]
        made = Block(
            block.number,
            block.begin,
            block.width,
            masks,
            self.rows,
            self.size,
            block.job[bundle[bundles]],
            source[bundles],
            target,
            np.searchsorted(target, np.arange(masks.size)),
            origin[bundles],
            arcs[bundles],
        )
        old_rows = block.first_row + old_target
        self.count[block.first_row : block.first_row + block.masks.size] = np.bincount(
            old_target, minlength=block.masks.size
        )
        self.first[old_rows[::-1]] = np.arange(self.rows, self.rows + masks.size)[::-1]
        self.masks = _extended(self.masks, self.rows, masks)
        self.nodes = _extended(self.nodes, self.rows, self.size + block.width * np.arange(masks.size))
        self.value = _extended(self.value, self.size, value.ravel())
        self.rows += masks.size
        self.size += value.size
        return made


def _extended(array: np.ndarray, size: int, more: np.ndarray) -> np.ndarray:
    """Write values behind the first ones of an array that grows by doubling."""
    if size + more.size > array.size:
        array = np.resize(array, 2 * (size + more.size))
    array[size : size + more.size] = more
    return array
