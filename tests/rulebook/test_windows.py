"""Operators over windows obey their definitions and laws, checked against brute force."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

from fuzzytime.rulebook.logic.traces import Past
from fuzzytime.rulebook.logic.windows import Extent, mean, mostly, slope, sometime, throughout
from fuzzytime.satisfaction import Floats

TRACES = hnp.arrays(float, st.tuples(st.integers(1, 3), st.integers(2, 40)), elements=st.floats(0, 1))
CRISP = st.integers(0, 20).map(lambda steps: Extent(float(steps), float(steps)))
SOFT = st.tuples(st.floats(0.1, 15), st.floats(0, 0.6)).map(
    lambda pair: Extent.of(pair[0], pair[0] * (1 + pair[1]), 1.0)
)


def brute_sometime(trace: Floats, extent: Extent, unknown: float) -> Floats:
    """sup_a min(w(a), φ(t − a)) over the ages at grid points and at the end of the full part."""
    found = np.empty_like(trace)
    size = trace.shape[-1]
    for row in range(trace.shape[0]):
        known = np.concatenate([np.full(60, unknown), trace[row]])
        positions = np.arange(known.size) - 60
        for t in range(size):
            ages = np.unique([*range(int(np.ceil(extent.whole)) + 1), extent.full])
            ages = ages[ages <= extent.whole]
            fade = extent.whole - extent.full
            weights = np.where(ages <= extent.full, 1.0, (extent.whole - ages) / fade if fade else 0.0)
            found[row, t] = np.minimum(weights, np.interp(t - ages, positions, known)).max()
    return found


@given(TRACES, st.one_of(CRISP, SOFT), st.sampled_from([0.0, 1.0]))
def test_sometime_is_the_supremum_over_the_window(trace: Floats, extent: Extent, unknown: float) -> None:
    np.testing.assert_allclose(
        sometime(Past(trace, unknown), extent), brute_sometime(trace, extent, unknown), atol=1e-12
    )


@given(TRACES, st.one_of(CRISP, SOFT), st.sampled_from([0.0, 1.0]))
def test_throughout_is_not_sometime_not(trace: Floats, extent: Extent, unknown: float) -> None:
    dual = 1 - brute_sometime(1 - trace, extent, 1 - unknown)
    np.testing.assert_allclose(throughout(Past(trace, unknown), extent), dual, atol=1e-12)


@given(TRACES, st.integers(0, 20))
def test_crisp_windows_are_those_of_signal_temporal_logic(trace: Floats, steps: int) -> None:
    extent = Extent(float(steps), float(steps))
    for t in range(steps, trace.shape[-1]):
        window = trace[:, t - steps : t + 1]
        np.testing.assert_array_equal(sometime(Past(trace, 0.0), extent)[:, t], window.max(axis=1))
        np.testing.assert_allclose(throughout(Past(trace, 0.0), extent)[:, t], window.min(axis=1), atol=1e-15)


def brute_mean(trace: Floats, extent: Extent, unknown: float) -> Floats:
    """∫ w·φ / ∫ w by a fine sum."""
    ages = np.linspace(0, extent.whole, 20_001)
    ages = (ages[1:] + ages[:-1]) / 2
    fade = extent.whole - extent.full
    weights = np.where(ages <= extent.full, 1.0, (extent.whole - ages) / fade if fade else 0.0)
    found = np.empty_like(trace)
    for row in range(trace.shape[0]):
        known = np.concatenate([np.full(60, unknown), trace[row]])
        for t in range(trace.shape[-1]):
            found[row, t] = np.average(
                np.interp(t - ages, np.arange(known.size) - 60, known), weights=weights
            )
    return found


@pytest.mark.parametrize("length", [1.0, 4.0, 4.3, 0.7])
@pytest.mark.parametrize("softness", [0.0, 0.25, 0.5])
@pytest.mark.parametrize("unknown", [0.0, 1.0])
def test_the_mean_is_the_integral_over_the_window(length: float, softness: float, unknown: float) -> None:
    trace = np.random.default_rng(1).random((2, 12))
    extent = Extent.of(length, length * (1 + softness), 1.0)
    np.testing.assert_allclose(
        mean(Past(trace, unknown), extent), brute_mean(trace, extent, unknown), atol=2e-4
    )


def test_mostly_asks_for_more_than_half() -> None:
    shares = np.array([0.4, 0.5, 0.65, 0.8, 1.0])
    traces = np.repeat(shares[:, None], 20, axis=1)
    now = mostly(Past(traces, 0.0), Extent(5.0, 6.25))[:, -1]
    assert now == pytest.approx([0.0, 0.0, 0.5, 1.0, 1.0])


OPERATORS = st.sampled_from([sometime, throughout, mostly])


@given(TRACES, st.floats(0, 0.5), st.one_of(CRISP.filter(lambda e: e.full > 0), SOFT), OPERATORS)
def test_operators_are_monotone(trace: Floats, more: float, extent: Extent, operator: object) -> None:
    assert callable(operator)
    raised = np.minimum(trace + more, 1.0)
    assert (operator(Past(raised, 0.0), extent) >= operator(Past(trace, 0.0), extent) - 1e-9).all()


@given(TRACES, SOFT, OPERATORS)
def test_operators_stay_between_0_and_1_and_in_shape(trace: Floats, extent: Extent, operator: object) -> None:
    assert callable(operator)
    found = operator(Past(trace, 0.0), extent)
    assert found.shape == trace.shape
    assert ((found >= 0) & (found <= 1)).all()


@given(st.floats(-5, 5), st.floats(0.5, 12), st.floats(-100, 100))
def test_the_slope_of_a_line_is_its_slope(rate: float, length: float, level: float) -> None:
    trace = (level + rate * np.arange(30.0))[None, :]
    found = slope(trace, Extent(length, length))
    first = int(np.ceil(length))
    np.testing.assert_allclose(found[0, first:], rate, atol=1e-6)
    assert np.isnan(found[0, : first - 1]).all()


def test_the_slope_is_that_of_least_squares() -> None:
    trace = np.random.default_rng(2).random((1, 200)).cumsum(axis=1)
    length = 40
    fine = np.linspace(150 - length, 150, 40_001)
    expected = np.polyfit(fine, np.interp(fine, np.arange(200), trace[0]), 1)[0]
    assert slope(trace, Extent(float(length), float(length)))[0, 150] == pytest.approx(expected, rel=1e-6)


def test_the_slope_over_a_gap_is_unknown() -> None:
    trace = np.arange(20.0)[None, :].copy()
    trace[0, 10] = np.nan
    missing = np.isnan(slope(trace, Extent(3.0, 3.0))[0])
    assert missing[10:14].all()
    assert not missing[[5, 15]].any()
