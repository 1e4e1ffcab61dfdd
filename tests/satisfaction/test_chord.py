"""The bound in continuous time stands on chord errors, so they must never be too small."""

import itertools

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.satisfaction import Bell, Floored, SatisfactionFunction, Trapezoid, cell_chord_errors
from fuzzytime.satisfaction.chord import linear_chord_error
from satisfaction.shapes_of import plain


def _measured(function: SatisfactionFunction, edges: np.ndarray) -> np.ndarray:
    """The largest rise of each cell's chord above the cost, on a dense sample."""
    rises = []
    for start, end in itertools.pairwise(edges):
        at = np.linspace(start, end, 501)
        cost = -function.log(at)
        chord = cost[0] + (cost[-1] - cost[0]) * (at - start) / (end - start)
        rises.append((chord - cost).max())
    return np.array(rises)


@given(plain, st.floats(1e-3, 0.5), st.floats(0.5, 5e4), st.floats(-1e5, 1e5))
def test_chord_errors_bound_what_is_measured(
    function: SatisfactionFunction, floor: float, step: float, first: float
) -> None:
    floored = Floored(function, floor)
    edges = first + step * np.arange(12)
    assert (cell_chord_errors(floored, edges) >= _measured(floored, edges) - 1e-6).all()


@given(plain, st.floats(1e-3, 0.5), st.floats(0.5, 5e4), st.floats(-1e5, 1e5))
def test_chord_errors_of_cells_together_are_those_of_each(
    function: SatisfactionFunction, floor: float, step: float, first: float
) -> None:
    floored = Floored(function, floor)
    edges = first + step * np.arange(12)
    each = [cell_chord_errors(floored, edges[cell : cell + 2])[0] for cell in range(11)]
    np.testing.assert_allclose(cell_chord_errors(floored, edges), each, atol=1e-9)


def test_chord_errors_vanish_with_the_square_of_the_step() -> None:
    for function in (Trapezoid(0, 100, 200, 300), Bell(150, 40, 2)):
        edges = np.array([30.0, 31.0])
        fine = np.array([30.0, 30.1])
        coarse_error, fine_error = cell_chord_errors(function, edges)[0], cell_chord_errors(function, fine)[0]
        assert 50 < coarse_error / fine_error < 200


def test_a_plateau_has_no_chord_error() -> None:
    assert cell_chord_errors(Trapezoid(0, 10, 20, 30), np.array([10.0, 15, 20])).tolist() == [0, 0]


def test_beside_the_least_numbers_the_error_is_still_finite_and_grows() -> None:
    first = np.array([1e-300, 1e-310, 5e-324])
    errors = linear_chord_error(first, np.ones(3))
    assert np.isfinite(errors).all()
    assert (np.diff(errors) > 0).all()
