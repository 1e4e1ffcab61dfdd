"""The best slots for jobs in a fixed order, and the best place for one more.

For the jobs of one agent in their order, F_k(t) is the least cost of the first k by slot t and G_k(t) that of
the others from slot t on, where each may be left out:

    F_k+1(t) = min(F_k(t), F_k+1(t − 1), F_k(t − d) + c(t − d)).

Job i put in at place k then makes the whole cost min over t of F_k(t) + c_i(t) + G_k(t + d_i): one matrix
holds all places.
"""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.problem.grid import Curve


class Removed(NamedTuple):
    """A job that was taken out, its place, and the rows of the tables that changed with that."""

    job: int
    place: int
    forward: Floats
    backward: Floats


class Tables(NamedTuple):
    """A sequence of jobs, and its tables."""

    sequence: tuple[int, ...]
    forward: Floats
    backward: Floats


class Order:
    """A sequence of jobs on one agent between two slots, its tables kept up to date as jobs come and go.

    Parameters
    ----------
    curves
        For each job its gains on this agent's lane, which may change while a job is out of the sequence.
    durations
        Slots for each job.
    begin, end
        The slots between which the agent is free.
    sequence
        The jobs to begin with.
    """

    def __init__(
        self,
        curves: Mapping[int, Curve],
        durations: Mapping[int, int],
        begin: int,
        end: int,
        sequence: Sequence[int] = (),
    ) -> None:
        self.curves = dict(curves)
        self.durations = durations
        self.sequence = list(sequence)
        self._forward = np.zeros((len(curves) + 1, end + 1))
        self._forward[0, :begin] = np.inf
        self._backward = np.zeros((len(curves) + 1, end + 1))
        self._fill(0, len(self.sequence))

    @property
    def gain(self) -> float:
        """What the sequence costs less the rejection of all: at most 0."""
        return float(self._forward[len(self.sequence), -1])

    def _fill(self, first: int, last: int) -> None:
        """Work out the rows forward from place ``first`` and backward from place ``last``."""
        for place in range(first, len(self.sequence)):
            job = self.sequence[place]
            curve, duration = self.curves[job], self.durations[job]
            row, before = self._forward[place + 1], self._forward[place]
            row[:] = before
            if not curve.gains.size:
                continue
            ends = row[curve.first + duration : curve.stop + duration]
            np.minimum(ends, before[curve.first : curve.stop] + curve.gains, out=ends)
            np.minimum.accumulate(ends, out=ends)
            # F does not rise, so that one number is all that the rest has to learn.
            late = row[curve.stop + duration :]
            np.minimum(late, ends[-1], out=late)
        for place in range(last - 1, -1, -1):
            job = self.sequence[place]
            curve, duration = self.curves[job], self.durations[job]
            row, after = self._backward[place], self._backward[place + 1]
            row[:] = after
            if not curve.gains.size:
                continue
            starts = row[curve.first : curve.stop]
            np.minimum(
                starts, after[curve.first + duration : curve.stop + duration] + curve.gains, out=starts
            )
            np.minimum.accumulate(starts[::-1], out=starts[::-1])
            early = row[: curve.first]
            np.minimum(early, starts[0], out=early)

    def remove(self, job: int) -> "Removed":
        """Take a job out, and give what it takes to put it back."""
        place, count = self.sequence.index(job), len(self.sequence)
        forward, backward = self._forward[place + 1 : count + 1], self._backward[: place + 1]
        removed = Removed(job, place, forward.copy(), backward.copy())
        self.remove_all([job])
        return removed

    def remove_all(self, jobs: Sequence[int]) -> None:
        """Take several jobs out at once."""
        out, count = set(jobs), len(self.sequence)
        places = [place for place, job in enumerate(self.sequence) if job in out]
        if not places:
            return
        last = places[-1] + 1
        behind = last - len(places)
        self._backward[behind : count + 1 - len(places)] = self._backward[last : count + 1]
        self.sequence = [job for job in self.sequence if job not in out]
        self._fill(places[0], behind)

    def state(self) -> Tables:
        """Give what moves, to go back to."""
        rows = len(self.sequence) + 1
        return Tables(tuple(self.sequence), self._forward[:rows].copy(), self._backward[:rows].copy())

    def restore(self, state: Tables) -> None:
        """Go back to an earlier state."""
        rows = len(state.sequence) + 1
        self.sequence = list(state.sequence)
        self._forward[:rows], self._backward[:rows] = state.forward, state.backward

    def put_back(self, removed: "Removed") -> None:
        """Put the job back that was taken out last, where it was."""
        place, count = removed.place, len(self.sequence)
        self._backward[place + 1 : count + 2] = self._backward[place : count + 1]
        self.sequence.insert(place, removed.job)
        self._forward[place + 1 : count + 2] = removed.forward
        self._backward[: place + 1] = removed.backward

    def insert(self, place: int, job: int) -> None:
        """Put a job in at a place."""
        count = len(self.sequence)
        self._backward[place + 1 : count + 2] = self._backward[place : count + 1]
        self.sequence.insert(place, job)
        self._fill(place, place + 1)

    def best_insertion(self, job: int) -> tuple[float, int]:
        """Give the cost of the sequence with one more job at its best place, and that place."""
        curve, duration, places = self.curves[job], self.durations[job], len(self.sequence) + 1
        if not curve.gains.size:
            return self.gain, len(self.sequence)
        total = self._forward[:places, curve.first : curve.stop] + curve.gains
        total += self._backward[:places, curve.first + duration : curve.stop + duration]
        cost = total.min(axis=1)
        place = int(cost.argmin())
        return min(float(cost[place]), self.gain), place

    def prices(self) -> dict[int, float]:
        """Give for each job what it brings: the cost of the others without it, less that of all."""
        return {
            job: float((self._forward[place] + self._backward[place + 1]).min()) - self.gain
            for place, job in enumerate(self.sequence)
        }

    def starts(self) -> dict[int, int]:
        """Give start slots of the jobs that are not left out, the last ones as early as they can be."""
        found: dict[int, int] = {}
        slot = self._forward.shape[1] - 1
        for place in range(len(self.sequence), 0, -1):
            job = self.sequence[place - 1]
            row, before = self._forward[place], self._forward[place - 1]
            slot = int(np.argmax(row == row[slot]))
            if before[slot] > row[slot]:
                slot -= self.durations[job]
                found[job] = slot
        return found
