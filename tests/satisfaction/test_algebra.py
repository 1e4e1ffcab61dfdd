"""Products, averages and points stand for what they say."""

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import (
    ALWAYS,
    EVERYWHERE,
    NEVER,
    Bell,
    Interval,
    Rectangle,
    SatisfactionFunction,
    Trapezoid,
    Triangle,
    averaged,
    points_of,
    product,
)
from satisfaction.shapes_of import linear, plain

PROBES = np.linspace(-1e5, 1e5, 401)


@example(Triangle(0.0, 2217.0, 2217.0), Bell(0.0, 278.0, 4.0))
@given(linear, plain)
def test_a_product_is_within_its_tolerance(first: SatisfactionFunction, second: SatisfactionFunction) -> None:
    both = product(first, second, 1e-3)
    kinks = np.array([*first.kinks, *second.kinks])
    probes = PROBES[np.abs(PROBES[:, None] - kinks).min(axis=1) > 1e-6]
    assert both(probes) == pytest.approx(first(probes) * second(probes), abs=2e-3)


@given(linear, st.floats(1, 1e4))
def test_an_average_is_the_integral_over_the_execution(
    function: SatisfactionFunction, duration: float
) -> None:
    mean = averaged(function, duration, 1e-3)
    for start in (-5e4, -10.0, 0.0, 3.0, 4e4):
        at = np.linspace(start, start + duration, 4001)
        middle = (at[1:] + at[:-1]) / 2
        assert float(mean(start)) == pytest.approx(float(function(middle).mean()), abs=5e-3)


def test_throughout_a_window_is_full_only_where_the_whole_execution_fits() -> None:
    mean = averaged(Rectangle(10, 20), 5)
    assert mean([4, 5, 7.5, 10, 15, 17.5, 20]).tolist() == pytest.approx([0, 0, 0.5, 1, 1, 0.5, 0])
    assert mean.best.low == 10


def test_an_instant_is_no_average() -> None:
    assert averaged(Rectangle(1, 2), 0) == Rectangle(1, 2)


@given(st.floats(1.0, 1e5), st.floats(0.0, 1e4), st.floats(1.0, 1e4), st.floats(1.0, 1e4))
def test_where_both_wishes_are_full_their_product_is(
    start: float, length: float, rise: float, fall: float
) -> None:
    """A plateau that leaned to one side by rounding alone would draw every start to that side."""
    wish = Trapezoid(start - rise, start, start + length, start + length + fall)
    both = product(wish, Rectangle(start - rise / 2, start + length + fall / 2))
    assert both([start, start + length]).tolist() == [1.0, 1.0]


def test_disjoint_wishes_have_no_product() -> None:
    assert product(Rectangle(0, 1), Rectangle(2, 3)) == NEVER


def test_a_product_keeps_jumps() -> None:
    both = product(Rectangle(0, 10), Trapezoid(0, 10, 20, 30))
    assert both([9.999, 10, 10.001]).tolist() == pytest.approx([0.9999, 1, 0], abs=1e-3)


def test_points_of_a_bell_on_an_interval_fit_it() -> None:
    bell = Bell(100, 20, 2)
    points = points_of(bell, bell.kinks, Interval(0, 200), 1e-4)
    at = np.linspace(0, 200, 5001)
    assert np.abs(points(at) - bell(at)).max() < 2e-4
    assert len(points.times) < 400


def test_points_need_a_finite_interval() -> None:
    with pytest.raises(FuzzytimeError, match="points need a finite interval"):
        points_of(ALWAYS, ALWAYS.kinks, EVERYWHERE)
    with pytest.raises(FuzzytimeError, match="a duration must be finite"):
        averaged(Rectangle(0, 1), math.inf)
