"""Several agents and few skills: list each agent's possible shares of the work, and fit shares together.

A share is a set of jobs that one agent does, S, at its least cost p(S) on the grid. At prices λ its reduced
cost is r(S) = p(S) + Σ_{i in S} λ_i, and with the bound D and the cheapest path V of its lane
(`fuzzytime.scheduling.bound.relaxation`) a schedule in which some agent has S costs at least D − V + r(S). So
a schedule below a threshold is made of shares with

    r(S) < threshold − D + V,

which labels list that keep all their bits: few where the bound is good, though a path that visits jobs once
only is no better a bound. From the list come the disjoint shares that cost least, which is exact; and for
each share what a schedule with it costs at least, so that the sweep back
(`fuzzytime.scheduling.exact.backward`) deletes the starts that no better schedule uses. Baldacci,
Christofides and Mingozzi, An exact algorithm for the vehicle routing problem based on the set partitioning
formulation, Math. Programming 115 (2008) 351-385, list routes in the same way.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from fuzzytime.errors import RefusedError
from fuzzytime.scheduling.bound.refinement import GridSearch
from fuzzytime.scheduling.bound.relaxation import Relaxation
from fuzzytime.scheduling.exact.backward import used_below
from fuzzytime.scheduling.exact.fitting import Fit, Listed
from fuzzytime.scheduling.exact.labels import Labels
from fuzzytime.scheduling.exact.memory import memory_of_all
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.search.local_search import LocalSearch
from fuzzytime.scheduling.solver import Draft

MOST_JOBS = 22

TABLE_BYTES = 64
"""Memory that each of all sets of jobs takes, in a lane's tables."""

ROUNDING = 1e-9


@dataclass(frozen=True, slots=True)
class Shares:
    """Exact for several agents and few skills, as far as time and memory go; always with a bound.

    Lags are relaxed for the bound.
    """

    name: ClassVar[str] = "shares"

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Bound and solve grid after grid.

        Raises
        ------
        RefusedError
            If there is one agent only, or too many skills for the memory.
        """
        fault = why_not(problem, watch.limits.memory)
        if fault:
            raise RefusedError(f"sharing out {fault}")
        return _Search(problem, watch, warm or LocalSearch().search(problem, watch.share(0.3))).run()


def why_not(problem: Problem, memory: float) -> str:
    """Tell what is wrong with a problem for this solver, nothing if it is small enough."""
    if problem.agents < 2:
        return "needs several agents, got 1"
    if len(problem.jobs) > MOST_JOBS:
        return f"takes up to {MOST_JOBS} skills, got {len(problem.jobs)}"
    needed = TABLE_BYTES * len(problem.lanes) << len(problem.jobs)
    return f"needs {needed / 1e9:.2g} GB, got {memory / 1e9:.2g}" if needed > memory else ""


class _Search(GridSearch):
    """Shares below a rising threshold."""

    first_slots: ClassVar[int] = 200
    enough = 0.035

    def close(self, relaxation: Relaxation) -> bool:
        """Solve a grid, or prove that none of its schedules is better; tell whether that was done."""
        delta = 0.1 * (self.best.cost - self.lower) + self.left_over
        self.lower = max(self.lower, relaxation.lower)
        least = relaxation.cheapest()
        while not self.is_over():
            threshold = min(self.best.cost, self.lower + delta)
            programs = self._programs(relaxation, threshold, least)
            if not programs:
                return False
            lists = [_listed(*pair) for pair in zip(relaxation.agents, programs, strict=True)]
            fit = Fit(lists, relaxation.base, relaxation.prices)
            found = fit.best(threshold, self.watch)
            if not found.exact:
                return False
            if found.chosen:
                self.take(self._timed(relaxation, programs, found.chosen))
            self.lower = max(self.lower, min(found.cost, threshold))
            if self.is_closed():
                return True
            if self.best.cost <= threshold:
                rests = zip(programs, fit.beyond(), strict=True)
                relaxation.keep([used_below(program, self.best.cost, rest) for program, rest in rests])
                return True
            # The lists tell what a path costs at least that visits no job twice.
            bounds = zip(least, lists, programs, strict=True)
            least = [max(low, min(shares.least, program.limit)) for low, shares, program in bounds]
            delta = np.inf if found.chosen else 4 * delta
        return not self.watch.is_over()

    def _programs(self, relaxation: Relaxation, threshold: float, least: Sequence[float]) -> list[Labels]:
        """List the shares of each lane below a threshold; nothing where there are too many.

        ``least`` is what a path of each lane costs at least.
        """
        grid, prices, programs = relaxation.grid, relaxation.prices, []
        proved = relaxation.base - float(prices.sum()) + float(np.dot(relaxation.agents, least))
        for arcs, low in zip(relaxation.arcs_below(threshold), least, strict=True):
            nothing: list[list[int]] = [[] for _ in prices]
            program = Labels(arcs, grid.durations, grid.slots, prices, 0.0, nothing, memory_of_all)
            cells = self.watch.limits.memory // 16 // len(least)
            # In case of a tie in the sums the share is listed.
            if not program.run(threshold - proved + low + ROUNDING, self.watch, cells).exact:
                return []
            programs.append(program)
        return programs

    def _timed(self, relaxation: Relaxation, programs: Sequence[Labels], chosen: Sequence[int]) -> Draft:
        """Time the chosen shares, one for each agent, lane by lane."""
        slots, agents = np.full(relaxation.prices.size, -1), np.ones(relaxation.prices.size, np.int64)
        team = [(agent, number) for number, lane in enumerate(self.problem.lanes) for agent in lane.agents]
        for (agent, number), place in zip(team, chosen, strict=True):
            starts = programs[number].traced(place)
            slots[starts >= 0], agents[starts >= 0] = starts[starts >= 0], agent
        return self.timed(relaxation.grid, slots, agents)


def _listed(agents: int, program: Labels) -> Listed:
    """Give the shares that a run ended with."""
    sets, reduced = program.last()
    return Listed(agents, sets.astype(np.int64), np.where(reduced < program.limit, reduced, np.inf))
