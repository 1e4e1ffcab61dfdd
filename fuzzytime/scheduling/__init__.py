"""FuzzyTask to Schedule: provably best start times."""

from fuzzytime.scheduling.auto import Auto
from fuzzytime.scheduling.exact import Labels
from fuzzytime.scheduling.limits import Limits
from fuzzytime.scheduling.local_search import LocalSearch
from fuzzytime.scheduling.milp import Milp
from fuzzytime.scheduling.schedule import THRESHOLD, Certificate, Schedule, Status
from fuzzytime.scheduling.small import HeldKarp
from fuzzytime.scheduling.solve import solve
from fuzzytime.scheduling.solver import Solver

__all__ = [
    "THRESHOLD",
    "Auto",
    "Certificate",
    "HeldKarp",
    "Labels",
    "Limits",
    "LocalSearch",
    "Milp",
    "Schedule",
    "Solver",
    "Status",
    "solve",
]
