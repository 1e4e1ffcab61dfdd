"""Skills and tasks refuse what cannot be."""

import math

import pytest

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import ALWAYS
from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask, Precedence, SpecificSkill

STIR = FuzzySkill("stir", ALWAYS, 60.0)


def test_a_skill_is_done_when_it_has_elapsed_and_frees_the_agent_before() -> None:
    eggs = SpecificSkill("boil the eggs", start=120, duration=60, elapsed=480)
    assert (eggs.end, eggs.done) == (180, 600)
    assert FuzzySkill("stir", ALWAYS, 60.0).time_until_done == 60


@pytest.mark.parametrize("duration", [-1, math.inf, math.nan])
def test_durations_are_finite_and_not_negative(duration: float) -> None:
    with pytest.raises(FuzzytimeError, match="duration must be finite and at least 0"):
        FuzzySkill("stir", ALWAYS, duration)


def test_priorities_are_above_0() -> None:
    with pytest.raises(FuzzytimeError, match="priority must be above 0"):
        FuzzySkill("stir", ALWAYS, 60, priority=0)


def test_precedences_name_skills_of_the_task_and_form_no_circle() -> None:
    with pytest.raises(FuzzytimeError, match="must name skills 0 to 1, got 2"):
        FuzzyTask((STIR, STIR), precedences=(Precedence(0, 2),))
    with pytest.raises(FuzzytimeError, match="must not form a circle"):
        FuzzyTask((STIR, STIR, STIR), precedences=(Precedence(0, 1), Precedence(1, 0), Precedence(1, 2)))
    twice = FuzzyTask((STIR, STIR), precedences=(Precedence(0, 1), Precedence(0, 1, maximum_lag=9)))
    assert len(twice.precedences) == 2


def test_agents_are_counted_from_1() -> None:
    with pytest.raises(FuzzytimeError, match="at least one agent"):
        FuzzyTask((STIR,), agents=0)
    with pytest.raises(FuzzytimeError, match="one of 1 to 2, got 3"):
        FuzzyTask((STIR,), agents=2, busy=(Busy(0, 1, agent=3),))


def test_intervals_do_not_run_backwards() -> None:
    with pytest.raises(FuzzytimeError, match="must not end before it starts"):
        Busy(2, 1)
    with pytest.raises(FuzzytimeError, match="minimum lag must not exceed its maximum"):
        Precedence(0, 1, 5, 4)
