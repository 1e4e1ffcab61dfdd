"""Continuous functions for drawn curves, by the Trust Region Reflective method (the paper's III-C.2).

The method may stop in a local minimum, so it starts from several guesses read off the curve. Two models
need no iteration and get the global optimum instead: the rectangle (the interval on which Σ(2ψ − 1) is
largest) and the polynomial (linear least squares).
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Floats, Interval, Rectangle, SatisfactionFunction, points_of
from fuzzytime.study.analysis.models import (
    BELL,
    FULL_AT_END,
    FULL_AT_START,
    TRAPEZOID,
    TRIANGLE,
    Curve,
    Shape,
)
from fuzzytime.study.answers.subjective import SubjectiveSatisfaction

STARTS = 3
"""Guesses that a fit starts from."""

EVALUATIONS = 60
"""Evaluations from one guess: trapezoids take about ten, a bell that becomes a jump would never end."""

FIRST_LEG = 8
"""Evaluations that every guess gets before only the best is followed."""

TOLERANCE = 1e-6
"""Relative changes of error and parameters below which a fit has settled: a millisecond in twenty minutes."""

DEGREE = 8
"""Degree of a fitted polynomial unless another is asked for: nine parameters."""

UNSEEN = 0.95
"""A trapezoid that begins (or ends) its timeline above this is taken to be full there."""


POOR = 0.9
"""Below this R² a function is said to fit badly: a tenth of what varies in the curve is not in it."""

MISSED = 0.01
"""Where nothing varies R² says nothing: a root mean square residual above this counts as a miss."""


class Model(StrEnum):
    """Families of functions to fit."""

    TRAPEZOID = "trapezoid"
    TRIANGLE = "triangle"
    RECTANGLE = "rectangle"
    BELL = "bell"
    POLYNOMIAL = "polynomial"


_SHAPES: Mapping[Model, Shape] = MappingProxyType(
    {Model.TRAPEZOID: TRAPEZOID, Model.TRIANGLE: TRIANGLE, Model.BELL: BELL}
)


@dataclass(frozen=True, slots=True)
class Fit:
    """A function fitted to a curve, and how far it misses.

    Parameters
    ----------
    model
        The family.
    function
        ψ over seconds.
    parameters
        What describes it, by name; times in seconds. A polynomial's are its coefficients, over the timeline
        scaled to [−1, 1].
    sse
        The paper's "prediction error": the sum of squared residuals over the samples.
    rmse
        √(sse / k).
    r_squared
        1 − sse / (sum of squares about the mean); NaN for a constant curve.
    """

    model: Model
    function: SatisfactionFunction
    parameters: Mapping[str, float]
    sse: float
    rmse: float
    r_squared: float

    @property
    def poor(self) -> bool:
        """Whether the function tells little of the curve: of a constant one, where it misses it at all."""
        return self.rmse > MISSED if np.isnan(self.r_squared) else self.r_squared < POOR


def fit(
    times: ArrayLike, values: ArrayLike, model: Model, *, starts: int = STARTS, degree: int = DEGREE
) -> Fit:
    """Fit one model to a curve.

    Parameters
    ----------
    times, values : arrays of shape (k,)
        Seconds, ascending; satisfactions in [0, 1].
    model : Model
        The family.
    starts : int
        How many guesses to start from, where the model is iterative.
    degree : int
        The polynomial's degree.

    Raises
    ------
    FuzzytimeError
        If times do not ascend, satisfactions are not in [0, 1], the curve is 0 everywhere, or it has no more
        samples than the model has parameters.

    >>> found = fit([0, 60, 120, 180, 240, 300], [0, 0.5, 1, 1, 0.5, 0], Model.TRAPEZOID)
    >>> [round(corner) for corner in found.function.kinks]
    [0, 120, 180, 300]
    """
    at, curve = np.asarray(times, float), np.asarray(values, float)
    if at.ndim != 1 or at.shape != curve.shape:
        raise FuzzytimeError(f"a curve needs as many values as times, got {curve.shape} and {at.shape}")
    SubjectiveSatisfaction(at, curve[None])  # It knows what times and satisfactions must be.
    needed = degree + 2 if model is Model.POLYNOMIAL else 5
    if at.size < needed:
        raise FuzzytimeError(f"fitting a {model} needs at least {needed} samples, got {at.size}")
    if not (curve > 0).any():
        raise FuzzytimeError("a curve that is 0 everywhere cannot be fitted")
    if model is Model.RECTANGLE:
        return _scored(model, _best_rectangle(at, curve), at, curve)
    if model is Model.POLYNOMIAL:
        return _best_polynomial(at, curve, degree)
    scaled = Curve.of(at, curve)
    shape = _SHAPES[model]
    parameters = _least_squares(shape, scaled, starts)
    if model is Model.TRAPEZOID:
        shape, parameters = _without_unseen_flank(parameters, scaled, starts)
    named = shape.parameters_in_seconds(parameters, scaled)
    return _scored(model, shape.function(parameters, scaled), at, curve, named)


def fit_models(
    times: ArrayLike, values: ArrayLike, models: Iterable[Model] = tuple(Model), *, starts: int = STARTS
) -> dict[Model, Fit]:
    """Fit several models to one curve."""
    return {model: fit(times, values, model, starts=starts) for model in models}


def _scored(
    model: Model,
    function: SatisfactionFunction,
    times: Floats,
    values: Floats,
    parameters: Mapping[str, float] | None = None,
) -> Fit:
    residuals = function(times) - values
    sse = float(residuals @ residuals)
    about_mean = float(((values - values.mean()) ** 2).sum())
    r_squared = 1 - sse / about_mean if about_mean > 0 else float("nan")
    if parameters is None:
        parameters = {name: value for name, value in function.parameters.items() if isinstance(value, float)}
    return Fit(
        model, function, MappingProxyType(dict(parameters)), sse, float(np.sqrt(sse / times.size)), r_squared
    )


def _least_squares(shape: Shape, curve: Curve, starts: int) -> Floats:
    """Give the best parameters that Trust Region Reflective finds from the first guesses."""
    from scipy.optimize import least_squares

    def residuals(parameters: Floats) -> Floats:
        return shape.value(parameters, curve.positions) - curve.values

    def derivatives(parameters: Floats) -> Floats:
        return shape.derivatives(parameters, curve.positions)

    low, high = shape.bounds(curve)
    margin = 1e-9 * (high - low)

    def descend(start: Floats, evaluations: int) -> tuple[float, Floats]:
        result = least_squares(
            residuals,
            np.clip(start, low + margin, high - margin),
            jac=derivatives,
            bounds=(low, high),
            method="trf",
            x_scale="jac",
            max_nfev=evaluations,
            ftol=TOLERANCE,
            xtol=TOLERANCE,
        )
        return float(result.cost), np.asarray(result.x, float)

    # All run a first leg, and the best one runs on: by then it is plain which valley is the deepest.
    legs = [descend(guess, FIRST_LEG) for guess in shape.guesses(curve)[:starts]]
    _, ahead = min(legs, key=lambda leg: leg[0])
    return descend(ahead, EVALUATIONS)[1]


def _without_unseen_flank(parameters: Floats, curve: Curve, starts: int) -> tuple[Shape, Floats]:
    """Fit again without a flank of which the timeline shows only the last twentieth, or nothing.

    Such a flank would be made up from the wobble of the plateau beside it.
    """
    begin, end = TRAPEZOID.value(parameters, np.array([0.0, 1.0]))
    if begin >= UNSEEN > end:
        return FULL_AT_START, _least_squares(FULL_AT_START, curve, starts)
    if end >= UNSEEN > begin:
        return FULL_AT_END, _least_squares(FULL_AT_END, curve, starts)
    return TRAPEZOID, parameters


def _best_rectangle(times: Floats, values: Floats) -> Rectangle:
    """Find the samples i … j with the largest Σ(2ψ − 1); the edges lie halfway to their neighbours."""
    gains = np.concatenate([[0.0], np.cumsum(2 * values - 1)])
    floor = np.minimum.accumulate(gains[:-1])
    last = int(np.argmax(gains[1:] - floor))
    first = int(np.argmin(gains[: last + 1]))
    halves = np.concatenate([[times[0]], (times[1:] + times[:-1]) / 2, [times[-1]]])
    return Rectangle(float(halves[first]), float(halves[last + 1]))


def _best_polynomial(times: Floats, values: Floats, degree: int) -> Fit:
    """Fit by linear least squares; as a satisfaction the polynomial is cut off at 0 and 1."""
    polynomial = np.polynomial.Polynomial.fit(times, values, degree)
    roots = np.concatenate([(polynomial - level).roots() for level in (0.0, 1.0)])
    meets = roots[np.isreal(roots)].real.tolist()
    function = points_of(
        lambda at: np.clip(polynomial(at), 0.0, 1.0), meets, Interval(float(times[0]), float(times[-1]))
    )
    coefficients = {f"c{power}": float(value) for power, value in enumerate(polynomial.coef)}
    return _scored(Model.POLYNOMIAL, function, times, values, coefficients)
