"""FuzzyTask to Schedule: provably best start times."""

from fuzzytime.scheduling.auto import Auto, LocalSearch
from fuzzytime.scheduling.limits import Limits
from fuzzytime.scheduling.schedule import THRESHOLD, Certificate, Schedule, Status
from fuzzytime.scheduling.small import HeldKarp
from fuzzytime.scheduling.solve import solve
from fuzzytime.scheduling.solver import Solver

__all__ = [
    "THRESHOLD",
    "Auto",
    "Certificate",
    "HeldKarp",
    "Limits",
    "LocalSearch",
    "Schedule",
    "Solver",
    "Status",
    "solve",
]
