"""Characteristic values of Ψ_I: at each time, what the participants' satisfactions are like (III-C.1)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.satisfaction import Floats
from fuzzytime.study.answers.subjective import SubjectiveSatisfaction

BINS = 21
"""Bins over satisfaction, centred on 0, 0.05, … 1: nobody draws finer, and 0 and 1 have bins of their own."""


@dataclass(frozen=True, slots=True, eq=False)
class Characteristics:
    """What is characteristic of Ψ_I at each time; every array has the shape (k,).

    Parameters
    ----------
    times
        Seconds.
    mean, median, mode
        Three ways to one ψ. The mode is the most frequent satisfaction, by `histogram`.
    deviation
        Standard deviation (of the sample; 0 for one participant): how much people disagree.
    minimum, lower_quartile, upper_quartile, maximum
        Quantiles 0, ¼, ¾ and 1, interpolated linearly.
    skew, kurtosis
        Standardised third and fourth moment, the latter less 3; NaN where all agree.
    """

    times: Floats
    mean: Floats
    median: Floats
    mode: Floats
    deviation: Floats
    minimum: Floats
    lower_quartile: Floats
    upper_quartile: Floats
    maximum: Floats
    skew: Floats
    kurtosis: Floats

    @property
    def disagreement(self) -> float:
        """Mean deviation over the times at which anybody is satisfied at all; 0 where nobody ever is."""
        drawn = self.maximum > 0
        return float(self.deviation[drawn].mean()) if drawn.any() else 0.0


def characterise(subjective: SubjectiveSatisfaction) -> Characteristics:
    """Determine the characteristic values of Ψ_I.

    Parameters
    ----------
    subjective : SubjectiveSatisfaction
        Values of shape (participants, k).

    Returns
    -------
    Characteristics
        Arrays of shape (k,).
    """
    values = subjective.values
    mean = values.mean(axis=0)
    centred = values - mean
    second = (centred**2).mean(axis=0)
    # Rounding leaves 1e-33 where all agree: no moment is to be divided by that.
    spread = np.where(second > 1e-18, second, np.nan)
    count = subjective.participants
    quantiles = np.quantile(values, [0.0, 0.25, 0.75, 1.0], axis=0)
    return Characteristics(
        times=subjective.times,
        mean=mean,
        median=subjective.median,
        mode=_mode(subjective),
        deviation=np.sqrt(second * count / max(count - 1, 1)),
        minimum=quantiles[0],
        lower_quartile=quantiles[1],
        upper_quartile=quantiles[2],
        maximum=quantiles[3],
        skew=(centred**3).mean(axis=0) / spread**1.5,
        kurtosis=(centred**4).mean(axis=0) / spread**2 - 3,
    )


def histogram(subjective: SubjectiveSatisfaction, bins: int = BINS) -> Floats:
    """Count participants over time and satisfaction: the third dimension of Ψ_I.

    Parameters
    ----------
    subjective : SubjectiveSatisfaction
        Values of shape (participants, k).
    bins : int
        Bins over satisfaction, with centres i / (bins − 1) for i = 0 … bins − 1.

    Returns
    -------
    array of shape (bins, k)
        Counts; each column sums to the number of participants.
    """
    cells = _cells(subjective.values, bins)
    return np.asarray((cells[None] == np.arange(bins)[:, None, None]).sum(axis=1), float)


def _cells(values: ArrayLike, bins: int) -> np.ndarray[tuple[int, ...], np.dtype[np.int64]]:
    return np.floor(np.asarray(values, float) * (bins - 1) + 0.5).astype(np.int64)


def _mode(subjective: SubjectiveSatisfaction) -> Floats:
    """Median of the values in the fullest bin; among bins equally full, the one nearest the median."""
    counts = histogram(subjective)
    centres = np.linspace(0.0, 1.0, BINS)[:, None]
    # A distance is at most 1, so that half of it never outweighs a count.
    fullest = np.argmax(counts - 0.5 * np.abs(centres - subjective.median), axis=0)
    inside = np.where(_cells(subjective.values, BINS) == fullest, subjective.values, np.nan)
    return np.asarray(np.nanmedian(inside, axis=0))
