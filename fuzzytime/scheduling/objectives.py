"""What counts among schedules that satisfy equally: nearness to what was named, early starts, and more.

An objective wishes a start for each skill, as a satisfaction function of its own, so that every solver can
follow it. See `fuzzytime.scheduling.secondary` for how.
"""

from dataclasses import dataclass
from typing import ClassVar, Protocol

from fuzzytime.satisfaction import SatisfactionFunction, Triangle
from fuzzytime.skills import FuzzySkill

GENTLE = 100.0
"""How many horizons away a wish is worth nothing: so far that a sum of wishes is as good as their product."""

PATIENCE = 10.0
"""How many seconds later a start that nobody named may be, for a second nearer to one that somebody did."""


class Objective(Protocol):
    """Something to want among schedules that satisfy equally: a frozen value."""

    name: ClassVar[str]
    """What it is called."""

    def wish(self, skill: FuzzySkill, reach: float) -> SatisfactionFunction:
        """Give the wish for a skill's start, close to 1 everywhere before ``reach`` seconds."""
        ...


@dataclass(frozen=True, slots=True)
class EarliestStart:
    """The least sum of start times."""

    name: ClassVar[str] = "earliest start"

    def wish(self, skill: FuzzySkill, reach: float) -> SatisfactionFunction:
        """Wish for 0, linearly less from there on."""
        del skill
        return Triangle(-1.0, 0.0, GENTLE * reach)


@dataclass(frozen=True, slots=True)
class Nearness:
    """The least sum of distances to the starts that were named, and of start times where none was.

    A second of the latter counts `PATIENCE` times less.
    """

    name: ClassVar[str] = "nearness"

    def wish(self, skill: FuzzySkill, reach: float) -> SatisfactionFunction:
        """Wish for the preferred start, linearly less away from it."""
        if skill.preferred is None:
            return EarliestStart().wish(skill, PATIENCE * reach)
        return Triangle(skill.preferred - GENTLE * reach, skill.preferred, skill.preferred + GENTLE * reach)


DEFAULT = (Nearness(),)
"""What counts among equals unless something else is asked for."""
