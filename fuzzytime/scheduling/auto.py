"""The solver that picks: exact where it can be, else a sound heuristic."""

from dataclasses import dataclass
from typing import ClassVar

from fuzzytime.scheduling import exact, small
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.local_search import LocalSearch
from fuzzytime.scheduling.milp import Milp
from fuzzytime.scheduling.problem import Problem
from fuzzytime.scheduling.solver import Draft

EXACT_JOBS = 12
"""Up to so many skills Held-Karp is fast."""


@dataclass(frozen=True, slots=True)
class Auto:
    """Held-Karp for few skills, labels for many; a mixed-integer program for what neither knows."""

    name: ClassVar[str] = "auto"

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Solve by the best method for the problem."""
        quick = LocalSearch().search(problem, watch.share(0.3), warm)
        if len(problem.jobs) <= EXACT_JOBS and not small.why_not(problem, watch.limits.memory):
            return small.HeldKarp().search(problem, watch, quick)
        if not exact.why_not(problem):
            return exact.Labels().search(problem, watch, quick)
        return Milp().search(problem, watch, quick)
