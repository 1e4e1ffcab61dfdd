import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Bell, Rectangle, SatisfactionFunction, Trapezoid, Triangle
from fuzzytime.study import Model, fit, fit_models
from fuzzytime.study.analysis.models import (
    BELL,
    FULL_AT_END,
    FULL_AT_START,
    TRAPEZOID,
    TRIANGLE,
    Curve,
    Shape,
)

TIMES = 4.5 * np.arange(800, dtype=float)


@settings(max_examples=40, deadline=None)
@given(
    start=st.floats(100, 1500),
    left=st.floats(10, 600),
    core=st.floats(0, 600),
    right=st.floats(10, 600),
    seed=st.integers(0, 10**6),
)
def test_a_wobbly_trapezoid_is_found_again(
    start: float, left: float, core: float, right: float, seed: int
) -> None:
    meant = Trapezoid(start, start + left, start + left + core, start + left + core + right)
    wobble = 0.003 * np.random.default_rng(seed).standard_normal(800)
    drawn = np.clip(meant(TIMES) + np.where(meant(TIMES) > 0, wobble, 0.0), 0.0, 1.0)
    found = fit(TIMES, drawn, Model.TRAPEZOID)
    assert isinstance(found.function, Trapezoid)
    assert found.function.corners == pytest.approx(meant.corners, abs=6.0)
    assert found.sse <= 800 * 0.003**2 * 1.5


@pytest.mark.parametrize(
    ("meant", "model"),
    [
        (Triangle(300, 600, 1500), Model.TRIANGLE),
        (Rectangle(600, 1503), Model.RECTANGLE),
        (Bell(900, 240, 1.0), Model.BELL),
        (Bell(900, 600, 9.0), Model.BELL),
    ],
)
def test_each_model_finds_its_own_shape(meant: SatisfactionFunction, model: Model) -> None:
    found = fit(TIMES, meant(TIMES), model)
    assert type(found.function) is type(meant)
    assert found.sse < 1e-3
    assert found.r_squared > 0.9999
    assert list(found.function.parameters.values()) == pytest.approx(
        list(meant.parameters.values()), rel=0.01
    )


def test_on_a_plateau_the_generalised_bell_is_far_better_than_a_gaussian() -> None:
    plateau = Trapezoid(1200, 1400, 2200, 2400)(TIMES)
    gaussian = min(
        float(((np.exp(-(((TIMES - 1800) / width) ** 2)) - plateau) ** 2).sum())
        for width in np.linspace(100, 2000, 400)
    )
    assert gaussian > 10 * fit(TIMES, plateau, Model.BELL).sse


def test_a_trapezoid_is_never_worse_than_the_triangle_within_it() -> None:
    generator = np.random.default_rng(5)
    for _ in range(5):
        corners = np.sort(generator.uniform(0, 3600, 4))
        curve = np.clip(Trapezoid(*corners)(TIMES) + 0.05 * generator.standard_normal(800), 0, 1)
        found = fit_models(TIMES, curve, (Model.TRAPEZOID, Model.TRIANGLE, Model.RECTANGLE))
        assert found[Model.TRAPEZOID].sse <= min(f.sse for f in found.values()) + 1e-6


def test_the_rectangle_is_the_best_of_all() -> None:
    generator = np.random.default_rng(3)
    times = np.arange(40.0)
    curve = generator.uniform(0, 1, 40)
    tried = min(
        float(((((np.arange(40) >= i) & (np.arange(40) <= j)) - curve) ** 2).sum())
        for i in range(40)
        for j in range(i, 40)
    )
    assert fit(times, curve, Model.RECTANGLE).sse == pytest.approx(tried)


def test_a_flank_that_the_timeline_does_not_show_is_not_made_up_from_wobble() -> None:
    wobble = 0.01 * np.abs(np.random.default_rng(1).standard_normal(800))
    until = fit(TIMES, np.clip(Trapezoid(0, 0, 1800, 1860)(TIMES) - wobble, 0, 1), Model.TRAPEZOID)
    assert until.function.kinks == pytest.approx((0, 1800, 1860), abs=4.5)
    since = fit(TIMES, np.clip(Trapezoid(1740, 1800, 4000, 4000)(TIMES) - wobble, 0, 1), Model.TRAPEZOID)
    assert since.function.kinks == pytest.approx((1740, 1800, TIMES[-1]), abs=4.5)


def test_a_polynomial_is_cut_off_at_0_and_1_and_more_degrees_fit_better() -> None:
    curve = Trapezoid(600, 900, 1500, 1800)(TIMES)
    few, many = (fit(TIMES, curve, Model.POLYNOMIAL, degree=degree) for degree in (4, 16))
    assert many.sse < few.sse
    assert len(many.parameters) == 17
    everywhere = many.function(np.linspace(-100, 3700, 5000))
    assert everywhere.min() >= 0
    assert everywhere.max() <= 1


def test_figures_of_a_fit_belong_together() -> None:
    curve = np.clip(Bell(1800, 300, 1)(TIMES) + 0.1 * np.sin(TIMES / 50), 0, 1)
    found = fit(TIMES, curve, Model.BELL)
    residuals = found.function(TIMES) - curve
    assert found.sse == pytest.approx(float(residuals @ residuals))
    assert found.rmse == pytest.approx(np.sqrt(found.sse / 800))
    assert found.r_squared == pytest.approx(1 - found.sse / (800 * curve.var()))


@pytest.mark.parametrize(
    ("times", "values", "rule"),
    [
        (TIMES, np.zeros(800), "0 everywhere"),
        (TIMES[:4], np.ones(4), "at least 5 samples, got 4"),
        (TIMES, np.ones(8), "as many values as times"),
        (TIMES[::-1], np.ones(800), "must ascend"),
        (np.append(TIMES[:-1], np.inf), np.ones(800), "must be finite"),
        (TIMES, np.full(800, np.nan), r"must lie in \[0, 1\]"),
        (TIMES, np.full(800, 1.2), r"must lie in \[0, 1\]"),
    ],
)
def test_what_cannot_be_fitted_is_refused(times: np.ndarray, values: np.ndarray, rule: str) -> None:
    for model in (Model.TRAPEZOID, Model.POLYNOMIAL) if times.size > 4 else (Model.TRAPEZOID,):
        with pytest.raises(FuzzytimeError, match=rule):
            fit(times, values, model)


def test_a_constant_curve_is_fitted_badly_by_what_is_not_constant() -> None:
    half, ones = np.full(800, 0.5), np.ones(800)
    assert [fit(TIMES, half, model).poor for model in (Model.TRAPEZOID, Model.POLYNOMIAL)] == [True, False]
    assert not fit(TIMES, ones, Model.TRAPEZOID).poor


@pytest.mark.parametrize(
    "curve", [np.eye(1, 800)[0], np.ones(800), np.linspace(0, 1, 800), np.full(800, 0.3)]
)
@pytest.mark.parametrize("model", list(Model))
def test_odd_curves_get_finite_fits(curve: np.ndarray, model: Model) -> None:
    found = fit(TIMES, curve, model)
    assert np.isfinite(found.sse)
    assert np.isfinite(found.function(TIMES)).all()


@pytest.mark.parametrize("shape", [TRAPEZOID, TRIANGLE, FULL_AT_START, FULL_AT_END, BELL])
def test_derivatives_are_those_of_the_values(shape: Shape) -> None:
    curve = Curve.of(TIMES, Trapezoid(900, 1200, 2000, 2600)(TIMES))
    at = shape.guesses(curve)[0]
    # Between samples no point may cross a bend while a parameter is nudged.
    positions = curve.positions + 0.37 / 800
    numeric = np.stack(
        [
            (shape.value(at + step, positions) - shape.value(at - step, positions)) / 2e-7
            for step in 1e-7 * np.eye(at.size)
        ],
        axis=-1,
    )
    assert shape.derivatives(at, positions) == pytest.approx(numeric, abs=2e-3)
