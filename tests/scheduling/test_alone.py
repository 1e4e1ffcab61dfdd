"""What a skill could have alone."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.satisfaction import ALWAYS, NEVER, Bell, Rectangle, Sampled, Trapezoid
from fuzzytime.scheduling import best_alone
from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask
from scheduling.random_tasks import random_task


def task_of(function: object, *busy: Busy, agents: int = 1, agent: int | None = None) -> FuzzyTask:
    skill = FuzzySkill("call", function, 20.0, agent=agent)  # type: ignore[arg-type]
    return FuzzyTask((skill,), agents, busy=busy)


def test_a_plateau_is_best_from_end_to_end() -> None:
    best = best_alone(task_of(Trapezoid(0, 60, 90, 120)), 0, near=0)
    assert best.satisfaction == 1
    assert (best.starts.low, best.starts.high) == pytest.approx((60, 90), abs=1e-6)


def test_what_is_past_is_no_time_to_start() -> None:
    best = best_alone(task_of(Trapezoid(-100, -80, -60, 60)), 0, near=30)
    assert best.satisfaction == pytest.approx(0.5)
    assert best.nearest(30) == pytest.approx(0, abs=1e-6)


def test_an_appointment_of_the_only_agent_takes_its_minutes() -> None:
    assert best_alone(task_of(Rectangle(50, 60), Busy(0, 55)), 0, near=0).nearest(0) == 55
    assert best_alone(task_of(Rectangle(50, 60), Busy(0, 100)), 0, near=0).satisfaction == 0


def test_another_agent_is_free_while_one_has_an_appointment() -> None:
    busy = Busy(0, 100, agent=1)
    assert best_alone(task_of(Rectangle(50, 60), busy, agents=2), 0, near=0).satisfaction == 1
    assert best_alone(task_of(Rectangle(50, 60), busy, agents=2, agent=1), 0, near=0).satisfaction == 0


def test_of_two_peaks_the_nearer_one_is_given() -> None:
    peaks = Sampled((0.0, 10.0, 20.0, 50.0, 60.0, 70.0), (0.0, 0.8, 0.0, 0.0, 0.8, 0.0))
    assert best_alone(task_of(peaks), 0, near=15).nearest(15) == pytest.approx(10)
    assert best_alone(task_of(peaks), 0, near=45).nearest(45) == pytest.approx(60)


def test_what_may_be_done_at_any_time_is_best_at_any_time() -> None:
    best = best_alone(task_of(ALWAYS), 0, near=1234)
    assert (best.satisfaction, best.starts.low, best.starts.high) == (1, 0, math.inf)


def test_what_never_satisfies_has_no_best_time() -> None:
    best = best_alone(task_of(NEVER), 0, near=0)
    assert best.satisfaction == 0
    assert best.starts.empty


@given(st.integers(0, 100_000))
def test_no_start_on_a_fine_raster_is_better(seed: int) -> None:
    task = random_task(seed)
    for position, skill in enumerate(task.skills):
        best = best_alone(task, position, near=0)
        times = np.linspace(0, 600, 6001)
        for busy in task.busy:
            times = times[(times <= busy.start - skill.duration) | (times >= busy.end)]
        assert skill.satisfaction(times).max(initial=0) <= best.satisfaction + 1e-12
        if not best.starts.empty:
            assert float(skill.satisfaction(best.starts.low)) == pytest.approx(best.satisfaction)


def test_a_bell_after_its_centre_is_best_at_once() -> None:
    best = best_alone(task_of(Bell(100, 50, 2), Busy(80, 150)), 0, near=0)
    assert best.nearest(0) == pytest.approx(60)
    assert best.satisfaction == pytest.approx(float(Bell(100, 50, 2)(60)))
