"""Curves at other times than the design's, brought to those."""

from collections.abc import Iterable

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Floats
from fuzzytime.study.asking.design import Design

NEAR = 1e-6
"""Seconds within which a time that was written down stands for one of the design's."""


def resampled(samples: Iterable[tuple[float, float]], design: Design) -> Floats:
    """Give a curve of shape (samples,) at the design's times from pairs of time and satisfaction.

    Between the pairs it is linear; before the first and after the last the design's default holds.

    Raises
    ------
    FuzzytimeError
        If there is no pair, or two have the same time.
    """
    pairs = np.array(sorted(samples), float).reshape(-1, 2)
    if not pairs.size:
        raise FuzzytimeError("a curve must have a sample")
    if (np.diff(pairs[:, 0]) <= 0).any():
        twice = pairs[1:][np.diff(pairs[:, 0]) <= 0][0, 0]
        raise FuzzytimeError(f"samples of a curve must have different times, got {twice:g} s twice")
    times = design.timeline.times
    close = np.searchsorted(times, pairs[:, 0] - NEAR).clip(0, times.size - 1)
    own = np.where(np.abs(times[close] - pairs[:, 0]) <= NEAR, times[close], pairs[:, 0])
    return np.asarray(np.interp(times, own, pairs[:, 1], left=design.default, right=design.default))
