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
from fuzzytime.skills import FuzzySkill, FuzzyTask, Precedence
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


@pytest.mark.parametrize("objective", ALL, ids=lambda objective: type(objective).__name__)
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


@pytest.mark.parametrize("wished", [150.0, 200.0, 260.0])
@pytest.mark.parametrize("named", [None, 500.0])
def test_a_wished_lag_is_kept_to_wherever_the_other_is(wished: float, named: float | None) -> None:
    soak = FuzzySkill("soak", Rectangle(0, 900), 30, preferred=named)
    task = FuzzyTask(
        (skill("weld", 0, 10, 60), soak, skill("drain", 0, 2000)),
        precedences=(Precedence(1, 2, 100, 300, wished),),
    )
    found = solve(task).skills
    assert found[2].start - found[1].done == pytest.approx(wished)
    assert found[1].start == (named or 60)


def test_what_is_named_says_when_what_it_comes_before_is() -> None:
    dinner = FuzzySkill("dinner", Rectangle(3000, 5000), 20, preferred=4000.0)
    task = FuzzyTask((skill("chill", 0, 4500), dinner), precedences=(Precedence(0, 1, 0, 2000, 600),))
    first, second = solve(task).skills
    assert (second.start, second.start - first.done) == (4000, 600)


@given(
    st.lists(st.floats(0, 400), min_size=3, max_size=3),
    st.floats(-200, 200).map(lambda low: round(low, 3)),
    st.floats(0, 300),
    st.floats(0, 1),
)
@settings(max_examples=20, deadline=None)
def test_wishing_for_a_lag_costs_no_satisfaction(
    peaks: list[float], low: float, width: float, share: float
) -> None:
    skills = tuple(
        FuzzySkill(f"s{place}", Trapezoid(peak - 120, peak - 60, peak + 60, peak + 120), 40)
        for place, peak in enumerate(peaks)
    )
    plain = FuzzyTask(skills, precedences=(Precedence(0, 2, low, low + width),))
    wished = FuzzyTask(skills, precedences=(Precedence(0, 2, low, low + width, low + share * width),))
    one, other = solve(plain), solve(wished)
    assert other.satisfaction == pytest.approx(one.satisfaction, abs=1e-9)
    assert not faults(other)


def test_a_wished_lag_lies_between_the_others() -> None:
    with pytest.raises(FuzzytimeError, match="wished lag must lie between"):
        Precedence(0, 1, 10, 20, 30)
