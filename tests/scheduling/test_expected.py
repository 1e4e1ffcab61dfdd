"""Where a search begins."""

import math

from fuzzytime.satisfaction import ALWAYS, Rectangle
from fuzzytime.scheduling import solve
from fuzzytime.scheduling.search.expected import expected_starts
from fuzzytime.skills import FuzzySkill, FuzzyTask, Precedence

ANY = Rectangle(0, 36000)


def test_what_must_end_shortly_before_another_starts_late() -> None:
    simmer, heat, bake = (
        FuzzySkill("simmer", ANY, duration=60, elapsed=5400),
        FuzzySkill("heat", ANY, duration=30, elapsed=720),
        FuzzySkill("bake", ANY, duration=300),
    )
    entries = (Precedence(0, 2), Precedence(1, 2, 0, 600))
    assert expected_starts(FuzzyTask((simmer, heat, bake), 1, entries)) == [0, 4080, 5400]


def test_a_task_without_such_lags_gets_none() -> None:
    skills = (FuzzySkill("mix", ALWAYS, duration=60), FuzzySkill("bake", ALWAYS, duration=60))
    assert expected_starts(FuzzyTask(skills, 1, (Precedence(0, 1),))) == []


def test_lags_that_no_start_keeps_end_the_search_for_them() -> None:
    skills = (FuzzySkill("mix", ALWAYS, duration=60), FuzzySkill("bake", ALWAYS, duration=60))
    starts = expected_starts(FuzzyTask(skills, 1, (Precedence(0, 1, 100, 200), Precedence(0, 1, 300, 400))))
    assert all(math.isfinite(start) for start in starts)


def test_many_steps_with_one_that_ends_shortly_before_another_are_all_planned() -> None:
    steps = [FuzzySkill(f"step {place}", ANY, duration=120) for place in range(12)]
    heat = FuzzySkill("heat", ANY, duration=30, elapsed=720)
    bake = FuzzySkill("bake", ANY, duration=300)
    entries = (
        *(Precedence(place, place + 1, 600 * (place % 3)) for place in range(11)),
        Precedence(11, 13),
        Precedence(12, 13, -90, 900),
    )
    assert not any(solve(FuzzyTask((*steps, heat, bake), 1, entries)).rejected)
