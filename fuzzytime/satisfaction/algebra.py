"""New satisfaction functions from others: products, averages, points that stand for a function.

Shift, widening and floor keep a shape and are its methods. A product or an average of piecewise linear
functions is piecewise quadratic; it is given as `Sampled` points within a stated tolerance.
"""

from collections.abc import Callable, Iterable
from itertools import pairwise

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction.protocol import Floats, Interval, SatisfactionFunction
from fuzzytime.satisfaction.sampled import Sampled
from fuzzytime.satisfaction.trapezoid import Trapezoid

TOLERANCE = 1e-4
"""How far points may lie from the function that they stand for."""

ROUNDING = 1e-9
"""Up to here two satisfactions are the same but for rounding."""

MAX_POINTS = 20_000

LANDMARKS = (0.02, 0.5, 0.98)
"""Satisfactions between whose times points of a product are sought."""

ALWAYS = Trapezoid(0.0, 0.0, np.inf, np.inf)
"""Satisfied at any time from now on: an instruction without time words."""

NEVER = Sampled((0.0,), (0.0,))
"""ψ ≡ 0: what can never satisfy."""


def points_of(
    value: Callable[[Floats], Floats],
    kinks: Iterable[float],
    within: Interval,
    tolerance: float = TOLERANCE,
) -> Sampled:
    """Give points that stand for a function of time on an interval; outside it they give 0.

    Parameters
    ----------
    value : callable
        From times of shape (k,) to satisfactions of that shape.
    kinks : iterable of float
        Where it jumps or bends. Between them, cells are halved until the points fit.
    within : Interval
        A finite interval; an empty one gives `NEVER`.
    tolerance : float
        The largest distance allowed at quarters of a cell.

    Raises
    ------
    FuzzytimeError
        If the interval is not finite.
    """
    if within.empty:
        return NEVER
    if not np.isfinite([within.low, within.high]).all():
        raise FuzzytimeError(f"points need a finite interval, got {within.low:g} to {within.high:g}")
    inner = [kink for kink in kinks if within.low < kink < within.high]
    nodes = np.unique(np.array([within.low, *inner, within.high], float))
    if nodes.size == 1:
        return Sampled(nodes, np.clip(value(nodes), 0.0, 1.0))
    pieces = [_refined(value, a, b, tolerance) for a, b in pairwise(nodes.tolist())]
    times = np.concatenate([times for times, _ in pieces])
    values = np.concatenate([values for _, values in pieces])
    # One piece ends where the next begins: one point where the two agree, two where the function jumps.
    twice = np.append(times[1:] == times[:-1], False) & (np.abs(np.append(np.diff(values), 0.0)) < ROUNDING)
    # Where both wishes are full, so is their product: a plateau must not lean to one side.
    values = np.where(values > 1 - ROUNDING, 1.0, values)
    return Sampled(times[~twice], np.clip(values[~twice], 0.0, 1.0))


def _refined(
    value: Callable[[Floats], Floats], start: float, end: float, tolerance: float
) -> tuple[Floats, Floats]:
    """Points on a smooth piece, by limits from inside at its ends; the cells that miss are halved."""
    quarters = np.array([0.25, 0.5, 0.75])
    times = np.array([start, end])
    values = value(np.array([np.nextafter(start, end), np.nextafter(end, start)]))
    while times.size < MAX_POINTS:
        inside = times[:-1, None] + np.diff(times)[:, None] * quarters
        chord = values[:-1, None] + np.diff(values)[:, None] * quarters
        exact = value(inside.ravel()).reshape(inside.shape)
        cells = np.flatnonzero((np.abs(exact - chord) > tolerance).any(axis=1))
        if not cells.size:
            break
        times = np.insert(times, cells + 1, inside[cells, 1])
        values = np.insert(values, cells + 1, exact[cells, 1])
    return times, values


def product(
    first: SatisfactionFunction, second: SatisfactionFunction, tolerance: float = TOLERANCE
) -> Sampled:
    """Give ψ₁·ψ₂ as points: both wishes, joined by the paper's logical AND.

    Raises
    ------
    FuzzytimeError
        If the two are above 0 together on an infinite interval.
    """
    within = first.support.intersection(second.support)
    # A narrow peak must not fall between the places where cells are tried.
    marks = [mark for one in (first, second) for mark in _landmarks(one)]
    return points_of(lambda times: first(times) * second(times), marks, within, tolerance)


def _landmarks(function: SatisfactionFunction) -> list[float]:
    """Give the times between which a function goes one way, and not far at once."""
    crossings = [time for level in LANDMARKS for time in function.crossings(level)]
    marks = [*function.kinks, *crossings, function.best.low, function.best.high]
    return [mark for mark in marks if np.isfinite(mark)]


def averaged(
    function: SatisfactionFunction, duration: float, tolerance: float = TOLERANCE
) -> SatisfactionFunction:
    """Give the mean of ψ over an execution that starts at t: (1 / d) ∫₀ᵈ ψ(t + u) du.

    For what is asked to happen *throughout* a time. A duration of 0 gives ψ itself.

    Raises
    ------
    FuzzytimeError
        If the duration is negative or not finite, or ψ is above 0 on an infinite interval.
    """
    if not 0 <= duration < np.inf:
        raise FuzzytimeError(f"a duration must be finite and at least 0, got {duration}")
    if duration == 0:
        return function
    base = points_of(function, function.kinks, function.support, tolerance / 4)
    within = Interval(base.support.low - duration, base.support.high)
    # The running integral of the points is exact by trapezia: they are linear in between.
    times, values = base.times, base.values
    running = np.concatenate([[0.0], np.cumsum((values[1:] + values[:-1]) / 2 * np.diff(times))])

    def integral(until: Floats) -> Floats:
        clipped = np.clip(until, times[0], times[-1])
        cell = np.clip(np.searchsorted(times, clipped, "right") - 1, 0, max(times.size - 2, 0))
        return np.asarray(running[cell] + (clipped - times[cell]) * (values[cell] + base(clipped)) / 2)

    def mean(start: Floats) -> Floats:
        # Sums of many trapezia leave 1 − 3e-16 on a plateau: rounding keeps it a plateau.
        return np.asarray(np.round((integral(start + duration) - integral(start)) / duration, 12))

    return points_of(mean, {*base.kinks, *(np.asarray(base.kinks) - duration).tolist()}, within, tolerance)
