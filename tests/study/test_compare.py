from dataclasses import replace

import numpy as np
import pytest

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import SatisfactionFunction
from fuzzytime.study import (
    Answers,
    Design,
    Population,
    StudyInstruction,
    SubjectiveSatisfaction,
    compare,
    simulate,
    variance,
)
from study.truths import truth


def groups(answers: Answers) -> tuple[list[SubjectiveSatisfaction], list[SubjectiveSatisfaction]]:
    return list(answers.subjective("person").values()), list(answers.subjective("robot").values())


def test_variances_are_those_of_the_median_curves(answers: Answers) -> None:
    person, robot = groups(answers)
    found = compare(person, robot, permutations=9)
    for variances, group in ((found.first, person), (found.second, robot)):
        expected = [float(variance(drawn.times, drawn.median)) for drawn in group]
        assert variances == pytest.approx(expected, rel=1e-9)
    assert found.mean_difference == pytest.approx(float((found.first - found.second).mean()))


def test_a_difference_between_groups_is_found(design: Design) -> None:
    for seed in range(3):
        population = Population(group_widths={"person": 1.25, "robot": 0.8})
        found = compare(*groups(simulate(design, truth, 32, seed=seed, population=population)), seed=seed)
        assert found.p_value <= 0.01
        assert found.mean_difference > 0


def test_a_difference_in_one_instruction_is_found_among_many(design: Design) -> None:
    def meant(entry: StudyInstruction, group: str) -> SatisfactionFunction:
        factor = 2.0 if entry.key == "in-1" and group == "person" else 1.0
        return truth(entry).widened(factor, entry.t_spec)

    found = compare(*groups(simulate(design, meant, 32, seed=2)), permutations=299)
    assert found.p_value <= 0.05


def test_no_difference_is_seldom_cried(design: Design) -> None:
    some = replace(design, instructions=design.instructions[:5])
    cried = sum(
        compare(*groups(simulate(some, truth, 32, seed=seed)), permutations=199, seed=seed).p_value <= 0.05
        for seed in range(20)
    )
    assert cried <= 3


def test_exchanging_the_groups_turns_the_sign_only(answers: Answers) -> None:
    person, robot = groups(answers)
    one, other = compare(person, robot, seed=3), compare(robot, person, seed=4)
    assert one.differences == pytest.approx(-other.differences)
    assert one.p_value == pytest.approx(other.p_value, abs=0.08)


def test_p_values_of_instructions_are_adjusted_for_their_number(answers: Answers) -> None:
    person, robot = groups(answers)
    together = compare(person, robot, permutations=199)
    assert (together.p_values <= 1).all()
    assert together.p_values.min() >= 14 / 200 * 0.999


def test_a_single_instruction_can_be_compared() -> None:
    times = np.arange(0, 100.0)
    wide = np.array([np.clip(1 - np.abs(times - 50) / (30 + i), 0, 1) for i in range(8)])
    narrow = np.array([np.clip(1 - np.abs(times - 50) / (10 + i), 0, 1) for i in range(8)])
    found = compare([SubjectiveSatisfaction(times, wide)], [SubjectiveSatisfaction(times, narrow)])
    assert found.p_value <= 0.01
    assert found.p_values[0] == pytest.approx(found.p_value)


def test_groups_that_do_not_correspond_are_refused() -> None:
    times = np.arange(3.0)
    some = SubjectiveSatisfaction(times, np.ones((2, 3)))
    none = SubjectiveSatisfaction(times, np.zeros((2, 3)))
    later = SubjectiveSatisfaction(times + 1, np.ones((2, 3)))
    more = SubjectiveSatisfaction(times, np.ones((4, 3)))
    with pytest.raises(FuzzytimeError, match="same instructions"):
        compare([some, some], [some])
    with pytest.raises(FuzzytimeError, match="same instructions"):
        compare([], [])
    with pytest.raises(FuzzytimeError, match="same times"):
        compare([some], [later])
    with pytest.raises(FuzzytimeError, match="same participants"):
        compare([some, more], [some, some])
    with pytest.raises(FuzzytimeError, match="above 0 somewhere"):
        compare([some], [none])
