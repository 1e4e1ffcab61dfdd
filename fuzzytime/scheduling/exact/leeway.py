"""What states of a set of jobs leave to the jobs outside: which are lost, and what they cost at least.

The soonest and the last start of a job follow from its arcs, from when agents are free, from the starts of
open jobs, and from the soonest and last starts of what must come before it. A job is *lost* where they cross.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.bound.paths import Arcs
from fuzzytime.scheduling.exact.open_jobs import LONG_AGO, Bools, JobSet, States
from fuzzytime.scheduling.problem.grid import Ints
from fuzzytime.scheduling.problem.jobs import Lag


class Costs(NamedTuple):
    """What a job costs with its price from its first slot on.

    For each slot also the last as good before it, and the least cost from there on and up to there.
    """

    first: int
    gains: Floats
    as_good: Ints
    from_there: Floats
    up_to_there: Floats

    @property
    def last(self) -> int:
        """The last slot."""
        return self.first + self.gains.size - 1

    @classmethod
    def of(cls, arcs: Arcs, price: float) -> "Costs":
        """Give the costs of a job by its arcs."""
        first = int(arcs.start.min())
        gains = np.full(int(arcs.start.max()) - first + 1, np.inf)
        gains[arcs.start - first] = arcs.gain + price
        behind, before = np.minimum.accumulate(gains[::-1])[::-1], np.minimum.accumulate(gains)
        return cls(first, gains, _last_as_good(first, gains), behind, before)

    def least(self, low: Floats, high: Floats) -> Floats:
        """Bound what the job costs from some slots to others; infinity where there are none between."""
        begin = np.maximum(low, self.first) - self.first
        end = np.minimum(high, self.last) - self.first
        some = begin <= end
        begin, end = (np.where(some, slots, 0).astype(np.int64) for slots in (begin, end))
        found: Floats = np.where(some, np.maximum(self.from_there[begin], self.up_to_there[end]), np.inf)
        return found


def _last_as_good(first: int, gains: Floats) -> Ints:
    """Give for each slot the last one before it that costs no more; the one before all where none does."""
    found, rising = np.full(gains.size, first - 1), [-1]
    for place, value in enumerate(gains.tolist()):
        while rising[-1] >= 0 and gains[rising[-1]] > value:
            rising.pop()
        found[place] = first + rising[-1]
        rising.append(place)
    return found


class Room(NamedTuple):
    """What states leave to the jobs outside their set.

    ``soonest``, of shape (jobs, states), is when agents let each start; ``lost``, of that shape, says which
    can no longer be done. A state is in ``vain`` that has lost what must come. The jobs outside cost so much
    at ``least``, each for itself.
    """

    soonest: Floats
    lost: Bools
    vain: Bools
    least: Floats

    def select(self, keep: Ints) -> "Room":
        """Give what some of the states leave."""
        return Room(self.soonest[:, keep], self.lost[:, keep], self.vain[keep], self.least[keep])


class Leeway:
    """Tells it for the arcs of all lanes.

    Parameters
    ----------
    lanes
        For each lane its arcs.
    agents
        How many each lane has.
    lags
        In slots.
    prices : array of shape (jobs,)
        λ.
    """

    def __init__(
        self, lanes: Sequence[Arcs], agents: Sequence[int], lags: Sequence[Lag], prices: Floats
    ) -> None:
        self._lags, self._prices = lags, prices
        self.team = list(pairwise(np.cumsum([0, *agents]).tolist()))
        self.costs = [
            {job: Costs.of(arcs.select(arcs.job == job), prices[job]) for job in np.unique(arcs.job).tolist()}
            for arcs in lanes
        ]

    def room(self, inside: JobSet, states: States) -> Room:
        """Work out what states leave to the jobs outside their set."""
        shape = self._prices.size, states.cost.size
        soonest, last = np.full(shape, np.inf), np.full(shape, -np.inf)
        for (first_agent, _), costs in zip(self.team, self.costs, strict=True):
            for job in costs.keys() & {*inside.outside}:
                free = np.maximum(states.free[:, first_agent], costs[job].first)
                np.minimum(soonest[job], free, out=soonest[job])
                np.maximum(last[job], costs[job].last, out=last[job])
        low = soonest.copy()
        for place, job, least, most, _ in inside.bonds:
            np.maximum(low[job], states.opened[:, place] + least, out=low[job])
            np.minimum(last[job], states.opened[:, place] + most, out=last[job])
        # Lags are sorted: what must come before is told before what comes behind.
        lags = [lag for lag in self._lags if not (inside.done >> lag.first | inside.done >> lag.second) & 1]
        for lag in lags:
            # What can never start says nothing of what may be any time before or behind it.
            if lag.low > -np.inf:
                np.maximum(low[lag.second], low[lag.first] + lag.low, out=low[lag.second])
            if lag.high < np.inf:
                np.minimum(last[lag.second], last[lag.first] + lag.high, out=last[lag.second])
        lost = np.zeros(shape, bool)
        lost[inside.outside] = low[inside.outside] > last[inside.outside]
        for lag in lags:
            lost[lag.second] |= lost[lag.first]
        vain, at_least = np.zeros(shape[1], bool), np.zeros(shape[1])
        for bond in inside.bonds:
            vain |= lost[bond.job] & bond.must
        for job in inside.outside:
            here = [costs[job].least(low[job], last[job]) for costs in self.costs if job in costs]
            alone = np.minimum.reduce([np.full(shape[1], self._prices[job]), *here])
            at_least += np.where(lost[job], self._prices[job], alone)
        return Room(soonest, lost, vain, at_least)

    def opened(self, inside: JobSet, states: States, room: Room) -> tuple[Ints, Bools]:
        """Give the starts of open jobs, all alike on which nothing depends, and which may be too late.

        A start is as good as any later one where no lag from it ends before the other's own last start. It
        may be too late where agents let the other start before a lag does: that of what it is too late for
        stays, or a state that has lost it would be like one that has not.
        """
        known, pinned = np.full(states.opened.shape, LONG_AGO), np.zeros(states.opened.shape, bool)
        for place, job, least, most, _ in inside.bonds:
            start, alive = states.opened[:, place], ~room.lost[job]
            pinned[:, place] |= start + least > room.soonest[job]
            ends = [costs[job].last for costs in self.costs if job in costs]
            if most < np.inf and ends:
                enough = np.minimum(start, max(ends) - int(most))
                known[:, place] = np.maximum(known[:, place], np.where(alive, enough, LONG_AGO))
        return np.where(pinned, states.opened, known), pinned
