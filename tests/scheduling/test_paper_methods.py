"""The paper's own methods: valid schedules, never better than what is proved, the same for the same seed."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fuzzytime.errors import FuzzytimeError, RefusedError
from fuzzytime.satisfaction import Rectangle, Trapezoid, Triangle
from fuzzytime.scheduling import (
    ExhaustiveSampling,
    Genetic,
    HillClimbing,
    Limits,
    SimulatedAnnealing,
    Solver,
    Status,
    solve,
)
from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask, Precedence
from scheduling.random_tasks import faults, random_task

QUICK: list[Solver] = [
    ExhaustiveSampling(frequency=0.1),
    HillClimbing(climbers=3, neighbours=8, patience=10),
    SimulatedAnnealing(chains=4, steps=100),
    Genetic(population=20, generations=30),
]
SEEDED = (HillClimbing, SimulatedAnnealing, Genetic)


def crowded(count: int) -> FuzzyTask:
    generator = np.random.default_rng(count)
    centres = generator.uniform(100, 90 * count, count).tolist()
    return FuzzyTask(
        tuple(
            FuzzySkill(f"skill {k}", Trapezoid(c - 300, c - 60, c + 60, c + 300), 100.0)
            for k, c in enumerate(centres)
        )
    )


@pytest.mark.parametrize("solver", QUICK, ids=lambda solver: str(solver.name))
@settings(max_examples=25, deadline=None)
@given(seed=st.integers(0, 100_000))
def test_a_schedule_is_valid_and_never_better_than_the_exact_one(solver: Solver, seed: int) -> None:
    task = random_task(seed, most=4)
    exact, found = solve(task, objectives=()), solve(task, solver=solver, objectives=())
    assert not faults(found)
    # A rejected skill is placed after all others, which may by chance satisfy a little.
    if not any(found.rejected):
        assert found.weighted_cost >= exact.certificate.lower_cost - 1e-9


@pytest.mark.parametrize("kind", SEEDED, ids=lambda kind: str(kind.name))
def test_on_few_skills_a_method_finds_what_is_best(kind: type[HillClimbing]) -> None:
    task = crowded(5)
    schedule = solve(task, solver=kind(seed=3))
    assert schedule.weighted_cost <= solve(task).weighted_cost + 1e-3
    assert schedule.certificate.status is Status.HEURISTIC
    assert schedule.certificate.method == kind.name


@pytest.mark.parametrize("kind", SEEDED, ids=lambda kind: str(kind.name))
def test_the_same_seed_gives_the_same_schedule(kind: type[HillClimbing]) -> None:
    task = crowded(12)
    assert solve(task, solver=kind(seed=5)).start_times == solve(task, solver=kind(seed=5)).start_times


@pytest.mark.parametrize("solver", QUICK, ids=lambda solver: str(solver.name))
def test_several_agents_lags_and_appointments_are_kept(solver: Solver) -> None:
    wish = Trapezoid(0, 20, 60, 90)
    task = FuzzyTask(
        (
            FuzzySkill("boil", wish, 20, elapsed=40, agent=2),
            FuzzySkill("peel", Triangle(60, 90, 200), 20),
            FuzzySkill("stir", wish, 30),
        ),
        agents=2,
        precedences=(Precedence(0, 1, 5, 60),),
        busy=(Busy(0, 30, agent=1), Busy(10, 15, agent=2)),
    )
    schedule = solve(task, solver=solver)
    assert not faults(schedule)
    assert schedule.agents[0] == 2
    assert not any(schedule.rejected)


@pytest.mark.parametrize("solver", QUICK, ids=lambda solver: str(solver.name))
def test_without_time_a_method_still_gives_a_schedule(solver: Solver) -> None:
    schedule = solve(crowded(4), solver=solver, limits=Limits(seconds=0))
    assert not faults(schedule)


def test_sampling_refuses_a_search_space_that_is_too_large() -> None:
    with pytest.raises(RefusedError, match=r"tries every vector of start times, at most 1e\+08, got \d+ × "):
        solve(crowded(12), solver=ExhaustiveSampling())


def test_sampling_meets_narrow_wishes_at_their_ends() -> None:
    task = FuzzyTask((FuzzySkill("a", Rectangle(61, 61), 10), FuzzySkill("b", Triangle(0, 77.5, 100), 3)))
    assert solve(task, solver=ExhaustiveSampling()).start_times == (61, 77.5)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: HillClimbing(climbers=0), "climbers must be at least 1, got 0"),
        (lambda: SimulatedAnnealing(hottest=0.1, coldest=1), "temperatures must fall"),
        (lambda: Genetic(population=2), "more than 2 members, got 2"),
        (lambda: Genetic(mutation=1.5), "a share in"),
        (lambda: ExhaustiveSampling(frequency=0), "above 0 and finite, got 0"),
        (lambda: ExhaustiveSampling(most=0), "at least one start vector"),
    ],
)
def test_impossible_settings_are_refused(make: object, message: str) -> None:
    assert callable(make)
    with pytest.raises(FuzzytimeError, match=message):
        make()
