"""Two groups compared: how broad their median curves are, and what they answer on a scale (F2).

Broadness is the variance of a group's median curve as a density. Whether it differs is tested by permuting
who belongs to which group: that holds at any size of group and for any shape of curve.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Floats
from fuzzytime.study.analysis.density import moment_weights, variance_of_moments
from fuzzytime.study.answers.subjective import SubjectiveSatisfaction

PERMUTATIONS = 999
"""Permutations of a test unless others are asked for: its smallest p-value is 0.001."""


@dataclass(frozen=True, slots=True, eq=False)
class Comparison:
    """Variances of two groups' median curves over the same instructions; arrays of shape (instructions,).

    Parameters
    ----------
    first, second
        Variances in seconds².
    p_values
        Of each instruction's difference, two-sided, adjusted for their number after Holm.
    p_value
        Of all differences together: of their sum, each in units of its own standard deviation under
        permutation, which finds groups that differ alike everywhere, and of the least probable of them, which
        finds groups that differ in one instruction or here one way and there the other. The less probable of
        the two counts, against the less probable of the two in every permutation.
    """

    first: Floats
    second: Floats
    p_values: Floats
    p_value: float

    @property
    def differences(self) -> Floats:
        """First less second, in seconds²."""
        return self.first - self.second

    @property
    def mean_difference(self) -> float:
        """Mean over the instructions, in seconds²."""
        return float(self.differences.mean())


def compare(
    first: Sequence[SubjectiveSatisfaction],
    second: Sequence[SubjectiveSatisfaction],
    *,
    permutations: int = PERMUTATIONS,
    seed: int = 0,
) -> Comparison:
    """Compare two groups of participants over the same instructions.

    Parameters
    ----------
    first, second : sequences of SubjectiveSatisfaction
        One for each instruction, in the same order; within a group, row i is always the same participant.
    permutations : int
        How many random exchanges of participants between the groups.
    seed : int
        Of the exchanges.

    Raises
    ------
    FuzzytimeError
        If the groups' instructions, times or rows do not correspond, or a group's median is 0 everywhere.
    """
    _check(first, second)
    medians = _Medians.of(first, second)
    people = medians.participants
    observed = medians.variances(np.arange(people))
    if np.isnan(observed).any():
        raise FuzzytimeError("a group's median curve must be above 0 somewhere, or it has no variance")
    generator = np.random.default_rng(seed)
    exchanged = np.empty((permutations, len(first)))
    for row in range(permutations):
        exchanged[row] = np.subtract(*medians.variances(generator.permutation(people)))
    difference = observed[0] - observed[1]
    spread = np.nanstd(exchanged, axis=0) if permutations else np.ones_like(difference)
    spread = np.where(spread > 0, spread, np.inf)
    # A median that is 0 everywhere has no variance: such an exchange counts as one without a difference.
    null = np.nan_to_num(exchanged) / spread
    return Comparison(
        first=observed[0],
        second=observed[1],
        p_values=_holm(_extreme(np.abs(null), np.abs(difference / spread))),
        p_value=_together(np.vstack([difference / spread, null])),
    )


def _together(standardised: Floats) -> float:
    """Give the p-value over all instructions; the first row is the observed one, the others permutations."""
    alike = _share_as_extreme(np.abs(standardised.sum(axis=1)))
    single = np.stack([_share_as_extreme(column) for column in np.abs(standardised).T]).min(axis=0)
    least = np.minimum(alike, _share_as_extreme(-single))
    return float((least <= least[0] + 1e-12).mean())


def _share_as_extreme(statistic: Floats) -> Floats:
    """Give for each value the share of all values that are at least as large."""
    return np.asarray(1 - np.searchsorted(np.sort(statistic), statistic - 1e-12) / statistic.size)


def _check(first: Sequence[SubjectiveSatisfaction], second: Sequence[SubjectiveSatisfaction]) -> None:
    if not first or len(first) != len(second):
        raise FuzzytimeError(
            f"groups must have the same instructions, got {len(first)} and {len(second)} of them"
        )
    for group in (first, second):
        for subjective in group:
            if not np.array_equal(subjective.times, first[0].times):
                raise FuzzytimeError("all instructions must be sampled at the same times")
            if subjective.participants != group[0].participants:
                raise FuzzytimeError(
                    "within a group every instruction needs the same participants, "
                    f"got {group[0].participants} and {subjective.participants}"
                )


@dataclass(frozen=True, slots=True, eq=False)
class _Medians:
    """Everyone's satisfactions, laid out so that the variances of two groups' medians come quickly.

    Only samples at which enough people draw something for a group's median to be above 0 are kept, those of
    all instructions side by side: ``values`` has the shape (participants, samples), ``weights`` (samples, 3).
    ``starts`` says where each instruction's samples begin, ``split`` how many people are in the first group.
    """

    values: Floats
    weights: Floats
    starts: tuple[int, ...]
    split: int

    @classmethod
    def of(
        cls, first: Sequence[SubjectiveSatisfaction], second: Sequence[SubjectiveSatisfaction]
    ) -> "_Medians":
        enough = min(first[0].participants, second[0].participants) // 2
        every_weight = moment_weights(first[0].times)
        values, weights, starts = [], [], [0]
        for one, other in zip(first, second, strict=True):
            together = np.concatenate([one.values, other.values])
            kept = (together > 0).sum(axis=0) >= max(enough, 1)
            kept[0] = True  # Every instruction keeps a sample, so that sums over its samples exist.
            values.append(together[:, kept])
            weights.append(every_weight[kept])
            starts.append(starts[-1] + int(kept.sum()))
        return cls(np.hstack(values), np.vstack(weights), tuple(starts[:-1]), first[0].participants)

    @property
    def participants(self) -> int:
        return len(self.values)

    def variances(self, order: NDArray[np.int64]) -> Floats:
        """Variances of shape (2, instructions), the first group being the first people in an order."""
        groups = (order[: self.split], order[self.split :])
        medians = np.stack([_median(self.values[rows]) for rows in groups])
        moments = np.add.reduceat(medians[..., None] * self.weights, self.starts, axis=1)
        return variance_of_moments(moments)


def _median(values: Floats) -> Floats:
    """Give the median over the first axis; a whole sort of few rows beats the selection that NumPy's does."""
    ordered = np.sort(values, axis=0)
    count = ordered.shape[0]
    return np.asarray((ordered[(count - 1) // 2] + ordered[count // 2]) / 2)


def _extreme(null: Floats, observed: Floats) -> Floats:
    """Give the share of permutations at least as extreme, the observed arrangement among them."""
    return np.asarray(((null >= observed - 1e-12).sum(axis=0) + 1) / (null.shape[0] + 1))


def _holm(p_values: Floats) -> Floats:
    order = np.argsort(p_values)
    raised = p_values[order] * np.arange(p_values.size, 0, -1)
    adjusted = np.empty_like(p_values)
    adjusted[order] = np.minimum(np.maximum.accumulate(raised), 1.0)
    return adjusted
