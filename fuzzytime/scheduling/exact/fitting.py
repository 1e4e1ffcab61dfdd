"""Which shares of the work fit together: disjoint sets of jobs, one an agent, that cost least.

For each lane a table over all sets of jobs X holds the least cost of a listed share within X: n passes of
one operation each, a minimum over subsets (the zeta transform of Björklund, Husfeldt, Kaski and Koivisto,
Fourier meets Möbius, STOC 2007, 67-74). The last agent's share is looked up there. The others' are searched
with a bound: k more agents cost at least −λ(X) + k·min r on the jobs X that are left.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import Ints


@dataclass(frozen=True, slots=True, eq=False)
class Listed:
    """The shares that an agent of a lane may have.

    Parameters
    ----------
    agents
        How many agents the lane has.
    sets : array of shape (shares,)
        Bit i says that job i is in the share.
    reduced : array of shape (shares,)
        r of each.
    """

    agents: int
    sets: Ints
    reduced: Floats

    @property
    def least(self) -> float:
        """The lowest r."""
        return float(self.reduced.min(initial=np.inf))


@dataclass(frozen=True, slots=True)
class Fitted:
    """The cost of the best choice below a threshold, and the place of each agent's share in its lane's list.

    ``exact`` says that no choice below the threshold was cut off.
    """

    exact: bool
    cost: float
    chosen: tuple[int, ...]


class Fit:
    """The shares of all lanes, and tables over all sets of jobs.

    Parameters
    ----------
    lanes
        Their lists.
    base
        The cost of doing nothing.
    prices : array of shape (jobs,)
        λ.
    """

    def __init__(self, lanes: Sequence[Listed], base: float, prices: Floats) -> None:
        self.lanes, self.base = lanes, base
        self.of_agent = [number for number, lane in enumerate(lanes) for _ in range(lane.agents)]
        self._worth = np.zeros(1)
        for price in prices.tolist():
            self._worth = np.concatenate([self._worth, self._worth + price])
        self._all = self._worth.size - 1
        self._costs = [lane.reduced - self._worth[lane.sets] for lane in lanes]
        self._cheapest = [
            self._least_within(lane.sets, costs) for lane, costs in zip(lanes, self._costs, strict=True)
        ]
        several = len(self.of_agent) > 2
        self._reduced = [self._least_within(lane.sets, lane.reduced) for lane in lanes if several]

    def _least_within(self, sets: Ints, values: Floats) -> Floats:
        """Give for every set of jobs the least value of the listed sets within it."""
        table = np.full(self._worth.size, np.inf)
        table[sets] = values
        size = 1
        while size < table.size:
            halves = table.reshape(-1, 2, size)
            np.minimum(halves[:, 1], halves[:, 0], out=halves[:, 1])
            size *= 2
        return table

    def best(self, threshold: float, watch: Stopwatch) -> Fitted:
        """Search the disjoint shares, one for each agent, that cost least.

        Parameters
        ----------
        threshold
            Below which the cost must lie.
        watch
            Asked before each share that is tried.
        """
        search = _Search(self, threshold, watch)
        search.choose((), self._all, self.base)
        return Fitted(search.exact, search.cost if search.chosen else np.inf, search.chosen)

    def beyond(self) -> list[Floats]:
        """Give for each lane, for each share, what a schedule with it costs at least, less r.

        Exact for two agents, and a lower bound for more.
        """
        found = []
        for number, lane in enumerate(self.lanes):
            others = list(self.of_agent)
            others.remove(number)
            rest = self.rest(others, self._all ^ lane.sets)
            found.append(self.base - self._worth[lane.sets] + rest)
        return found

    def rest(self, others: Sequence[int], free: Ints) -> Floats:
        """Give what the shares of some agents, by their lanes, cost at least within sets of jobs."""
        if len(others) == 1:
            return np.asarray(self._cheapest[others[0]][free])
        return np.asarray(
            np.sum([self._reduced[number][free] for number in others], axis=0) - self._worth[free]
        )

    def within(self, agent: int, free: int, first: int) -> tuple[Ints, Ints, Floats]:
        """Give an agent's shares within a set, from a place on: their places, what is left, and costs."""
        sets, costs = self.lanes[self.of_agent[agent]].sets, self._costs[self.of_agent[agent]]
        places = first + np.flatnonzero(sets[first:] & ~free == 0)
        return places, free ^ sets[places], costs[places]


class _Search:
    """Depth first over agents; where two follow each other in a lane, so do their shares in its list."""

    def __init__(self, fit: Fit, threshold: float, watch: Stopwatch) -> None:
        self._fit, self._watch = fit, watch
        self.cost, self.exact = threshold, True
        self.chosen: tuple[int, ...] = ()

    def choose(self, path: tuple[int, ...], free: int, cost: float) -> None:
        """Give shares within a set of jobs to the agents that have none yet."""
        agent, lanes = len(path), self._fit.of_agent
        others = lanes[agent + 1 :]
        follows = agent > 0 and bool(others) and lanes[agent] == lanes[agent - 1]
        places, left, costs = self._fit.within(agent, free, path[-1] if follows else 0)
        total = cost + costs + (self._fit.rest(others, left) if others else 0.0)
        ranked = np.argsort(total)
        # Where one agent is left after this one the total is exact, and the least is enough.
        for k in ranked[: 1 if len(others) < 2 else None].tolist():
            if total[k] >= self.cost:
                return
            if self._watch.is_over():
                self.exact = False
                return
            chosen = (*path, int(places[k]))
            if others:
                self.choose(chosen, int(left[k]), cost + float(costs[k]))
            else:
                self.cost, self.chosen = float(total[k]), chosen
