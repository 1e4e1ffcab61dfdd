"""The satisfaction of a whole plan, where its product is too small for a number and little is proved."""

import math
from dataclasses import replace

import pytest

from fuzzytime.satisfaction import Sampled, Triangle
from fuzzytime.scheduling import Alternative, Schedule, Status, solve
from fuzzytime.skills import FuzzySkill, FuzzyTask
from fuzzytime_cli.formats.whole import how_near, is_same, product_of


def flat(satisfaction: float, number: int, threshold: float = 0.001) -> Schedule:
    """Give a schedule of skills that are all satisfied so much, whatever their times."""
    curve = Sampled([0, 1e6], [satisfaction, satisfaction])
    skills = tuple(FuzzySkill(f"skill {i}", curve, 1.0) for i in range(number))
    return solve(FuzzyTask(skills), threshold=threshold)


def test_a_product_that_underflows_is_written_all_the_same() -> None:
    schedule = flat(0.01, 200)
    assert schedule.satisfaction == 0
    assert product_of(schedule, schedule) == "1e-400"
    better = Alternative(0.0, (0.02, *schedule.satisfactions[1:]), 0.0, schedule.weighted_cost - math.log(2))
    assert product_of(better, schedule) == "2e-400"
    assert not is_same(schedule, better)


def test_a_strict_product_that_fails_is_0() -> None:
    wish = Triangle(5, 10, 15)
    schedule = solve(FuzzyTask((FuzzySkill("a", wish, 60), FuzzySkill("b", wish, 60))), threshold=0)
    assert product_of(schedule, schedule) == "0"


@pytest.mark.parametrize(
    ("gap", "words"),
    [
        (0.125, "the average is within 12.50% of the best possible"),
        (808.0, "no schedule has an average above 0.81"),
        (math.inf, "no schedule has an average above 0.81"),
    ],
)
def test_a_wide_gap_is_told_by_the_best_that_is_possible(gap: float, words: str) -> None:
    schedule = flat(0.001, 4, threshold=0.0001)
    lower = -4 * math.log(0.81)
    certificate = replace(schedule.certificate, status=Status.BOUNDED, gap=gap, lower_cost=lower)
    assert how_near(replace(schedule, certificate=certificate)) == words
