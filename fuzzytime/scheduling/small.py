"""Held–Karp for few jobs: over sets of jobs, with whole vectors of time.

F[S, t] is the least cost of doing exactly the jobs S by slot t on one lane:

    F[S, t] = min(F[S, t − 1],  min over i in S of F[S − i, t − d_i] + c_i(t − d_i)).

A set is one row of a table, so that each of the n·2ⁿ⁻¹ transitions is one operation on a vector. Held and
Karp, A dynamic programming approach to sequencing problems, J. SIAM 10 (1962) 196-210.
"""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from fuzzytime.errors import RefusedError
from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.grid import Grid, Ints, grid_of, step_for
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem import Problem
from fuzzytime.scheduling.schedule import OPTIMAL_GAP
from fuzzytime.scheduling.settle import settled
from fuzzytime.scheduling.solver import Draft, nothing

MOST_JOBS = 16

FIRST_SLOTS = 3000
"""Slots of the first grid, at least."""

REFINEMENT = 4
"""How much finer the next grid is, where the gap is too large."""


@dataclass(frozen=True, slots=True)
class HeldKarp:
    """Exact for one agent and few skills; the grid becomes finer until the gap closes or a limit is met."""

    name: ClassVar[str] = "held-karp"

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Solve grid after grid, each a bound in continuous time; time the order each finds.

        Raises
        ------
        RefusedError
            If there are several agents, too many skills for the memory, or lags that an order does not keep.
        """
        fault = why_not(problem, watch.limits.memory)
        if fault:
            raise RefusedError(f"Held-Karp {fault}")
        before: list[list[int]] = [[] for _ in problem.jobs]
        for lag in problem.lags:
            before[lag.second].append(lag.first)
        best, lower = warm or nothing(problem), -math.inf
        step = step_for(problem, FIRST_SLOTS)
        agents = np.full(len(problem.jobs), problem.lanes[0].agents[0], np.int64)
        while True:
            grid = grid_of(problem, step)
            if table_bytes(grid) > watch.limits.memory:
                break
            cost, slots = held_karp(grid, before)
            lower = max(lower, cost)
            hints = np.where(slots >= 0, grid.times(slots), np.nan)
            draft = settled(problem, hints, agents, 2 * step)
            best = draft if draft.cost <= best.cost + 1e-9 else best
            if best.cost - lower <= OPTIMAL_GAP * problem.weight or watch.is_over():
                break
            step /= REFINEMENT
        return Draft(best.starts, best.agents, best.cost, min(lower, best.cost))


def why_not(problem: Problem, memory: int) -> str:
    """Say why Held–Karp cannot solve a problem; nothing where it can."""
    count = len(problem.jobs)
    if len(problem.lanes) > 1 or len(problem.lanes[0].agents) > 1:
        return f"schedules one agent, got {sum(len(lane.agents) for lane in problem.lanes)}"
    if count > MOST_JOBS or 8 * FIRST_SLOTS << count > memory:
        return f"needs a table of 2^skills rows, got {count} skills"
    return "" if all(problem.kept_by_order(lag) for lag in problem.lags) else "knows no lags"


def table_bytes(grid: Grid) -> int:
    """Give the memory that the table takes."""
    return 8 * (grid.slots + 1) << len(grid.durations)


def held_karp(grid: Grid, before: list[list[int]]) -> tuple[float, Ints]:
    """Give the least cost of a grid with one lane, and start slots that have it, −1 where rejected.

    Parameters
    ----------
    grid
        Its jobs may be done by one agent, or rejected.
    before
        For each job those that must have been done before it.
    """
    count = len(grid.durations)
    needed = [sum(1 << first for first in firsts) for firsts in before]
    moves = [
        (curve.first, curve.stop, curve.gains, duration)
        for (curve,), duration in zip(grid.curves, grid.durations.tolist(), strict=True)
    ]
    table = np.full((1 << count, grid.slots + 1), np.inf)
    table[0] = 0.0
    for members in range(1, 1 << count):
        row = table[members]
        for job, (first, stop, gains, duration) in enumerate(moves):
            rest = members ^ (1 << job)
            if rest < members and needed[job] & rest == needed[job]:
                ends = row[first + duration : stop + duration]
                np.minimum(ends, table[rest, first:stop] + gains, out=ends)
        np.minimum.accumulate(row, out=row)
    best = int(table[:, -1].argmin())
    return float(table[best, -1] + grid.rejections.sum()), _trace(grid, table, best)


def _trace(grid: Grid, table: Floats, members: int) -> Ints:
    """Walk back along equal costs from the last slot of a set."""
    starts = np.full(len(grid.durations), -1, np.int64)
    slot = grid.slots
    while members:
        slot = int(np.argmax(table[members] == table[members, slot]))
        # Among equals the last in the task comes last.
        for job in range(len(starts) - 1, -1, -1):
            curve, rest, start = grid.curves[job][0], members ^ (1 << job), slot - int(grid.durations[job])
            if rest > members or not curve.first <= start < curve.stop:
                continue
            if table[rest, start] + curve.gains[start - curve.first] == table[members, slot]:
                starts[job], members, slot = start, rest, start
                break
    return starts
