"""ψ: how satisfied a person is with a start time (the paper's eq. 3).

The ``protocol``, and what keeps it: ``bell``, and what is ``linear`` piece by piece, by corners
(``trapezoid``) or by points (``sampled``). Made of others: ``either``, ``clipped``, ``floored``, and by
``algebra``. ``chord`` is for bounds.
"""

from fuzzytime.satisfaction.algebra import ALWAYS, NEVER, averaged, points_of, product
from fuzzytime.satisfaction.bell import Bell
from fuzzytime.satisfaction.chord import cell_chord_errors
from fuzzytime.satisfaction.clipped import Clipped
from fuzzytime.satisfaction.either import Either
from fuzzytime.satisfaction.floored import Floored
from fuzzytime.satisfaction.protocol import EMPTY, EVERYWHERE, Floats, Interval, SatisfactionFunction
from fuzzytime.satisfaction.sampled import Sampled
from fuzzytime.satisfaction.trapezoid import Rectangle, Trapezoid, Triangle

__all__ = [
    "ALWAYS",
    "EMPTY",
    "EVERYWHERE",
    "NEVER",
    "Bell",
    "Clipped",
    "Either",
    "Floats",
    "Floored",
    "Interval",
    "Rectangle",
    "Sampled",
    "SatisfactionFunction",
    "Trapezoid",
    "Triangle",
    "averaged",
    "cell_chord_errors",
    "points_of",
    "product",
]
