"""The exact method for few skills that lags of any kind bind, of one agent or of several.

On each grid (`fuzzytime.scheduling.bound.refinement`) a dynamic program that knows the starts on which later
ones depend (`fuzzytime.scheduling.exact.waiting`) searches below a threshold just above the bound, which
rises until a schedule lies below it. The starts that it tried below the best known cost are all that the
next, finer grid need have. Good schedules come from the same program in a beam; and where even these may be
far from the best, first with each skill near the time where it would be if agents had time for all at once,
on a grid that is fine there: what must end shortly before another might do so at any time of the day.
"""

import math
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from fuzzytime.satisfaction import Interval
from fuzzytime.scheduling.bound.refinement import GridSearch
from fuzzytime.scheduling.bound.relaxation import Relaxation
from fuzzytime.scheduling.exact.waiting import Found, Waiting
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import room_of
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.problem.windows import in_common
from fuzzytime.scheduling.search.local_search import LocalSearch
from fuzzytime.scheduling.solver import Draft, nothing
from fuzzytime.scheduling.timing.settle import manned, settled

BYTES_PER_START = 16
"""Memory that a start takes which is tried: of few a state remains."""

ROOM, MORE = 500_000, 8
"""Starts that are tried at first, and how many times as many next."""

FIRST = 0.1
"""Of the gap, the first threshold is above the bound."""

FARTHER = 4
"""How many times as far the next one is."""

LEAST = 0.05
"""Of the gap, a threshold is above the bound at least; where there is too much to try even so, it stays."""

BEAM, WIDER, BEAMS = 200, 4, 2
"""States in the first beam, how many times as many the next one has, and how many beams there are."""

SLOTS = 150
"""Slots in which an average skill may start on the first grid, at least."""

BRIEF = 0.5
"""Of the time left, for a schedule near where each skill would be if agents had time for all at once."""


@dataclass(frozen=True, slots=True)
class Pauses:
    """Exact for few skills, whatever lags bind them, as far as time and memory go; always with a bound."""

    name: ClassVar[str] = "pauses"

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Bound and solve grid after grid."""
        best = warm or LocalSearch().search(problem, watch.share(0.3))
        search = _Search(problem, watch, best)
        if search.is_doubtful():
            search.take(_Brief(_near(problem), watch.share(BRIEF), nothing(problem)).run())
        return search.run()


class _Search(GridSearch):
    """States below a rising threshold."""

    finer = 4
    fastest = 4
    enough = 0.05

    @property
    def first_slots(self) -> int:
        """As many as give each skill its share."""
        jobs = self.problem.jobs
        span = max(job.latest + job.duration for job in jobs) - min(job.earliest for job in jobs)
        mean = room_of(self.problem) / (len(jobs) * len(self.problem.lanes))
        return round(SLOTS * min(max(1.0, span / mean), len(jobs))) if mean > 0 else SLOTS

    @property
    def closable(self) -> bool:
        """Nothing is relaxed."""
        return True

    def close(self, relaxation: Relaxation) -> bool:
        """Solve a grid, or prove that none of its schedules is better; tell whether that was done."""
        self.lower = max(self.lower, relaxation.lower)
        if self.is_doubtful():
            self.follow_beams(relaxation)
        whole, room, width = self.watch.limits.memory // BYTES_PER_START, ROOM, BEAM
        delta = FIRST * (self.best.cost - self.lower) + self.left_over
        while not self.is_over():
            threshold = min(self.best.cost, self.lower + delta)
            program, found = self._run(relaxation, threshold, room)
            if self.is_closed():
                return True
            if found.exact and self.best.cost <= threshold:
                relaxation.keep([program.used(lane, arcs) for lane, arcs in enumerate(relaxation.arcs)])
                return True
            if found.exact:
                delta = np.inf if found.starts is not None else FARTHER * delta
            elif room < whole:
                room, width = MORE * room, WIDER * width
                self._run(relaxation, self.best.cost, whole, width)
            else:
                delta = (threshold - self.lower) / 2
                if delta <= LEAST * (self.best.cost - self.lower):
                    return False
        return not self.watch.is_over()

    def follow_beams(self, relaxation: Relaxation) -> None:
        """Search in ever broader beams, as long as the best schedule is in doubt."""
        width, known = BEAM, self.best.cost
        for _ in range(BEAMS):
            room = self.watch.limits.memory // BYTES_PER_START
            _, found = self._run(relaxation, self.best.cost, room, width)
            if found.exact or not self.is_doubtful() or self.watch.is_over():
                break
            width *= WIDER
        if self.best.cost < known:
            relaxation.fix(self.best.cost)

    def _run(
        self, relaxation: Relaxation, threshold: float, room: int, width: int | None = None
    ) -> tuple[Waiting, Found]:
        """Run the program below a threshold, and learn from what it finds."""
        grid, prices = relaxation.grid, relaxation.prices.copy()
        for arcs in relaxation.instants:
            np.maximum.at(prices, arcs.job, -arcs.gain)
        program = Waiting(grid, relaxation.everything_below(threshold), relaxation.agents, prices)
        found = program.run(threshold, self.watch, room, width)
        if found.starts is not None and found.lanes is not None:
            agents = manned(self.problem, found.lanes, found.starts, found.starts + grid.durations)
            hints = np.where(found.starts >= 0, grid.times(found.starts), np.nan)
            self.take(settled(self.problem, hints, agents, 2 * grid.step))
        if found.exact:
            self.lower = max(self.lower, min(found.cost, threshold))
        return program, found


class _Brief(_Search):
    """Beams on one grid."""

    def close(self, relaxation: Relaxation) -> bool:
        """Search in beams."""
        self.follow_beams(relaxation)
        return False


def _near(problem: Problem) -> Problem:
    """Give the problem with each job near where it would be if agents had time for all at once."""
    starts = [min(max(job.function.best.low, job.earliest), job.latest) for job in problem.jobs]
    for _ in problem.jobs:
        for lag in problem.lags:
            starts[lag.second] = max(starts[lag.second], starts[lag.first] + lag.low)
            starts[lag.first] = max(starts[lag.first], starts[lag.second] - lag.high)
    work = math.fsum(job.duration for job in problem.jobs)
    jobs = []
    for job, start in zip(problem.jobs, starts, strict=True):
        near = [Interval(start - work, start + work)]
        jobs.append(replace(job, windows=tuple(in_common(lane, near) for lane in job.windows)))
    return replace(problem, jobs=tuple(jobs))
