import numpy as np
import pytest

from fuzzytime.errors import FuzzytimeError
from fuzzytime.study import compare_answers


def test_modes_u_and_p_are_those_of_the_answers() -> None:
    found = compare_answers([1, 1, 2, 3, 1], [3, 3, 4, 5, 2])
    assert found.first_mode == (1,)
    assert found.second_mode == (3,)
    # By hand: of 25 pairs, the first is larger in 1 and equal in 3;
    # with U's deviation 4.655 for these ties, z = (10 − ½) / 4.655.
    assert found.u == 2.5
    assert found.delta == pytest.approx((1 - 21) / 25)
    assert found.p_value == pytest.approx(0.0413, abs=0.0001)
    assert found.few


def test_equally_frequent_answers_are_all_modes() -> None:
    assert compare_answers([2, 2, 4, 4, 1], [3, 3]).first_mode == (2, 4)


def test_the_interval_covers_the_true_delta_in_95_of_100_studies() -> None:
    generator = np.random.default_rng(11)
    scale = np.arange(1, 6)
    robot, person = np.array([0.35, 0.25, 0.2, 0.15, 0.05]), np.array([0.1, 0.2, 0.35, 0.2, 0.15])
    true = float(robot @ np.sign(scale[:, None] - scale[None, :]) @ person)
    covered = 0
    for _ in range(400):
        found = compare_answers(
            generator.choice(scale, 16, p=robot).tolist(), generator.choice(scale, 16, p=person).tolist()
        )
        low, high = found.interval
        assert -1 <= low <= found.delta <= high <= 1
        covered += low <= true <= high
    assert 0.92 <= covered / 400 <= 0.985


def test_answers_that_never_overlap_have_an_interval_too() -> None:
    found = compare_answers([1] * 16, [5] * 16)
    assert found.delta == -1
    assert found.interval[0] == -1
    assert -1 < found.interval[1] < -0.5


def test_where_all_answer_alike_nothing_speaks_for_a_difference() -> None:
    found = compare_answers([3, 3, 3], [3, 3, 3])
    assert found.p_value == 1
    assert found.delta == 0


def test_a_single_answer_is_no_group() -> None:
    with pytest.raises(FuzzytimeError, match="two answers each, got 1 and 3"):
        compare_answers([1], [1, 2, 3])
