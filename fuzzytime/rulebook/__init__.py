"""From a time requirement and a context to a satisfaction function."""

from fuzzytime.rulebook.durations import OperationDuration
from fuzzytime.rulebook.profile import Actor, Profile
from fuzzytime.rulebook.resolution import (
    AtomDegree,
    Degree,
    HedgeEffect,
    Resolution,
    Share,
    SignalTrace,
    Trace,
)
from fuzzytime.rulebook.rulebook import HORIZON, Rulebook, check

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
