"""FuzzyTask to Schedule: provably best start times.

Its rooms, from the ground: ``problem`` is what is solved, ``timing`` makes start times of an order,
``bound`` says what no schedule can cost less than, ``search`` finds good schedules, ``exact`` proves
one best, ``secondary`` chooses among equals, ``paper`` holds the paper's own methods. ``solve`` is the
road through them, ``auto`` picks the solver, ``replan`` plans on, ``why`` and ``elsewhere`` explain. A
``solver`` works within ``limits`` and hands back a ``schedule``. docs/scheduling-exact.md derives it
all, and says in which order to read.
"""

from fuzzytime.scheduling.auto import Auto
from fuzzytime.scheduling.elsewhere import Alternative, elsewhere
from fuzzytime.scheduling.exact.milp import Milp
from fuzzytime.scheduling.exact.pauses import Pauses
from fuzzytime.scheduling.exact.shares import Shares
from fuzzytime.scheduling.exact.small import HeldKarp
from fuzzytime.scheduling.exact.threshold import Labels
from fuzzytime.scheduling.limits import Limits
from fuzzytime.scheduling.paper.climbing import HillClimbing, SimulatedAnnealing
from fuzzytime.scheduling.paper.exhaustive import ExhaustiveSampling
from fuzzytime.scheduling.paper.genetic import Genetic
from fuzzytime.scheduling.problem.alone import Best, best_alone
from fuzzytime.scheduling.replan import Move, Replan, replan
from fuzzytime.scheduling.schedule import THRESHOLD, Certificate, Schedule, Status
from fuzzytime.scheduling.search.local_search import LocalSearch
from fuzzytime.scheduling.secondary.objectives import (
    EarliestStart,
    Energy,
    IdleTime,
    Intrusiveness,
    Makespan,
    Nearness,
    Objective,
)
from fuzzytime.scheduling.secondary.over_time import OverTime
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
    "Pauses",
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
