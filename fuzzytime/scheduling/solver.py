"""What a solver is, and what it hands back."""

import math
from dataclasses import dataclass, field
from typing import ClassVar, Protocol

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import Ints
from fuzzytime.scheduling.problem.jobs import Problem


@dataclass(frozen=True, slots=True, eq=False)
class Draft:
    """Start times for the jobs of a problem, and what is proved about them.

    Parameters
    ----------
    starts : array of shape (jobs,)
        Seconds, NaN where a job is rejected.
    agents : array of shape (jobs,)
        From 1; any where a job is rejected.
    cost
        Σ costs, those of rejection included.
    lower_cost
        A proven lower bound on it in continuous time, −inf where there is none.
    method
        The solver that it comes from, where another one picked that.
    """

    starts: Floats
    agents: Ints
    cost: float
    lower_cost: float = field(default=-math.inf)
    method: str = ""


def draft_of(problem: Problem, starts: Floats, agents: Ints, lower_cost: float = -math.inf) -> Draft:
    """Give a draft with its cost worked out."""
    costs = [
        job.rejection if math.isnan(start) else float(job.costs(start))
        for job, start in zip(problem.jobs, starts.tolist(), strict=True)
    ]
    return Draft(starts, agents, math.fsum(costs), lower_cost)


def nothing(problem: Problem) -> Draft:
    """Give the draft that rejects every job."""
    count = len(problem.jobs)
    return Draft(np.full(count, np.nan), np.ones(count, np.int64), problem.rejection_of_all)


class Solver(Protocol):
    """A way to solve problems, with its settings: a frozen value."""

    name: ClassVar[str]
    """What a certificate calls it."""

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Give the best draft that is found until the stopwatch is over, with its bound.

        Parameters
        ----------
        problem
            At least one job, each with a window.
        watch
            Asked often; when it is over the best draft so far is given back.
        warm
            A draft to begin with.

        Raises
        ------
        RefusedError
            If the problem is beyond what this solver can do at all.
        """
        ...
