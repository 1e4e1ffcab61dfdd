"""Jobs that are tied to each other, moved as one among schedules that satisfy equally."""

import math

import numpy as np
import pytest

from fuzzytime.satisfaction import ALWAYS, Interval, Triangle
from fuzzytime.scheduling import THRESHOLD, EarliestStart, Limits, Nearness, solve
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.jobs import Job, Lag, Lane, Problem
from fuzzytime.scheduling.problem.posing import problem_of
from fuzzytime.scheduling.secondary.clusters import with_clusters_moved
from fuzzytime.scheduling.secondary.lexicographic import rearranged
from fuzzytime.scheduling.solver import draft_of
from fuzzytime.skills import FuzzySkill, FuzzyTask, Precedence
from scheduling.random_tasks import faults, random_bound_task

SOON = Triangle(-1, 0, 100_000)


def job(position: int, duration: float, windows: list[Interval], wish: Triangle = SOON) -> Job:
    return Job(position, wish, 1.0, duration, duration, 1e3, 1e3, math.inf, (tuple(windows),))


def moved(problem: Problem, starts: list[float], seconds: float = 10.0) -> list[float]:
    draft = draft_of(problem, np.array(starts, float), np.ones(len(starts), np.int64))
    found = with_clusters_moved(problem, draft, Stopwatch(Limits(seconds)))
    return [float(start) for start in found.starts]


ANYTIME, NOON = [Interval(0, 1000)], [Interval(500, 500)]
ONE = (Lane((1,), ()),)
DRIP, FILTER, LUNCH = job(0, 10, ANYTIME), job(1, 20, ANYTIME), job(2, 60, NOON)


def test_what_is_tied_moves_through_others_as_one() -> None:
    problem = Problem((DRIP, FILTER, LUNCH), ONE, (Lag(0, 1, 10, 15),))
    assert moved(problem, [560, 570, 500]) == [0, 10, 500]


def test_both_sides_of_a_pause_have_to_fit() -> None:
    fixed = [job(2 + place, 25, [Interval(start, start)]) for place, start in enumerate((0, 40, 65))]
    problem = Problem((DRIP, FILTER, *fixed), ONE, (Lag(0, 1, 10, 15),))
    # 15 seconds from 25 on hold the first only.
    assert moved(problem, [560, 570, 0, 40, 65]) == [90, 100, 0, 40, 65]


def test_the_order_within_a_cluster_is_sought() -> None:
    problem = Problem((DRIP, FILTER, LUNCH), ONE, (Lag(0, 1, -50, 50),))
    assert moved(problem, [580, 560, 500]) == [0, 10, 500]


def test_a_cluster_goes_next_to_what_one_of_it_wishes() -> None:
    wishing = job(1, 20, ANYTIME, Triangle(-99_700, 300, 100_300))
    problem = Problem((DRIP, wishing, LUNCH), ONE, (Lag(0, 1, 10, 10),))
    starts = moved(problem, [560, 570, 500])
    assert starts[1] - starts[0] == pytest.approx(10)
    assert starts[1] <= 300


def test_lags_to_what_stands_still_bind() -> None:
    problem = Problem(
        (DRIP, FILTER, LUNCH, job(3, 5, [Interval(700, 700)])),
        ONE,
        (Lag(0, 1, 10, 15), Lag(2, 0, 60, math.inf)),
    )
    assert moved(problem, [800, 810, 500, 700])[:2] == [560, 570]


def test_nothing_moves_when_the_time_is_over() -> None:
    problem = Problem((DRIP, FILTER, LUNCH), ONE, (Lag(0, 1, 10, 15),))
    assert moved(problem, [560, 570, 500], seconds=0) == [560, 570, 500]


def test_in_a_plan_of_many_what_is_tied_is_early_too() -> None:
    def at(time: float) -> FuzzySkill:
        return FuzzySkill(f"at {time}", Triangle(time - 60, time, time + 60), 600.0, preferred=time)

    # With a fortnight to plan for a grid is too coarse for what follows after exactly half an hour.
    times = [*(hour * 3600.0 for hour in range(1, 8)), 14 * 86400.0]
    tied = [
        FuzzySkill("drain", ALWAYS, 60.0),
        FuzzySkill("brakes", ALWAYS, 30.0),
        FuzzySkill("filter", ALWAYS, 300.0),
    ]
    drain = len(times)
    bonds = (Precedence(drain, drain + 2, 1800.0, 1800.0), Precedence(drain, drain + 1, 0.0, 60.0))
    task = FuzzyTask((*map(at, times), *tied), precedences=bonds)
    problem = problem_of(task, THRESHOLD)
    assert [job.position for job in problem.jobs] == list(range(len(task.skills)))
    late = draft_of(
        problem,
        np.array([*times, 25800, 25860, 27600]),
        np.ones(len(task.skills), np.int64),
    )
    found = rearranged(problem, task, late, (Nearness(),), Stopwatch(Limits()))
    assert found.cost <= late.cost
    assert found.starts[drain:].max() < 3600


@pytest.mark.parametrize("seed", range(30))
def test_at_random_nothing_satisfies_less_and_no_lag_is_broken(seed: int) -> None:
    task = random_bound_task(seed)
    plain = solve(task, objectives=())
    for objective in (EarliestStart(), Nearness()):
        early = solve(task, objectives=(objective,))
        assert not faults(early)
        assert early.rejected == plain.rejected
        if not any(plain.rejected):
            assert early.weighted_cost <= plain.weighted_cost + 1e-8
            assert sum(early.start_times) <= sum(plain.start_times) + 0.5 * len(task.skills)
