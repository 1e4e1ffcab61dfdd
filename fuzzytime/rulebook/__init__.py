"""From a time requirement and a context to a satisfaction function."""

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
