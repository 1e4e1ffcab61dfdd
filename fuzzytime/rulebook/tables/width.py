"""How leniency grows with the time named: the half-base w(t) of "in" (F3 of the paper); numbers beside it."""

from dataclasses import dataclass

import numpy as np

from fuzzytime.requirement import Unit


@dataclass(frozen=True, slots=True)
class Points:
    """A quantity over time by points, linear between them; before the first it keeps its value.

    Beyond the last it keeps its value too, or goes on with the last slope.
    """

    times: tuple[float, ...]
    values: tuple[float, ...]
    extended: bool = False
    source: str = ""

    def __call__(self, time: float) -> float:
        """Give the quantity at a time in seconds."""
        last = self.times[-1]
        if self.extended and time > last and len(self.times) > 1:
            slope = (self.values[-1] - self.values[-2]) / (last - self.times[-2])
            return self.values[-1] + slope * (time - last)
        return float(np.interp(time, self.times, self.values))


@dataclass(frozen=True, slots=True)
class Roundness:
    """When a number counts as round: where it is at most, or a multiple of, its unit's step.

    A hedge widens a number that is not round by another ``factor`` ("about 7" against "about 10").
    """

    steps: tuple[tuple[Unit, float], ...]
    factor: float
    source: str

    def __call__(self, number: float | None, unit: Unit | None) -> float:
        """Give the further factor for a number; 1 where it is round or none was said."""
        step = dict(self.steps).get(unit) if unit is not None else None
        if number is None or step is None or abs(number) <= step:
            return 1.0
        multiple = number / step
        return 1.0 if abs(multiple - round(multiple)) < 1e-9 else self.factor


@dataclass(frozen=True, slots=True)
class Softness:
    """How softly a number in a clause is meant ("above 150 degrees"): as a share of the number."""

    share: float
    source: str
