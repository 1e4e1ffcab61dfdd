"""The paper's hill climbing and simulated annealing, on wishes for start times.

Hill climbing takes the best of some neighbours as long as one is better, and ends in a local optimum.
Simulated annealing (Kirkpatrick, Gelatt and Vecchi, Science 220 (1983) 671-680) also takes a worse neighbour,
with probability exp(−Δ/T), and less and less so as T falls. Both run from several starts side by side; both
give no bound.
"""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.paper.wishes import Landscape
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.solver import Draft

SLOTS = 1500
"""Slots of the grid, at least."""

IMPROVEMENT = 1e-9
"""A neighbour is better if it costs less by more than this."""


@dataclass(frozen=True, slots=True)
class HillClimbing:
    """Shifts and swaps start times as long as that satisfies more.

    Parameters
    ----------
    seed
        Of all that is drawn.
    climbers
        Starts, each drawn at random.
    neighbours
        How many each climber looks at before a step.
    patience
        Steps without a better neighbour after which a climber is on its hill.

    Raises
    ------
    FuzzytimeError
        If a number is below 1.
    """

    name: ClassVar[str] = "hill-climbing"

    seed: int = 0
    climbers: int = 8
    neighbours: int = 24
    patience: int = 40

    def __post_init__(self) -> None:
        at_least_one(climbers=self.climbers, neighbours=self.neighbours, patience=self.patience)

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Climb until every climber has stood still for long."""
        generator = np.random.default_rng(self.seed)
        landscape = Landscape(problem, SLOTS)
        best = landscape.begun(generator, self.climbers, warm)
        cost, _ = landscape.scheduled(best)
        still = np.zeros(self.climbers, np.int64)
        while (still < self.patience).any() and not watch.is_over():
            climbing = np.flatnonzero(still < self.patience)
            tried = landscape.neighbours(generator, best.rows(np.repeat(climbing, self.neighbours)))
            costs, _ = landscape.scheduled(tried)
            costs = costs.reshape(climbing.size, self.neighbours)
            least = costs.argmin(axis=1)
            better = costs.min(axis=1) < cost[climbing] - IMPROVEMENT
            still[climbing] = np.where(better, 0, still[climbing] + 1)
            up = climbing[better]
            best = best.replaced(up, tried, (np.arange(climbing.size) * self.neighbours + least)[better])
            cost[up] = costs.min(axis=1)[better]
        return landscape.ended(best, int(cost.argmin()), warm)


@dataclass(frozen=True, slots=True)
class SimulatedAnnealing:
    """Shifts and swaps start times, at first even where that satisfies less.

    Parameters
    ----------
    seed
        Of all that is drawn.
    chains
        Walks, each from its own random start.
    steps
        Neighbours that each walk looks at.
    hottest, coldest
        Temperatures of the first and the last step, in units of −log ψ; they fall geometrically.

    Raises
    ------
    FuzzytimeError
        If a number is below 1, or the temperatures do not fall to one above 0.
    """

    name: ClassVar[str] = "annealing"

    seed: int = 0
    chains: int = 16
    steps: int = 1200
    hottest: float = 2.0
    coldest: float = 0.002

    def __post_init__(self) -> None:
        at_least_one(chains=self.chains, steps=self.steps)
        if not 0 < self.coldest <= self.hottest < np.inf:
            raise FuzzytimeError(
                f"temperatures must fall and stay above 0, got {self.hottest} to {self.coldest}"
            )

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Walk while it cools down, and give the best that was passed."""
        generator = np.random.default_rng(self.seed)
        landscape = Landscape(problem, SLOTS)
        here = landscape.begun(generator, self.chains, warm)
        cost, _ = landscape.scheduled(here)
        best, least = here, cost.copy()
        for temperature in np.geomspace(self.hottest, self.coldest, self.steps):
            if watch.is_over():
                break
            tried = landscape.neighbours(generator, here)
            costs, _ = landscape.scheduled(tried)
            with np.errstate(over="ignore"):
                taken = np.flatnonzero(generator.random(self.chains) < np.exp((cost - costs) / temperature))
            here = here.replaced(taken, tried, taken)
            cost[taken] = costs[taken]
            better = np.flatnonzero(cost < least - IMPROVEMENT)
            best = best.replaced(better, here, better)
            least[better] = cost[better]
        return landscape.ended(best, int(least.argmin()), warm)


def at_least_one(**numbers: int) -> None:
    """Check that settings are at least 1.

    Raises
    ------
    FuzzytimeError
        If one of them is not.
    """
    for name, value in numbers.items():
        if value < 1:
            raise FuzzytimeError(f"{name} must be at least 1, got {value}")
