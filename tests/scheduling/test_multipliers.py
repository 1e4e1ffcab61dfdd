"""Prices find the top of a concave function, however far it is."""

import numpy as np
import pytest
from scipy.optimize import linprog

from fuzzytime.satisfaction import Floats, Trapezoid
from fuzzytime.scheduling.bound.multipliers import Multipliers
from fuzzytime.scheduling.bound.relaxation import Relaxation
from fuzzytime.scheduling.limits import Limits, Stopwatch
from fuzzytime.scheduling.problem.grid import grid_of, step_for
from fuzzytime.scheduling.problem.posing import problem_of
from fuzzytime.scheduling.search.local_search import LocalSearch
from fuzzytime.skills import FuzzySkill, FuzzyTask


class Lowest:
    """The lowest of some planes, above a box of prices."""

    def __init__(self, slopes: Floats, levels: Floats, ceiling: Floats) -> None:
        self.slopes, self.levels, self.ceiling = slopes, levels, ceiling

    def evaluate(self, prices: Floats) -> tuple[float, Floats]:
        """Give the lowest plane's height and slope."""
        heights = self.levels + self.slopes @ prices
        lowest = int(heights.argmin())
        return float(heights[lowest]), self.slopes[lowest]

    def highest(self) -> float:
        """Give the top, by a linear program."""
        planes, prices = self.slopes.shape
        found = linprog(
            np.append(np.zeros(prices), -1.0),
            A_ub=np.hstack([-self.slopes, np.ones((planes, 1))]),
            b_ub=self.levels,
            bounds=[*((0.0, high) for high in self.ceiling.tolist()), (None, None)],
        )
        assert found.fun is not None
        return -found.fun


def visits(jobs: int, planes: int, seed: int) -> Lowest:
    """Paths that visit some jobs twice and some not at all, as the relaxation's do."""
    generator = np.random.default_rng(seed)
    slopes = generator.choice([-1.0, 0.0, 1.0], (planes, jobs), p=[0.3, 0.4, 0.3])
    return Lowest(slopes, generator.uniform(0.0, 20.0, planes), np.full(jobs, 7.0))


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("jobs", [5, 20, 60])
def test_the_search_ends_near_the_top(jobs: int, seed: int) -> None:
    bound = visits(jobs, 12 * jobs, seed)
    highest = bound.highest()
    begin = np.random.default_rng(seed).uniform(0.0, 7.0, jobs)
    first, _ = bound.evaluate(begin)
    prices = Multipliers(bound, begin, upper=highest + 0.1)
    watch = Stopwatch(Limits())
    assert prices.improve(highest + 0.1, 3000, watch)
    assert prices.lower <= highest + 1e-9
    assert prices.lower == pytest.approx(bound.evaluate(prices.prices)[0])
    assert highest - prices.lower <= 0.03 * (highest - first)


def test_nothing_is_promised_at_the_top() -> None:
    bound = Lowest(np.array([[1.0], [-1.0]]), np.array([0.0, 2.0]), np.array([5.0]))
    prices = Multipliers(bound, np.array([4.5]), upper=1.0)
    assert prices.improve(1.0, 100, Stopwatch(Limits()))
    assert prices.lower == pytest.approx(1.0, abs=1e-3)
    assert prices.improve(1.0, 100, Stopwatch(Limits()))


def test_a_search_that_is_cut_off_is_not_at_an_end() -> None:
    bound = visits(20, 200, 1)
    prices = Multipliers(bound, np.full(20, 7.0), upper=bound.highest())
    assert not prices.improve(bound.highest(), 3, Stopwatch(Limits()))


def crowded(count: int, seed: int) -> FuzzyTask:
    """Wishes about a few moments, wide enough to give way."""
    generator = np.random.default_rng(seed)
    durations = 10.0 * generator.integers(3, 40, count)
    horizon = durations.sum() / 0.7
    moments = generator.uniform(0.1, 0.9, 1 + count // 10) * horizon
    wishes = np.abs(generator.choice(moments, count) + generator.normal(0, 0.01 * horizon, count))
    core = generator.uniform(60.0, 240.0, count)
    foot = core + generator.uniform(200.0, 1200.0, count)
    corners = zip((wishes - foot).tolist(), (wishes - core).tolist(), (wishes + core).tolist(), strict=True)
    functions = [
        Trapezoid(a, b, c, d) for (a, b, c), d in zip(corners, (wishes + foot).tolist(), strict=True)
    ]
    skills = zip(functions, durations.tolist(), strict=True)
    return FuzzyTask(tuple(FuzzySkill(str(i), *skill) for i, skill in enumerate(skills)))


@pytest.mark.parametrize("seed", [2, 7])
def test_the_bound_is_the_same_wherever_prices_begin(seed: int) -> None:
    problem = problem_of(crowded(40, seed), 1e-3)
    problem = problem.select(max(problem.groups(), key=len))
    watch = Stopwatch(Limits(seconds=60.0))
    upper = LocalSearch(kicks=50).search(problem, watch).cost
    grid = grid_of(problem, step_for(problem, 1500))
    found = []
    for price in (0.0, 1.5, 3.0):
        relaxation = Relaxation(problem, grid, upper, np.full(len(problem.jobs), price))
        relaxation.improve(upper, 40, 1e-3, watch)
        found.append(relaxation.lower)
    assert max(found) - min(found) < 0.06 * (upper - max(found))
