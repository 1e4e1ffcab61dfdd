"""Held–Karp for few jobs: over sets of jobs, with whole vectors of time.

F[S, t] is the least cost of doing exactly the jobs S by slot t on one agent:

    F[S, t] = min(F[S, t − 1],  min over i in S of F[S − i, t − d_i] + c_i(t − d_i)).

A set is one row of a table, so that each of the n·2ⁿ⁻¹ transitions is one operation on a vector. Held and
Karp, A dynamic programming approach to sequencing problems, J. SIAM 10 (1962) 196-210.

Several agents share the jobs out: the least cost of doing exactly S by agents 1 to k is the least, over the
subsets A of S that agent k does, of that of S − A by the others and of A by agent k. All subsets of all sets
are 3ⁿ pairs.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from fuzzytime.errors import RefusedError
from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.bound.refinement import bytes_for
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import Grid, Ints, grid_of, step_for
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.schedule import OPTIMAL_GAP
from fuzzytime.scheduling.solver import Draft, nothing
from fuzzytime.scheduling.timing.settle import settled

MOST_JOBS = 16

FIRST_SLOTS = 3000
"""Slots of the first grid, at least."""

FINER = 5
"""How much finer than that it may be: a row for every set of skills is soon too long."""

REFINEMENT = 4
"""How much finer the next grid is, where the gap is too large."""

NARROWED = 0.5
"""The share of the gap that a finer grid leaves, or it is not narrowed."""

PATIENCE = 3
"""So many grids may fail to narrow it, where nothing is relaxed."""


@dataclass(frozen=True, slots=True)
class HeldKarp:
    """Exact for few skills; the grid becomes finer until the gap closes or a limit is met.

    Of lags it knows only the order of two skills on one agent: others are relaxed for the bound.
    """

    name: ClassVar[str] = "held-karp"

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Solve grid after grid, each a bound in continuous time; time the order each finds.

        Raises
        ------
        RefusedError
            If there are too many skills for the memory.
        """
        fault = why_not(problem, watch.limits.memory)
        if fault:
            raise RefusedError(f"Held-Karp {fault}")
        best, lower, open_before = warm or nothing(problem), 0.0, np.inf
        # A gap that finer grids do not narrow comes of lags that are relaxed.
        patience = PATIENCE if problem.kept_by_order else 1
        step = step_for(problem, FIRST_SLOTS, FINER)
        while bytes_for(problem, step) <= watch.limits.memory:
            grid = grid_of(problem, step)
            if table_bytes(problem, grid) > watch.limits.memory:
                break
            try:
                cost, slots, agents = held_karp(problem, grid)
            except KeyboardInterrupt:
                watch.stop()
                break
            lower = max(lower, cost)
            hints = np.where(slots >= 0, grid.times(slots), np.nan)
            draft = settled(problem, hints, agents, 2 * step)
            best = draft if draft.cost <= best.cost + 1e-9 else best
            still_open = best.cost - lower
            patience -= still_open > NARROWED * open_before
            if still_open <= OPTIMAL_GAP * problem.weight or not patience or watch.is_over():
                break
            open_before = still_open
            step /= REFINEMENT
        return Draft(best.starts, best.agents, best.cost, min(lower, best.cost))


def why_not(problem: Problem, memory: int) -> str:
    """Say why Held–Karp cannot solve a problem; nothing where it can."""
    count = len(problem.jobs)
    if count > MOST_JOBS or 8 * FIRST_SLOTS * len(problem.lanes) << count > memory:
        return f"needs a table of 2^skills rows, got {count} skills"
    return ""


def table_bytes(problem: Problem, grid: Grid) -> int:
    """Give the memory that the tables take."""
    return 8 * (grid.slots + 1) * len(problem.lanes) << len(grid.durations)


def held_karp(problem: Problem, grid: Grid) -> tuple[float, Ints, Ints]:
    """Give the least cost of a grid, start slots that have it, −1 where rejected, and who does what."""
    count, before = len(problem.jobs), problem.before()
    tables = [_table(grid, lane, before) for lane in range(len(problem.lanes))]
    turns = [(lane, agent) for lane, team in enumerate(problem.lanes) for agent in team.agents]
    # Of each set the least cost to do exactly that; the first agent's, then the first two agents', and so on.
    shared = [tables[turns[0][0]][:, -1]]
    # The first agent does whatever the others leave.
    shares: list[Ints] = [np.arange(1 << count)]
    for lane, _ in turns[1:]:
        cost, share = _shared(shared[-1], tables[lane][:, -1])
        shared.append(cost)
        shares.append(share)
    members = int(shared[-1].argmin())
    total = float(shared[-1][members] + grid.rejections.sum())
    slots, agents = np.full(count, -1, np.int64), np.ones(count, np.int64)
    for (lane, agent), share in zip(reversed(turns), reversed(shares), strict=True):
        mine = int(share[members])
        for job, slot in _trace(grid, lane, tables[lane], mine).items():
            slots[job], agents[job] = slot, agent
        members ^= mine
    return total, slots, agents


def _table(grid: Grid, lane: int, before: Sequence[Sequence[int]]) -> Floats:
    """Give F for one agent of a lane."""
    count = len(grid.durations)
    needed = [sum(1 << first for first in firsts) for firsts in before]
    curves = [curves[lane] for curves in grid.curves]
    moves = [
        (curve.first, curve.stop, curve.gains, duration)
        for curve, duration in zip(curves, grid.durations.tolist(), strict=True)
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
    return table


def _shared(others: Floats, mine: Floats) -> tuple[Floats, Ints]:
    """Share every set out between some agents and one more: the least costs, and what the one more does."""
    cost, share = others.copy(), np.zeros(others.size, np.int64)
    subsets = [np.zeros(1, np.int64)]
    for members in range(1, others.size):
        # The subsets of a set are those without its highest job, and the same with it.
        highest = 1 << (members.bit_length() - 1)
        below = subsets[members ^ highest]
        subsets.append(np.concatenate([below, below | highest]))
        total = others[members ^ subsets[members]] + mine[subsets[members]]
        least = int(total.argmin())
        cost[members], share[members] = total[least], subsets[members][least]
    return cost, share


def _trace(grid: Grid, lane: int, table: Floats, members: int) -> dict[int, int]:
    """Walk back along equal costs from the last slot of a set, and give the start slots."""
    starts: dict[int, int] = {}
    slot = grid.slots
    while members:
        slot = int(np.argmax(table[members] == table[members, slot]))
        # Among equals the last in the task comes last.
        for job in range(len(grid.durations) - 1, -1, -1):
            curve, rest, start = grid.curves[job][lane], members ^ (1 << job), slot - int(grid.durations[job])
            if rest > members or not curve.first <= start < curve.stop:
                continue
            if table[rest, start] + curve.gains[start - curve.first] == table[members, slot]:
                starts[job], members, slot = start, rest, start
                break
    return starts
