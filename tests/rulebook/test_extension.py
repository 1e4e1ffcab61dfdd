"""Fuzzy times add by the extension principle."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.rulebook.resolving.extension import added
from fuzzytime.satisfaction import NEVER, Rectangle, Sampled, SatisfactionFunction, Trapezoid

CORNERS = st.lists(st.floats(0, 100), min_size=4, max_size=4).map(sorted).map(tuple)
TRAPEZOIDS = CORNERS.map(lambda corners: Trapezoid(*corners))


def brute(first: SatisfactionFunction, second: SatisfactionFunction, times: np.ndarray) -> np.ndarray:
    starts = np.linspace(-10, 220, 2301)
    return np.array([np.minimum(first(starts), second(time - starts)).max() for time in times])


@given(TRAPEZOIDS, TRAPEZOIDS)
def test_corners_of_trapezoids_add(first: Trapezoid, second: Trapezoid) -> None:
    total = added(first, second)
    assert isinstance(total, Trapezoid)
    assert total.corners == tuple(a + b for a, b in zip(first.corners, second.corners, strict=True))


def test_other_shapes_are_added_level_by_level() -> None:
    curve = Sampled([0, 40, 60, 100], [0.0, 0.7, 0.7, 0.0])
    lag = Trapezoid(10, 30, 50, 80)
    times = np.linspace(0, 200, 81)
    np.testing.assert_allclose(added(curve, lag)(times), brute(curve, lag, times), atol=0.02)


def test_a_sharp_lag_only_shifts() -> None:
    curve = Sampled([0, 40, 60, 100], [0.0, 0.7, 0.7, 0.0])
    moved = added(curve, Trapezoid(100, 100, 100, 100))
    times = np.linspace(90, 210, 50)
    np.testing.assert_allclose(moved(times), curve(times - 100), atol=0.02)


def test_jumps_stay_jumps() -> None:
    total = added(Rectangle(0, 10), Sampled([0, 0, 5, 5], [0, 0.5, 0.5, 0]))
    assert total([-0.1, 0, 15, 15.1]).tolist() == pytest.approx([0, 0.5, 0.5, 0])


def test_a_moment_without_extent_gives_one() -> None:
    total = added(Sampled([5], [0.5]), Trapezoid(1, 1, 1, 1))
    assert total(6) == 0.5
    assert total.support.low == total.support.high == 6


def test_what_never_happens_has_no_time_after_it() -> None:
    assert added(NEVER, Trapezoid(0, 1, 2, 3)) == NEVER
