"""A grid as a mixed-integer program: agents flow through time, starts are arcs, idling is an arc too.

At every slot where something starts or ends, as many agents leave as arrive; a lane of m agents sends m units
through. Each job has at most one start. This is the time-indexed program in network form, whose rows are
short and whose linear relaxation is the bound of `fuzzytime.scheduling.bound.relaxation`; what it adds are
whole numbers, and lags: the second job has started by slot s only if the first has by s − low, so with Z(s)
the number of starts by s

    Z_second(s) ≤ Z_first(s − low),
    Z_second(end) − Z_second(s − 1) ≤ Z_first(end) − Z_first(s − high − 1).

Sousa and Wolsey, A time indexed formulation of non-preemptive single machine scheduling problems, Math.
Programming 54 (1992) 353-367.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.bound.paths import Arcs
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import Grid, Ints

TOLERANCE = 1e-6
"""What the solver may take for whole, and for equal, relative to the values."""


@dataclass(frozen=True, slots=True, eq=False)
class Solved:
    """What a program gave: a bound on the gain of all starts, and the arcs it chose, None if it found none.

    ``best`` says that the chosen arcs are proved the best.
    """

    bound: float
    chosen: Ints | None
    best: bool


class Flow:
    """The program for the arcs of all lanes.

    Parameters
    ----------
    grid
        Durations, lags and horizon.
    lanes
        For each lane its arcs, those of jobs shorter than a slot included.
    agents
        How many each lane has.
    """

    def __init__(self, grid: Grid, lanes: Sequence[Arcs], agents: Sequence[int]) -> None:
        self.arcs = Arcs(*(np.concatenate(columns) for columns in zip(*lanes, strict=True)))
        self.lane = np.repeat(np.arange(len(lanes)), [arcs.job.size for arcs in lanes])
        self._entries: list[tuple[Ints, Ints, Floats]] = []
        self._bounds: list[tuple[Floats, Floats]] = []
        self._count = 0
        self._size = self.arcs.job.size
        self._highs: list[Floats] = [np.ones(self._size)]
        for lane, many in enumerate(agents):
            self._conserve(np.flatnonzero((self.lane == lane) & (self.arcs.end > self.arcs.start)), many)
        jobs, row = np.unique(self.arcs.job, return_inverse=True)
        self._add(row, np.arange(self.arcs.job.size), np.ones(row.size), -np.inf, np.ones(jobs.size))
        steps: dict[int, tuple[Ints, int]] = {}
        for lag in grid.lags:
            for job in (lag.first, lag.second):
                if job not in steps:
                    steps[job] = self._staircase(job)
            self._bind(steps[lag.first], steps[lag.second], lag.low, lag.high)

    def _add(self, row: Ints, column: Ints, value: Floats, low: Floats | float, high: Floats) -> None:
        """Add rows, numbered from 0 here, with their bounds."""
        self._entries.append((row + self._count, column, value))
        self._bounds.append((np.broadcast_to(low, high.shape), high))
        self._count += high.size

    def _variables(self, count: int, high: float) -> Ints:
        """Add continuous variables from 0 on."""
        self._highs.append(np.full(count, high))
        self._size += count
        return np.arange(self._size - count, self._size)

    def _conserve(self, arcs: Ints, agents: int) -> None:
        """As many agents leave a slot as arrive; idling leads from each event to the next."""
        if not arcs.size:
            return
        start, end = self.arcs.start[arcs], self.arcs.end[arcs]
        events = np.unique(np.concatenate([start, end]))
        idle = self._variables(events.size - 1, float(agents))
        place = np.arange(events.size)
        row = [np.searchsorted(events, start), np.searchsorted(events, end), place[:-1], place[1:]]
        one = np.ones(arcs.size), np.ones(idle.size)
        supply = np.zeros(events.size)
        supply[0], supply[-1] = agents, -agents
        self._add(
            np.concatenate(row),
            np.concatenate([arcs, arcs, idle, idle]),
            np.concatenate([one[0], -one[0], one[1], -one[1]]),
            supply,
            supply,
        )

    def _staircase(self, job: int) -> tuple[Ints, int]:
        """Add Z of a job: give the slots where it may rise, and the variable of its value before them."""
        mine = np.flatnonzero(self.arcs.job == job)
        slots, step = np.unique(self.arcs.start[mine], return_inverse=True)
        variables = self._variables(slots.size + 1, 1.0)
        rows = np.arange(slots.size)
        # Z_0 = 0, and Z_k − Z_k−1 is the sum of the starts in slot k.
        self._add(np.zeros(1, np.int64), variables[:1], np.ones(1), 0.0, np.zeros(1))
        self._add(
            np.concatenate([rows, rows, step]),
            np.concatenate([variables[1:], variables[:-1], mine]),
            np.concatenate([np.ones(slots.size), -np.ones(slots.size), -np.ones(mine.size)]),
            0.0,
            np.zeros(slots.size),
        )
        return slots, int(variables[0])

    def _bind(self, first: tuple[Ints, int], second: tuple[Ints, int], low: float, high: float) -> None:
        """Let the second start only when and if the first has."""
        slots, zero = second
        before, origin = first
        rows = np.arange(slots.size)
        mine = zero + 1 + rows
        earlier = origin + np.searchsorted(before, slots - low, "right")
        ones = np.ones(slots.size)
        self._add(
            np.tile(rows, 2), np.append(mine, earlier), np.append(ones, -ones), -np.inf, np.zeros(slots.size)
        )
        # Even where no slot asks for it, there is no second without a first.
        last, end = np.array([zero + slots.size]), np.array([origin + before.size])
        self._add(np.zeros(2, np.int64), np.append(last, end), np.array([1.0, -1.0]), -np.inf, np.zeros(1))
        if high < math.inf:
            sooner = origin + np.searchsorted(before, slots - high, "left")
            self._add(
                np.tile(rows, 4),
                np.concatenate([np.repeat(last, rows.size), mine - 1, np.repeat(end, rows.size), sooner]),
                np.concatenate([ones, -ones, -ones, ones]),
                -np.inf,
                np.zeros(slots.size),
            )

    def solve(self, watch: Stopwatch) -> Solved:
        """Minimise the gains of the starts in the time that is left."""
        from scipy.optimize import Bounds, LinearConstraint, milp
        from scipy.sparse import csr_array

        row, column, value = (np.concatenate(part) for part in zip(*self._entries, strict=True))
        matrix = csr_array((value, (row, column)), shape=(self._count, self._size))
        low, high = (np.concatenate(part) for part in zip(*self._bounds, strict=True))
        whole = np.zeros(self._size, np.int64)
        whole[: self.arcs.job.size] = 1
        answer = milp(
            np.append(self.arcs.gain, np.zeros(self._size - self.arcs.job.size)),
            integrality=whole,
            constraints=LinearConstraint(matrix, low, high),
            bounds=Bounds(0.0, np.concatenate(self._highs)),
            options={"time_limit": max(watch.remaining, 0.1), "mip_rel_gap": TOLERANCE},
        )
        bound = -math.inf
        if answer.mip_dual_bound is not None and math.isfinite(answer.mip_dual_bound):
            bound = float(answer.mip_dual_bound) - TOLERANCE * (1 + abs(answer.mip_dual_bound))
        if answer.x is None:
            return Solved(bound, None, best=False)
        chosen = np.flatnonzero(answer.x[: self.arcs.job.size] > 0.5)
        return Solved(bound, chosen, best=answer.status == 0)
