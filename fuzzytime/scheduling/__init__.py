"""FuzzyTask to Schedule: provably best start times."""

from fuzzytime.scheduling.alone import Best, best_alone
from fuzzytime.scheduling.auto import Auto
from fuzzytime.scheduling.climbing import HillClimbing, SimulatedAnnealing
from fuzzytime.scheduling.elsewhere import Alternative, elsewhere
from fuzzytime.scheduling.exact import Labels
from fuzzytime.scheduling.exhaustive import ExhaustiveSampling
from fuzzytime.scheduling.genetic import Genetic
from fuzzytime.scheduling.limits import Limits
from fuzzytime.scheduling.local_search import LocalSearch
from fuzzytime.scheduling.milp import Milp
from fuzzytime.scheduling.objectives import (
    EarliestStart,
    Energy,
    IdleTime,
    Intrusiveness,
    Makespan,
    Nearness,
    Objective,
)
from fuzzytime.scheduling.over_time import OverTime
from fuzzytime.scheduling.replan import Move, Replan, replan
from fuzzytime.scheduling.schedule import THRESHOLD, Certificate, Schedule, Status
from fuzzytime.scheduling.shares import Shares
from fuzzytime.scheduling.small import HeldKarp
from fuzzytime.scheduling.solve import solve
from fuzzytime.scheduling.solver import Solver
from fuzzytime.scheduling.why import Bond, Neighbour, Why, explain

__all__ = [
    "THRESHOLD",
    "Alternative",
    "Auto",
    "Best",
    "Bond",
    "Certificate",
    "EarliestStart",
    "Energy",
    "ExhaustiveSampling",
    "Genetic",
    "HeldKarp",
    "HillClimbing",
    "IdleTime",
    "Intrusiveness",
    "Labels",
    "Limits",
    "LocalSearch",
    "Makespan",
    "Milp",
    "Move",
    "Nearness",
    "Neighbour",
    "Objective",
    "OverTime",
    "Replan",
    "Schedule",
    "Shares",
    "SimulatedAnnealing",
    "Solver",
    "Status",
    "Why",
    "best_alone",
    "elsewhere",
    "explain",
    "replan",
    "solve",
]
