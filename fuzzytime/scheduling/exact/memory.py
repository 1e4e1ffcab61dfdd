"""What a label remembers: which of the jobs that are still open have been done, in 64 bits.

A job is open from its first possible start to its last, or to that of the last job that must come after it.
Jobs that are not open at the same time may share a bit, so that 64 bits serve any number of jobs with at most
64 open at once.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.problem.grid import Ints

Masks = NDArray[np.uint64]

BITS = 64

Remember = Callable[[Ints, Ints, int, Floats], "Memory"]
"""Gives bits to jobs, by their first and last blocks, the number of blocks, and prices."""


@dataclass(frozen=True, slots=True, eq=False)
class Memory:
    """Which bit each job holds, and when it gives it back.

    Parameters
    ----------
    of_job : array of shape (jobs,)
        The bit of each, 0 for none.
    closing
        For each block, and the end, the jobs that give theirs back before it.
    prices : array of shape (jobs,)
        What is paid for a job that closes and was not done.
    complete
        Whether there was a bit for every job that ever opens.
    """

    of_job: Masks
    closing: list[list[int]]
    prices: Floats
    complete: bool

    def closed(self, after: int, block: int, masks: Masks) -> tuple[Masks, Floats]:
        """Carry sets from one block into a later one: clear bits that close, and give what that costs."""
        extra = np.zeros(masks.size)
        for number in range(after + 1, block + 1):
            for job in self.closing[number]:
                bit = self.of_job[job]
                extra += np.where(masks & bit, 0.0, self.prices[job])
                masks = masks & ~bit
        return masks, extra


def memory_of_open(opens: Ints, closes: Ints, blocks: int, prices: Floats) -> Memory:
    """Give bits to jobs so that those open in the same block differ; jobs for which none is left get none.

    Parameters
    ----------
    opens, closes : arrays of shape (jobs,)
        First and last block in which each is open; the last is negative where it never is.
    blocks
        How many there are.
    prices : array of shape (jobs,)
        λ.
    """
    bit = np.zeros(opens.size, np.uint64)
    closing: list[list[int]] = [[] for _ in range(blocks + 1)]
    last_use, complete = np.full(BITS, -1), True
    for job in np.argsort(opens, kind="stable").tolist():
        if closes[job] < 0:
            continue
        free = np.flatnonzero(last_use < opens[job])
        if free.size:
            bit[job] = np.uint64(1 << int(free[0]))
            closing[closes[job] + 1].append(job)
            last_use[free[0]] = closes[job]
        else:
            complete = False
    return Memory(bit, closing, prices, complete)


def memory_of_all(opens: Ints, closes: Ints, blocks: int, prices: Floats) -> Memory:
    """Give each of at most 64 jobs a bit that it keeps, where nothing is paid for what is not done.

    Parameters
    ----------
    opens, closes, blocks, prices
        As for `memory_of_open`.
    """
    bit = np.where(closes >= 0, np.uint64(1) << np.arange(opens.size, dtype=np.uint64), np.uint64(0))
    return Memory(bit, [[] for _ in range(blocks + 1)], np.zeros(prices.size), complete=True)


def last_needed(closes: Ints, before: Sequence[Sequence[int]]) -> Ints:
    """Let what must come first stay open as long as what waits for it.

    Parameters
    ----------
    closes : array of shape (jobs,)
        The last block in which each can start, negative where it never can.
    before
        For each job those that must be done before it.
    """
    found = closes.copy()
    changed = True
    while changed:
        changed = False
        for job, firsts in enumerate(before):
            for first in firsts:
                if 0 <= found[first] < found[job]:
                    found[first], changed = found[job], True
    return found
