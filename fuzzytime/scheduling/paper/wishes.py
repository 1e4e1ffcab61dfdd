"""What hill climbing, annealing and genetic search move in: a wished slot and an agent for each job.

Wishes become a schedule in one pass: by ascending wish each job starts at the first slot from its wish on at
which its agent is free and it may start; one that then comes too late is left out. Every wish so gives a
schedule without overlap, and the best schedule is what its own start times give. Many rows of wishes, the
members of a population or the neighbours of one, are turned into schedules at once.
"""

from dataclasses import dataclass

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.problem.grid import Grid, Ints, grid_of, step_for
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.solver import Draft
from fuzzytime.scheduling.timing.settle import lanes_of_agents, settled

LATE = 1 << 40
"""A slot that never comes."""


@dataclass(frozen=True, slots=True, eq=False)
class Wishes:
    """Rows of wishes.

    Parameters
    ----------
    slots : array of shape (rows, jobs)
        Where each job would like to start.
    agents : array of shape (rows, jobs)
        Who does it, by place in the landscape's agents.
    """

    slots: Ints
    agents: Ints

    def __len__(self) -> int:
        return len(self.slots)

    def rows(self, which: Ints) -> "Wishes":
        """Give some rows, any of them several times."""
        return Wishes(self.slots[which].copy(), self.agents[which].copy())

    def replaced(self, where: Ints, by: "Wishes", which: Ints) -> "Wishes":
        """Give these rows with some of them replaced by rows of others."""
        slots, agents = self.slots.copy(), self.agents.copy()
        slots[where], agents[where] = by.slots[which], by.agents[which]
        return Wishes(slots, agents)


class Landscape:
    """A problem on a grid, for wishes: what they cost, and what lies next to them.

    Parameters
    ----------
    problem
        What is solved.
    slots
        Slots of the grid, at least.
    """

    def __init__(self, problem: Problem, slots: int) -> None:
        self.problem = problem
        self.grid: Grid = grid_of(problem, step_for(problem, slots))
        lanes = lanes_of_agents(problem)
        self.agents = np.array(sorted(lanes), np.int64)
        count, length = len(problem.jobs), self.grid.slots + 2
        self._gains = np.full((len(self.agents), count, length), np.inf)
        for place, agent in enumerate(self.agents.tolist()):
            for job, curves in enumerate(self.grid.curves):
                curve = curves[lanes[agent]]
                self._gains[place, job, curve.first : curve.stop] = curve.gains
        slot = np.where(np.isfinite(self._gains), np.arange(length), LATE)
        self._next = np.minimum.accumulate(slot[:, :, ::-1], axis=2)[:, :, ::-1]
        self._able = np.isfinite(self._gains).any(axis=2)
        spans = [np.flatnonzero(np.isfinite(self._gains[:, job]).any(axis=0)) for job in range(count)]
        self._first = np.array([span[0] if span.size else 0 for span in spans])
        self._last = np.array([span[-1] if span.size else 0 for span in spans])
        self._lags: dict[int, list[tuple[int, float, float]]] = {}
        for lag in problem.lags:
            low, high = lag.low / self.grid.step, lag.high / self.grid.step
            self._lags.setdefault(lag.second, []).append((lag.first, low, high))

    def scheduled(self, wishes: Wishes) -> tuple[Floats, Ints]:
        """Give the cost of each row, and the slots at which its jobs start, −1 for those left out."""
        rows, count = wishes.slots.shape
        row = np.arange(rows)
        free = np.zeros((rows, len(self.agents)), np.int64)
        starts = np.full((rows, count), -1, np.int64)
        cost = np.full(rows, float(self.grid.rejections.sum()))
        # Of jobs with the same wish the shorter one goes first.
        ranking = np.lexsort((np.broadcast_to(self.grid.durations, wishes.slots.shape), wishes.slots))
        for job in ranking.T:
            agent = wishes.agents[row, job]
            earliest, latest = self._released(starts, job)
            slot = np.maximum(np.maximum(wishes.slots[row, job], free[row, agent]), earliest)
            slot = self._next[agent, job, np.minimum(slot, self.grid.slots + 1)]
            placed = slot <= np.minimum(latest, self.grid.slots + 1)
            where = np.flatnonzero(placed)
            chosen, who, when = job[where], agent[where], slot[where]
            cost[where] += self._gains[who, chosen, when]
            starts[where, chosen] = when
            free[where, who] = when + self.grid.durations[chosen]
        return cost, starts

    def _released(self, starts: Ints, jobs: Ints) -> tuple[Ints, Ints]:
        """Give the slots between which lags let a job of each row start."""
        earliest, latest = np.zeros(len(jobs), np.int64), np.full(len(jobs), LATE - 1)
        for second, lags in self._lags.items():
            where = np.flatnonzero(jobs == second)
            for first, low, high in lags:
                begun = starts[where, first]
                release = np.where(begun >= 0, np.ceil(begun + low - 1e-9), LATE).astype(np.int64)
                earliest[where] = np.maximum(earliest[where], release)
                if np.isfinite(high):
                    latest[where] = np.minimum(latest[where], np.floor(begun + high + 1e-9).astype(np.int64))
        return earliest, latest

    def drawn(self, generator: np.random.Generator, rows: int) -> Wishes:
        """Draw rows anywhere, each job in its windows and by an agent that may do it."""
        jobs = np.tile(np.arange(len(self._first)), (rows, 1))
        return Wishes(
            generator.integers(self._first[jobs], self._last[jobs] + 1), self._drawn_agents(generator, jobs)
        )

    def begun(self, generator: np.random.Generator, rows: int, warm: Draft | None) -> Wishes:
        """Draw rows to search from, the first of them a known draft where there is one."""
        drawn = self.drawn(generator, rows)
        return drawn if warm is None else drawn.replaced(np.array([0]), self.of_draft(warm), np.array([0]))

    def _drawn_agents(self, generator: np.random.Generator, jobs: Ints) -> Ints:
        scores = generator.random((*jobs.shape, len(self.agents))) + self._able.T[jobs]
        return np.asarray(scores.argmax(axis=-1))

    def neighbours(self, generator: np.random.Generator, wishes: Wishes) -> Wishes:
        """Give for each row one next to it.

        One job moves a little or far, or anywhere, or to another agent, or two jobs change places.
        """
        rows, count = wishes.slots.shape
        row = np.arange(rows)
        job, other = generator.integers(0, count, (2, rows))
        kind = generator.integers(0, 4, (rows,))
        slots, agents = wishes.slots.copy(), wishes.agents.copy()
        here, there = slots[row, job], slots[row, other]
        reach = np.exp(generator.uniform(0, np.log(2.0 + self._last[job] - self._first[job])))
        shifted = here + np.rint(generator.normal(0, reach)).astype(np.int64)
        anywhere = generator.integers(self._first[job], self._last[job] + 1)
        slots[row, job] = np.choose(np.minimum(kind, 2), [shifted, anywhere, there])
        swapped = row[kind == 2]
        slots[swapped, other[swapped]] = here[swapped]
        moved = row[kind == 3]
        slots[moved, job[moved]] = here[moved]
        agents[moved, job[moved]] = self._drawn_agents(generator, job[moved])
        return Wishes(np.clip(slots, 0, self.grid.slots), agents)

    def of_draft(self, draft: Draft) -> Wishes:
        """Give a draft as a row; jobs that it rejects wish for the end."""
        times = np.where(np.isnan(draft.starts), np.inf, draft.starts / self.grid.step - self.grid.origin)
        slots = np.clip(np.rint(np.minimum(times, self.grid.slots)), 0, self.grid.slots).astype(np.int64)
        agents = np.searchsorted(self.agents, draft.agents)
        return Wishes(slots[None], agents[None])

    def ended(self, wishes: Wishes, row: int, warm: Draft | None) -> Draft:
        """Give a row as a draft, timed in continuous time; the known draft where that is as good."""
        _, starts = self.scheduled(wishes.rows(np.array([row])))
        hints = np.where(starts[0] >= 0, self.grid.times(starts[0]), np.nan)
        found = settled(self.problem, hints, self.agents[wishes.agents[row]], 4 * self.grid.step)
        return found if warm is None or found.cost < warm.cost else warm
