"""Costs on the grid lie below those in continuous time."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.satisfaction import Rectangle, Sampled, SatisfactionFunction, Trapezoid
from fuzzytime.scheduling.problem.grid import grid_of, step_for
from fuzzytime.scheduling.problem.posing import problem_of
from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask
from satisfaction.shapes_of import plain


@given(plain, st.floats(0.2, 3e3), st.sampled_from([1e-3, 0.2, 0]), st.floats(0, 5e4))
def test_between_grid_points_the_bound_lies_below_the_cost(
    function: SatisfactionFunction, step: float, threshold: float, appointment: float
) -> None:
    busy = (Busy(appointment, appointment + 2.7 * step),)
    problem = problem_of(FuzzyTask((FuzzySkill("a", function, 1.3 * step),), busy=busy), threshold)
    for job in problem.jobs:
        step = max(step, job.latest / 2000)
        grid = grid_of(problem, step)
        curve = grid.curves[0][0]
        # Slots that cost as much as rejection are no starts: rejecting stands for them.
        gains = np.where(np.isinf(curve.gains), 0.0, curve.gains)
        slots = np.arange(curve.first - 1, curve.stop + 1)
        bound = np.concatenate([[0.0], gains, [0.0]])
        for window in job.windows[0]:
            times = np.unique([*np.linspace(window.low, window.high, 400), *function.kinks])
            times = times[(times >= window.low) & (times <= window.high)]
            below = np.interp(times / step - grid.origin, slots, bound)
            assert (below <= job.costs(times) - job.rejection + 1e-6).all()


def test_on_a_grid_of_corners_the_bound_touches_them() -> None:
    # Were it alone, no time long after its best one would be needed.
    late = FuzzySkill("b", Rectangle(500, 500), 10)
    problem = problem_of(FuzzyTask((FuzzySkill("a", Trapezoid(100, 200, 300, 400), 10), late)), 1e-3)
    grid = grid_of(problem, 1.0)
    curve = grid.curves[0][0]
    at = np.array([200, 250, 300]) - grid.origin - curve.first
    assert np.allclose(curve.gains[at] + problem.jobs[0].rejection, 0, atol=2e-5)


def test_at_a_jump_off_the_grid_the_better_side_keeps_its_cost() -> None:
    steps = Sampled([12.0, 13.0, 13.0, 24.0], [0.8, 0.8, 0.6, 0.6])
    problem = problem_of(FuzzyTask((FuzzySkill("a", steps, 6.0),)), 1e-3)
    for step in (0.3, 0.07, 0.003):
        curve = grid_of(problem, step).curves[0][0]
        assert curve.gains.min() + problem.jobs[0].rejection == problem.jobs[0].least


def test_an_instant_is_a_start_at_both_neighbouring_slots() -> None:
    problem = problem_of(FuzzyTask((FuzzySkill("a", Rectangle(10.5, 10.5), 1),)), 1e-3)
    grid = grid_of(problem, 1.0)
    assert (grid.times(np.arange(2)) == [10, 11]).all()
    assert grid.curves[0][0].gains.tolist() == [-problem.jobs[0].rejection] * 2


def test_durations_off_the_grid_are_rounded_down() -> None:
    problem = problem_of(FuzzyTask((FuzzySkill("a", Trapezoid(0, 5, 9, 20), 2.9),)), 1e-3)
    assert grid_of(problem, 1.0).durations.tolist() == [2]


def test_the_step_divides_all_durations_where_one_does() -> None:
    skills = (
        FuzzySkill("a", Trapezoid(0, 600, 900, 7200), 90),
        FuzzySkill("b", Trapezoid(0, 600, 900, 7200), 75),
    )
    assert step_for(problem_of(FuzzyTask(skills), 1e-3), 100) == 5
