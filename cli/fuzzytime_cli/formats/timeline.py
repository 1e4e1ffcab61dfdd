"""The timeline: for each skill a lane with ψ as shade, and on it the time that the skill takes.

Shades tell how well a start there would satisfy; nothing needs colour.
"""

from collections.abc import Container, Sequence
from dataclasses import dataclass

import numpy as np

from fuzzytime.satisfaction import SatisfactionFunction

SHADES = " ░▒▓"
TAKEN, WAITING, APPOINTMENT = "█", "─", "×"


@dataclass(frozen=True, slots=True)
class Window:
    """The stretch of time that lanes show, in seconds, on a number of columns."""

    start: float
    end: float
    columns: int

    @property
    def step(self) -> float:
        """Seconds that one column stands for."""
        return (self.end - self.start) / self.columns

    def column(self, time: float) -> int:
        """Give the column of a time, possibly outside."""
        return int(np.floor((time - self.start) / self.step))


def shades(function: SatisfactionFunction, window: Window) -> list[str]:
    """Give the shade of each column: the best satisfaction of a start within it.

    What any start satisfies in full says nothing, and is not shaded.
    """
    inner = window.start + (np.arange(window.columns)[:, None] + np.linspace(0, 1, 9)) * window.step
    best = function(inner).max(axis=1)
    # A wish may be far narrower than a column.
    marks = np.array(
        [time for time in (*function.kinks, function.best.low) if window.start <= time < window.end]
    )
    np.maximum.at(best, [min(window.column(time), window.columns - 1) for time in marks], function(marks))
    if best.min() >= 1.0:
        return [" "] * window.columns
    level = np.where(best <= 0.02, 0, np.minimum(np.floor(best * 3) + 1, 3)).astype(int)
    return [SHADES[index] for index in level]


def legend(drawn: Container[str]) -> str:
    """Say what the marks mean that are drawn."""
    named = (
        (TAKEN, f"{TAKEN} at work"),
        (WAITING, f"{WAITING} goes on by itself"),
        (APPOINTMENT, f"{APPOINTMENT} time that is taken"),
    )
    told = [words for mark, words in named if mark in drawn]
    if any(shade in drawn for shade in SHADES.strip()):
        told.append(f"{SHADES.strip()} how well a start there would satisfy")
    return "  ".join(told)


def lane(function: SatisfactionFunction, start: float, end: float, done: float, window: Window) -> list[str]:
    """Draw one skill: ψ as shade, then what goes on by itself, then the time the agent is taken."""
    cells = shades(function, window)
    _fill(cells, WAITING, end, done, window)
    _fill(cells, TAKEN, start, end, window)
    return cells


def taken(spans: Sequence[tuple[float, float]], window: Window) -> list[str]:
    """Draw times that are taken."""
    cells = [" "] * window.columns
    for start, end in spans:
        _fill(cells, APPOINTMENT, start, end, window)
    return cells


def _fill(cells: list[str], mark: str, start: float, end: float, window: Window) -> None:
    """Mark the columns from start to end; a stretch shorter than a column still gets one."""
    if end < start or end <= window.start or start >= window.end or (end == start and mark != TAKEN):
        return
    first = max(0, window.column(start))
    last = min(window.columns - 1, max(first, window.column(end - 1e-9)))
    for column in range(first, last + 1):
        cells[column] = mark
