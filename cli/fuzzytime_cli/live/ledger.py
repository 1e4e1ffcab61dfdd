"""What has been started, and what became of it."""

import math
from dataclasses import dataclass, field, replace
from enum import StrEnum

from fuzzytime.interpreter import Started

SHORTEST_DELAY = 5.0
"""Seconds that what is late is expected to take at least from then on."""

DELAY_SHARE = 0.25
"""What has taken long takes longer: so much of the time spent is expected to be still needed."""


class Phase(StrEnum):
    """Where a skill that was started, or given up, stands."""

    RUNNING = "running"
    RESTING = "resting"
    DONE = "done"
    FAILED = "failed"
    DROPPED = "dropped"


@dataclass(frozen=True, slots=True, kw_only=True)
class Task:
    """A skill that was started, or given up: it does not move any more. Times are in seconds of the run.

    Parameters
    ----------
    end
        When the agent is free: as expected, then as it was.
    planned
        Seconds from start to end, as planned.
    rest
        Seconds from the end until the result is there; infinite where it will never be.
    satisfaction
        ψ at its start; None where it was never started.
    in_passing
        Whether it keeps its agent from nothing else.
    """

    identifier: str
    name: str
    start: float
    end: float
    planned: float
    rest: float
    agent: int = 1
    satisfaction: float | None = None
    phase: Phase = Phase.RUNNING
    in_passing: bool = False

    @property
    def done(self) -> float:
        """When the result is there."""
        return self.end + self.rest

    @property
    def planned_done(self) -> float:
        """When the result should have been there."""
        return self.start + self.planned + self.rest

    @property
    def is_over(self) -> bool:
        """Whether nothing more is to come of it."""
        return self.phase not in {Phase.RUNNING, Phase.RESTING}

    def ended(self, at: float) -> "Task":
        """Give the task with its agent free."""
        return replace(self, end=at, phase=Phase.RESTING)

    def completed(self, at: float) -> "Task":
        """Give the task with its result there."""
        end = min(self.end, at)
        return replace(self, end=end, rest=at - end, phase=Phase.DONE)

    def lost(self, at: float, phase: Phase) -> "Task":
        """Give the task as failed or dropped: its agent is free, its result will never be there."""
        return replace(self, end=min(self.end, at), rest=math.inf, phase=phase)

    def delayed(self, now: float) -> "Task":
        """Give the task with its end expected later, because it is not there when it should be."""
        return replace(self, end=now + max(SHORTEST_DELAY, DELAY_SHARE * (now - self.start)))

    def as_seen(self, now: float) -> Started:
        """Give the task as planning sees it from a moment."""
        return Started(
            identifier=self.identifier,
            start=self.start - now,
            end=(self.start if self.in_passing else self.end) - now,
            done=self.done - now,
            agent=self.agent,
        )


@dataclass(slots=True)
class Ledger:
    """Every task by its identifier, in the order of starting."""

    tasks: dict[str, Task] = field(default_factory=dict)

    def keep(self, task: Task) -> Task:
        """Keep a task, or what has become of it."""
        self.tasks[task.identifier] = task
        return task

    def in_phase(self, *phases: Phase) -> list[Task]:
        """Give the tasks that are in some phases."""
        return [task for task in self.tasks.values() if task.phase in phases]

    def names(self, *phases: Phase) -> tuple[str, ...]:
        """Give the identifiers of the tasks in some phases."""
        return tuple(task.identifier for task in self.in_phase(*phases))

    def as_seen(self, now: float) -> tuple[Started, ...]:
        """Give all tasks as planning sees them from a moment."""
        return tuple(task.as_seen(now) for task in self.tasks.values())
