"""F1: which continuous functions model what people mean by a preposition."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from fuzzytime.satisfaction import Trapezoid
from fuzzytime.study.analysis.described import Described
from fuzzytime.study.analysis.fitting import Model


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


def models_by_preposition(described: Iterable[Described]) -> dict[str, PrepositionModels]:
    """Answer F1 for each preposition, in the order in which they first occur."""
    by_preposition: dict[str, list[Described]] = {}
    for entry in described:
        by_preposition.setdefault(entry.instruction.preposition, []).append(entry)
    return {name: _models(name, chosen) for name, chosen in by_preposition.items()}


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
