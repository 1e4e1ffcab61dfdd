"""Everything that a study says, from one set of answers: Ψ_I, and the paper's questions F1, F2 and F3."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Floats, Trapezoid
from fuzzytime.study.answers import Answers
from fuzzytime.study.characteristics import Characteristics, characterise
from fuzzytime.study.compare import PERMUTATIONS, Comparison, compare
from fuzzytime.study.density import Flanks, flanks, variance
from fuzzytime.study.fitting import Fit, Model, fit, fit_models
from fuzzytime.study.questions import StudyInstruction
from fuzzytime.study.scale import ScaleComparison, compare_answers
from fuzzytime.study.start_times import StartTimeInfluence, influence_of_start_times
from fuzzytime.study.subgroups import Subgroups, subgroups
from fuzzytime.study.subjective import SubjectiveSatisfaction

Intervals = tuple[tuple[float, float], ...]
"""Low and high ends, one pair for each corner."""

BYTES = 8
"""What one number takes in memory."""


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


@dataclass(frozen=True, slots=True)
class PrepositionModels:
    """F1 for one preposition: how well each model fits its instructions, and where the plateau lies.

    Parameters
    ----------
    errors
        The smallest and the largest prediction error, by model.
    best
        How often the trapezoid's error is below the bell's, of how many instructions.
    encloses
        How often the trapezoid's plateau contains the specified time.
    left_edges
        Seconds from the specified time to the start of the plateau, where its rise is on the timeline.
    left, right
        Means over the instructions of the fitted flanks' absolute gradients, per second; NaN where there is
        none. `Described.flanks` measures the medians themselves, which are as steep as the sampling at most.
    """

    preposition: str
    errors: Mapping[Model, tuple[float, float]]
    best: tuple[int, int]
    encloses: int
    left_edges: tuple[float, ...]
    left: float
    right: float


@dataclass(frozen=True, slots=True)
class Memory:
    """What one plan's satisfaction functions take: n skills by samples O(n·k), by a fit O(n)."""

    samples: int
    parameters: int

    @property
    def sampled_bytes(self) -> int:
        """Bytes for one discretised function."""
        return self.samples * BYTES

    @property
    def fitted_bytes(self) -> int:
        """Bytes for the same as a trapezoid."""
        return self.parameters * BYTES


@dataclass(frozen=True, slots=True)
class Analysis:
    """What a study says.

    Parameters
    ----------
    answers
        The answers behind it.
    overall
        Each instruction over everybody who counts, by key.
    by_group
        The same over each group.
    models
        F1, by preposition.
    compared
        The two groups in the order in which they are compared: the design's second, then its first.
    comparison, scale
        F2: variances, and answers to the control question. None where a group is too small.
    start_times
        F3 over everybody (None) and each group; empty where fewer than two times were asked.
    intervals
        95 % intervals of the trapezoids' corners by key, in seconds; empty where none were asked for.
    """

    answers: Answers
    overall: Mapping[str, Described]
    by_group: Mapping[str, Mapping[str, Described]]
    models: Mapping[str, PrepositionModels]
    compared: tuple[str, str] | None
    comparison: Comparison | None
    scale: ScaleComparison | None
    start_times: Mapping[str | None, StartTimeInfluence]
    intervals: Mapping[str, Intervals]

    @property
    def memory(self) -> Memory:
        """What a discretised function takes against a fitted one."""
        return Memory(self.answers.design.timeline.samples, 4)

    @property
    def divergent(self) -> tuple[str, ...]:
        """The instructions in which two subgroups describe the participants clearly better than one."""
        return tuple(key for key, described in self.overall.items() if described.subgroups.divergent)


def analyse(
    answers: Answers, *, permutations: int = PERMUTATIONS, resamples: int = 0, seed: int = 0
) -> Analysis:
    """Analyse a study.

    Parameters
    ----------
    answers : Answers
        At least one participant who counts.
    permutations : int
        Of the test between groups.
    resamples : int
        Of the bootstrap that gives corners their intervals; 0 gives none.
    seed : int
        Of both.

    Raises
    ------
    FuzzytimeError
        If nobody counts, or there are fewer than 20 resamples.
    """
    overall = _described(answers, None)
    groups = [group for group in answers.design.groups if answers.members(group)]
    by_group = {group: _described(answers, group) for group in groups}
    compared = (groups[1], groups[0]) if len(groups) == 2 else None
    return Analysis(
        answers=answers,
        overall=overall,
        by_group=by_group,
        models={
            preposition: _models(preposition, chosen) for preposition, chosen in _by_preposition(overall)
        },
        compared=compared,
        comparison=_compared(answers, compared, permutations, seed),
        scale=_scale(answers, compared),
        start_times={**_start_times(None, overall), **_of_groups(by_group)},
        intervals={
            key: corner_intervals(described, resamples=resamples, seed=seed)
            for key, described in overall.items()
            if resamples and described.median.any()
        },
    )


def _described(answers: Answers, group: str | None) -> dict[str, Described]:
    drawn = answers.subjective(group)
    return {entry.key: Described(entry, group, drawn[entry.key]) for entry in answers.design.instructions}


def _by_preposition(described: Mapping[str, Described]) -> list[tuple[str, list[Described]]]:
    names = dict.fromkeys(entry.instruction.preposition for entry in described.values())
    return [
        (name, [entry for entry in described.values() if entry.instruction.preposition == name])
        for name in names
    ]


def _models(preposition: str, chosen: Sequence[Described]) -> PrepositionModels:
    fitted = [entry for entry in chosen if entry.fits]
    errors = {
        model: (
            min((entry.fits[model].sse for entry in fitted), default=float("nan")),
            max((entry.fits[model].sse for entry in fitted), default=float("nan")),
        )
        for model in Model
    }
    better = sum(entry.fits[Model.TRAPEZOID].sse <= entry.fits[Model.BELL].sse for entry in fitted)
    encloses, edges = 0, []
    rises: list[float] = []
    falls: list[float] = []
    for entry in fitted:
        function, t_spec = entry.fits[Model.TRAPEZOID].function, entry.instruction.t_spec
        if isinstance(function, Trapezoid):
            step = float(np.diff(entry.subjective.times).max())
            encloses += function.full_start - step <= t_spec <= function.full_end + step
            if function.rise_start < function.full_start:
                edges.append(function.full_start - t_spec)
                rises.append(1 / (function.full_start - function.rise_start))
            if function.full_end < function.fall_end:
                falls.append(1 / (function.fall_end - function.full_end))
    return PrepositionModels(
        preposition=preposition,
        errors=errors,
        best=(better, len(fitted)),
        encloses=encloses,
        left_edges=tuple(edges),
        left=float(np.mean(rises)) if rises else float("nan"),
        right=float(np.mean(falls)) if falls else float("nan"),
    )


def _compared(
    answers: Answers, compared: tuple[str, str] | None, permutations: int, seed: int
) -> Comparison | None:
    if compared is None or min(len(answers.members(group)) for group in compared) < 2:
        return None
    first, second = (list(answers.subjective(group).values()) for group in compared)
    if any(not drawn.median.any() for drawn in (*first, *second)):
        return None
    return compare(first, second, permutations=permutations, seed=seed)


def _scale(answers: Answers, compared: tuple[str, str] | None) -> ScaleComparison | None:
    if compared is None:
        return None
    first, second = (
        [person.control for person in answers.members(group) if person.control is not None]
        for group in compared
    )
    return compare_answers(first, second) if min(len(first), len(second)) >= 2 else None


def _of_groups(
    by_group: Mapping[str, Mapping[str, Described]],
) -> dict[str | None, StartTimeInfluence]:
    found: dict[str | None, StartTimeInfluence] = {}
    for group, described in by_group.items():
        found |= _start_times(group, described)
    return found


def _start_times(
    group: str | None, described: Mapping[str, Described]
) -> dict[str | None, StartTimeInfluence]:
    """Relate the instructions with "in", or else the first preposition, that have no hedge."""
    plain = [
        entry for entry in described.values() if entry.instruction.fuzziness is None and entry.median.any()
    ]
    names = [entry.instruction.preposition for entry in plain]
    name = "in" if "in" in names else names[0] if names else ""
    chosen = {
        entry.instruction.t_spec: entry.subjective for entry in plain if entry.instruction.preposition == name
    }
    if len(chosen) < 2:
        return {}
    return {group: influence_of_start_times([*chosen], [*chosen.values()])}


def corner_intervals(described: Described, *, resamples: int = 200, seed: int = 0) -> Intervals:
    """Give 95 % bootstrap intervals of the fitted trapezoid's corners, in seconds.

    Participants are drawn with replacement, and the trapezoid is fitted to each sample's median.

    Raises
    ------
    FuzzytimeError
        If there are fewer than 20 resamples, or the median is 0 everywhere.
    """
    if resamples < 20:
        raise FuzzytimeError(f"an interval needs at least 20 resamples, got {resamples}")
    if not described.median.any():
        raise FuzzytimeError("a median that is 0 everywhere has no corners")
    generator = np.random.default_rng(seed)
    corners = []
    for _ in range(resamples):
        rows = generator.integers(0, described.subjective.participants, described.subjective.participants)
        median = described.subjective.chosen(rows).median
        if not median.any():
            continue
        function = fit(described.subjective.times, median, Model.TRAPEZOID, starts=1).function
        if isinstance(function, Trapezoid):
            corners.append(function.corners)
    low, high = np.quantile(np.array(corners), [0.025, 0.975], axis=0)
    return tuple(zip(low.tolist(), high.tolist(), strict=True))
