"""The sweep back over the labels of a run, which tells for every start whether a good schedule uses it.

A run of labels (`fuzzytime.scheduling.exact.labels`) knows what leads to each label. From the end back, the
same labels tell what the rest costs at least, now with the sets themselves in place of a bound. A start
through which every schedule costs too much can be deleted: far more are than by the bound, so that the next,
finer grid is small.
"""

from itertools import pairwise

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.bound.paths import Arcs
from fuzzytime.scheduling.exact.labels import Labels
from fuzzytime.scheduling.exact.memory import Masks
from fuzzytime.scheduling.exact.merging import lower
from fuzzytime.scheduling.problem.grid import Ints


def used_below(labels: Labels, threshold: float, beyond: Floats | None = None) -> Arcs:
    """Give the arcs of all schedules that cost less than a threshold, after an exact run.

    Parameters
    ----------
    labels
        The program that was run.
    threshold
        Where nothing is beyond, at most that of the run.
    beyond : array of shape (sets,)
        What is to be added for each of the last sets.
    """
    limit, count = threshold - labels.base, labels.durations.size
    within = min(limit, labels.limit) if beyond is None else labels.limit
    rest = _Rest(labels)
    used: list[Ints] = [np.empty(0, np.int64)]
    for number in reversed(range(labels.blocks)):
        masks, cost = labels.history[number] or (np.empty(0, np.uint64), np.empty((0, 0)))
        if not masks.size:
            continue
        here = np.full(cost.shape, np.inf)
        here[-1] = rest.after(number, number + 1, masks, slice(0, 1))
        if beyond is not None and number + 1 == labels.blocks:
            here[-1] += beyond
        for move in labels.moves[number]:
            sets, rows, after = labels.done(move, masks, cost, within)
            reached = masks[sets] | labels.memory.of_job[move.job]
            for block, row, part in labels.landings(number, move, rows):
                onward = rest.after(number, block, reached, slice(row, row + part.stop - part.start))
                through = np.flatnonzero((after[part] + onward < limit).any(axis=1))
                first = rows.start + part.start
                used.append((int(labels.bounds[number]) + first + through) * count + move.job)
                onward += move.cost[first - move.row :][: onward.shape[0], None]
                lower(here[first : first + onward.shape[0]], sets, onward)
        for later, row in pairwise(here[::-1]):
            np.minimum(later, row, out=row)
        rest.costs[number] = here
    key = labels.arcs.start * count + labels.arcs.job
    return labels.arcs.select(np.isin(key, np.concatenate(used)))


class _Rest:
    """What the rest costs at least, for the labels of each block that the sweep has seen."""

    def __init__(self, labels: Labels) -> None:
        self._labels = labels
        self.costs: list[Floats] = [np.empty((0, 0))] * (labels.blocks + 1)

    def after(self, origin: int, block: int, masks: Masks, rows: slice) -> Floats:
        """Give what sets that are carried into a block cost from its rows on; inf where none was kept."""
        sets, extra = self._labels.memory.closed(origin, block, masks)
        if block == self._labels.blocks:
            return extra[None, :]
        known = self._labels.history[block]
        if known is None:
            return np.full((rows.stop - rows.start, masks.size), np.inf)
        column = np.minimum(np.searchsorted(known[0], sets), known[0].size - 1)
        onward = self.costs[block][rows].take(column, axis=1)
        onward += np.where(known[0][column] == sets, extra, np.inf)
        return onward
