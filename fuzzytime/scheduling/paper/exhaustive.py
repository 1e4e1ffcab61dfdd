"""The paper's naive method: sample the start times, and try every vector of them, O(kⁿ)."""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import NDArray

from fuzzytime.errors import FuzzytimeError, RefusedError
from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import Ints
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.solver import Draft, nothing
from fuzzytime.scheduling.timing.settle import lanes_of_agents, settled


@dataclass(frozen=True, slots=True, eq=False)
class _Samples:
    """The start times at which one job is tried; the last one, NaN, stands for leaving it out."""

    times: Floats
    agents: Ints
    costs: Floats


@dataclass(frozen=True, slots=True)
class ExhaustiveSampling:
    """Tries every vector of sampled start times, and times the best one's order; no bound between samples.

    Parameters
    ----------
    frequency
        u, samples a second.
    most
        Start vectors that are tried at most; a larger search space is refused.

    Raises
    ------
    FuzzytimeError
        If a number is not above 0.
    """

    name: ClassVar[str] = "exhaustive"

    frequency: float = 1 / 15
    most: int = 100_000_000

    def __post_init__(self) -> None:
        if not 0 < self.frequency < math.inf:
            raise FuzzytimeError(f"a frequency must be above 0 and finite, got {self.frequency}")
        if self.most < 1:
            raise FuzzytimeError(f"at least one start vector must be allowed, got {self.most}")

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Try all.

        Raises
        ------
        RefusedError
            If there are more vectors than ``most``.
        """
        samples = [self._samples(problem, index) for index in range(len(problem.jobs))]
        sizes = [entry.times.size for entry in samples]
        if math.prod(sizes) > self.most:
            raise RefusedError(
                f"exhaustive sampling tries every vector of start times, at most {self.most:.0e}, got "
                f"{' × '.join(map(str, sizes))}: sample less often, or take another solver"
            )
        best = warm or nothing(problem)
        chosen = _Search(problem, samples, watch).best
        hints = np.array([entry.times[index] for entry, index in zip(samples, chosen, strict=True)])
        agents = np.array([entry.agents[index] for entry, index in zip(samples, chosen, strict=True)])
        found = settled(problem, hints, agents, 1 / self.frequency)
        return found if found.cost < best.cost else best

    def _samples(self, problem: Problem, index: int) -> _Samples:
        """Sample the windows of a job, their ends and the best time included."""
        job = problem.jobs[index]
        times, agents = [], []
        for agent, lane in lanes_of_agents(problem).items():
            mine: set[float] = set()
            for window in job.windows[lane]:
                count = math.floor(window.length * self.frequency + 1e-9)
                mine |= {window.low + step / self.frequency for step in range(count + 1)} | {window.high}
                mine |= {kink for kink in job.function.kinks if kink in window}
            times += sorted(mine)
            agents += [agent] * len(mine)
        moments = np.array(times)
        return _Samples(
            np.append(moments, np.nan),
            np.append(np.array(agents, np.int64), 1),
            np.append(job.costs(moments), job.rejection),
        )


class _Search:
    """Depth first over the jobs: each choice rules out those of later jobs that it does not go with."""

    def __init__(self, problem: Problem, samples: list[_Samples], watch: Stopwatch) -> None:
        self._samples, self._watch = samples, watch
        count = len(samples)
        self._goes = {
            (first, second): _compatible(problem, samples, first, second)
            for second in range(count)
            for first in range(second)
        }
        self.best = [entry.times.size - 1 for entry in samples]
        self._least = math.fsum(job.rejection for job in problem.jobs)
        self._try([], [np.ones(entry.times.size, np.bool_) for entry in samples], 0.0)

    def _try(self, chosen: list[int], open_: list[NDArray[np.bool_]], cost: float) -> None:
        job = len(chosen)
        options = np.flatnonzero(open_[job])
        costs = cost + self._samples[job].costs[options]
        if job == len(self._samples) - 1:
            if options.size and costs.min() < self._least:
                self._least, self.best = float(costs.min()), [*chosen, int(options[costs.argmin()])]
            return
        for option, so_far in zip(options.tolist(), costs.tolist(), strict=True):
            if self._watch.is_over():
                return
            later = [
                mask & self._goes[job, other][option] if other > job else mask
                for other, mask in enumerate(open_)
            ]
            self._try([*chosen, option], later, so_far)


def _compatible(problem: Problem, samples: list[_Samples], first: int, second: int) -> NDArray[np.bool_]:
    """Say which samples of two jobs go together: no overlap on one agent, lags kept."""
    one, two = samples[first], samples[second]
    begin, other = one.times[:, None], two.times[None, :]
    end, other_end = begin + problem.jobs[first].duration, other + problem.jobs[second].duration
    apart = ~((begin < other_end - 1e-9) & (other < end - 1e-9))
    good: NDArray[np.bool_] = apart | (one.agents[:, None] != two.agents[None, :])
    for lag in problem.lags:
        if {lag.first, lag.second} != {first, second}:
            continue
        gap = other - begin if lag.first == first else begin - other
        inside = (gap >= lag.low - 1e-9) & (gap <= lag.high + 1e-9)
        # What must come after a job that is left out is left out too.
        left_out = np.isnan(other if lag.second == second else begin)
        good &= inside | left_out
    return good
