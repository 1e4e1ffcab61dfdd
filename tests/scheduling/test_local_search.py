"""The local search: whole days in no time."""

import numpy as np

from fuzzytime.satisfaction import Trapezoid
from fuzzytime.scheduling.limits import Limits, Stopwatch
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.problem.posing import problem_of
from fuzzytime.scheduling.search.local_search import LocalSearch
from fuzzytime.skills import FuzzySkill, FuzzyTask


def long_day(count: int, *, load: float) -> Problem:
    """Skills of any duration, wished for here and there."""
    generator = np.random.default_rng(count)
    durations = generator.uniform(30.0, 600.0, count)
    wishes = generator.uniform(0.0, durations.sum() / load, count)
    feet = generator.uniform(900.0, 3600.0, count)
    rows = zip(wishes.tolist(), feet.tolist(), durations.tolist(), strict=True)
    skills = tuple(
        FuzzySkill(str(index), Trapezoid(wish - foot, wish - 60, wish + 60, wish + foot), duration)
        for index, (wish, foot, duration) in enumerate(rows)
    )
    return problem_of(FuzzyTask(skills), 1e-3)


def test_out_of_time_at_once_hardly_anything_is_left_out() -> None:
    problem = long_day(300, load=0.7)
    found = LocalSearch().search(problem, Stopwatch(Limits(seconds=0.0)))
    assert np.isnan(found.starts).mean() < 0.05


def test_on_a_coarse_grid_plans_are_as_full_as_on_a_fine_one() -> None:
    problem, watch = long_day(150, load=1.0), Stopwatch(Limits(seconds=60.0))
    coarse, fine = (LocalSearch(slots=slots).search(problem, watch).cost for slots in (1, 20_000))
    assert coarse < 1.1 * fine
