"""What a run takes for being in time."""

from dataclasses import dataclass

JUST = 1e-3
"""Seconds after which what was due is surely past."""

LATENCY = 0.1
"""Seconds of the machine that are no delay."""


@dataclass(frozen=True, slots=True)
class Pace:
    """Leeway, in seconds of the run.

    Parameters
    ----------
    tolerance
        How far from its time something may happen without being late, or missed.
    patience
        How long readings are gathered before their meaning is looked at again.
    """

    tolerance: float = 1.0
    patience: float = 1.0

    @classmethod
    def at(cls, speed: float) -> "Pace":
        """Give the pace of a run whose seconds pass ``speed`` times as fast as the machine's."""
        return cls(max(1.0, LATENCY * speed), max(1.0, LATENCY * speed))
