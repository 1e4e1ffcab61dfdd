"""An independent optimiser for small tasks: every accepted set in every order, timed over a common lattice.

It shares no code with the solvers. With s_k = t_k − (durations before k) the s_k of an order do not decrease;
over a lattice of s that holds all corners less all sums of durations, and fine steps between, dynamic
programming finds the best timing of an order to within the steps.
"""

import itertools
import math

import numpy as np

from fuzzytime.skills import FuzzyTask


def best_cost(task: FuzzyTask, threshold: float, step: float = 0.25) -> float:
    """Give the least Σ −priority·log max(ψ, ε) for one agent; precedences without lags are kept."""
    count = len(task.skills)
    lattice = _lattice(task, step)
    rejection = [-skill.priority * math.log(threshold) for skill in task.skills]
    for index, skill in enumerate(task.skills):
        if float(skill.satisfaction(math.inf)) > threshold:
            rejection[index] = -skill.priority * math.log(float(skill.satisfaction(math.inf)))
    best = math.inf
    for size in range(count + 1):
        for order in itertools.permutations(range(count), size):
            if _keeps(task, order):
                left_out = math.fsum(rejection[index] for index in range(count) if index not in order)
                best = min(best, left_out + _timed(task, order, lattice, threshold))
    return best


def _keeps(task: FuzzyTask, order: tuple[int, ...]) -> bool:
    place = {index: rank for rank, index in enumerate(order)}
    return all(
        entry.second not in place or place.get(entry.first, math.inf) < place[entry.second]
        for entry in task.precedences
    )


def _lattice(task: FuzzyTask, step: float) -> np.ndarray:
    corners = {0.0} | {entry.end for entry in task.busy}
    sums = {0.0}
    for skill in task.skills:
        corners |= {kink for kink in skill.satisfaction.kinks if math.isfinite(kink)}
        corners |= {entry.start - skill.duration for entry in task.busy}
        sums |= {total + skill.duration for total in sums}
    exact = np.array([corner - total for corner in corners for total in sums])
    reach = max(corners) + max(sums)
    return np.unique(np.concatenate([np.arange(-max(sums), reach, step), exact]))


def _timed(task: FuzzyTask, order: tuple[int, ...], lattice: np.ndarray, threshold: float) -> float:
    best = np.zeros(lattice.size)
    before = 0.0
    for index in order:
        skill = task.skills[index]
        start = _on_corners(lattice + before, task, index)
        value = skill.satisfaction(start)
        allowed = (start >= 0) & (value > threshold)
        for entry in task.busy:
            allowed &= (start <= entry.start - skill.duration) | (start >= entry.end)
        with np.errstate(divide="ignore"):
            cost = np.where(allowed, -skill.priority * np.log(value), np.inf)
        best = np.minimum.accumulate(best + cost)
        before += skill.duration
    return float(best[-1])


def _on_corners(times: np.ndarray, task: FuzzyTask, index: int) -> np.ndarray:
    """Corners less sums of durations, plus those durations again, differ from corners by rounding."""
    skill = task.skills[index]
    corners = np.unique(
        [0.0, *skill.satisfaction.kinks]
        + [entry.end for entry in task.busy]
        + [entry.start - skill.duration for entry in task.busy]
    )
    place = np.clip(np.searchsorted(corners, times - 1e-9), 0, corners.size - 1)
    return np.where(np.abs(corners[place] - times) <= 1e-9, corners[place], times)
