"""What counts among schedules that satisfy equally."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fuzzytime.satisfaction import ALWAYS, Bell, Rectangle, Sampled, SatisfactionFunction, Trapezoid, Triangle
from fuzzytime.scheduling import (
    EarliestStart,
    HeldKarp,
    LocalSearch,
    Nearness,
    Schedule,
    Solver,
    Status,
    solve,
)
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


def test_what_goes_on_by_itself_changes_nothing_of_the_order_said() -> None:
    always = Trapezoid(0, 0, 1e5, 2e5)
    hands, over = (900.0, 480.0, 720.0, 60.0, 60.0, 300.0), (900.0, 480.0, 720.0, 1800.0, 60.0, 300.0)
    skills = tuple(
        FuzzySkill(f"chore {place}", always, length, elapsed=elapsed)
        for place, (length, elapsed) in enumerate(zip(hands, over, strict=True))
    )
    task = FuzzyTask(skills, precedences=(Precedence(2, 3), Precedence(3, 4), Precedence(4, 5)))
    assert solve(task).start_times == pytest.approx((0, 900, 1380, 2100, 3900, 3960))


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


EVENING = Trapezoid(2 * 3600, 2.4 * 3600, 5 * 3600, 6 * 3600)


@pytest.mark.parametrize(
    ("past_hour", "others", "starts"),
    [
        # At 16:00 "this evening" is fully there at 18:24; a quarter of an hour is rounder than five minutes.
        (0.0, (), [8640.0 + 360]),
        (60.0, (), [8640.0 + 300]),
        # Somebody comes at 18:34, so that 18:30 is too late, and 18:25 is not.
        (0.0, (Triangle(9150, 9240, 9330),), [8640.0 + 60, 9240.0]),
        # What was named right behind it does not move, nor what comes before that.
        (0.0, (Triangle(8740, 8940, 9140),), [8640.0, 8940.0]),
    ],
)
def test_where_a_vague_time_begins_the_clock_is_round(
    past_hour: float, others: tuple[SatisfactionFunction, ...], starts: list[float]
) -> None:
    first = replace(FuzzySkill("bathe", EVENING, 300.0), by_the_clock=True)
    rest = tuple(FuzzySkill("call", one, 60.0).starting_near(one.best.low) for one in others)
    schedule = solve(FuzzyTask((first, *rest), past_hour=past_hour))
    assert list(schedule.start_times) == pytest.approx(starts)
    assert schedule.satisfaction == 1.0
    assert schedule.certificate.status is Status.OPTIMAL


@pytest.mark.parametrize(
    "wish",
    [
        Rectangle(8640, 20000),
        Trapezoid(-1000, 0, 5000, 6000),
        Trapezoid(250, 500, 5000, 6000),
        Trapezoid(8000, 8640, 8690, 20000),
    ],
    ids=["told to the minute", "now", "soon", "over before it is round"],
)
def test_a_time_that_somebody_told_is_not_rounded(wish: SatisfactionFunction) -> None:
    skill = replace(FuzzySkill("bathe", wish, 300.0), by_the_clock=True)
    assert solve(FuzzyTask((skill,))).start_times == (max(0.0, wish.best.low),)
    untold = FuzzySkill("bathe", EVENING, 300.0)
    assert solve(FuzzyTask((untold,))).start_times == (8640.0,)


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 100_000), st.floats(0, 3600))
def test_a_round_clock_costs_nobody_anything(seed: int, past_hour: float) -> None:
    plain = random_task(seed)
    stretched = tuple(
        replace(skill, satisfaction=skill.satisfaction.shifted(1800.0), by_the_clock=seed % 2 == place % 2)
        for place, skill in enumerate(plain.skills)
    )
    task = replace(plain, skills=stretched, past_hour=past_hour)
    round_ones, others = (
        solve(task),
        solve(replace(task, skills=tuple(replace(s, by_the_clock=False) for s in stretched))),
    )
    assert not faults(round_ones)
    assert round_ones.weighted_cost <= others.weighted_cost + 1e-8
    assert round_ones.certificate.status is others.certificate.status
