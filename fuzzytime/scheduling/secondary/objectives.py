"""What counts among schedules that satisfy equally: nearness to what was named, early starts, and more.

An objective wishes a start for each skill, as a satisfaction function of its own, so that every solver can
follow it. See `fuzzytime.scheduling.secondary.lexicographic` for how. The paper names total time, idle time,
intrusiveness and energy (section on scheduling) as further aspects of a schedule.
"""

import math
from abc import ABC, abstractmethod
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import ClassVar, Protocol

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import (
    EVERYWHERE,
    Either,
    Interval,
    Rectangle,
    Sampled,
    SatisfactionFunction,
    Triangle,
)
from fuzzytime.scheduling.secondary.over_time import OverTime
from fuzzytime.skills import FuzzySkill

GENTLE = 100.0
"""How many horizons away a wish is worth nothing: so far that a sum of wishes is as good as their product."""

PATIENCE = 10.0
"""How many seconds later a start that nobody named may be, for a second nearer to one that somebody did."""

LATER_CHOICE = 0.9
"""The share of its distance from what was named first that an alternative, though as good, counts as."""

SHORTEST = 1.0
"""Seconds that count for what keeps nobody's hands."""

FIRST_SAID = 0.5
"""How much more a second counts of what was said first of all than of what was said last."""

PIECES = 8
"""Lines that stand for a curve's integral between two of its corners."""


@dataclass(frozen=True, slots=True)
class Arrangement:
    """Skills that are placed, by whom, and how far their starts reach.

    Parameters
    ----------
    skills, starts, agents
        One entry for each skill that is not rejected.
    reach
        A time in seconds before which all of them start.
    """

    skills: tuple[FuzzySkill, ...]
    starts: tuple[float, ...]
    agents: tuple[int, ...]
    reach: float

    def ends_of_agents(self) -> dict[int, tuple[int, int]]:
        """Give for each agent the index of the skill that it starts first, and of the one it ends last."""
        found: dict[int, tuple[int, int]] = {}
        for agent in sorted(set(self.agents)):
            mine = [index for index, other in enumerate(self.agents) if other == agent]
            first = min(mine, key=lambda index: (self.starts[index], index))
            last = max(mine, key=lambda index: (self.starts[index] + self.skills[index].duration, index))
            found[agent] = first, last
        return found


class Objective(Protocol):
    """Something to want among schedules that satisfy equally: a frozen value."""

    reorders: ClassVar[bool]
    """Whether its wishes still say what is wanted when the skills change places."""

    in_order: ClassVar[bool]
    """Whether the order said counts more than the wishes where no start was named, and pauses bind skills."""

    def wishes(self, arrangement: Arrangement) -> Sequence[SatisfactionFunction]:
        """Give the wish for each skill's start, close to 1 everywhere before the reach."""
        ...

    def bounds(self, arrangement: Arrangement) -> Sequence[Interval]:
        """Give the starts that later objectives must keep to, beside those that this one wishes as much."""
        ...


class _EachForItself(ABC):
    """An objective that is a sum over the skills."""

    __slots__ = ()

    reorders: ClassVar[bool] = True
    in_order: ClassVar[bool] = False

    @abstractmethod
    def wish(self, skill: FuzzySkill, reach: float) -> SatisfactionFunction:
        """Give the wish for one skill's start."""

    def wishes(self, arrangement: Arrangement) -> Sequence[SatisfactionFunction]:
        """Give the wish for each skill's start, close to 1 everywhere before the reach."""
        return [self.wish(skill, arrangement.reach) for skill in arrangement.skills]

    def bounds(self, arrangement: Arrangement) -> Sequence[Interval]:
        """Bind no skill for the sake of others."""
        return [EVERYWHERE for _ in arrangement.skills]


@dataclass(frozen=True, slots=True)
class EarliestStart(_EachForItself):
    """The least sum of start times."""

    def wish(self, skill: FuzzySkill, reach: float) -> SatisfactionFunction:
        """Wish for 0, linearly less from there on."""
        del skill
        return _early(reach)


@dataclass(frozen=True, slots=True)
class Nearness(_EachForItself):
    """The least sum of distances to the starts that were named, and of start times where none was.

    A second of the latter counts `PATIENCE` times less at most, and by how long hands are kept: then what
    nobody named a time for is done in the order said, and not by its length (Smith's rule, 1956).
    Of equal sums the one that is shared out more evenly is wished a little more.
    """

    in_order: ClassVar[bool] = True

    def wishes(self, arrangement: Arrangement) -> Sequence[SatisfactionFunction]:
        """Give the wish for each skill's start, close to 1 everywhere before the reach."""
        skills, reach = arrangement.skills, arrangement.reach
        counts = [
            max(skill.duration, SHORTEST) * (1.0 + FIRST_SAID * (1.0 - place / len(skills)))
            for place, skill in enumerate(skills)
        ]
        most = max(counts, default=1.0)
        return [
            self.wish(skill, reach if skill.preferred is not None else reach * most / count)
            for skill, count in zip(skills, counts, strict=True)
        ]

    def wish(self, skill: FuzzySkill, reach: float) -> SatisfactionFunction:
        """Wish for the preferred start, linearly less away from it; a little more for an alternative."""
        if skill.preferred is None:
            return _early(PATIENCE * reach)
        wide = GENTLE * reach
        wish = Triangle(skill.preferred - wide, skill.preferred, skill.preferred + wide)
        if not skill.alternatives:
            return wish
        peaks = {time: 1.0 - LATER_CHOICE * abs(time - skill.preferred) / wide for time in skill.alternatives}
        others = [
            Sampled((time - wide, time, time + wide), (0, peak, 0))
            for time, peak in peaks.items()
            if peak > 0
        ]
        return Either([wish, *others])


DEFAULT: tuple[Objective, ...] = (Nearness(),)
"""What counts among equals unless something else is asked for."""


@dataclass(frozen=True, slots=True)
class Makespan:
    """The least total time: the end of each agent's last skill, for the order that was found."""

    reorders: ClassVar[bool] = False
    in_order: ClassVar[bool] = False

    def wishes(self, arrangement: Arrangement) -> Sequence[SatisfactionFunction]:
        """Wish for early starts of the last skills only."""
        lasts = {last for _, last in arrangement.ends_of_agents().values()}
        return [
            _early(arrangement.reach) if index in lasts else _anywhere()
            for index in range(len(arrangement.skills))
        ]

    def bounds(self, arrangement: Arrangement) -> Sequence[Interval]:
        """Let no skill end later than its agent's last one does."""
        lasts = {agent: last for agent, (_, last) in arrangement.ends_of_agents().items()}
        return [
            Interval(-math.inf, _end(arrangement, lasts[agent]) - skill.duration)
            for skill, agent in zip(arrangement.skills, arrangement.agents, strict=True)
        ]


@dataclass(frozen=True, slots=True)
class IdleTime:
    """The least time without work between an agent's first and last skill, for the order that was found."""

    reorders: ClassVar[bool] = False
    in_order: ClassVar[bool] = False

    def wishes(self, arrangement: Arrangement) -> Sequence[SatisfactionFunction]:
        """Wish for early last skills and late first ones."""
        found: list[SatisfactionFunction] = [_anywhere() for _ in arrangement.skills]
        reach = arrangement.reach
        for first, last in arrangement.ends_of_agents().values():
            if first != last:
                found[first] = Triangle(-GENTLE * reach, reach, reach + 1.0)
                found[last] = _early(reach)
        return found

    def bounds(self, arrangement: Arrangement) -> Sequence[Interval]:
        """Let no skill start before its agent's first one, or end after the last."""
        ends = arrangement.ends_of_agents()
        return [
            Interval(arrangement.starts[ends[agent][0]], _end(arrangement, ends[agent][1]) - skill.duration)
            for skill, agent in zip(arrangement.skills, arrangement.agents, strict=True)
        ]


@dataclass(frozen=True, slots=True)
class Intrusiveness(_EachForItself):
    """The least disturbance: a penalty over time, summed over all hands-on time.

    Parameters
    ----------
    penalty
        How much work disturbs at each moment, such as 1 during a meeting and 0 else.
    """

    penalty: OverTime

    def wish(self, skill: FuzzySkill, reach: float) -> SatisfactionFunction:
        """Wish for starts from which the work disturbs little."""
        return _cheap(self.penalty, skill.duration, 1.0 / (max(self.penalty.values) or 1.0), reach)


@dataclass(frozen=True, slots=True)
class Energy(_EachForItself):
    """The least cost of energy: each skill's power against a tariff, until its result is there.

    Parameters
    ----------
    tariff
        Price of energy at each moment.
    powers
        Power by the names of skills, in any unit; others take ``power``.
    power
        Power of all other skills.

    Raises
    ------
    FuzzytimeError
        If a power is negative or not finite.
    """

    tariff: OverTime
    powers: Mapping[str, float] = field(default_factory=dict, hash=False)
    power: float = 1.0

    def __post_init__(self) -> None:
        for power in (self.power, *self.powers.values()):
            if not 0 <= power < math.inf:
                raise FuzzytimeError(f"a power must be finite and at least 0, got {power}")

    def wish(self, skill: FuzzySkill, reach: float) -> SatisfactionFunction:
        """Wish for starts from which the skill's energy is cheap."""
        most = max([self.power, *self.powers.values()]) * max(self.tariff.values) or 1.0
        share = self.powers.get(skill.name, self.power) / most
        return _cheap(self.tariff, skill.time_until_done, share, reach)


def _early(reach: float) -> SatisfactionFunction:
    return Triangle(-1.0, 0.0, GENTLE * reach)


def _anywhere() -> SatisfactionFunction:
    return Rectangle(-math.inf, math.inf)


def _end(arrangement: Arrangement, index: int) -> float:
    return arrangement.starts[index] + arrangement.skills[index].duration


def _cheap(curve: OverTime, duration: float, share: float, reach: float) -> SatisfactionFunction:
    """Give 1 less a gentle share of what a curve sums up to over a duration, at points about its corners."""
    corners = np.array([*curve.times, *(time - duration for time in curve.times), 0.0, reach])
    corners = np.unique(np.clip(corners, 0.0, reach))
    pieces = np.linspace(0, 1, PIECES, endpoint=False)
    times = np.unique(
        np.append((corners[:-1, None] + np.diff(corners)[:, None] * pieces).ravel(), corners[-1])
    )
    return Sampled(times, 1.0 - share * curve.over(times, duration) / (GENTLE * max(reach, duration)))
