"""A schedule: start times for a task's skills, with the certificate that says how good they are."""

import math
from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property

from fuzzytime.skills import FuzzyTask, Precedence, SpecificSkill

THRESHOLD = 0.001
"""ε, the paper's minimum satisfaction: a skill not placed above it is rejected, and counts as ε."""

TINY = 1e-300
"""What stands for ε where the strict product is asked for (threshold 0)."""

OPTIMAL_GAP = 1e-4
"""The gap in geometric-mean satisfaction up to which a schedule is called optimal."""

ROUNDING = 1e-9
"""Relative precision at which a lag is kept."""


class Status(StrEnum):
    """What is proved about a schedule."""

    OPTIMAL = "optimal"
    BOUNDED = "bounded"
    HEURISTIC = "heuristic"
    INFEASIBLE = "infeasible"


@dataclass(frozen=True, slots=True)
class Certificate:
    """What is proved, by what, in which time.

    Parameters
    ----------
    status
        Optimal: no schedule in continuous time has a geometric-mean satisfaction higher by more than
        `OPTIMAL_GAP`. Bounded: the gap is proved but larger. Heuristic: no bound. Infeasible: the strict
        product is 0 for every arrangement.
    lower_cost
        A proven lower bound on Σ −priority·log max(ψ, ε), −inf where there is none.
    gap
        exp((cost − lower_cost) / Σ priority) − 1: how much better the geometric mean could be at most.
    method
        The solver's name.
    seconds
        Time spent, as measured by the clock that the caller gave.
    """

    status: Status
    lower_cost: float
    gap: float
    method: str
    seconds: float

    @property
    def upper_bound(self) -> float:
        """The bound as a (weighted) product of satisfactions, infinite where there is none.

        It underflows to 0 near 150 hopeless skills, where `lower_cost` does not.
        """
        return math.exp(-self.lower_cost) if self.lower_cost > -math.inf else math.inf


@dataclass(frozen=True)
class Schedule:
    """t⃗*: one start time and agent for each of the task's skills, in the task's order.

    Parameters
    ----------
    task
        What was scheduled.
    start_times
        Seconds; a rejected skill has one too.
    agents
        Which agent does each skill, from 1.
    certificate
        What is proved.
    threshold
        ε; 0 for the paper's strict product.
    clash
        Where the task is infeasible, positions of a smallest set of skills that cannot all be satisfied.
    """

    task: FuzzyTask
    start_times: tuple[float, ...]
    agents: tuple[int, ...]
    certificate: Certificate
    threshold: float = THRESHOLD
    clash: tuple[int, ...] = ()

    @cached_property
    def satisfactions(self) -> tuple[float, ...]:
        """ψ_i(t_i), not floored; 0 where a skill starts later behind another than it may.

        "Within five minutes after the bacon is fried" is not satisfied in an hour, nor where none is fried.
        """
        pairs = zip(self.task.skills, self.start_times, strict=True)
        found = [float(skill.satisfaction(start)) for skill, start in pairs]
        closely = [entry for entry in self.task.precedences if entry.maximum_lag < math.inf]
        late = [True]
        while any(late):
            late = [found[entry.second] > self.threshold and self._is_late(entry, found) for entry in closely]
            for entry, is_late in zip(closely, late, strict=True):
                if is_late:
                    found[entry.second] = 0.0
        return tuple(found)

    def _is_late(self, entry: Precedence, found: list[float]) -> bool:
        """Tell whether a skill starts too late behind another, or behind one that is rejected."""
        start = self.start_times[entry.second]
        pause = start - self.start_times[entry.first] - self.task.skills[entry.first].time_until_done
        slack = ROUNDING * max(1.0, abs(start))
        return found[entry.first] <= self.threshold or pause > entry.maximum_lag + slack

    @cached_property
    def rejected(self) -> tuple[bool, ...]:
        """Which skills are not placed where they satisfy above the threshold."""
        return tuple(satisfaction <= self.threshold for satisfaction in self.satisfactions)

    @cached_property
    def costs(self) -> tuple[float, ...]:
        """−log max(ψ_i(t_i), ε), not weighted."""
        floor = self.threshold or TINY
        return tuple(-math.log(max(satisfaction, floor)) + 0.0 for satisfaction in self.satisfactions)

    @property
    def cost(self) -> float:
        """−log of the product of satisfactions, which does not underflow."""
        return math.fsum(self.costs)

    @property
    def weighted_cost(self) -> float:
        """What was minimised: Σ −priority·log max(ψ, ε)."""
        pairs = zip(self.task.skills, self.costs, strict=True)
        return math.fsum(skill.priority * cost for skill, cost in pairs)

    @property
    def satisfaction(self) -> float:
        """∏ max(ψ_i(t_i), ε), the paper's objective; exactly 0 for a strict product that fails."""
        if self.threshold == 0 and any(self.rejected):
            return 0.0
        return math.exp(-self.cost)

    @property
    def geometric_mean(self) -> float:
        """The satisfaction of an average skill; 1 for an empty task."""
        if self.threshold == 0 and any(self.rejected):
            return 0.0
        return math.exp(-self.cost / len(self.start_times)) if self.start_times else 1.0

    @cached_property
    def skills(self) -> tuple[SpecificSkill, ...]:
        """The skills with their start times, in the task's order."""
        rows = zip(self.task.skills, self.start_times, self.agents, strict=True)
        return tuple(
            SpecificSkill(
                skill.name,
                start,
                skill.duration,
                skill.parameters,
                skill.elapsed,
                agent,
                skill.until,
                skill.in_passing,
            )
            for skill, start, agent in rows
        )

    @cached_property
    def order(self) -> tuple[int, ...]:
        """Positions of the skills by start time."""
        return tuple(sorted(range(len(self.start_times)), key=lambda i: (self.start_times[i], i)))
