import numpy as np
import pytest
from numpy.typing import ArrayLike

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Triangle
from fuzzytime.study import SubjectiveSatisfaction


@pytest.mark.parametrize(
    ("times", "values", "rule"),
    [
        ([0.0], [[1.0]], "k ≥ 2"),
        ([0.0, 1.0], [1.0, 1.0], "shape"),
        ([0.0, 1.0], [[1.0, 1.0, 1.0]], "shape"),
        ([0.0, 1.0], np.zeros((0, 2)), "with a participant"),
        ([0.0, 0.0], [[1.0, 1.0]], "must ascend"),
        ([0.0, np.nan], [[1.0, 1.0]], "finite"),
        ([0.0, 1.0], [[0.0, 1.5]], r"\[0, 1\], got 0 to 1.5"),
        ([0.0, 1.0], [[0.0, np.nan]], r"\[0, 1\]"),
    ],
)
def test_what_is_no_set_of_satisfactions_is_refused(times: ArrayLike, values: ArrayLike, rule: str) -> None:
    with pytest.raises(FuzzytimeError, match=rule):
        SubjectiveSatisfaction(np.asarray(times), np.asarray(values))


def test_functions_are_sampled_and_given_back() -> None:
    drawn = SubjectiveSatisfaction.of([Triangle(0, 60, 120), Triangle(0, 30, 60)], [0, 30, 60, 90])
    assert drawn.values.tolist() == [[0, 0.5, 1, 0.5], [0, 1, 0, 0]]
    assert float(drawn.function(0)(75)) == 0.75
    assert drawn.chosen([1]).values.tolist() == [[0, 1, 0, 0]]
    assert drawn.chosen([True, False]).participants == 1


def test_its_arrays_do_not_change() -> None:
    values = np.zeros((1, 2))
    drawn = SubjectiveSatisfaction(np.array([0.0, 1.0]), values)
    values[0, 0] = 1.0
    assert drawn.values[0, 0] == 0.0
    with pytest.raises(ValueError, match="read-only"):
        drawn.values[0, 0] = 1.0
