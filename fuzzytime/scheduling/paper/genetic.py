"""The paper's genetic algorithm, on wishes for start times: selection, reproduction, mutation; no bound."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.paper.climbing import SLOTS, at_least_one
from fuzzytime.scheduling.paper.wishes import Landscape, Wishes
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.solver import Draft

RIVALS = 3
"""Members that compete for being a parent."""

ELITE = 2
"""Members that live on as they are."""


@dataclass(frozen=True, slots=True)
class Genetic:
    """Breeds start times: each child has every job's wish from one of two parents, and some change.

    Parameters
    ----------
    seed
        Of all that is drawn.
    population
        Members of a generation.
    generations
        How many.
    mutation
        The share of children that change a little.

    Raises
    ------
    FuzzytimeError
        If there are too few members to breed, no generation, or the share is not in [0, 1].
    """

    name: ClassVar[str] = "genetic"

    seed: int = 0
    population: int = 120
    generations: int = 400
    mutation: float = 0.8

    def __post_init__(self) -> None:
        at_least_one(generations=self.generations)
        if self.population <= ELITE:
            raise FuzzytimeError(f"a population must have more than {ELITE} members, got {self.population}")
        if not 0 <= self.mutation <= 1:
            raise FuzzytimeError(f"mutation must be a share in [0, 1], got {self.mutation}")

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Breed generation after generation, and give the best member of the last."""
        generator = np.random.default_rng(self.seed)
        landscape = Landscape(problem, SLOTS)
        members = landscape.begun(generator, self.population, warm)
        cost, _ = landscape.scheduled(members)
        for _ in range(self.generations):
            if watch.is_over():
                break
            elite = np.argsort(cost, kind="stable")[:ELITE]
            children = self._children(generator, landscape, members, cost)
            members = children.replaced(np.arange(ELITE), members, elite)
            cost, _ = landscape.scheduled(members)
        return landscape.ended(members, int(cost.argmin()), warm)

    def _children(
        self, generator: np.random.Generator, landscape: Landscape, members: Wishes, cost: np.ndarray
    ) -> Wishes:
        """Give as many children as there are members."""
        size = self.population
        rivals = generator.integers(0, size, (2, size, RIVALS))
        first, second = np.take_along_axis(rivals, cost[rivals].argmin(axis=2)[..., None], 2)[..., 0]
        from_first = generator.random(members.slots.shape) < 0.5
        children = Wishes(
            np.where(from_first, members.slots[first], members.slots[second]),
            np.where(from_first, members.agents[first], members.agents[second]),
        )
        mutating = np.flatnonzero(generator.random(size) < self.mutation)
        changed = landscape.neighbours(generator, children.rows(mutating))
        return children.replaced(mutating, changed, np.arange(mutating.size))
