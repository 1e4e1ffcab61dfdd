import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Trapezoid
from fuzzytime.study import flanks, variance
from fuzzytime.study.analysis.density import SQUARE_MINUTE, mean_time
from study.truths import half_base

TIMES = 4.5 * np.arange(800)


@pytest.mark.parametrize(
    ("t_spec", "printed"), [(0.0, 0.197), (60.0, 0.505), (600.0, 0.955), (1800.0, 1.630)]
)
def test_the_law_of_widths_gives_the_variances_of_the_paper(t_spec: float, printed: float) -> None:
    w = half_base(t_spec)
    times = np.arange(0, 3600, 0.5)
    curve = Trapezoid(t_spec - w, t_spec - 0.4 * w, t_spec + 0.4 * w, t_spec + w)(times)
    assert variance(times, curve) / SQUARE_MINUTE == pytest.approx(printed, rel=0.02)


@given(st.floats(60, 1500), st.floats(1, 300), st.floats(0, 300), st.floats(1, 300), st.floats(0.1, 5))
def test_variance_grows_with_the_square_of_the_width_and_does_not_mind_a_shift(
    start: float, left: float, core: float, right: float, factor: float
) -> None:
    shape = Trapezoid(start, start + left, start + left + core, start + left + core + right)

    def exact(shape: Trapezoid) -> float:
        # Samples at the corners and nothing between: linear pieces are integrated exactly.
        times = np.unique(shape.corners)
        return float(variance(times, shape(times)))

    assert exact(shape.widened(factor, start)) == pytest.approx(factor**2 * exact(shape), rel=1e-6, abs=1e-4)
    assert exact(shape.shifted(1000.0)) == pytest.approx(exact(shape), rel=1e-6, abs=1e-4)


def test_variances_come_for_many_curves_at_once_and_nothing_drawn_has_none() -> None:
    curves = np.array([[Trapezoid(60, 120, 180, 240)(TIMES), np.zeros(800)]])
    found = variance(TIMES, curves)
    assert found.shape == (1, 2)
    assert found[0, 0] == pytest.approx((90**2 + 30**2) / 6, rel=0.01)
    assert np.isnan(found[0, 1])


def test_the_mean_time_of_a_symmetric_curve_is_its_centre() -> None:
    assert mean_time(TIMES, Trapezoid(100, 200, 300, 400)(TIMES)) == pytest.approx(250, abs=0.5)


def test_flanks_of_a_trapezoid_are_one_over_their_widths() -> None:
    found = flanks(TIMES, Trapezoid(585, 630, 675, 855)(TIMES))
    assert found.left == pytest.approx(1 / 45, rel=1e-6)
    assert found.right == pytest.approx(1 / 180, rel=1e-6)


def test_flanks_outside_the_timeline_are_not_made_up() -> None:
    found = flanks(TIMES, Trapezoid(0, 0, 1800, 1845)(TIMES))
    assert np.isnan(found.left)
    assert found.right == pytest.approx(1 / 45, rel=1e-6)
    with pytest.raises(FuzzytimeError, match="no flanks"):
        flanks(TIMES, np.zeros(800))
