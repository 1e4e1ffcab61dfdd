"""Improve a long schedule part by part, each solved while the rest stands still.

A part is some skills that are done, together with those rejected that might fit there. Where many crowd,
no single skill may be better elsewhere though a rearrangement of two dozen gains much, and a problem of two
dozen is what exact methods are fast at. A *stretch* is a row of skills next to each other in time. Of several
agents the *day* of one, while the others keep to theirs, is a part as well: a problem of one agent. Taillard
and Voss, POPMUSIC: Partial optimization metaheuristic under special intensification conditions, Essays and
Surveys in Metaheuristics (2002) 613-629.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.search.parts import part_of
from fuzzytime.scheduling.solver import Draft, draft_of
from fuzzytime.scheduling.timing.settle import in_turn, lanes_of_agents, sequences, settled

LARGEST_SHARE = 0.3
"""Of the time left for one part, at most."""

NEAR = 1.0
"""Seconds around its place in which a skill that is not log-concave is timed anew."""

IMPROVEMENT = 1e-7
"""A new part must gain more than this."""

SolvePart = Callable[[Problem, list[int], Stopwatch, Draft], Draft]
"""Solves the problem of a part, of which the second argument names the members, from a warm draft on."""


@dataclass(frozen=True, slots=True)
class Stretches:
    """Solve parts in turn.

    Parameters
    ----------
    solve
        For one part.
    length
        Skills of a stretch that are done.
    rejected
        Skills that may come into a stretch, at most: those that would gain most for their time.
    """

    solve: SolvePart
    length: int
    rejected: int

    def improve(self, problem: Problem, watch: Stopwatch, best: Draft) -> Draft:
        """Improve until nothing is better: each agent's day, all stretches, and those half of one further."""
        search = _Search(self, problem, watch, best)
        rounds = [lambda: search.try_stretches(0), lambda: search.try_stretches(self.length // 2)]
        if problem.agents > 1:
            rounds.insert(0, search.try_days)
        number, since = 0, 0
        while since < len(rounds) and not watch.is_over():
            known = search.best.cost
            rounds[number % len(rounds)]()
            number, since = number + 1, since + 1 if search.best.cost == known else 0
        return search.best


class _Search:
    """The best schedule so far, and the parts that are solved."""

    def __init__(self, method: Stretches, problem: Problem, watch: Stopwatch, best: Draft) -> None:
        self._method, self._problem, self._watch = method, problem, watch
        self.best = best
        self._solved: set[tuple[object, ...]] = set()

    def try_days(self) -> None:
        """Try to improve what one agent does, and then the next."""
        team = lanes_of_agents(self._problem)
        for done, agent in enumerate(team):
            day = sequences(self._problem, self.best.starts, self.best.agents)[agent]
            self._try(day, len(team) - done, len(self._problem.jobs), [agent])

    def try_stretches(self, offset: int) -> None:
        """Try to improve stretch after stretch from a place on."""
        count, length = int(np.count_nonzero(~np.isnan(self.best.starts))), self._method.length
        firsts = range(offset - length if offset else 0, count, length)
        for done, first in enumerate(firsts):
            stretch = in_turn(self._problem, self.best.starts)[max(first, 0) : first + length]
            self._try(stretch, len(firsts) - done, self._method.rejected)

    def _try(self, moving: list[int], left: int, rejected: int, team: list[int] | None = None) -> None:
        """Try to improve a part, the first of some that are left to try."""
        if self._watch.is_over():
            return
        try:
            self._improve(moving, self._watch.share(min(LARGEST_SHARE, 1 / left)), rejected, team)
        except KeyboardInterrupt:
            self._watch.stop()

    def _improve(self, moving: list[int], watch: Stopwatch, rejected: int, team: list[int] | None) -> None:
        best = self.best
        members, part = part_of(self._problem, best, moving, rejected, team)
        warm = draft_of(part, best.starts[members], best.agents[members])
        key = (*members, *(job.windows for job in part.jobs), warm.cost)
        if not members or key in self._solved:
            return
        found = self._method.solve(part, members, watch, warm)
        if found.cost > warm.cost - IMPROVEMENT:
            if not watch.is_over():
                self._solved.add(key)
            return
        starts, agents = best.starts.copy(), best.agents.copy()
        starts[members], agents[members] = found.starts, found.agents
        after = draft_of(self._problem, starts, agents)
        if any(math.isnan(starts[lag.first]) > math.isnan(starts[lag.second]) for lag in self._problem.lags):
            # What stood still must not come after a skill that is rejected now.
            after = settled(self._problem, starts, agents, NEAR)
        self.best = after if after.cost < best.cost else best
