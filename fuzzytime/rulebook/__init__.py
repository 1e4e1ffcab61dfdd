"""From a time requirement and a context to a satisfaction function.

The ``rulebook`` is the road: ``tables`` say what holds, ``wording`` finds what a text names in them,
``logic`` is temporal fuzzy logic, true ``over_time``, and ``resolving`` ends in ψ.
"""

from fuzzytime.rulebook.resolving.resolution import (
    AtomDegree,
    Degree,
    HedgeEffect,
    Resolution,
    Share,
    SignalTrace,
    Trace,
)
from fuzzytime.rulebook.rulebook import HORIZON, Rulebook, check
from fuzzytime.rulebook.tables.durations import OperationDuration
from fuzzytime.rulebook.tables.profile import Actor, Profile

__all__ = [
    "HORIZON",
    "Actor",
    "AtomDegree",
    "Degree",
    "HedgeEffect",
    "OperationDuration",
    "Profile",
    "Resolution",
    "Rulebook",
    "Share",
    "SignalTrace",
    "Trace",
    "check",
]
