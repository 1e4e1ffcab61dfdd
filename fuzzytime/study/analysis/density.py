"""A satisfaction curve read as a probability density over time: its mean, its variance, its flanks.

The study calls a curve *broad* by the variance of that density (the paper's section IV-B). Between samples
a curve is linear, so the integrals here are exact for it, also where one is narrow against the sampling.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Floats
from fuzzytime.times import MINUTE

SQUARE_MINUTE = MINUTE**2
"""Seconds² in the unit in which the study prints variances."""

FLANK_LEVELS = (0.05, 0.95)
"""Shares of a curve's maximum between which its flanks are measured: the wobble at both ends stays out."""


def moment_weights(times: ArrayLike) -> Floats:
    """Give the weights of samples in the integrals of ψ, t·ψ and t²·ψ, for ψ linear between samples.

    Parameters
    ----------
    times : array of shape (k,)
        Seconds, ascending.

    Returns
    -------
    array of shape (k, 3)
        ``values @ weights`` are the three integrals; t counts from the middle of the timeline, which keeps
        them small against their difference.
    """
    at = np.asarray(times, float)
    position = at - (at[0] + at[-1]) / 2
    width, middle = np.diff(at), (position[1:] + position[:-1]) / 2
    weights = np.zeros((at.size, 3))
    for power in range(3):
        # Simpson's rule is exact up to t² ψ, a cubic on each cell.
        weights[:-1, power] += width / 6 * (position[:-1] ** power + 2 * middle**power)
        weights[1:, power] += width / 6 * (position[1:] ** power + 2 * middle**power)
    return weights


def variance_of_moments(moments: Floats) -> Floats:
    """Give the variance from integrals of shape (..., 3); NaN where the first, the area, is 0."""
    area = np.where(moments[..., 0] > 0, moments[..., 0], np.nan)
    return np.asarray(np.maximum(moments[..., 2] / area - (moments[..., 1] / area) ** 2, 0.0))


def variance(times: ArrayLike, values: ArrayLike) -> Floats:
    """Give the variance over time of curves taken as densities.

    Parameters
    ----------
    times : array of shape (k,)
        Seconds, ascending.
    values : array of shape (..., k)
        Satisfactions; a curve is linear between samples and 0 outside.

    Returns
    -------
    array of shape (...)
        Seconds²; NaN for a curve that is 0 everywhere.

    >>> round(float(variance([0, 60], [1, 1])))
    300
    """
    return variance_of_moments(np.asarray(values, float) @ moment_weights(times))


def mean_time(times: ArrayLike, values: ArrayLike) -> Floats:
    """Give the mean over time of curves of shape (..., k) taken as densities, in seconds."""
    at = np.asarray(times, float)
    moments = np.asarray(values, float) @ moment_weights(at)
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray((at[0] + at[-1]) / 2 + moments[..., 1] / moments[..., 0])


@dataclass(frozen=True, slots=True)
class Flanks:
    """How steeply a curve rises and falls: mean absolute gradients, in satisfaction per second.

    NaN for a flank that lies outside the timeline.
    """

    left: float
    right: float


def flanks(times: ArrayLike, values: ArrayLike) -> Flanks:
    """Measure the mean absolute gradient on both sides of a curve's plateau.

    A flank is measured between the first passage of 5 % and that of 95 % of the curve's maximum, from
    either end, as `FLANK_LEVELS` has it. A curve that already starts (or still ends) high has no such flank.

    Parameters
    ----------
    times, values : arrays of shape (k,)
        Seconds, and satisfactions.

    Raises
    ------
    FuzzytimeError
        If the curve is 0 everywhere.

    >>> flanks([0, 60, 120, 300], [0, 1, 1, 0]).left * 60
    1.0
    """
    at, curve = np.asarray(times, float), np.asarray(values, float)
    peak = float(curve.max())
    if peak <= 0:
        raise FuzzytimeError("a curve without a value above 0 has no flanks")
    low, high = (level * peak for level in FLANK_LEVELS)

    def gradient(times: Floats, curve: Floats) -> float:
        if curve[0] > low:
            return float("nan")
        rise = first_passage(times, curve, high) - first_passage(times, curve, low)
        return (high - low) / abs(rise)

    return Flanks(gradient(at, curve), gradient(at[::-1], curve[::-1]))


def first_passage(times: Floats, values: Floats, level: float) -> float:
    """Give the time at which a curve of shape (k,) first reaches a level, in the order of the samples.

    It is interpolated between samples; the first sample's time where that one lies at the level or above.

    Raises
    ------
    FuzzytimeError
        If the curve stays below the level.
    """
    reached = np.flatnonzero(values >= level)
    if not reached.size:
        raise FuzzytimeError(f"a curve whose maximum is {values.max():g} does not reach {level:g}")
    after = int(reached[0])
    if after == 0:
        return float(times[0])
    before = after - 1
    share = (level - values[before]) / (values[after] - values[before])
    return float(times[before] + share * (times[after] - times[before]))
