"""Fewer points for a curve, none of them far from it."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.rulebook.over_time.thinning import MOST_POINTS, thinned


@given(st.lists(st.floats(0, 1), min_size=1, max_size=60), st.sampled_from([1e-4, 0.01, 0.3]))
def test_every_point_that_is_left_out_lies_near_the_line(values: list[float], tolerance: float) -> None:
    times = np.arange(float(len(values)))
    curve = np.array(values)
    fewer_times, fewer = thinned(times, curve, tolerance)
    assert np.abs(np.interp(times, fewer_times, fewer) - curve).max() <= tolerance + 1e-12
    assert fewer_times[0] == times[0]
    assert fewer_times[-1] == times[-1]


def test_a_straight_stretch_keeps_its_ends() -> None:
    times = np.linspace(0, 10, 1001)
    assert thinned(times, np.minimum(times / 5, 1.0))[0].size <= 4


def test_a_jump_keeps_both_its_ends() -> None:
    times = np.array([0.0, 1, 2, np.nextafter(3, 0), 3, 4, 5])
    kept, values = thinned(times, np.array([0.0, 0, 0, 0, 1, 1, 1]))
    assert kept.tolist() == [0.0, float(np.nextafter(3, 0)), 3.0, 5.0]
    assert values.tolist() == [0, 0, 1, 1]


def test_there_are_never_too_many() -> None:
    times = np.arange(50_000.0)
    assert thinned(times, np.random.default_rng(1).random(50_000))[0].size <= MOST_POINTS


@given(st.lists(st.floats(0, 1), min_size=1, max_size=60))
def test_the_first_and_the_last_of_the_highest_points_stay(values: list[float]) -> None:
    times = np.arange(float(len(values)))
    curve = np.array(values)
    fewer_times, fewer = thinned(times, curve, 0.3)
    highest, kept = times[curve == curve.max()], fewer_times[fewer == curve.max()]
    assert (kept[0], kept[-1]) == (highest[0], highest[-1])
