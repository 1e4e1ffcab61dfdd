"""Everything that a study says, from one set of answers: Ψ_I, and the paper's questions F1, F2 and F3."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Trapezoid
from fuzzytime.study.analysis.compare import PERMUTATIONS, Comparison, compare
from fuzzytime.study.analysis.described import Described
from fuzzytime.study.analysis.fitting import Model, fit
from fuzzytime.study.analysis.prepositions import PrepositionModels, models_by_preposition
from fuzzytime.study.analysis.scale import ScaleComparison, compare_answers
from fuzzytime.study.analysis.start_times import StartTimeInfluence, influence_of_start_times
from fuzzytime.study.answers.participants import Answers

Intervals = tuple[tuple[float, float], ...]
"""Low and high ends, one pair for each corner."""

FEWEST_RESAMPLES = 20
"""From fewer medians of resamples nobody can read off 95 %."""

BYTES = 8
"""What one number takes in memory."""


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
        F3 over everybody (None), and each of several groups; empty where fewer than two times were asked.
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
    def poor(self) -> tuple[str, ...]:
        """The instructions whose medians no trapezoid fits well."""
        return tuple(
            key
            for key, described in self.overall.items()
            if described.fits and described.fits[Model.TRAPEZOID].poor
        )

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
        If nobody counts, or there are resamples and fewer than `FEWEST_RESAMPLES`.
    """
    overall = _described(answers, None)
    groups = [group for group in answers.design.groups if answers.members(group)]
    by_group = {group: _described(answers, group) for group in groups}
    compared = (groups[1], groups[0]) if len(groups) == 2 else None
    return Analysis(
        answers=answers,
        overall=overall,
        by_group=by_group,
        models=models_by_preposition(overall.values()),
        compared=compared,
        comparison=_compared(answers, compared, permutations, seed),
        scale=_scale(answers, compared),
        start_times={**_start_times(None, overall), **(_of_groups(by_group) if len(groups) > 1 else {})},
        intervals={
            key: corner_intervals(described, resamples=resamples, seed=seed)
            for key, described in overall.items()
            if resamples and described.median.any()
        },
    )


def _described(answers: Answers, group: str | None) -> dict[str, Described]:
    drawn = answers.subjective(group)
    return {entry.key: Described(entry, group, drawn[entry.key]) for entry in answers.design.instructions}


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
        If there are fewer than `FEWEST_RESAMPLES`, or the median is 0 everywhere.
    """
    if resamples < FEWEST_RESAMPLES:
        raise FuzzytimeError(f"an interval needs at least {FEWEST_RESAMPLES} resamples, got {resamples}")
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
