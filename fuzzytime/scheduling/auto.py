"""The solver that picks: exact where it can be, else a sound heuristic."""

import math
from dataclasses import dataclass, replace
from typing import ClassVar

from fuzzytime.scheduling.exact import shares, small
from fuzzytime.scheduling.exact.milp import Milp
from fuzzytime.scheduling.exact.pauses import Pauses
from fuzzytime.scheduling.exact.threshold import CROWD, MANY, Labels, search_part
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.schedule import OPTIMAL_GAP
from fuzzytime.scheduling.search.local_search import LocalSearch
from fuzzytime.scheduling.search.stretches import Stretches
from fuzzytime.scheduling.solver import Draft, Solver

EXACT_JOBS = 12
"""Up to so many skills Held-Karp is fast."""

KICKS, KICKS_A_PAIR = 200, 0.4
"""Of a local search where a gap is left, at most; what may change places are pairs of skills."""

PAUSED_JOBS = 24
"""Up to so many skills lags of any kind are heeded by a program of their own."""

PAUSED_SHARE = 0.8
"""Of the time left, for that program: what it cannot close is left to the mixed-integer one."""

AGAIN = 2.0
"""How many times as long as the first a second search may take at least, to be worth its beginning."""


@dataclass(frozen=True, slots=True)
class Auto:
    """Held-Karp for few skills, labels or shares for more, pauses for lags; else a mixed-integer program."""

    name: ClassVar[str] = "auto"

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Solve by the best method for the problem."""
        # Around the bound's path the exact method for many finds better ones than a longer search would.
        sweeps = 1 if problem.agents == 1 and MANY <= len(problem.jobs) <= CROWD else math.inf
        since = watch.seconds
        begun = LocalSearch(sweeps=sweeps).search(problem, watch.share(0.3), warm)
        spent = watch.seconds - since
        best = replace(begun, method=LocalSearch.name)
        few = len(problem.jobs) <= EXACT_JOBS and not small.why_not(problem, watch.limits.memory)
        paused = not problem.kept_by_order and len(problem.jobs) <= PAUSED_JOBS
        for solver in self._exact(problem, watch, few=few, paused=paused):
            share = watch.share(PAUSED_SHARE) if isinstance(solver, Pauses) else watch
            found = solver.search(problem, share, best)
            best = replace(found, lower_cost=max(best.lower_cost, found.lower_cost), method=solver.name)
            if best.cost - best.lower_cost <= OPTIMAL_GAP * problem.weight:
                break
        gave_up = best.cost >= begun.cost > best.lower_cost and sweeps < math.inf
        if gave_up and watch.remaining > AGAIN * spent:
            # Where the exact method gives up for want of memory, the time left is the search's.
            longer = LocalSearch().search(problem, watch, best)
            best = replace(longer, lower_cost=best.lower_cost, method=LocalSearch.name)
        best = replace(best, lower_cost=max(best.lower_cost, min(problem.least_cost, best.cost)))
        # They relax what binds jobs otherwise than by their order.
        is_open = best.cost - best.lower_cost > OPTIMAL_GAP * problem.weight
        if is_open and not watch.is_over() and not (problem.kept_by_order and (few or problem.agents == 1)):
            kicks = max(KICKS, round(KICKS_A_PAIR * math.comb(len(problem.jobs), 2)))
            better = LocalSearch(kicks=kicks).search(problem, watch.share(0.2), best)
            if len(problem.jobs) > PARTS.length + PARTS.rejected:
                better = PARTS.improve(problem, watch.share(0.6), better)
            other = Milp().search(problem, watch, better)
            best = replace(other, lower_cost=max(best.lower_cost, other.lower_cost), method=Milp.name)
        return best

    @staticmethod
    def _exact(problem: Problem, watch: Stopwatch, *, few: bool, paused: bool) -> list[Solver]:
        """Give the exact methods for a problem, in turn until one closes the gap."""
        if paused:
            # Of one agent sets alone often tell enough, and at once.
            return [small.HeldKarp(), Pauses()] if few and problem.agents == 1 else [Pauses()]
        if few:
            return [small.HeldKarp()]
        if problem.agents == 1:
            return [Labels()]
        return [] if shares.why_not(problem, watch.limits.memory) else [shares.Shares()]


def _solve_part(part: Problem, _: list[int], watch: Stopwatch, warm: Draft) -> Draft:
    """Solve a stretch of all agents, or look for a better day of one."""
    return search_part(part, watch, warm) if part.agents == 1 else Auto().search(part, watch, warm)


PARTS = Stretches(_solve_part, length=14, rejected=8)
"""For what labels do not know: a stretch of several agents is small enough for shares."""
