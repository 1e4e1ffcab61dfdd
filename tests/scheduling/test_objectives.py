"""Each secondary objective, where schedules satisfy equally."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Rectangle, Trapezoid
from fuzzytime.scheduling import (
    EarliestStart,
    Energy,
    IdleTime,
    Intrusiveness,
    Makespan,
    Nearness,
    Objective,
    OverTime,
    Schedule,
    solve,
)
from fuzzytime.skills import FuzzySkill, FuzzyTask
from scheduling.random_tasks import faults, random_task

MEETING = OverTime((0, 100, 100, 200, 200, 300), (0, 0, 1, 1, 0, 0))
"""0 but for 1 from 100 s to 200 s."""


def skill(name: str, low: float, high: float, duration: float = 20.0) -> FuzzySkill:
    return FuzzySkill(name, Rectangle(low, high), duration)


def ends(schedule: Schedule) -> list[float]:
    return [entry.end for entry in schedule.skills]


def test_the_least_makespan_lets_the_last_skill_end_soonest() -> None:
    named = FuzzySkill("paint", Rectangle(50, 400), 20, preferred=300.0)
    task = FuzzyTask((skill("weld", 0, 100), named))
    assert max(ends(solve(task))) == 320
    assert max(ends(solve(task, objectives=(Makespan(),)))) == 70


def test_after_the_makespan_nearness_moves_only_what_does_not_end_last() -> None:
    weld = FuzzySkill("weld", Rectangle(0, 100), 20, preferred=40.0)
    paint = FuzzySkill("paint", Rectangle(150, 400), 20, preferred=300.0)
    schedule = solve(FuzzyTask((weld, paint)), objectives=(Makespan(), Nearness()))
    assert schedule.start_times == (40, 150)


def test_the_least_idle_time_lets_skills_follow_each_other() -> None:
    task = FuzzyTask((skill("weld", 0, 100), skill("paint", 150, 400), skill("wash", 90, 300)))
    early, dense = solve(task, objectives=(EarliestStart(),)), solve(task, objectives=(IdleTime(),))
    assert max(ends(early)) - min(early.start_times) == 170
    assert max(ends(dense)) - min(dense.start_times) == pytest.approx(70)


def test_after_the_idle_time_earliest_starts_keep_the_skills_together() -> None:
    task = FuzzyTask((skill("weld", 0, 100), skill("paint", 150, 400), skill("wash", 90, 300)))
    schedule = solve(task, objectives=(IdleTime(), EarliestStart()))
    assert max(ends(schedule)) - min(schedule.start_times) == pytest.approx(70)


def test_work_avoids_the_time_at_which_it_disturbs() -> None:
    task = FuzzyTask((FuzzySkill("drill", Rectangle(90, 260), 20, preferred=150.0),))
    assert solve(task).start_times == (150,)
    (start,) = solve(task, objectives=(Intrusiveness(MEETING), Nearness())).start_times
    assert start == pytest.approx(200, abs=0.5)


def test_where_work_must_disturb_it_disturbs_little() -> None:
    task = FuzzyTask((FuzzySkill("drill", Rectangle(90, 150), 20, preferred=150.0),))
    (start,) = solve(task, objectives=(Intrusiveness(MEETING), Nearness())).start_times
    assert start == pytest.approx(90, abs=0.5)


def test_the_skill_that_takes_most_power_has_the_cheap_time() -> None:
    task = FuzzyTask((skill("bake", 80, 150, 60), skill("sweep", 80, 150, 60)))
    night = OverTime((0, 140, 140, 300), (5, 5, 1, 1))
    for name, position in (("bake", 0), ("sweep", 1)):
        schedule = solve(task, objectives=(Energy(night, {name: 2000.0}, power=1.0), EarliestStart()))
        assert schedule.start_times[position] == pytest.approx(150, abs=1e-6)
        assert schedule.start_times[1 - position] == pytest.approx(90, abs=1e-6)


def test_energy_is_taken_until_the_result_is_there() -> None:
    eggs = FuzzySkill("eggs", Rectangle(0, 300), 5, elapsed=100)
    (start,) = solve(FuzzyTask((eggs,)), objectives=(Energy(MEETING), EarliestStart())).start_times
    assert start == 0


@given(st.lists(st.tuples(st.integers(0, 50), st.integers(0, 9)), min_size=1, max_size=6), st.floats(0, 40))
def test_a_curve_is_summed_up_as_many_small_steps_do(points: list[tuple[int, int]], duration: float) -> None:
    points.sort(key=lambda point: point[0])
    curve = OverTime(tuple(time for time, _ in points), tuple(value for _, value in points))
    grid = np.linspace(-10, -10 + duration, 40_001)
    middle = (grid[1:] + grid[:-1]) / 2
    # Of several values at one time the last holds from there on, the first until there.
    values = np.interp(middle, curve.times, curve.values)
    expected = float(values.sum() * (grid[1] - grid[0]))
    assert float(curve.over(np.array(-10.0), duration)) == pytest.approx(expected, abs=1e-2)


@pytest.mark.parametrize(
    ("times", "values"),
    [((), ()), ((1.0,), ()), ((2.0, 1.0), (0.0, 0.0)), ((1.0,), (-1.0,)), ((np.inf,), (1.0,))],
)
def test_an_impossible_curve_is_refused(times: tuple[float, ...], values: tuple[float, ...]) -> None:
    with pytest.raises(FuzzytimeError, match="a curve"):
        OverTime(times, values)


def test_a_negative_power_is_refused() -> None:
    with pytest.raises(FuzzytimeError, match="power must be finite and at least 0, got -1"):
        Energy(MEETING, {"bake": -1.0})


ALL: list[Objective] = [EarliestStart(), Makespan(), IdleTime(), Intrusiveness(MEETING), Energy(MEETING)]


@pytest.mark.parametrize("objective", ALL, ids=lambda objective: str(objective.name))
@settings(max_examples=15, deadline=None)
@given(seed=st.integers(0, 100_000))
def test_no_objective_costs_satisfaction(objective: Objective, seed: int) -> None:
    task = random_task(seed, most=4)
    plain, schedule = solve(task, objectives=()), solve(task, objectives=(objective, Nearness()))
    assert not faults(schedule)
    if not any(plain.rejected):
        assert schedule.weighted_cost <= plain.weighted_cost + 1e-8


def test_two_agents_each_have_their_last_skill() -> None:
    wish = Trapezoid(0, 10, 300, 400)
    skills = tuple(FuzzySkill(f"skill {k}", wish, 40, preferred=250.0) for k in range(4))
    schedule = solve(FuzzyTask(skills, agents=2), objectives=(Makespan(),))
    assert not faults(schedule)
    assert schedule.satisfaction == 1
