"""How far chords of a cost −log ψ rise above it: what makes a bound on a grid hold in continuous time.

Within a grid's cell the chord is compared with the cost piece by piece, where pieces lie between edges and
kinks and are smooth. On a piece the chord minus the cost is at most its larger value at the piece's two ends
(by limits from inside) plus the piece's own chord error; and at most the chord minus the piece's least cost.
"""

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.satisfaction.protocol import Floats, SatisfactionFunction


def linear_chord_error(first: Floats, last: Floats) -> Floats:
    """Give the chord error of −log ψ where ψ runs linearly between two values; infinite where one is 0.

    With m = (r − 1) / log r and r = last / first, the largest distance is log m − 1 + 1 / m.
    """
    low, high = np.minimum(first, last), np.maximum(first, last)
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        step = high / low - 1
        mean = step / np.log1p(step)
        error = np.log(mean) - 1 + 1 / mean
        # Beside the least numbers that there are r overflows, where log r does not.
        distance = np.log(high) - np.log(low)
        error = np.where(np.isinf(step), distance - np.log(distance) - 1, error)
    # The closed form cancels near r = 1; there the error is below (r − 1)² / 8.
    error = np.where(step < 1e-3, np.minimum(step, 1.0) ** 2 / 8, error)
    return np.where(low > 0, error, np.inf)


def cell_chord_errors(function: SatisfactionFunction, edges: ArrayLike) -> Floats:
    """Bound the rise of the chord of −log ψ above −log ψ in each cell between neighbouring edges.

    Parameters
    ----------
    function : SatisfactionFunction
        ψ.
    edges : array of shape (k + 1,)
        Ascending times in seconds.

    Returns
    -------
    array of shape (k,)
        Errors ≥ 0. Lowering −log ψ at an edge by the larger error of its two cells keeps the linear
        interpolation below −log ψ everywhere; infinite where ψ is 0 at an edge.
    """
    cells = np.asarray(edges, float)
    best = function.best
    first, last = np.searchsorted(cells, best.low), np.searchsorted(cells, best.high, "right") - 1
    if last <= first:
        return _errors(function, cells)
    # Where ψ keeps its maximum, which may be most of the time, chords do not rise.
    before, after = cells[: first + 1], cells[last:]
    level = np.zeros(last - first)
    return np.concatenate([_errors(function, before), level, _errors(function, after)])


def _errors(function: SatisfactionFunction, cells: Floats) -> Floats:
    if cells.size < 2:
        return np.zeros(0)
    kinks = np.unique(np.asarray(function.kinks, float))
    kinks = kinks[(kinks > cells[0]) & (kinks < cells[-1])]
    place = np.searchsorted(cells, kinks)
    place, kinks = place[cells[place] != kinks], kinks[cells[place] != kinks]
    nodes = np.insert(cells, place, kinks)
    starts, ends = nodes[:-1], nodes[1:]
    cell = np.insert(np.arange(cells.size), place, place - 1)[:-1]
    cost = -function.log(cells)
    after = -function.log(np.nextafter(starts, ends))
    before = -function.log(np.nextafter(ends, starts))
    with np.errstate(invalid="ignore"):
        slope = np.diff(cost) / np.diff(cells)
        chord_start = cost[cell] + slope[cell] * (starts - cells[cell])
        chord_end = cost[cell] + slope[cell] * (ends - cells[cell])
        smooth = np.maximum(chord_start - after, chord_end - before) + function.chord_error(starts, ends)
        # An unbounded piece is monotone: its cost falls from infinity to the finite end.
        crude = np.maximum(chord_start, chord_end) - np.minimum(after, before)
        piece = np.where(np.isfinite(smooth), np.maximum(smooth, 0.0), np.maximum(crude, 0.0))
        # At a jump ψ takes its larger value, which may lie above both limits.
        piece = np.maximum(piece, chord_start + function.log(starts))
    error = np.zeros(cells.size - 1)
    np.maximum.at(error, cell, np.where(np.isnan(piece), 0.0, piece))
    return np.where(np.isfinite(cost[:-1]) & np.isfinite(cost[1:]), error, np.inf)
