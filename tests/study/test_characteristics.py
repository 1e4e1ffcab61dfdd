import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from fuzzytime.study import SubjectiveSatisfaction, characterise, histogram

VALUES = arrays(float, st.tuples(st.integers(1, 9), st.integers(2, 6)), elements=st.floats(0, 1, width=16))


def of(values: np.ndarray) -> SubjectiveSatisfaction:
    return SubjectiveSatisfaction(np.arange(values.shape[1], dtype=float), values)


@given(VALUES)
def test_quantiles_are_in_order_and_averages_lie_between_them(values: np.ndarray) -> None:
    found = characterise(of(values))
    for low, high in (
        (found.minimum, found.lower_quartile),
        (found.lower_quartile, found.median),
        (found.median, found.upper_quartile),
        (found.upper_quartile, found.maximum),
    ):
        assert (low <= high + 1e-12).all()
    for average in (found.mean, found.mode):
        assert (average >= found.minimum - 1e-12).all()
        assert (average <= found.maximum + 1e-12).all()


@given(VALUES)
def test_each_column_of_the_histogram_holds_everybody(values: np.ndarray) -> None:
    counts = histogram(of(values))
    assert counts.shape == (21, values.shape[1])
    assert (counts.sum(axis=0) == values.shape[0]).all()


@given(VALUES)
def test_moments_equal_those_of_scipy(values: np.ndarray) -> None:
    from scipy import stats

    # Where a spread is down to rounding, standardised moments are not defined; ours are NaN there.
    spread = values.std(axis=0) > 1e-3
    found = characterise(of(values))
    kept = values[:, spread]
    assert found.skew[spread] == pytest.approx(stats.skew(kept, axis=0), abs=1e-6)
    assert found.kurtosis[spread] == pytest.approx(stats.kurtosis(kept, axis=0), abs=1e-6)
    assert np.isnan(found.skew[values.std(axis=0) == 0]).all()


def test_the_mode_is_what_most_people_said() -> None:
    found = characterise(of(np.array([[1.0, 0.31], [1.0, 0.29], [0.2, 0.9], [0.0, 0.3], [1.0, 0.0]])))
    assert found.mode.tolist() == [1.0, 0.3]


def test_of_equally_frequent_satisfactions_the_one_nearest_the_median_is_the_mode() -> None:
    found = characterise(of(np.array([[0.0, 0.0], [0.0, 0.0], [0.9, 0.5], [0.9, 0.5], [0.6, 0.4]])))
    assert found.mode.tolist() == pytest.approx([0.9, 0.5])


def test_disagreement_counts_only_where_somebody_is_satisfied() -> None:
    values = np.array([[0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0]])
    assert characterise(of(values)).disagreement == pytest.approx(np.std([0, 1], ddof=1))
    assert characterise(of(np.zeros((3, 4)))).disagreement == 0.0
