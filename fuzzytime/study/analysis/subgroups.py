"""Whether participants' expectations fall apart into two groups (the paper's III-C.1).

Curves are compared by the area between them. The best two medoids are found by trying all pairs, and the
split is judged by its silhouette: its mean is above 0.7 where "a strong structure has been found" (Kaufman &
Rousseeuw, "Finding Groups in Data", 1990). One broad group stays below: evenly spread widths give about 0.6.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from fuzzytime.satisfaction import Floats
from fuzzytime.study.answers.subjective import SubjectiveSatisfaction

STRONG = 0.7
"""The mean silhouette from which on two groups are clearly better than one."""

SMALLEST_SHARE = 0.1
"""The share of participants that a subgroup needs; below, they are outliers."""


@dataclass(frozen=True, slots=True, eq=False)
class Subgroups:
    """The best split of participants into two.

    Parameters
    ----------
    second
        Mask of shape (participants,): who belongs to the second, smaller one.
    silhouette
        Mean silhouette of the split, in [−1, 1]; 0 where all curves are equal or there are fewer than four.
    """

    second: NDArray[np.bool_]
    silhouette: float

    @property
    def divergent(self) -> bool:
        """Whether two subgroups describe the participants clearly better than one."""
        share = float(self.second.mean())
        return self.silhouette >= STRONG and share >= SMALLEST_SHARE and int(self.second.sum()) > 1


def subgroups(subjective: SubjectiveSatisfaction) -> Subgroups:
    """Find the best split of Ψ_I into two subgroups.

    Parameters
    ----------
    subjective : SubjectiveSatisfaction
        Values of shape (participants, k).
    """
    count = subjective.participants
    distances = _areas_between(subjective)
    if count < 4 or not distances.any():
        return Subgroups(np.zeros(count, bool), 0.0)
    # For each first medoid: the cost with every second one.
    costs = np.array([np.minimum(distances, distances[:, [medoid]]).sum(axis=0) for medoid in range(count)])
    one, other = np.unravel_index(int(np.argmin(costs)), costs.shape)
    second = distances[:, other] < distances[:, one]
    if second.sum() * 2 > count:
        second = ~second
    return Subgroups(second, _silhouette(distances, second))


def _areas_between(subjective: SubjectiveSatisfaction) -> Floats:
    weight = np.gradient(subjective.times)
    values = subjective.values
    return np.array([np.abs(values - row) @ weight for row in values])


def _silhouette(distances: Floats, second: NDArray[np.bool_]) -> float:
    """Give the mean of (b − a) / max(a, b): distance to the other group against that within one's own."""
    own = second[:, None] == second[None, :]
    sizes = own.sum(axis=1)
    if (sizes == second.size).any():
        return 0.0
    within = (distances * own).sum(axis=1) / np.maximum(sizes - 1, 1)
    across = (distances * ~own).sum(axis=1) / (second.size - sizes)
    larger = np.maximum(np.maximum(within, across), 1e-300)
    # Somebody alone in a group has no distance within: by convention 0.
    return float(np.where(sizes > 1, (across - within) / larger, 0.0).mean())
