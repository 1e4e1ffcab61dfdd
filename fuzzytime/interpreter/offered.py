"""What was said of when something is done, resolved: ψ of all of it together, or why no time satisfies."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Self

from fuzzytime.interpreter.bounding import to_its_end
from fuzzytime.interpreter.horizon import passed
from fuzzytime.interpreter.joining import both, either, is_day_of_another, with_alternatives
from fuzzytime.requirement import TimeRequirement
from fuzzytime.rulebook import Resolution
from fuzzytime.satisfaction import ALWAYS, Rectangle, SatisfactionFunction


@dataclass(frozen=True, slots=True)
class Offered:
    """Times that must all be kept, each with those that may be kept instead of it.

    ``given`` is when they were said, in seconds of the request's timeline.
    """

    times: tuple[tuple[Resolution, ...], ...]
    given: float

    @classmethod
    def of(
        cls, requirements: Sequence[TimeRequirement], resolutions: Sequence[Resolution], given: float
    ) -> Self:
        """Give the resolutions of requirements, apart from days that are only those of another."""
        times = (
            tuple(to_its_end(requirements[place], resolutions[place], requirements) for place in places)
            for places in with_alternatives(requirements)
            if not is_day_of_another(requirements, places)
        )
        return cls(tuple(times), given)

    @property
    def satisfaction(self) -> SatisfactionFunction:
        """ψ of all on the request's timeline: the paper's logical AND, OR of alternatives.

        What the readings tell counts from their now; everything else from when it was said.
        """
        joined: SatisfactionFunction = (
            Rectangle(-math.inf, math.inf) if self.times else ALWAYS.shifted(self.given)
        )
        for alternatives in self.times:
            parts = [one.satisfaction.shifted(self._origin(one)) for one in alternatives]
            joined = both(joined, either(parts))
        return joined

    @property
    def named(self) -> tuple[float, ...]:
        """The start that was named, on the request's timeline, with its alternatives."""
        for alternatives in self.times:
            if alternatives[0].named is not None:
                named = ((self._origin(one), one.named) for one in alternatives)
                return tuple(origin + time for origin, time in named if time is not None)
        return ()

    def why_never(self) -> tuple[str, bool]:
        """Give why no time satisfies, and whether that is only as nobody has told yet what it waits for."""
        never = [one for one in self.times if all(part.reason for part in one)]
        untold = [part.reason for one in never for part in one if part.untold]
        for one in never:
            if not any(part.untold for part in one):
                return one[0].reason or "", False
        if not untold:
            return "", False
        others = tuple(one for one in self.times if not all(part.reason for part in one))
        left = replace(self, times=others).satisfaction.support.high
        if left == -math.inf:
            # What else is said contradicts itself, whatever comes: "soon but later, unless it rains".
            return "", False
        return (passed(-left), False) if left < 0 else (untold[0] or "", True)

    def _origin(self, resolution: Resolution) -> float:
        """Give the time that a resolution counts from: the readings' now, or when it was said."""
        return 0.0 if resolution.from_readings else self.given
