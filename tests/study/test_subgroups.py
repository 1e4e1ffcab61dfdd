import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fuzzytime.satisfaction import Trapezoid
from fuzzytime.study import SubjectiveSatisfaction, subgroups

TIMES = 4.5 * np.arange(800)


def drawn(*shapes: Trapezoid) -> SubjectiveSatisfaction:
    return SubjectiveSatisfaction.of(shapes, TIMES)


def test_two_readings_of_after_are_told_apart() -> None:
    """Some let satisfaction fall after the time, some keep it to the end of the timeline."""
    widths = np.linspace(0.8, 1.2, 12)
    close = [Trapezoid(1790, 1800, 1835, 2027).widened(width, 1800) for width in widths]
    any_time = [Trapezoid(1790, 1800, 3600, 3600).widened(width, 1800) for width in widths[:6]]
    found = subgroups(drawn(*close, *any_time))
    assert found.divergent
    assert found.silhouette > 0.9
    assert found.second.tolist() == [False] * 12 + [True] * 6


@settings(max_examples=25, deadline=None)
@given(st.integers(0, 10**6))
def test_one_group_of_individual_widths_is_not_split(seed: int) -> None:
    widths = np.exp(0.25 * np.random.default_rng(seed).standard_normal(32))
    assert not subgroups(
        drawn(*(Trapezoid(1626, 1730, 1870, 1974).widened(w, 1800) for w in widths))
    ).divergent


def test_an_outlier_is_no_subgroup() -> None:
    one = Trapezoid(1626, 1730, 1870, 1974)
    found = subgroups(
        drawn(*[one.widened(1 + i / 100, 1800) for i in range(15)], Trapezoid(0, 0, 3600, 3600))
    )
    assert found.second.sum() == 1
    assert not found.divergent


@pytest.mark.parametrize("count", [1, 3, 8])
def test_equal_or_few_curves_are_one_group(count: int) -> None:
    found = subgroups(drawn(*[Trapezoid(0, 60, 120, 180)] * count))
    assert found.silhouette == 0
    assert not found.divergent
