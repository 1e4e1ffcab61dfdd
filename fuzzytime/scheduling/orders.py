"""The best slots for jobs in a fixed order, and the best place for one more.

For the jobs of one agent in their order, F_k(t) is the least cost of the first k by slot t and G_k(t) that of
the others from slot t on, where each may be left out:

    F_k+1(t) = min(F_k(t), F_k+1(t − 1), F_k(t − d) + c(t − d)).

Job i put in at place k then makes the whole cost min over t of F_k(t) + c_i(t) + G_k(t + d_i): one matrix
holds all places.
"""

from collections.abc import Mapping

import numpy as np

from fuzzytime.scheduling.grid import Curve


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
    """

    def __init__(
        self, curves: Mapping[int, Curve], durations: Mapping[int, int], begin: int, end: int
    ) -> None:
        self.curves = dict(curves)
        self.durations = durations
        self.sequence: list[int] = []
        self._forward = np.zeros((len(curves) + 1, end + 1))
        self._forward[0, :begin] = np.inf
        self._backward = np.zeros((len(curves) + 1, end + 1))

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
            ends = row[curve.first + duration : curve.stop + duration]
            np.minimum(ends, before[curve.first : curve.stop] + curve.gains, out=ends)
            late = row[curve.first + duration :]
            np.minimum.accumulate(late, out=late)
        for place in range(last - 1, -1, -1):
            job = self.sequence[place]
            curve, duration = self.curves[job], self.durations[job]
            row, after = self._backward[place], self._backward[place + 1]
            row[:] = after
            starts = row[curve.first : curve.stop]
            np.minimum(
                starts, after[curve.first + duration : curve.stop + duration] + curve.gains, out=starts
            )
            early = row[: curve.stop][::-1]
            np.minimum.accumulate(early, out=early)

    def remove(self, job: int) -> int:
        """Take a job out, and give its place."""
        place = self.sequence.index(job)
        del self.sequence[place]
        count = len(self.sequence)
        self._backward[place : count + 1] = self._backward[place + 1 : count + 2]
        self._fill(place, place)
        return place

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
