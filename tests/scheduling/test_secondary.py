"""What counts among schedules that satisfy equally."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fuzzytime.satisfaction import ALWAYS, Bell, Rectangle, Sampled, Trapezoid, Triangle
from fuzzytime.scheduling import EarliestStart, HeldKarp, LocalSearch, Nearness, Schedule, Solver, solve
from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask, Precedence
from scheduling.random_tasks import faults, random_task

WIDE = Trapezoid(0, 45.6, 400, 500)


def named(name: str, preferred: float | None, duration: float = 60.0) -> FuzzySkill:
    return FuzzySkill(name, WIDE, duration, preferred=preferred)


def distance(schedule: Schedule) -> float:
    pairs = zip(schedule.task.skills, schedule.start_times, strict=True)
    return sum(start if s.preferred is None else abs(start - s.preferred) for s, start in pairs)


def test_alone_a_skill_starts_when_it_was_named() -> None:
    assert solve(FuzzyTask((named("flip", 240.0),))).start_times == (240,)


def test_without_a_named_start_earlier_is_better_up_to_a_rounder_time() -> None:
    assert solve(FuzzyTask((named("flip", None),))).start_times == (46,)


def test_satisfaction_goes_before_nearness() -> None:
    assert solve(FuzzyTask((named("flip", 450.0),))).start_times == pytest.approx((400,), abs=0.5)
    peak = FuzzySkill("stir", Triangle(0, 100, 200), 30, preferred=150.0)
    assert solve(FuzzyTask((peak,))).start_times == (100,)
    bell = FuzzySkill("stir", Bell(100, 30, 2), 30, preferred=90.0)
    assert solve(FuzzyTask((bell,))).start_times == (100,)


def test_the_order_follows_what_was_named() -> None:
    schedule = solve(FuzzyTask((named("last", 300.0), named("first", 100.0), named("second", 200.0))))
    assert schedule.start_times == (300, 100, 200)


def test_two_that_were_named_for_the_same_moment_share_the_distance() -> None:
    schedule = solve(FuzzyTask((named("flip", 200.0), named("pour", 200.0))))
    assert sorted(schedule.start_times) == pytest.approx([170, 230], abs=0.5)


def test_a_curve_of_points_has_its_named_start_too() -> None:
    curve = Sampled((0.0, 50.0, 100.0, 300.0, 350.0), (0.0, 0.2, 0.7, 0.7, 0.0))
    assert solve(FuzzyTask((FuzzySkill("stir", curve, 10, preferred=222.0),))).start_times == (222,)


def test_a_named_start_inside_an_appointment_moves_to_its_nearer_end() -> None:
    task = FuzzyTask((named("flip", 200.0),), busy=(Busy(150, 210),))
    assert solve(task).start_times == (210,)


def test_what_must_come_first_stays_first() -> None:
    task = FuzzyTask((named("boil", 300.0), named("peel", 100.0)), precedences=(Precedence(0, 1),))
    schedule = solve(task)
    assert not faults(schedule)
    assert distance(schedule) == pytest.approx(260)


@pytest.mark.parametrize("solver", [None, LocalSearch(), HeldKarp()])
def test_every_solver_goes_by_nearness(solver: Solver | None) -> None:
    task = FuzzyTask((named("last", 300.0), named("first", 100.0)))
    assert solve(task, solver=solver).start_times == (300, 100)


def test_of_two_objectives_the_first_counts_most() -> None:
    task = FuzzyTask((named("flip", 240.0),))
    assert solve(task, objectives=(EarliestStart(), Nearness())).start_times == (46,)
    assert solve(task, objectives=(Nearness(), EarliestStart())).start_times == (240,)


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 100_000))
def test_nothing_is_lost_and_the_sum_of_distances_never_grows(seed: int) -> None:
    task, generator = random_task(seed), np.random.default_rng(seed)
    skills = tuple(
        replace(skill, preferred=float(generator.uniform(0, 200)) if generator.random() < 0.7 else None)
        for skill in task.skills
    )
    task = replace(task, skills=skills)
    plain, near = solve(task, objectives=()), solve(task)
    assert not faults(near)
    # A rejected skill is placed after all others, which may by chance satisfy a little.
    slack = 0.5 * len(skills) if not any(plain.rejected) else np.inf
    if not any(plain.rejected):
        assert near.weighted_cost <= plain.weighted_cost + 1e-8
    late = [skill.satisfaction(np.inf) > 0 for skill in skills]
    if not any(late):
        assert distance(near) <= distance(plain) + slack
    assert near.certificate.status is plain.certificate.status


@pytest.mark.parametrize("durations", [(300.0, 60.0, 120.0), (60.0, 3600.0, 1.0), (10.0,) * 20])
def test_what_nobody_named_a_time_for_is_done_in_the_order_said(durations: tuple[float, ...]) -> None:
    always = Trapezoid(0, 0, 1e5, 2e5)
    skills = tuple(FuzzySkill(f"chore {place}", always, length) for place, length in enumerate(durations))
    starts = solve(FuzzyTask(skills)).start_times
    assert starts == pytest.approx(np.cumsum((0.0, *durations[:-1])).tolist())


def test_the_order_said_gives_way_to_a_start_that_was_named() -> None:
    always = Trapezoid(0, 0, 1e4, 2e4)
    chores = tuple(FuzzySkill(name, always, 300.0) for name in ("sweep", "dust", "mop"))
    flip = FuzzySkill("flip", always, 60.0, preferred=300.0)
    assert solve(FuzzyTask((*chores, flip))).start_times == pytest.approx((0, 360, 660, 300))


@pytest.mark.parametrize(("agents", "rest"), [(1, 1260.0), (2, 960.0)])
def test_what_may_be_at_any_time_is_near_to_what_was_named(agents: int, rest: float) -> None:
    read = FuzzySkill("read", ALWAYS, 1000.0)
    call = FuzzySkill("call", ALWAYS, 60.0, preferred=1200.0, alternatives=(300.0,))
    ring = FuzzySkill("ring", Rectangle(600.0, math.inf), 60.0, preferred=900.0)
    schedule = solve(FuzzyTask((read, call, ring), agents, busy=(Busy(840.0, 960.0),)))
    assert schedule.start_times == (rest, 1200.0, 960.0)
    assert not faults(schedule)
