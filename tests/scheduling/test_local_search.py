"""The local search: whole days in no time."""

import numpy as np

from fuzzytime.satisfaction import Rectangle, Trapezoid
from fuzzytime.scheduling.limits import Limits, Stopwatch
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.problem.posing import problem_of
from fuzzytime.scheduling.search.local_search import LocalSearch
from fuzzytime.scheduling.search.warm import one_by_one
from fuzzytime.skills import FuzzySkill, FuzzyTask, Precedence


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


def test_what_waits_one_for_another_is_planned_at_once() -> None:
    many = 40
    skills = tuple(FuzzySkill(f"step {index}", Rectangle(0, 1e5), 60) for index in range(many))
    order = tuple(Precedence(index, index + 1) for index in range(many - 1))
    draft = one_by_one(problem_of(FuzzyTask(skills, precedences=order), 1e-3))
    assert draft.starts.tolist() == [60.0 * index for index in range(many)]


def test_what_must_follow_what_finds_no_place_gets_none() -> None:
    skills = [FuzzySkill(name, Rectangle(100, 130), 60) for name in ("sweep", "mop")]
    skills.append(FuzzySkill("wax", Rectangle(0, 1e4), 60))
    draft = one_by_one(problem_of(FuzzyTask(tuple(skills), precedences=(Precedence(1, 2),)), 1e-3))
    assert np.isnan(draft.starts).tolist() == [False, True, True]
