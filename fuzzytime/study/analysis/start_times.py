"""How the instructed start time influences a satisfaction function (F3): variance over t_spec."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Floats
from fuzzytime.study.analysis.density import variance
from fuzzytime.study.answers.subjective import SubjectiveSatisfaction


@dataclass(frozen=True, slots=True, eq=False)
class StartTimeInfluence:
    """Variances of median curves over the times that their instructions specify; arrays of shape (m,).

    Parameters
    ----------
    t_spec
        Seconds, ascending.
    variances
        Seconds².
    growth
        Slope of the straight line through the standard deviations, in seconds per second: how much the
        tolerance widens with the time to wait.
    """

    t_spec: Floats
    variances: Floats
    growth: float

    @property
    def ratio(self) -> float:
        """Variance at the latest time over that at the earliest."""
        return float(self.variances[-1] / self.variances[0])

    @property
    def increasing(self) -> bool:
        """Whether each variance is larger than the one before."""
        return bool((np.diff(self.variances) > 0).all())


def influence_of_start_times(
    t_spec: ArrayLike, subjective: Sequence[SubjectiveSatisfaction]
) -> StartTimeInfluence:
    """Relate the variance of the median curve to the specified start time.

    Parameters
    ----------
    t_spec : array of shape (m,), m ≥ 2
        Seconds, in the order of ``subjective``.
    subjective : sequence of SubjectiveSatisfaction
        One for each time, for otherwise equal instructions.

    Raises
    ------
    FuzzytimeError
        If there are fewer than two times, their number does not fit, or two are equal.
    """
    times = np.asarray(t_spec, float)
    if times.ndim != 1 or times.size < 2 or times.size != len(subjective):
        raise FuzzytimeError(
            f"start times need two instructions or more, got {times.size} times for {len(subjective)}"
        )
    order = np.argsort(times)
    if (np.diff(times[order]) == 0).any():
        raise FuzzytimeError("start times to compare must differ")
    variances = np.array([float(variance(drawn.times, drawn.median)) for drawn in subjective])[order]
    growth = float(np.polyfit(times[order], np.sqrt(variances), 1)[0])
    return StartTimeInfluence(times[order], variances, growth)
