"""The methods for many skills, for several agents and for lags, beside independent optimisers."""

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest

from fuzzytime.satisfaction import Rectangle, Sampled, Trapezoid, Triangle
from fuzzytime.scheduling import (
    HeldKarp,
    Labels,
    Limits,
    LocalSearch,
    Milp,
    Pauses,
    Shares,
    Solver,
    Status,
    solve,
)
from fuzzytime.scheduling.auto import KICKS
from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask, Precedence
from scheduling.checks import FAMILIES, wrong
from scheduling.random_tasks import faults


@pytest.mark.parametrize(
    ("name", "seed"),
    [
        *(("one agent, labels", seed) for seed in range(16)),
        *(("one agent, all ready", seed) for seed in range(16)),
        *(("several agents", seed) for seed in range(16)),
        *(("several agents, shares", seed) for seed in range(16)),
        *(("several agents, program", seed) for seed in range(3)),
        *(("lags", seed) for seed in range(6)),
        *(("lags, pauses", seed) for seed in (*range(12), 793)),
        *(("lags, program", seed) for seed in range(4)),
        *(("curves and lags", seed) for seed in range(12)),
        *(("events", seed) for seed in (15, 23, 30, 51, 135)),
        *(("steps without end", seed) for seed in range(16)),
    ],
)
def test_no_random_task_is_solved_wrongly(name: str, seed: int) -> None:
    assert not list(wrong(FAMILIES[name], seed))


def spread(count: int, seed: int, agents: int = 1) -> FuzzyTask:
    """Wishes spread over as much time as the work needs."""
    generator = np.random.default_rng(seed)
    durations = 30.0 + 5 * generator.integers(0, 100, count)
    centres = generator.uniform(100, durations.sum() / agents, count)
    widths = generator.uniform(100, 600, count)
    skills = [
        FuzzySkill(
            f"skill {index}", Trapezoid(max(0.0, c - 2 * w), c - w / 4, c + w / 4, c + 2 * w), float(d)
        )
        for index, (d, c, w) in enumerate(zip(durations, np.maximum(centres, widths), widths, strict=True))
    ]
    return FuzzyTask(tuple(skills), agents)


def test_labels_and_held_karp_prove_the_same() -> None:
    task = spread(9, 5)
    labels, both = solve(task, solver=Labels()), solve(task)
    assert labels.certificate.status is both.certificate.status is Status.OPTIMAL
    assert labels.weighted_cost == pytest.approx(both.weighted_cost, abs=1e-4)


def test_twenty_skills_are_proved() -> None:
    schedule = solve(spread(20, 1), limits=Limits(seconds=60))
    assert not faults(schedule)
    assert schedule.certificate.status is Status.OPTIMAL


@pytest.mark.parametrize("agents", [2, 3])
def test_shares_prove_what_held_karp_proves(agents: int) -> None:
    task = spread(9, 3, agents)
    shares, both = solve(task, solver=Shares()), solve(task, solver=HeldKarp())
    assert shares.certificate.status is both.certificate.status is Status.OPTIMAL
    assert shares.weighted_cost == pytest.approx(both.weighted_cost, abs=1e-3)


def test_eighteen_skills_for_two_agents_are_proved() -> None:
    schedule = solve(spread(18, 4, agents=2), limits=Limits(seconds=60))
    assert not faults(schedule)
    assert schedule.certificate.status is Status.OPTIMAL


def test_the_bound_of_many_skills_holds_for_any_time_limit() -> None:
    task = spread(25, 2)
    best = solve(task, limits=Limits(seconds=60))
    for ticks in (0, 5, 50, 300):
        schedule = solve(task, limits=Limits(seconds=ticks, clock=Ticks()))
        assert not faults(schedule)
        assert schedule.certificate.lower_cost <= best.weighted_cost + 1e-6
        assert schedule.weighted_cost >= best.certificate.lower_cost - 1e-6


class Ticks:
    """A clock that moves on by one second whenever somebody looks at it."""

    def __init__(self) -> None:
        self._looks: Iterator[int] = iter(range(1 << 30))

    def __call__(self) -> float:
        return float(next(self._looks))


@pytest.mark.parametrize("solver", [Labels(), Shares(), Milp(), HeldKarp(), LocalSearch()])
def test_an_interrupt_gives_the_best_so_far(solver: Solver) -> None:
    looks = iter(range(1 << 30))

    def interrupted() -> bool:
        if next(looks) == 20:
            raise KeyboardInterrupt
        return False

    agents = 2 if isinstance(solver, Shares) else 1
    schedule = solve(spread(8, 1, agents), solver=solver, limits=Limits(stopped=interrupted))
    assert not faults(schedule)
    assert schedule.certificate.lower_cost <= schedule.weighted_cost


def test_little_memory_leaves_a_bound() -> None:
    schedule = solve(spread(20, 3), limits=Limits(seconds=20, memory=1 << 20))
    assert not faults(schedule)
    assert 0 <= schedule.certificate.lower_cost <= schedule.weighted_cost


def test_what_must_come_first_comes_first_among_many() -> None:
    task = spread(15, 4)
    first, second = 3, 8
    task = FuzzyTask(task.skills, precedences=(Precedence(first, second), Precedence(second, 11)))
    schedule = solve(task, solver=Labels(), limits=Limits(seconds=60))
    assert not faults(schedule)
    assert schedule.certificate.status is Status.OPTIMAL


def test_kicks_find_what_no_single_move_finds() -> None:
    tasks = [spread(25, seed, agents=2) for seed in range(4)]
    once = [solve(task, solver=LocalSearch()).weighted_cost for task in tasks]
    kicked = [solve(task, solver=LocalSearch(kicks=KICKS)) for task in tasks]
    assert not any(faults(schedule) for schedule in kicked)
    assert all(schedule.weighted_cost <= cost for schedule, cost in zip(kicked, once, strict=True))
    assert any(schedule.weighted_cost < cost - 0.1 for schedule, cost in zip(kicked, once, strict=True))


def test_two_agents_work_at_the_same_time() -> None:
    wish = Triangle(0, 600, 1200)
    skills = (FuzzySkill("sweep", wish, 300), FuzzySkill("mop", wish, 300))
    schedule = solve(FuzzyTask(skills, agents=2))
    assert list(schedule.start_times) == [600, 600]
    assert sorted(schedule.agents) == [1, 2]


def test_a_lag_is_kept_between_agents() -> None:
    eggs = FuzzySkill("boil the eggs", Rectangle(0, 60), 60, elapsed=600, agent=1)
    peel = FuzzySkill("peel them", Triangle(0, 300, 1500), 120, agent=2)
    schedule = solve(FuzzyTask((eggs, peel), 2, (Precedence(0, 1, 60, 300),)), solver=Milp())
    assert schedule.certificate.status is Status.OPTIMAL
    assert schedule.start_times == pytest.approx((0, 660))


@pytest.mark.parametrize("solver", [None, Pauses(), Milp()])
def test_what_takes_no_time_may_start_with_what_it_must_not_precede(solver: Solver | None) -> None:
    stir = FuzzySkill("stir the soup", Rectangle(21, 22), 3.0)
    ring = FuzzySkill("ring the bell", Rectangle(21, 21), 0.0)
    # Three seconds before the soup is done: when stirring begins.
    schedule = solve(FuzzyTask((stir, ring), precedences=(Precedence(0, 1, -3.0, -3.0),)), solver=solver)
    assert schedule.start_times == (21.0, 21.0)
    assert schedule.certificate.lower_cost == 0.0


@pytest.mark.parametrize("rest", [0.0, 1.0])
@pytest.mark.parametrize("solver", [None, Pauses(), Milp()])
def test_what_is_too_late_for_another_is_not_as_good_as_what_is_not(
    solver: Solver | None, rest: float
) -> None:
    """Both orders of boiling and frying take as long, but only one leaves time for peeling."""
    boil = FuzzySkill("boil", Sampled([12, 12, 22, 22], [0, 0.5, 0.5, 0]), 1.0, elapsed=5.0)
    fry = FuzzySkill("fry", Sampled([1, 12, 12, 14, 14, 22, 22], [0.5, 0.5, 0.9, 0.9, 0.5, 0.5, 0]), 5.0)
    peel = FuzzySkill("peel", Rectangle(-math.inf, 21), rest)
    task = FuzzyTask((boil, replace(fry, priority=2), peel), precedences=(Precedence(0, 2),))
    schedule = solve(task, solver=solver)
    assert schedule.certificate.lower_cost <= -math.log(0.5) - 2 * math.log(0.9) + 1e-9
    assert schedule.satisfactions == (0.5, 0.9, 1.0)


@pytest.mark.parametrize("solver", [None, HeldKarp(), Pauses(), Milp(), LocalSearch()])
def test_what_must_only_not_come_late_may_come_at_any_time_before(solver: Solver | None) -> None:
    serve, ring = (
        FuzzySkill("serve", Rectangle(60, 90), 5.0),
        FuzzySkill("ring", Trapezoid(0, 0, 0, 200), 5.0),
    )
    task = FuzzyTask((serve, ring), precedences=(Precedence(0, 1, -math.inf, 10.0),))
    schedule = solve(task, solver=solver)
    assert schedule.start_times == (60.0, 0.0)
    late = replace(ring, satisfaction=Rectangle(120, 200))
    rejected = solve(replace(task, skills=(serve, late)), solver=solver)
    assert rejected.rejected == (False, True)


def test_what_must_end_shortly_before_dinner_is_not_done_in_the_morning() -> None:
    # All but the roast may be done at any time of the day, and nothing is better than with all of them.
    day = Trapezoid(0, 0, 56000, 56000)
    roast = FuzzySkill("put in the roast", Trapezoid(27900, 28500, 29100, 29700), 60, elapsed=720)
    others = [
        ("carve", 300),
        ("serve", 300),
        ("pour the wine", 30),
        ("call everybody", 600),
        ("wash up", 180),
    ]
    boil = FuzzySkill("boil the potatoes", day, 180, elapsed=1500)
    mash = FuzzySkill("mash them", day, 240)
    skills = (roast, *(FuzzySkill(name, day, seconds) for name, seconds in others), boil, mash)
    bonds = (
        (0, 1, 0, 1200),
        (1, 2, 0, 300),
        (3, 2, 0, 600),
        (4, 2, 0, 1500),
        (2, 5, 0, 3600),
        (6, 7, 0, 300),
    )
    order = tuple(Precedence(*bond) for bond in (*bonds, (7, 2, 0, 1500)))
    schedule = solve(FuzzyTask(skills, precedences=order), limits=Limits(seconds=60))
    assert not faults(schedule)
    assert schedule.certificate.status is Status.OPTIMAL
    assert schedule.satisfaction == pytest.approx(1)


def test_an_event_of_unknown_moment_takes_nobody_from_work() -> None:
    arrive = FuzzySkill("the guests arrive", Triangle(0, 50, 100), 0, happens=True)
    work = FuzzySkill("bake", Rectangle(0, 0), 100)
    serve = FuzzySkill("serve", Rectangle(0, 1000), 10)
    schedule = solve(FuzzyTask((arrive, work, serve), precedences=(Precedence(0, 2, 0, 60),)))
    assert not faults(schedule)
    assert schedule.start_times == pytest.approx((50, 0, 100))
    assert schedule.certificate.status is Status.OPTIMAL


def test_a_hundred_skills_for_two_agents_come_with_a_gap() -> None:
    task = spread(100, 6, agents=2)
    lunch = Busy(9000, 11000, "lunch")
    chain = tuple(Precedence(k, k + 50) for k in range(10))
    schedule = solve(FuzzyTask(task.skills, 2, chain, (lunch,)), limits=Limits(seconds=5))
    assert not faults(schedule)
    assert math.isfinite(schedule.certificate.gap)  # how small it is depends on the machine
