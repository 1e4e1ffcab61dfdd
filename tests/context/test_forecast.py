"""Forecasts: they hold, go on straight or approach, and know what they do not know."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.context import Approach, Context, Hold, Linear, Signal
from fuzzytime.context.fitting import noise_of
from fuzzytime.context.forecast import Forecast, forecast
from fuzzytime.context.sampling import SAMPLES, normal_points, unit_points
from fuzzytime.context.series import Series
from fuzzytime.context.signals import Course
from fuzzytime.satisfaction import Floats

PAN = Approach(set_point=230, horizon=900)
FAMILIAR_PAN = Approach(set_point=230, time_constant=150, spread=1.5, horizon=900)


def signal(course: Course, **limits: Any) -> Signal:  # noqa: ANN401
    return Signal(name="x", unit="degC", low=0, high=350, course=course, **limits)


def heating(
    times: Floats, level: float = 230.0, noise: float = 1.0, seed: int = 1, tau: float = 150.0
) -> Floats:
    """A pan that heats from 20 °C since the first time, read with noise."""
    course = level + (20 - level) * np.exp(-(times - times[0]) / tau)
    return np.asarray(course + np.random.default_rng(seed).normal(0, noise, times.size))


def median(found: Forecast, *after: float) -> list[float]:
    times = found.start + np.array(after)
    return [float(value) for value in found.quantiles(times, (0.5,))[0]]


def test_a_held_signal_stays_where_it_is() -> None:
    found = forecast(signal(Hold()), np.array([-60.0, 0.0]), np.array([20.0, 50.0]))
    assert np.ptp(found.quantiles(np.array([50.0]), (0.1, 0.9))) == 0
    assert median(found, 1, 1000) == [50.0, 50.0]


def test_a_line_goes_on_and_stops_at_the_range() -> None:
    found = forecast(signal(Linear()), np.arange(-60.0, 1, 10), 100 + np.arange(-60.0, 1, 10))
    assert median(found, 60, 1000) == pytest.approx([160, 350], abs=0.5)


def test_a_known_rate_needs_one_reading_only() -> None:
    found = forecast(signal(Linear(rate=-1)), np.array([0.0]), np.array([300.0]))
    assert np.ptp(found.quantiles(np.array([50.0]), (0.1, 0.9))) == 0
    assert median(found, 100, 400) == [200, 0]


def test_one_reading_without_a_rate_is_held() -> None:
    assert median(forecast(signal(Linear()), np.array([0.0]), np.array([80.0])), 500) == [80]


def test_one_reading_approaches_the_set_point_as_the_table_believes() -> None:
    found = forecast(signal(FAMILIAR_PAN), np.array([0.0]), np.array([20.0]))
    assert median(found, 150)[0] == pytest.approx(230 - 210 / np.e, abs=10)
    low, high = found.quantiles(np.array([150.0]), (0.05, 0.95))[:, 0]
    assert high - low > 30


def test_one_reading_without_a_belief_in_its_pace_is_held() -> None:
    assert median(forecast(signal(PAN), np.array([0.0]), np.array([80.0])), 500) == [80]


@pytest.mark.parametrize("course", [PAN, FAMILIAR_PAN])
def test_a_heating_pan_is_followed_to_its_set_point(course: Course) -> None:
    times = np.arange(-120.0, 1, 2)
    found = forecast(signal(course), times, heating(times))
    truth = 230 - 210 * np.exp(-(120 + np.array([60.0, 150.0, 800.0])) / 150)
    assert median(found, 60, 150, 800) == pytest.approx(truth.tolist(), abs=3)


@pytest.mark.parametrize("course", [PAN, FAMILIAR_PAN])
def test_a_pan_that_stalls_below_its_set_point_is_recognised(course: Course) -> None:
    times = np.arange(-300.0, 1, 2)
    found = forecast(signal(course), times, heating(times, level=150))
    assert found.level == pytest.approx(150, abs=3)
    assert float(found.quantiles(np.array([900.0]), (0.95,))[0, 0]) < 170


def test_a_pan_that_was_turned_off_a_minute_ago_cools() -> None:
    times = np.arange(-300.0, 1, 2)
    hot = heating(times, noise=0)
    last_hot = float(hot[times < -60][-1])
    values = np.where(times < -60, hot, 20 + (last_hot - 20) * np.exp(-(times + 60) / 400))
    noise = np.random.default_rng(2).normal(0, 1, times.size)
    found = forecast(signal(FAMILIAR_PAN), times, values + noise)
    assert median(found, 60)[0] < values[-1] - 10


def test_a_cold_pan_on_a_cold_hob_stays_cold() -> None:
    times = np.arange(-120.0, 1, 2)
    values = 20 + np.random.default_rng(3).normal(0, 0.5, times.size)
    assert median(forecast(signal(FAMILIAR_PAN), times, values), 300)[0] == pytest.approx(20, abs=3)


def test_without_a_set_point_the_readings_tell_the_level() -> None:
    times = np.arange(-400.0, 1, 5)
    found = forecast(signal(Approach(horizon=900)), times, heating(times, level=180))
    assert found.level == pytest.approx(180, abs=5)


AHEAD = np.arange(0.0, 900.0, 0.5)


def hot(temperatures: Floats) -> Floats:
    return np.interp(temperatures, [170, 190, 250, 280], [0, 1, 1, 0])


def of_noisy_readings(readings_for: float, seed: int) -> Forecast:
    """A pan from 20 to 230 °C with τ = 150 s, read every two seconds with a noise of 2 °C."""
    times = np.arange(-readings_for, 0.1, 2.0)
    return forecast(signal(PAN), times, heating(times, noise=2.0, seed=seed))


def test_a_minute_of_readings_tells_when_the_pan_is_hot() -> None:
    truth = hot(230 - 210 * np.exp(-(AHEAD + 60) / 150))
    half = 150 * np.log(210 / 50) - 60
    errors, misses = [], []
    for seed in range(80):
        found = of_noisy_readings(60.0, seed)
        parts = [
            hot(found.values(i, AHEAD)).mean(axis=0) * part.weight for i, part in enumerate(found.components)
        ]
        psi = np.sum(parts, axis=0)
        errors.append(abs(np.interp(0.5, np.maximum.accumulate(psi), AHEAD) - half))
        misses.append(np.abs(psi - truth).mean())
    assert np.median(errors) <= 3.0
    assert np.mean(misses) <= 0.01


@pytest.mark.parametrize("readings_for", [60.0, 120.0])
def test_the_interval_of_90_percent_covers_so_much(readings_for: float) -> None:
    half = np.array([150 * np.log(210 / 50) - readings_for])
    bands = [of_noisy_readings(readings_for, seed).quantiles(half, (0.05, 0.95))[:, 0] for seed in range(300)]
    assert 0.85 <= np.mean([low <= 180 <= high for low, high in bands]) <= 0.95


@given(st.integers(0, 20), st.floats(-3, 3))
def test_a_small_change_of_a_reading_changes_the_forecast_a_little(position: int, size: float) -> None:
    times = np.arange(-100.0, 1, 5)
    values = heating(times, noise=2.0)
    changed = values.copy()
    changed[position] += 1e-6 * size
    course = signal(FAMILIAR_PAN)
    before, after = (median(forecast(course, times, v), 30, 300) for v in (values, changed))
    assert np.abs(np.array(before) - after).max() < 1e-3


def test_the_points_that_stand_for_chance_are_even_and_fixed() -> None:
    points = unit_points(3)
    assert points.shape == (SAMPLES, 3)
    assert np.abs(points.mean(axis=0) - 0.5).max() < 0.02
    assert np.abs(normal_points(2).std(axis=0) - 1).max() < 0.1
    assert points is unit_points(3)


def series(course: Course, pairs: list[tuple[float, float]], **limits: float) -> Series:
    return Series.of(signal(course, **limits), Context.of({"x": pairs}).of_signal("x"))


def test_between_readings_a_signal_runs_straight_and_before_them_it_is_unknown() -> None:
    values = series(Hold(), [(-10, 20), (0, 40)]).at(np.array([-11.0, -10, -5, 0, 5]))[0]
    assert np.isnan(values[0])
    assert values[1:].tolist() == [20, 30, 40, 40]


def test_a_long_gap_is_unknown() -> None:
    values = series(Hold(), [(-100, 20), (-10, 30), (0, 40)], max_gap=30.0).at(
        np.array([-100.0, -50, -10, -5])
    )[0]
    assert np.isnan(values).tolist() == [False, True, False, False]


def test_a_dead_sensor_is_unknown_from_its_maximum_age_on() -> None:
    values = series(Hold(), [(-100, 20)], max_age=30.0).at(np.array([-80.0, -60, 0]))[0]
    assert np.isnan(values).tolist() == [False, True, True]


def test_beyond_its_horizon_a_forecast_is_unknown() -> None:
    values = series(Hold(horizon=60.0), [(0, 20)]).at(np.array([30.0, 90.0]))[0]
    assert np.isnan(values).tolist() == [False, True]


@given(
    st.lists(st.floats(1, 100), min_size=4, max_size=30),
    st.floats(-2, 2),
    st.floats(-50, 50),
)
def test_a_course_that_bends_evenly_is_no_noise(steps: list[float], bend: float, slope: float) -> None:
    times = np.cumsum(steps)
    values = bend * times**2 / 2 + slope * times
    found = noise_of(times, values, 1.0)
    assert found <= 1.0 + 1e-6


def test_the_noise_of_readings_is_told_without_bias() -> None:
    generator = np.random.default_rng(3)
    found = []
    for _ in range(400):
        times = np.sort(generator.uniform(0, 600, 20))
        found.append(noise_of(times, generator.normal(0, 3, times.size), 3.0) ** 2)
    assert np.sqrt(np.mean(found)) == pytest.approx(3, rel=0.05)
