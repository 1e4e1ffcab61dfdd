"""Planning on: what has started stays, the rest is scheduled anew, and what moved is said."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Rectangle, Trapezoid, Triangle
from fuzzytime.scheduling import LocalSearch, replan, solve
from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask, Precedence
from scheduling.random_tasks import faults, random_task

SOUP = FuzzySkill("soup", Triangle(60, 120, 180), 30)
SALAD = FuzzySkill("salad", Triangle(200, 300, 400), 60, preferred=300.0)


def test_when_nothing_happened_nothing_moves() -> None:
    before = solve(FuzzyTask((SOUP, SALAD)))
    later = replan(before, 50)
    assert not later.moves
    assert not later.running
    assert list(later.kept) == [0, 1]
    assert list(later.schedule.start_times) == [70, 250]
    assert later.schedule.satisfactions == before.satisfactions
    assert later.schedule.task.skills[1].preferred == 250


def test_what_has_started_holds_its_agent_until_it_is_done() -> None:
    later = replan(solve(FuzzyTask((SOUP, SALAD))), 130, added=[FuzzySkill("bell", Triangle(-20, 0, 20), 5)])
    (soup,) = later.running
    assert (soup.name, soup.start, soup.end) == ("soup", -10, 20)
    assert later.kept == (1,)
    assert later.schedule.start_times[1] >= 20


def test_what_is_done_is_forgotten() -> None:
    later = replan(solve(FuzzyTask((SOUP, SALAD))), 200)
    assert not later.running
    assert [skill.name for skill in later.schedule.skills] == ["salad"]


def test_what_works_by_itself_runs_on_and_leaves_its_agent_free() -> None:
    eggs = FuzzySkill("eggs", Rectangle(0, 0), 10, elapsed=100)
    later = replan(solve(FuzzyTask((eggs, SOUP))), 50)
    assert [skill.name for skill in later.running] == ["eggs"]
    assert list(later.schedule.start_times) == [70]


def test_what_must_come_after_a_started_skill_waits_for_it_and_keeps_its_open_end() -> None:
    eggs = FuzzySkill("eggs", Rectangle(0, 0), 10, elapsed=100)
    peel = FuzzySkill("peel", Trapezoid(0, 60, math.inf, math.inf), 10)
    later = replan(solve(FuzzyTask((eggs, peel), precedences=(Precedence(0, 1, minimum_lag=5),))), 50)
    assert list(later.schedule.start_times) == [55]
    assert list(later.schedule.satisfactions) == [1]


def test_what_goes_on_until_a_time_is_over_then_whenever_now_is() -> None:
    jazz = FuzzySkill("play jazz", Rectangle(0, 0), 10, elapsed=20, until=3600.0)
    bow = FuzzySkill("bow", Trapezoid(0, 0, 7200, 7300), 60)
    walk = FuzzySkill("walk", Rectangle(500, 600), 10, until=3600.0)
    before = solve(FuzzyTask((jazz, bow, walk), precedences=(Precedence(0, 1),)))
    later = replan(before, 15)
    assert [skill.done for skill in later.running] == [3585]
    assert list(later.schedule.start_times) == [5, 485]
    assert later.schedule.skills[1].done == 3585
    assert not replan(before, 4000).running


def test_a_wish_whose_last_moment_has_passed_is_late_not_lost() -> None:
    eggs = FuzzySkill("eggs", Rectangle(0, 0), 10)
    peel = FuzzySkill("peel", Trapezoid(0, 10, 200, 300), 10)
    task = FuzzyTask((eggs, peel), precedences=(Precedence(0, 1, maximum_lag=20),), busy=(Busy(12, 28),))
    assert solve(task).start_times == (0, 28)
    later = replan(solve(task), 20, dropped=[])
    assert later.schedule.start_times == (8,)


def test_a_new_skill_moves_another_and_that_is_said() -> None:
    before = solve(FuzzyTask((SOUP, SALAD)))
    later = replan(before, 10, added=[FuzzySkill("bell", Rectangle(105, 105), 30)])
    assert [(move.position, move.is_rejected) for move in later.moves] == [(0, False)]
    (move,) = later.moves
    assert move.before == 110
    assert move.after == later.schedule.start_times[0]
    assert move.by == pytest.approx(move.after - 110)


def test_a_skill_that_loses_its_place_is_said_to_be_rejected() -> None:
    spike = FuzzySkill("flip", Rectangle(100, 100), 10)
    later = replan(solve(FuzzyTask((spike,))), 10, added=[FuzzySkill("a", Rectangle(85, 95), 30, priority=9)])
    (move,) = later.moves
    assert (move.was_rejected, move.is_rejected) == (False, True)


def test_what_was_rejected_has_not_started_and_holds_nobody() -> None:
    soup, stew = (FuzzySkill(name, Triangle(5, 10, 15), 60) for name in ("soup", "stew"))
    before = solve(FuzzyTask((soup, stew)))
    assert before.rejected == (False, True)
    bell = FuzzySkill("bell", Triangle(-10, 0, 10), 5)
    later = replan(before, before.start_times[1] + 10, added=[bell])
    assert not later.running
    assert later.kept == (1,)
    assert later.schedule.rejected == (True, False)
    assert later.schedule.start_times[1] == pytest.approx(0.0, abs=1e-6)


def test_what_is_dropped_makes_room() -> None:
    spikes = (
        FuzzySkill("flip", Rectangle(100, 100), 10, priority=2),
        FuzzySkill("pour", Rectangle(105, 105), 9),
    )
    before = solve(FuzzyTask(spikes))
    assert list(before.rejected) == [False, True]
    later = replan(before, 10, dropped=[0])
    assert later.kept == (1,)
    assert later.schedule.rejected == (False,)
    assert later.moves[0].was_rejected


@pytest.mark.parametrize("now", [-1.0, math.inf, math.nan])
def test_the_new_now_must_not_lie_before_the_old(now: float) -> None:
    with pytest.raises(FuzzytimeError, match="new now must be finite"):
        replan(solve(FuzzyTask((SOUP,))), now)


def test_only_skills_that_are_there_can_be_dropped() -> None:
    with pytest.raises(FuzzytimeError, match="one of 0 to 0, got 3"):
        replan(solve(FuzzyTask((SOUP,))), 0, dropped=[3])


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 100_000), st.floats(0, 150))
def test_a_later_plan_is_valid_and_no_worse_for_what_is_left(seed: int, now: float) -> None:
    before = solve(random_task(seed))
    later = replan(before, now)
    assert not faults(later.schedule)
    for skill in later.running:
        for other in later.schedule.skills:
            assert other.start >= skill.end - 1e-9 or skill.end <= 0
    if not any(before.rejected):
        kept = [before.costs[position] * before.task.skills[position].priority for position in later.kept]
        assert later.schedule.weighted_cost <= math.fsum(kept) + 1e-3


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 100_000))
def test_a_hint_is_never_made_worse(seed: int) -> None:
    task = random_task(seed)
    good = solve(task)
    again = solve(task, solver=LocalSearch(), hints=good.start_times)
    assert again.weighted_cost <= good.weighted_cost + 1e-6 or any(good.rejected)


def test_hints_must_be_one_a_skill() -> None:
    with pytest.raises(FuzzytimeError, match="hints must be one for each of 1 skills, got 2"):
        solve(FuzzyTask((SOUP,)), hints=[1.0, 2.0])
