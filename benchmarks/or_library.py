"""Weighted tardiness of the OR-Library as a fuzzy task, beside the published optima.

    PYTHONPATH=. python benchmarks/or_library.py --dir DIR --jobs 40

``DIR`` holds ``wt40.txt`` and ``wtopt40.txt`` (also 50; for 100 ``wtbest100b.txt``), see
people.brunel.ac.uk/~mastjjb/jeb/orlib/wtinfo.html. A job with processing time p, weight w and due date d
costs w·max(0, t + p − d) where it starts at t. With ψ(t) = exp(−that / S) the cost of a schedule is the
weighted tardiness over S, whatever the scale S; nothing may be rejected, so that the threshold is 0. As
tardiness is a whole number, a bound above the optimum less one proves it.
"""

import argparse
import math
import statistics
import time
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.satisfaction import Floats, Interval
from fuzzytime.scheduling import Limits, solve
from fuzzytime.skills import FuzzySkill, FuzzyTask

LARGEST = 600.0
"""The largest cost of a job, below −log of the smallest number that stands for satisfaction."""


@dataclass(frozen=True)
class Tardiness:
    """ψ(t) = exp(−slope·max(0, t − due)): satisfaction with a start that may be late."""

    model: ClassVar[str] = "tardiness"

    due: float
    slope: float

    def __call__(self, times: ArrayLike) -> Floats:
        """Give ψ."""
        return np.exp(self.log(times))

    def log(self, times: ArrayLike) -> Floats:
        """Give log ψ, which is linear on both sides of the due time."""
        return np.asarray(-self.slope * np.maximum(0.0, np.asarray(times, float) - self.due))

    @property
    def parameters(self) -> dict[str, float | list[float]]:
        """The due time of the start, and the slope."""
        return {"due": self.due, "slope": self.slope}

    @property
    def support(self) -> Interval:
        """It never falls to 0."""
        return Interval(-math.inf, math.inf)

    @property
    def kinks(self) -> tuple[float, ...]:
        """The due time."""
        return (self.due,)

    @property
    def best(self) -> Interval:
        """Any start in time."""
        return Interval(-math.inf, self.due)

    @property
    def log_concave(self) -> bool:
        """Its log is the least of two lines."""
        return True

    def acceptable(self, level: float = 0.5) -> Interval:
        """Give the starts with ψ ≥ level."""
        return Interval(-math.inf, self.due - math.log(level) / self.slope)

    def crossings(self, level: float) -> tuple[float, ...]:
        """Give the time at which ψ falls below a level."""
        return (self.due - math.log(level) / self.slope,) if 0 < level < 1 else ()

    def chord_error(self, starts: ArrayLike, ends: ArrayLike) -> Floats:
        """Between kinks −log ψ is its own chord."""
        return np.zeros(np.broadcast_shapes(np.shape(starts), np.shape(ends)))

    def shifted(self, by: float) -> "Tardiness":
        """Give the same, later."""
        return Tardiness(self.due + by, self.slope)

    def widened(self, factor: float, anchor: float) -> "Tardiness":
        """Give the same, wider."""
        return Tardiness(anchor + (self.due - anchor) * factor, self.slope / factor)


def instances(folder: Path, jobs: int) -> list[tuple[FuzzyTask, float, int]]:
    """Read the tasks, with their scales S and best known values."""
    numbers = np.array((folder / f"wt{jobs}.txt").read_text().split(), int).reshape(-1, 3, jobs)
    known = folder / (f"wtopt{jobs}.txt" if jobs < 100 else "wtbest100b.txt")
    best = [int(word) for word in known.read_text().split()]
    found = []
    for (processing, weight, due), value in zip(numbers, best, strict=True):
        scale = float(weight.max() * processing.sum()) / LARGEST
        skills = tuple(
            FuzzySkill(f"job {index}", Tardiness(float(d - p), w / scale), float(p))
            for index, (p, w, d) in enumerate(zip(processing, weight, due, strict=True))
        )
        found.append((FuzzyTask(skills), scale, value))
    return found


def main() -> None:
    """Solve the instances and print a line for each."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--dir", type=Path, required=True)
    parser.add_argument("--jobs", type=int, choices=(40, 50, 100), default=40)
    parser.add_argument("--every", type=int, default=1, help="only every so many-th instance")
    parser.add_argument("--seconds", type=float, default=5.0)
    chosen = parser.parse_args()
    equal, proved, below, took = 0, 0, 0, []
    picked = instances(chosen.dir, chosen.jobs)[:: chosen.every]
    for number, (task, scale, value) in enumerate(picked):
        begun, used = time.perf_counter(), time.process_time()
        schedule = solve(task, threshold=0, limits=Limits(seconds=chosen.seconds))
        seconds, used = time.perf_counter() - begun, time.process_time() - used
        cost, lower = schedule.weighted_cost * scale, schedule.certificate.lower_cost * scale
        same, closed = abs(cost - value) < 0.5, lower > value - 1 + 1e-6
        equal, proved, below = equal + same, proved + (closed and same), below + (lower > value + 0.5)
        took.append(used)
        name = f"wt{chosen.jobs}-{number * chosen.every + 1}"
        print(
            f"{name:10} best {value:7} ours {cost:10.1f} bound {lower:10.1f} "
            f"{'proved' if closed else 'open':7} {seconds:6.2f} s, CPU {used:6.2f} s",
            flush=True,
        )
    print(
        f"{len(took)} instances: {equal} equal the best known value, {proved} proved, "
        f"{below} bounds too high; CPU median {statistics.median(took):.2f} s, most {max(took):.2f} s"
    )


if __name__ == "__main__":
    main()
