"""The shapes of ψ keep what the protocol promises."""

import math
import pickle

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import (
    ALWAYS,
    NEVER,
    Bell,
    Floored,
    Rectangle,
    Sampled,
    SatisfactionFunction,
    Trapezoid,
    Triangle,
)
from satisfaction.shapes_of import functions, levels, plain, points, times, trapezoids


@given(functions, st.lists(times, max_size=8))
def test_satisfaction_lies_between_0_and_1(function: SatisfactionFunction, at: list[float]) -> None:
    values = function([*at, -math.inf, math.inf])
    assert ((values >= 0) & (values <= 1)).all()


@given(functions, st.sampled_from([(), (0,), (3,), (2, 3), (1, 2, 2)]))
def test_the_answer_has_the_shape_of_the_times(
    function: SatisfactionFunction, shape: tuple[int, ...]
) -> None:
    assert function(np.zeros(shape)).shape == shape
    assert function.log(np.zeros(shape)).shape == shape


@given(functions, times, times)
def test_shifting_commutes_with_evaluation(function: SatisfactionFunction, by: float, at: float) -> None:
    moved = function.shifted(by)
    near = [abs(at - kink) for kink in function.kinks]
    assume(min(near, default=1) > 1e-6)  # beside a jump, rounding may choose the other side
    assert moved(at + by) == pytest.approx(float(function(at)), abs=1e-4)


@given(functions, st.floats(0.1, 10), times, times)
def test_widening_keeps_the_anchor_and_scales_around_it(
    function: SatisfactionFunction, factor: float, anchor: float, at: float
) -> None:
    assume(min((abs(at - kink) for kink in function.kinks), default=1) > 1e-6)
    wide = function.widened(factor, anchor)
    assert wide(anchor + factor * (at - anchor)) == pytest.approx(float(function(at)), abs=1e-4)


@given(plain, times)
def test_the_logarithm_is_that_of_the_value(function: SatisfactionFunction, at: float) -> None:
    value = float(function(at))
    assert float(function.log(at)) == pytest.approx(math.log(value) if value else -math.inf, abs=1e-9)


@given(functions, times)
def test_nothing_satisfies_outside_the_support(function: SatisfactionFunction, at: float) -> None:
    assert float(function(at)) == 0 or at in function.support


@given(plain)
def test_the_support_is_not_larger_than_it_must_be(function: SatisfactionFunction) -> None:
    support = function.support
    if support.empty:
        assert (function(np.linspace(-1e5, 1e5, 1001)) == 0).all()
    elif math.isfinite(support.low):
        inside = np.nextafter(support.low, math.inf)
        beyond = max((kink for kink in function.kinks if kink <= support.low), default=support.low)
        assert function([support.low, inside, support.low + 1e-3]).max() > 0 or beyond == support.high


@given(functions, times)
def test_no_time_is_better_than_the_best(function: SatisfactionFunction, at: float) -> None:
    best = function.best
    if best.empty:
        assert float(function(at)) == 0
        return
    peak = best.low if math.isfinite(best.low) else best.high if math.isfinite(best.high) else 0.0
    assert float(function(at)) <= float(function(peak)) + 1e-12
    if math.isfinite(best.low) and math.isfinite(best.high):
        assert function(np.linspace(best.low, best.high, 7)) == pytest.approx(float(function(peak)))


@given(functions, st.floats(0.01, 1), times)
def test_every_acceptable_time_lies_in_the_acceptable_interval(
    function: SatisfactionFunction, level: float, at: float
) -> None:
    if float(function(at)) >= level + 1e-9:
        assert at in function.acceptable(level)


@given(plain, st.floats(0.01, 0.99))
def test_satisfaction_passes_the_level_at_its_crossings(function: SatisfactionFunction, level: float) -> None:
    for crossing in function.crossings(level):
        sides = function([crossing, np.nextafter(crossing, -math.inf), np.nextafter(crossing, math.inf)])
        assert sides.min() - 1e-6 <= level <= sides.max() + 1e-6


@given(trapezoids, times)
def test_trapezoids_follow_their_corners(function: Trapezoid, at: float) -> None:
    rise_start, full_start, full_end, fall_end = function.corners
    if full_start <= at <= full_end:
        expected = 1.0
    elif at <= rise_start or at >= fall_end:
        expected = 0.0
    elif at < full_start:
        expected = (at - rise_start) / (full_start - rise_start)
    else:
        expected = (fall_end - at) / (fall_end - full_end)
    assert float(function(at)) == pytest.approx(expected, abs=1e-9)


@given(points, st.integers(0, 11))
def test_points_are_on_their_curve(function: Sampled, index: int) -> None:
    at = function.times[index % len(function.times)]
    assert float(function(at)) == function.values[function.times == at].max()


@given(trapezoids | points, st.lists(times, min_size=3, max_size=3, unique=True))
def test_what_is_called_log_concave_is(function: SatisfactionFunction, three: list[float]) -> None:
    first, middle, last = sorted(three)
    assume(function.log_concave)
    share = (middle - first) / (last - first)
    with np.errstate(invalid="ignore"):
        chord = (1 - share) * float(function.log(first)) + share * float(function.log(last))
    assert math.isnan(chord) or float(function.log(middle)) >= chord - 1e-6


def test_triangles_and_rectangles_are_trapezoids() -> None:
    at = np.linspace(-1, 11, 49)
    assert np.array_equal(Triangle(0, 4, 10)(at), Trapezoid(0, 4, 4, 10)(at))
    assert np.array_equal(Rectangle(2, 6)(at), Trapezoid(2, 2, 6, 6)(at))


def test_a_bell_is_one_half_a_width_from_its_centre() -> None:
    assert Bell(10, 2, 3)([8, 10, 12]).tolist() == pytest.approx([0.5, 1, 0.5])
    assert Bell(10, 2, 3).acceptable(0.5) == Bell(10, 2, 1).acceptable(0.5)


def test_a_jump_takes_the_larger_value() -> None:
    assert Trapezoid(5, 5, 9, 9)([4.999, 5, 9, 9.001]).tolist() == [0, 1, 1, 0]
    assert Sampled([0, 1, 1, 2], [0.2, 0.2, 0.9, 0.9])([0.5, 1, 1.5]).tolist() == [0.2, 0.9, 0.9]


def test_always_satisfies_from_now_on_and_never_never() -> None:
    assert ALWAYS([-1, 0, 1e9]).tolist() == [0, 1, 1]
    assert NEVER([-1, 0, 1]).tolist() == [0, 0, 0]
    assert NEVER.support.empty


def test_a_floor_lifts_what_lies_below_it() -> None:
    function = Floored(Trapezoid(0, 10, 20, 30), 0.25)
    assert function([-5, 1, 5, 15, 40]).tolist() == [0.25, 0.25, 0.5, 1, 0.25]
    assert {2.5, 27.5} <= set(function.kinks)


def test_functions_compare_hash_and_pickle_by_value() -> None:
    for function in (Trapezoid(0, 1, 2, 3), Bell(1, 2, 3), Sampled([0, 1], [0, 1]), Rectangle(0, 1)):
        again = pickle.loads(pickle.dumps(function))  # noqa: S301 - our own bytes
        assert again == function
        assert hash(again) == hash(function)
    assert Sampled([0, 1], [0, 1]) != Sampled([0, 1], [0, 0.5])


def test_points_do_not_change() -> None:
    function = Sampled([0, 1], [0, 1])
    with pytest.raises(ValueError, match="read-only"):
        function.values[0] = 1
    with pytest.raises(AttributeError, match="does not change"):
        function.times = np.zeros(2)


@pytest.mark.parametrize(
    ("build", "rule"),
    [
        (lambda: Trapezoid(3, 2, 1, 0), r"corners must not decrease, got \(3, 2, 1, 0\)"),
        (lambda: Trapezoid(0, math.nan, 1, 2), "corners must be numbers"),
        (lambda: Trapezoid(-math.inf, 0, 1, 2), "a flank must lie between two finite times"),
        (lambda: Rectangle(2, 1), "corners must not decrease"),
        (lambda: Bell(0, 0, 1), "width must be above 0"),
        (lambda: Bell(math.inf, 1, 1), "centre must be finite"),
        (lambda: Sampled([0, 1], [0.5]), "as many times as values"),
        (lambda: Sampled([1, 0], [0.5, 0.5]), "must not decrease"),
        (lambda: Sampled([0, 0, 0], [0, 1, 0]), "at most two points may share a time"),
        (lambda: Sampled([0, 1], [0, 1.5]), r"satisfactions must lie in \[0, 1\]"),
        (lambda: Floored(ALWAYS, 0), r"a floor must lie in \(0, 1\]"),
        (lambda: ALWAYS.widened(0, 0), "a factor of width must be above 0"),
    ],
)
def test_broken_rules_are_named_with_the_value(build: object, rule: str) -> None:
    assert callable(build)
    with pytest.raises(FuzzytimeError, match=rule):
        build()


@given(trapezoids, levels)
def test_trapezoids_are_acceptable_between_their_flanks(function: Trapezoid, level: float) -> None:
    assume(level > 0)
    rise_start, full_start, full_end, fall_end = function.corners
    inside = function.acceptable(level)
    assert inside.low == pytest.approx(rise_start + level * (full_start - rise_start), abs=1e-3)
    assert inside.high == pytest.approx(fall_end - level * (fall_end - full_end), abs=1e-3)
