"""One instruction over everybody, or over one group: what was drawn, and what it amounts to."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from fuzzytime.satisfaction import Floats
from fuzzytime.study.analysis.characteristics import Characteristics, characterise
from fuzzytime.study.analysis.density import Flanks, flanks, variance
from fuzzytime.study.analysis.fitting import Fit, Model, fit_models
from fuzzytime.study.analysis.subgroups import Subgroups, subgroups
from fuzzytime.study.answers.subjective import SubjectiveSatisfaction
from fuzzytime.study.asking.questions import StudyInstruction


@dataclass(frozen=True)
class Described:
    """One instruction over everybody, or over one group: what was drawn, and what it amounts to."""

    instruction: StudyInstruction
    group: str | None
    subjective: SubjectiveSatisfaction

    @cached_property
    def characteristics(self) -> Characteristics:
        """Pointwise characteristic values."""
        return characterise(self.subjective)

    @property
    def median(self) -> Floats:
        """The median curve, of shape (k,)."""
        return self.characteristics.median

    @cached_property
    def fits(self) -> Mapping[Model, Fit]:
        """Fits to the median, by model; none where it is 0 everywhere. Of a group only the trapezoid."""
        if not self.median.any():
            return {}
        models = tuple(Model) if self.group is None else (Model.TRAPEZOID,)
        return fit_models(self.subjective.times, self.median, models)

    @cached_property
    def variance(self) -> float:
        """Variance of the median as a density, in seconds²; NaN where it is 0 everywhere."""
        return float(variance(self.subjective.times, self.median))

    @cached_property
    def flanks(self) -> Flanks:
        """Mean absolute gradients of the median's flanks."""
        if not self.median.any():
            return Flanks(float("nan"), float("nan"))
        return flanks(self.subjective.times, self.median)

    @cached_property
    def subgroups(self) -> Subgroups:
        """The best split of the participants into two."""
        return subgroups(self.subjective)
