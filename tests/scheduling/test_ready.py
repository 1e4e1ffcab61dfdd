"""Jobs that are ready at once and whose costs never fall: the order is all that counts."""

import math
from itertools import permutations

import numpy as np
import pytest

from fuzzytime.errors import RefusedError
from fuzzytime.satisfaction import Trapezoid, Triangle
from fuzzytime.scheduling import Labels, Limits, Status, solve
from fuzzytime.scheduling.exact.dominance import Dominance
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.problem.posing import problem_of
from fuzzytime.scheduling.search.dynasearch import Dynasearch, only_order_counts
from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask, Precedence
from scheduling.random_tasks import random_ready_task


def problem_for(seed: int) -> Problem:
    """A random problem in which nothing is worth rejecting: each function stays above the threshold."""
    task = random_ready_task(seed)
    durations = [max(1.0, float(round(skill.duration))) for skill in task.skills]
    last = math.fsum(durations)
    generator = np.random.default_rng(seed)
    kinds = [
        Trapezoid(-math.inf, -math.inf, float(generator.uniform(0, last)), 3 * last),
        Trapezoid(0.0, 0.0, float(round(generator.uniform(0, last))), round(2.5 * last)),
        Trapezoid(-10.0, -5.0, -1.0, float(generator.uniform(1.5, 2) * last)),
    ]
    skills = [
        FuzzySkill(skill.name, kinds[int(generator.integers(3))], duration, priority=skill.priority)
        for skill, duration in zip(task.skills, durations, strict=True)
    ]
    return problem_of(FuzzyTask(tuple(skills)), 1e-9)


def cost_of(problem: Problem, order: tuple[int, ...]) -> float:
    """What the jobs cost one right after the other."""
    cost = time = 0.0
    for index in order:
        cost += float(problem.jobs[index].costs(time))
        time += problem.jobs[index].duration
    return cost


def keeps(problem: Problem, order: tuple[int, ...]) -> bool:
    """Whether an order, one job right after the other, keeps a problem's lags and windows."""
    time, starts = 0.0, {}
    for index in order:
        starts[index] = time
        time += problem.jobs[index].duration
    return all(starts[lag.first] < starts[lag.second] for lag in problem.lags) and all(
        any(window.low <= start <= window.high for window in problem.jobs[index].windows[0])
        for index, start in starts.items()
    )


@pytest.mark.parametrize("seed", range(60))
def test_some_best_order_keeps_all_that_is_deduced(seed: int) -> None:
    problem = problem_for(seed)
    assert only_order_counts(problem)
    known = Dominance(problem, 1.0).tightened(problem)
    orders = list(permutations(range(len(problem.jobs))))
    kept = [order for order in orders if keeps(known, order)]
    best = min(cost_of(problem, order) for order in orders)
    assert min(cost_of(problem, order) for order in kept) == pytest.approx(best, abs=1e-6)


def test_orders_are_deduced_from_most_problems() -> None:
    problems = [problem_for(seed) for seed in range(60)]
    assert sum(bool(Dominance(problem, 1.0).tightened(problem).lags) for problem in problems) > 40


def test_windows_are_cut_by_what_comes_before_and_after() -> None:
    functions = [Trapezoid(-math.inf, -math.inf, 0.0, 100.0), Trapezoid(-math.inf, -math.inf, 50.0, 150.0)]
    skills = [FuzzySkill(f"skill {index}", function, 10.0) for index, function in enumerate(functions)]
    problem = problem_of(FuzzyTask(tuple(skills)), 1e-3)
    first, second = Dominance(problem, 1.0).tightened(problem).jobs
    assert (first.latest, second.earliest, second.latest) == (0.0, 10.0, 10.0)


@pytest.mark.parametrize("seed", range(40))
def test_dynasearch_finds_the_best_order_of_few(seed: int) -> None:
    problem = problem_for(seed)
    draft = Dynasearch().search(problem, Stopwatch(Limits()))
    best = min(cost_of(problem, order) for order in permutations(range(len(problem.jobs))))
    assert draft.cost == pytest.approx(best, abs=1e-6)


def tardy(count: int, seed: int) -> FuzzyTask:
    """Much to do, each by its own time."""
    generator = np.random.default_rng(seed)
    durations = generator.integers(1, 30, count)
    due = generator.uniform(0.1, 0.6, count) * durations.sum()
    functions = [Trapezoid(-math.inf, -math.inf, float(round(d)), 4.0 * durations.sum()) for d in due]
    pairs = zip(functions, durations.tolist(), strict=True)
    return FuzzyTask(tuple(FuzzySkill(f"skill {i}", f, float(d)) for i, (f, d) in enumerate(pairs)))


def test_thirty_skills_that_may_only_be_late_are_proved() -> None:
    schedule = solve(tardy(30, 4), limits=Limits(seconds=60))
    assert schedule.certificate.status is Status.OPTIMAL
    assert schedule.certificate.method == "labels"


def test_the_orders_change_nothing_about_what_is_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    task = tardy(13, 2)
    with_orders = solve(task, solver=Labels())
    monkeypatch.setattr(Dominance, "tightened", lambda _, problem: problem)
    without = solve(task, solver=Labels())
    assert with_orders.certificate.status is without.certificate.status is Status.OPTIMAL
    assert with_orders.weighted_cost == pytest.approx(without.weighted_cost, abs=1e-3)


@pytest.mark.parametrize(
    "task",
    [
        FuzzyTask((FuzzySkill("late", Triangle(5, 10, 15), 5.0),)),
        FuzzyTask((FuzzySkill("soon", Trapezoid(0, 0, 10, 40), 5.0),), agents=2),
        FuzzyTask((FuzzySkill("soon", Trapezoid(0, 0, 10, 40), 5.0),), busy=(Busy(10.0, 20.0),)),
        FuzzyTask(
            tuple(FuzzySkill(n, Trapezoid(0, 0, 10, 40), 5.0) for n in "ab"), precedences=(Precedence(0, 1),)
        ),
    ],
)
def test_dynasearch_refuses_what_waiting_may_help(task: FuzzyTask) -> None:
    with pytest.raises(RefusedError, match="never fall"):
        Dynasearch().search(problem_of(task, 1e-3), Stopwatch(Limits()))
