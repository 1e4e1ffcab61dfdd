"""Round times for an axis, and what is written at them."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from datetime import datetime
from itertools import pairwise

from fuzzytime.times import instant_after, seconds_between
from fuzzytime_cli.clock import Clock
from fuzzytime_cli.render import width_of

MINUTES = (1, 2, 5, 10, 15, 30)
HOURS = (1, 2, 3, 6, 12)
DAYS = (1, 2, 7, 14)
MONTHS = (1, 2, 3, 6, 12, 24, 60)
STEPS = (*MINUTES, *(60 * m for m in MINUTES), *(3600 * h for h in HOURS), *(86400 * d for d in DAYS))
"""Distances between ticks that people find round, in seconds."""


@dataclass(frozen=True, slots=True)
class Tick:
    """A time on an axis, in seconds, and its words."""

    time: float
    label: str


def ticks(start: float, end: float, most: int, now: datetime | None) -> list[Tick]:
    """Give at most so many round times between two, in seconds from ``now``, as that clock shows them.

    Without ``now`` they are minutes, which may lie before 0.

    >>> ticks(0, 300, 2, datetime(2026, 3, 4, 8, 58))
    [Tick(time=120.0, label='09:00')]
    >>> [tick.label for tick in ticks(0, 300, 2, None)]
    ['+0 min', '+5 min']
    >>> [tick.label for tick in ticks(0, 400 * 86400, 2, datetime(2026, 3, 4))]
    ['01 Jul', '01 Jan 2027']
    """
    if now is None:
        return [Tick(time, f"{time / 60:+.4g} min") for time in round_times(start, end, most)]
    if end - start > most * STEPS[-1]:
        times = _months(start, end, most, now)
    else:
        times = round_times(start, end, most, _since_midnight(now))
    clock = Clock.for_times(now, times)
    shown = clock.day if all(map(clock.is_midnight, times)) else clock.of
    return [Tick(time, shown(time)) for time in times]


def axis(
    columns: int, most: int, span: tuple[float, float], now: datetime | None, column: Callable[[float], int]
) -> str:
    """Write a time axis in so many columns, with at most so many ticks, and as few as their words have room.

    ``column`` gives the place of a time.
    """
    shown: list[tuple[int, str]] = []
    for number in range(max(1, most), 0, -1):
        marks = [(column(tick.time), f"╵{tick.label}") for tick in ticks(*span, number, now)]
        shown = [(place, label) for place, label in marks if place + width_of(label) <= columns]
        if all(other - place > width_of(label) for (place, label), (other, _) in pairwise(shown)):
            break
    line = ""
    for place, label in shown:
        line = f"{line:<{place}}{label}"
    return line


def round_times(start: float, end: float, most: int, offset: float = 0.0) -> list[float]:
    """Give at most so many round times from start to end.

    ``offset`` is the distance from the last full hour or day to time 0, so that ticks fall on full minutes.

    >>> round_times(0, 1000, 4)
    [0.0, 300.0, 600.0, 900.0]
    """
    needed = (end - start) / max(1, most)
    step = next((step for step in STEPS if step >= needed), STEPS[-1] * math.ceil(needed / STEPS[-1]))
    first = math.ceil((start + offset) / step)
    last = math.floor((end + offset) / step)
    return [float(index * step - offset) for index in range(first, last + 1)]


def _months(start: float, end: float, most: int, now: datetime) -> list[float]:
    """Give at most so many beginnings of months between two times."""
    first, last = (_month_of(instant_after(now, time)) for time in (start, end))
    span = next((step for step in MONTHS if (last - first) // step <= most), last - first)
    found = (
        seconds_between(now, datetime(month // 12, month % 12 + 1, 1, tzinfo=now.tzinfo))
        for month in range(-(-first // span) * span, last + 1, span)
    )
    return [time for time in found if start <= time <= end]


def _month_of(instant: datetime) -> int:
    """Count the months of our calendar up to an instant."""
    return instant.year * 12 + instant.month - 1


def _since_midnight(now: datetime) -> float:
    """Give the seconds of the day so far, by the clock."""
    return now.hour * 3600.0 + now.minute * 60 + now.second + now.microsecond / 1e6
