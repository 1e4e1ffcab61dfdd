"""Hundreds of skills: prices that parts find hold for all, and no bound is too high."""

import numpy as np
import pytest

from fuzzytime.satisfaction import Trapezoid
from fuzzytime.scheduling.bound.relaxation import Relaxation, prices_from
from fuzzytime.scheduling.exact import crowd, threshold
from fuzzytime.scheduling.exact.crowd import improved_part_by_part
from fuzzytime.scheduling.exact.threshold import Labels
from fuzzytime.scheduling.limits import Limits, Stopwatch
from fuzzytime.scheduling.problem.grid import grid_of
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.problem.posing import problem_of
from fuzzytime.scheduling.search.local_search import LocalSearch
from fuzzytime.skills import FuzzySkill, FuzzyTask


def crowded(count: int, seed: int, *, load: float) -> Problem:
    """Wishes spread over a day that has hardly room for all."""
    generator = np.random.default_rng([count, seed])
    durations = 30.0 * generator.integers(1, 20, count)
    wishes = generator.uniform(0.0, durations.sum() / load, count)
    cores, feet = generator.uniform(60.0, 300.0, count), generator.uniform(300.0, 2400.0, count)
    rows = zip(wishes.tolist(), cores.tolist(), feet.tolist(), durations.tolist(), strict=True)
    skills = tuple(
        FuzzySkill(
            str(at), Trapezoid(wish - core - foot, wish - core, wish + core, wish + core + foot), duration
        )
        for at, (wish, core, foot, duration) in enumerate(rows)
    )
    return problem_of(FuzzyTask(skills), 1e-3)


@pytest.mark.parametrize("seed", range(4))
def test_prices_found_in_parts_prove_more_of_the_whole(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(crowd, "TOGETHER", 40)
    monkeypatch.setattr(crowd, "BESIDE", 15)
    problem, watch = crowded(120, seed, load=0.9), Stopwatch(Limits(seconds=60.0))
    best = LocalSearch().search(problem, watch)
    grid = grid_of(problem, 30.0)
    begun = prices_from(problem, grid, best)
    found = improved_part_by_part(problem, grid, best, begun, watch)
    before, after = (Relaxation(problem, grid, best.cost, prices).lower for prices in (begun, found))
    assert best.cost - after < 0.7 * (best.cost - before)


@pytest.mark.parametrize("seed", range(3))
def test_a_crowd_is_bounded_from_below_by_what_labels_prove(
    seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    problem, watch = crowded(40, seed, load=1.1), Stopwatch(Limits(seconds=60.0))
    exact = Labels().search(problem, watch)
    monkeypatch.setattr(threshold, "CROWD", 20)
    found = Labels().search(problem, watch)
    assert found.lower_cost <= exact.cost + 1e-9
    assert exact.lower_cost - 1e-9 <= found.cost
    assert found.cost - found.lower_cost <= 0.05 * len(problem.jobs)


def test_what_everybody_likes_is_closed_at_once() -> None:
    skills = tuple(
        FuzzySkill(str(at), Trapezoid(900 * at, 900 * at + 300, 900 * at + 600, 900 * at + 900), 60)
        for at in range(8)
    )
    problem = problem_of(FuzzyTask(skills), 1e-3)
    found = Labels().search(
        problem, Stopwatch(Limits(seconds=0.0)), LocalSearch().search(problem, Stopwatch(Limits()))
    )
    assert found.cost == found.lower_cost == pytest.approx(0.0, abs=1e-9)


def test_prices_of_a_long_order_are_those_of_all_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    problem, watch = crowded(150, 0, load=0.8), Stopwatch(Limits(seconds=60.0))
    best = LocalSearch(sweeps=1).search(problem, watch)
    grid = grid_of(problem, 30.0)
    prices = prices_from(problem, grid, best)
    monkeypatch.setattr("fuzzytime.scheduling.bound.relaxation.TOGETHER", 1000)
    assert np.abs(prices - prices_from(problem, grid, best)).max() < 1e-6
