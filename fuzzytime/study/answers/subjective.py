"""Ψ_I: what several people said, each by a whole function, about one instruction (the paper's III-C)."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Floats, Sampled, SatisfactionFunction


@dataclass(frozen=True, slots=True, eq=False)
class SubjectiveSatisfaction:
    """The satisfaction functions that participants drew for one instruction, at common times.

    Parameters
    ----------
    times : array of shape (k,)
        Seconds from when the instruction was given, ascending, k ≥ 2.
    values : array of shape (participants, k)
        Satisfactions in [0, 1], one row for each participant, at least one row.

    Raises
    ------
    FuzzytimeError
        If the shapes do not fit or the numbers break these rules.

    >>> drawn = SubjectiveSatisfaction([0, 60, 120], [[0, 1, 0], [0, 0.5, 1]])
    >>> drawn.participants, drawn.median.tolist()
    (2, [0.0, 0.75, 0.5])
    """

    times: Floats
    values: Floats

    def __post_init__(self) -> None:
        times, values = np.array(self.times, float), np.array(self.values, float)
        if times.ndim != 1 or times.size < 2:
            raise FuzzytimeError(f"times must have the shape (k,) with k ≥ 2, got {times.shape}")
        if values.ndim != 2 or values.shape[1] != times.size or not values.shape[0]:
            raise FuzzytimeError(
                f"values need the shape (participants, {times.size}) with a participant, got {values.shape}"
            )
        if not np.isfinite(times).all() or (np.diff(times) <= 0).any():
            raise FuzzytimeError("times must be finite and must ascend")
        if not ((values >= 0) & (values <= 1)).all():
            raise FuzzytimeError(
                f"satisfactions must lie in [0, 1], got {values.min():g} to {values.max():g}"
            )
        times.flags.writeable = values.flags.writeable = False
        object.__setattr__(self, "times", times)
        object.__setattr__(self, "values", values)

    @classmethod
    def of(cls, functions: Iterable[SatisfactionFunction], times: ArrayLike) -> "SubjectiveSatisfaction":
        """Evaluate satisfaction functions at common times."""
        at = np.asarray(times, float)
        return cls(at, np.array([function(at) for function in functions]).reshape(-1, at.size))

    @property
    def participants(self) -> int:
        """How many people drew."""
        return len(self.values)

    @property
    def median(self) -> Floats:
        """The pointwise median, of shape (k,): the function that the paper generalises by."""
        return np.asarray(np.median(self.values, axis=0))

    def chosen(self, rows: ArrayLike) -> "SubjectiveSatisfaction":
        """Give the rows of some participants, by positions or by a mask of shape (participants,)."""
        return SubjectiveSatisfaction(self.times, self.values[np.asarray(rows)])

    def function(self, row: int) -> Sampled:
        """Give one participant's ψ, linear between the samples."""
        return Sampled(self.times, self.values[row])
