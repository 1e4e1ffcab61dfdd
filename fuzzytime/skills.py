"""Skills and tasks: what is to be done (the paper's eqs. 1 and 2), before and after it is scheduled."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import SatisfactionFunction


@dataclass(frozen=True, slots=True)
class FuzzyParameter:
    """A vague amount or object, kept for whoever executes the skill: "some food", "a few screws".

    ``quantity`` is a fuzzy number, by the four corners of a trapezoid, or None where none is known.
    """

    text: str
    noun: str
    quantity: tuple[float, float, float, float] | None = None


@dataclass(frozen=True, slots=True)
class FuzzySkill:
    """s̃ = (ψ, t_d, Θ, Λ̃): an operation whose start time is a matter of satisfaction.

    Parameters
    ----------
    name
        What is done, for people: "flip the pancakes".
    satisfaction
        ψ over start times, in seconds.
    duration
        t_d in seconds: how long the agent is busy with it.
    fuzzy_parameters, parameters
        Θ and Λ̃: everything else that was said about it.
    elapsed
        Seconds from the start until it is done, where that is longer than the agent is busy: eggs boil
        while the cook is free. None means ``duration``.
    priority
        Weight of log ψ in what is maximised.
    agent
        The agent, from 1, that must do it; None leaves the choice to the solver.
    preferred
        The start, in seconds, that was named: among starts that satisfy equally, nearer is better. None where
        no moment was named, and earlier is better.
    alternatives
        Further starts that were named, one of which will do as well: "at six or at eight".
    until
        When it is over, in seconds, whenever it starts: "play jazz until ten". It takes ``elapsed`` at least.
    happens
        Whether it happens by itself and needs no agent, whatever else is done meanwhile: "the train leaves at
        9:15". Its duration is 0 then.
    in_passing
        Whether it is done in passing, beside whatever else keeps its agent. Its duration is 0 then, too.
    by_the_clock
        Whether its time was told by words such as "this evening", which name no moment: where it begins to be
        satisfied in full, a round time of the clock is better.

    Raises
    ------
    FuzzytimeError
        If a duration is negative or not finite, the priority is not above 0, a start that was named is not
        finite, or what happens by itself or in passing has a duration.
    """

    name: str
    satisfaction: SatisfactionFunction
    duration: float
    fuzzy_parameters: tuple[FuzzyParameter, ...] = ()
    parameters: Mapping[str, str] = field(default_factory=dict, hash=False)
    elapsed: float | None = None
    priority: float = 1.0
    agent: int | None = None
    preferred: float | None = None
    alternatives: tuple[float, ...] = ()
    until: float | None = None
    happens: bool = False
    in_passing: bool = False
    by_the_clock: bool = False

    def __post_init__(self) -> None:
        if self.needs_nobody and self.duration:
            what = "happens by itself" if self.happens else "is done in passing"
            raise FuzzytimeError(
                f"what {what} must take no agent's time, got a duration of {self.duration:g} s"
            )
        for named in self.named:
            if not math.isfinite(named):
                raise FuzzytimeError(f"a skill's preferred start must be finite, got {named}")
        for name, value in (("duration", self.duration), ("elapsed time", self.time_until_done)):
            if not 0 <= value < math.inf:
                raise FuzzytimeError(f"a skill's {name} must be finite and at least 0, got {value}")
        if not 0 < self.priority < math.inf:
            raise FuzzytimeError(f"a skill's priority must be above 0 and finite, got {self.priority}")

    @property
    def needs_nobody(self) -> bool:
        """Whether it keeps no agent from anything else."""
        return self.happens or self.in_passing

    @property
    def time_until_done(self) -> float:
        """Seconds from start until the result is there."""
        return self.duration if self.elapsed is None else self.elapsed

    @property
    def time_at_work(self) -> float:
        """Seconds from start until whoever does it has done their part, beside other work or not."""
        return self.time_until_done if self.in_passing else self.duration

    def done_at(self, start: float) -> float:
        """Give when the result is there of what starts at a time, or when it is over."""
        return _over(start + self.time_until_done, self.until)

    @property
    def named(self) -> tuple[float, ...]:
        """The starts that were named, the preferred one first."""
        return () if self.preferred is None else (self.preferred, *self.alternatives)

    def starting_near(self, *named: float) -> "FuzzySkill":
        """Give the same with other starts named, or none: the first is preferred."""
        return replace(self, preferred=named[0] if named else None, alternatives=named[1:])


@dataclass(frozen=True, slots=True)
class SpecificSkill:
    """s = (t_s, t_d, Λ): the same operation with a start time, ready to execute."""

    name: str
    start: float
    duration: float
    parameters: Mapping[str, str] = field(default_factory=dict, hash=False)
    elapsed: float | None = None
    agent: int = 1
    until: float | None = None
    in_passing: bool = False

    @property
    def end(self) -> float:
        """When the agent is free again."""
        return self.start + self.duration

    @property
    def worked_until(self) -> float:
        """When whoever does it has done their part, beside other work or not."""
        return self.end if self.elapsed is None or not self.in_passing else self.start + self.elapsed

    @property
    def done(self) -> float:
        """When the result is there, or when it is over."""
        return _over(self.start + (self.duration if self.elapsed is None else self.elapsed), self.until)


def _over(done: float, until: float | None) -> float:
    """Give when something is over that is done at a time, and goes on until another if one is told."""
    return done if until is None else max(done, until)


@dataclass(frozen=True, slots=True)
class Precedence:
    """Skill ``first`` is done before skill ``second`` starts, by positions in the task, from 0.

    The start of ``second`` minus the moment ``first`` is done, its ``time_until_done`` after it starts, lies
    between the two lags, in seconds; a negative one lets them overlap. Of lags that satisfy equally, one
    nearer to the ``wished_lag`` is better; None where no distance was named.

    Raises
    ------
    FuzzytimeError
        If the lags contradict each other.
    """

    first: int
    second: int
    minimum_lag: float = 0.0
    maximum_lag: float = math.inf
    wished_lag: float | None = None

    def __post_init__(self) -> None:
        if not self.minimum_lag <= self.maximum_lag or self.minimum_lag == math.inf:
            raise FuzzytimeError(
                "a precedence's minimum lag must not exceed its maximum, "
                f"got {self.minimum_lag} and {self.maximum_lag}"
            )
        if self.wished_lag is not None and not self.minimum_lag <= self.wished_lag <= self.maximum_lag:
            raise FuzzytimeError(
                "a precedence's wished lag must lie between its minimum and its maximum, "
                f"got {self.wished_lag}"
            )


@dataclass(frozen=True, slots=True)
class Busy:
    """A time when an agent, or every agent (None), is taken: an appointment, a skill that has started."""

    start: float
    end: float
    what: str = ""
    agent: int | None = None

    def __post_init__(self) -> None:
        if not self.start <= self.end:
            raise FuzzytimeError(f"a busy time must not end before it starts, got {self.start} to {self.end}")


@dataclass(frozen=True, slots=True)
class FuzzyTask:
    """T: the skills to schedule, by how many agents, and what binds them.

    ``past_hour`` are the seconds by which the clock is past a full hour at time 0.

    Raises
    ------
    FuzzytimeError
        If there is no agent, an agent or a precedence names what is not there, or precedences form a circle.
    """

    skills: tuple[FuzzySkill, ...]
    agents: int = 1
    precedences: tuple[Precedence, ...] = ()
    busy: tuple[Busy, ...] = ()
    past_hour: float = 0.0

    def __post_init__(self) -> None:
        if self.agents < 1:
            raise FuzzytimeError(f"a task needs at least one agent, got {self.agents}")
        named = [skill.agent for skill in self.skills] + [busy.agent for busy in self.busy]
        for agent in named:
            if agent is not None and not 1 <= agent <= self.agents:
                raise FuzzytimeError(f"an agent must be one of 1 to {self.agents}, got {agent}")
        for precedence in self.precedences:
            for position in (precedence.first, precedence.second):
                if not 0 <= position < len(self.skills):
                    raise FuzzytimeError(
                        f"a precedence must name skills 0 to {len(self.skills) - 1}, got {position}"
                    )
        self._refuse_circles()

    def select(self, positions: Sequence[int]) -> "FuzzyTask":
        """Give the task of some of the skills, in the given order; precedences with others are dropped."""
        place = {position: index for index, position in enumerate(positions)}
        precedences = tuple(
            replace(entry, first=place[entry.first], second=place[entry.second])
            for entry in self.precedences
            if entry.first in place and entry.second in place
        )
        skills = tuple(self.skills[position] for position in positions)
        return replace(self, skills=skills, precedences=precedences)

    def _refuse_circles(self) -> None:
        followers: dict[int, set[int]] = {}
        waiting = [0] * len(self.skills)
        for precedence in self.precedences:
            if precedence.second not in followers.setdefault(precedence.first, set()):
                followers[precedence.first].add(precedence.second)
                waiting[precedence.second] += 1
        free = [position for position, count in enumerate(waiting) if not count]
        for position in free:
            for follower in followers.get(position, ()):
                waiting[follower] -= 1
                if not waiting[follower]:
                    free.append(follower)
        if len(free) < len(self.skills):
            circle = ", ".join(repr(self.skills[i].name) for i, count in enumerate(waiting) if count)
            raise FuzzytimeError(f"precedences must not form a circle, got one among {circle}")
