"""A fixed set of points that stands for chance: the same in every run, so that every answer is."""

from functools import lru_cache
from statistics import NormalDist

import numpy as np

from fuzzytime.satisfaction import Floats

SAMPLES = 64
"""How many curves stand for one kind of forecast."""


@lru_cache(maxsize=32)
def unit_points(dimensions: int) -> Floats:
    """Give points of shape (`SAMPLES`, dimensions) that fill the unit cube evenly.

    The sequence of the generalised golden ratio φ_d, the root above 1 of x^(d+1) = x + 1: coordinates are
    multiples of its powers, modulo 1 (Roberts 2018, "The unreasonable effectiveness of quasirandom
    sequences").
    """
    ratio = 1.5
    for _ in range(60):
        ratio = (1 + ratio) ** (1 / (dimensions + 1))
    steps = ratio ** -np.arange(1.0, dimensions + 1)
    points = (0.5 + np.outer(np.arange(1, SAMPLES + 1), steps)) % 1.0
    points.flags.writeable = False
    return points


@lru_cache(maxsize=32)
def normal_points(dimensions: int) -> Floats:
    """Give the same points through the inverse of the normal distribution, in each coordinate."""
    inverse = NormalDist().inv_cdf
    points = np.array([[inverse(share) for share in row] for row in unit_points(dimensions).tolist()])
    points.flags.writeable = False
    return points
