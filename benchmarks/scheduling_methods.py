"""The paper's methods beside the exact one: ``python benchmarks/scheduling_methods.py [SKILLS …]``.

Random tasks of one agent, three seeds for each number of skills; wishes are trapezoids whose middles lie so
close that skills compete. For each method: the mean time of the processor, and by how much the geometric mean
of the satisfactions falls short of the proved bound, in the mean and at worst.
"""

import math
import sys
import time

import numpy as np

from fuzzytime.errors import RefusedError
from fuzzytime.satisfaction import Trapezoid
from fuzzytime.scheduling import (
    Auto,
    ExhaustiveSampling,
    Genetic,
    HillClimbing,
    Limits,
    LocalSearch,
    SimulatedAnnealing,
    Solver,
    solve,
)
from fuzzytime.skills import FuzzySkill, FuzzyTask

SEEDS = (1, 2, 3)
METHODS: tuple[Solver, ...] = (
    Auto(),
    LocalSearch(),
    ExhaustiveSampling(),
    HillClimbing(),
    SimulatedAnnealing(),
    Genetic(),
)


def crowded(count: int, seed: int) -> FuzzyTask:
    """Draw skills whose work takes about nine tenths of the time."""
    generator = np.random.default_rng(seed)
    middles = generator.uniform(100, 100 * count, count).tolist()
    durations = generator.integers(20, 160, count).tolist()
    return FuzzyTask(
        tuple(
            FuzzySkill(f"skill {index}", Trapezoid(m - 300, m - 60, m + 60, m + 300), float(duration))
            for index, (m, duration) in enumerate(zip(middles, durations, strict=True))
        )
    )


def main() -> None:
    """Print a table, a row for each number of skills and method."""
    print(f"{'skills':>6}  {'method':<14} {'seconds':>8} {'short':>9} {'at worst':>9}")
    for count in map(int, sys.argv[1:] or ("3", "10", "20")):
        tasks = [crowded(count, seed) for seed in SEEDS]
        bounds = [solve(task, objectives=(), limits=Limits(seconds=30)) for task in tasks]
        for method in METHODS:
            began, short = time.process_time(), []
            try:
                for task, bound in zip(tasks, bounds, strict=True):
                    found = solve(task, solver=method, objectives=(), limits=Limits(seconds=30))
                    gap = found.weighted_cost - bound.certificate.lower_cost
                    short.append(-math.expm1(-max(gap, 0.0) / count))
            except RefusedError:
                print(f"{count:>6}  {method.name:<14} refuses")
                continue
            spent = (time.process_time() - began) / len(tasks)
            print(f"{count:>6}  {method.name:<14} {spent:8.2f} {np.mean(short):9.2%} {max(short):9.2%}")


if __name__ == "__main__":
    main()
