"""What can be read: signals with their units and limits, and how each is expected to go on."""

import math
from dataclasses import dataclass

from fuzzytime.context.units import convert
from fuzzytime.errors import FuzzytimeError

LARGEST = 1e12
"""The largest value that a signal may have, whatever its range."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Hold:
    """A signal that stays where it is."""

    horizon: float = math.inf


@dataclass(frozen=True, slots=True, kw_only=True)
class Linear:
    """A signal that goes on straight; ``rate`` is its slope per second where it is known beforehand."""

    rate: float | None = None
    horizon: float = math.inf


@dataclass(frozen=True, slots=True, kw_only=True)
class Approach:
    """A signal that approaches a value: x(t) = x∞ + (x₀ − x∞)·exp(−t / τ).

    Parameters
    ----------
    set_point
        x∞, in the signal's unit, where it is known beforehand.
    time_constant
        τ in seconds, as expected before any reading.
    spread
        The factor by which τ may well differ from that, as one standard deviation of its logarithm.
    horizon
        Seconds beyond which nothing is forecast.
    """

    set_point: float | None = None
    time_constant: float | None = None
    spread: float = 1.3
    horizon: float = math.inf


Course = Hold | Linear | Approach
"""How a signal is expected to go on after its last reading."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Signal:
    """One thing that can be read over time, or an event, which happens and has no value.

    Parameters
    ----------
    unit
        The unit in which terms speak of it; None for a bare number.
    low, high
        Values outside cannot be.
    max_age
        Seconds after its last reading from which it counts as unknown.
    max_gap
        Seconds between two readings beyond which what lies between them is unknown.
    noise
        The standard deviation of a reading, in the signal's unit, where it is known; readings add what they
        show.
    softness
        How far a value may be from a number that a sentence says ("above 150 degrees") and still count for
        something, in the signal's unit; None for the tables' share of the number.
    words
        How a sentence names an event: "the timer rings".
    """

    name: str
    unit: str | None = None
    low: float = -math.inf
    high: float = math.inf
    max_age: float = math.inf
    max_gap: float = math.inf
    event: bool = False
    course: Course = Hold()
    noise: float | None = None
    softness: float | None = None
    words: tuple[str, ...] = ()

    def admitted(self, value: float | None, unit: str | None) -> float | None:
        """Give a reading's value in the signal's unit; None for an event.

        Raises
        ------
        FuzzytimeError
            If an event has a value or another signal has none, the units do not fit, or the value lies
            outside the range.
        """
        if self.event:
            if value is not None:
                raise FuzzytimeError(f"the event {self.name!r} must have no value, got {value:g}")
            return None
        if value is None:
            raise FuzzytimeError(f"a reading of {self.name!r} must have a value")
        if not abs(value) <= LARGEST:
            raise FuzzytimeError(f"a reading of {self.name!r} must be at most {LARGEST:g}, got {value:g}")
        if unit is not None and self.unit is None:
            raise FuzzytimeError(f"{self.name!r} has no unit, got {unit!r}")
        converted = value if unit is None or self.unit is None else convert(value, unit, self.unit)
        # Rounding in a conversion must not push a limit out of its own range.
        margin = 1e-9 * max(abs(converted), 1.0)
        if not self.low - margin <= converted <= self.high + margin:
            shown = f" {self.unit}" if self.unit else ""
            raise FuzzytimeError(
                f"{self.name!r} must lie between {self.low:g} and {self.high:g}{shown}, got {converted:g}"
            )
        return min(max(converted, self.low), self.high)
