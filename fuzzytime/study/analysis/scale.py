"""Answers on a Likert scale in two groups: the control question (F2).

Differences are tested by Mann and Whitney's U. Their size is Cliff's delta, P(first > second) −
P(first < second), with his asymmetric interval, which stays inside [−1, 1] (N. Cliff, "Dominance
statistics", Psychological Bulletin 114, 1993; form as in Feng & Cliff, 2004).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from fuzzytime.errors import FuzzytimeError

FEW = 20
"""Below this many answers in a group a test misses all but large effects: reports then say so."""


@dataclass(frozen=True, slots=True)
class ScaleComparison:
    """Two groups' answers to one question.

    Parameters
    ----------
    first_mode, second_mode
        The most frequent answers; more than one where several are equally frequent.
    u
        Mann and Whitney's U of the first group.
    p_value
        Two-sided, corrected for ties and continuity.
    delta
        Cliff's delta, above 0 where the first group's answers are higher.
    interval
        Of delta, at 95 %.
    few
        Whether a group has fewer than `FEW` answers.
    """

    first_mode: tuple[int, ...]
    second_mode: tuple[int, ...]
    u: float
    p_value: float
    delta: float
    interval: tuple[float, float]
    few: bool


def compare_answers(first: Sequence[int], second: Sequence[int]) -> ScaleComparison:
    """Compare two groups' answers on one scale.

    Raises
    ------
    FuzzytimeError
        If a group has fewer than two answers.

    >>> compare_answers([1, 1, 2, 1], [3, 4, 2, 3]).delta
    -0.9375
    """
    if min(len(first), len(second)) < 2:
        raise FuzzytimeError(f"groups to compare need two answers each, got {len(first)} and {len(second)}")
    from scipy.stats import mannwhitneyu

    test = mannwhitneyu(first, second, alternative="two-sided", method="asymptotic")
    delta, interval = _cliff(np.asarray(first, float), np.asarray(second, float))
    return ScaleComparison(
        first_mode=modes(first),
        second_mode=modes(second),
        u=float(test.statistic),
        # Where everybody answers alike the statistic has no spread, and nothing speaks for a difference.
        p_value=float(np.nan_to_num(test.pvalue, nan=1.0)),
        delta=delta,
        interval=interval,
        few=min(len(first), len(second)) < FEW,
    )


def modes(answers: Sequence[int]) -> tuple[int, ...]:
    """Give the most frequent answers, ascending."""
    values, counts = np.unique(np.asarray(answers, int), return_counts=True)
    return tuple(values[counts == counts.max()].tolist())


def _cliff(first: np.ndarray, second: np.ndarray) -> tuple[float, tuple[float, float]]:
    """Delta, and its interval by the consistent estimate of its variance."""
    dominance = np.sign(first[:, None] - second[None, :])
    n, m = dominance.shape
    delta = float(dominance.mean())
    rows = ((dominance.mean(axis=1) - delta) ** 2).sum() / (n - 1)
    columns = ((dominance.mean(axis=0) - delta) ** 2).sum() / (m - 1)
    cells = ((dominance - delta) ** 2).sum() / (n * m - 1)
    spread = float(max(((m - 1) * rows + (n - 1) * columns + cells) / (n * m), (1 - delta**2) / (n * m - 1)))
    if abs(delta) == 1:
        # No pair contradicts the difference: the interval is that of a proportion without a failure.
        reach = 1 - 2 * (1 - 0.025 ** (1 / min(n, m)))
        return delta, (reach, 1.0) if delta > 0 else (-1.0, -reach)
    z = 1.959964
    centre, half = delta - delta**3, z * spread**0.5 * ((1 - delta**2) ** 2 + z**2 * spread) ** 0.5
    whole = 1 - delta**2 + z**2 * spread
    return delta, (max(float(centre - half) / whole, -1.0), min(float(centre + half) / whole, 1.0))
