"""An analysis as JSON: every number of the report.

Times are in seconds, variances in min², gradients per minute.
"""

from collections.abc import Mapping

import numpy as np

from fuzzytime.satisfaction import Floats
from fuzzytime.study.analysis.analyse import Analysis
from fuzzytime.study.analysis.density import SQUARE_MINUTE
from fuzzytime.study.analysis.described import Described
from fuzzytime.study.analysis.fitting import Fit
from fuzzytime.study.analysis.prepositions import PrepositionModels
from fuzzytime.study.analysis.start_times import StartTimeInfluence
from fuzzytime.times import MINUTE

SCHEMA = "fuzzytime-study-analysis/1"

Json = object
"""None, a boolean, a number, a text, or a list or mapping of such."""


def numbers(analysis: Analysis, *, curves: bool = True) -> dict[str, Json]:
    """Give an analysis as a document that JSON can hold; what is not defined is null.

    Parameters
    ----------
    curves : bool
        Whether to include the pointwise characteristic values, most of the document's size.
    """
    answers = analysis.answers
    return {
        "schema": SCHEMA,
        "study": answers.design.name,
        "participants": {
            "counted": len(answers.counted),
            "groups": {group: len(answers.members(group)) for group in answers.design.groups},
            "set_aside": [{"participant": e.name, "reason": e.reason} for e in answers.set_aside],
        },
        "times_s": _list(answers.design.timeline.times) if curves else [],
        "instructions": {
            key: {
                **_described(described, curves=curves),
                "groups": {
                    group: _described(entries[key], curves=False)
                    for group, entries in analysis.by_group.items()
                },
            }
            for key, described in analysis.overall.items()
        },
        "f1": {name: _models(found) for name, found in analysis.models.items()},
        "f2": _groups(analysis),
        "f3": {group or "all": _start_times(found) for group, found in analysis.start_times.items()},
        "corner_intervals_s": {
            key: [[_number(low), _number(high)] for low, high in intervals]
            for key, intervals in analysis.intervals.items()
        },
        "memory": {
            "samples": analysis.memory.samples,
            "sampled_bytes": analysis.memory.sampled_bytes,
            "fitted_bytes": analysis.memory.fitted_bytes,
        },
    }


def _described(described: Described, *, curves: bool) -> dict[str, Json]:
    instruction, found = described.instruction, described.characteristics
    document: dict[str, Json] = {
        "text": instruction.text,
        "preposition": instruction.preposition,
        "fuzziness": instruction.fuzziness,
        "t_spec_s": instruction.t_spec,
        "participants": described.subjective.participants,
        "variance_min2": _number(described.variance / SQUARE_MINUTE),
        "gradient_left_per_min": _number(described.flanks.left * MINUTE),
        "gradient_right_per_min": _number(described.flanks.right * MINUTE),
        "disagreement": _number(found.disagreement),
        "fits": {model.value: _fit(fit) for model, fit in described.fits.items()},
    }
    if described.group is None:
        document["subgroups"] = {
            "divergent": described.subgroups.divergent,
            "silhouette": _number(described.subgroups.silhouette),
            "sizes": [int((~described.subgroups.second).sum()), int(described.subgroups.second.sum())],
        }
    if curves:
        document["characteristics"] = {
            "mean": _list(found.mean),
            "median": _list(found.median),
            "mode": _list(found.mode),
            "deviation": _list(found.deviation),
            "minimum": _list(found.minimum),
            "lower_quartile": _list(found.lower_quartile),
            "upper_quartile": _list(found.upper_quartile),
            "maximum": _list(found.maximum),
            "skew": _list(found.skew),
            "kurtosis": _list(found.kurtosis),
        }
    return document


def _fit(fit: Fit) -> dict[str, Json]:
    parameters: dict[str, Json] = {
        name: _number(value) for name, value in fit.function.parameters.items() if isinstance(value, float)
    }
    return {
        # A polynomial's function is points that stand for it: its parameters are the coefficients.
        "parameters": parameters or dict(fit.parameters),
        "sse": _number(fit.sse),
        "rmse": _number(fit.rmse),
        "r_squared": _number(fit.r_squared),
    }


def _models(found: PrepositionModels) -> dict[str, Json]:
    better, of = found.best
    return {
        "prediction_error": {model.value: list(map(_number, ends)) for model, ends in found.errors.items()},
        "trapezoid_better_than_bell": better,
        "instructions": of,
        "plateau_encloses_t_spec": found.encloses,
        "left_plateau_edge_minus_t_spec_s": [_number(edge) for edge in found.left_edges],
        "gradient_left_per_min": _number(found.left * MINUTE),
        "gradient_right_per_min": _number(found.right * MINUTE),
    }


def _groups(analysis: Analysis) -> Json:
    if analysis.compared is None:
        return None
    first, second = analysis.compared
    document: dict[str, Json] = {"first": first, "second": second}
    found, scale = analysis.comparison, analysis.scale
    if found is not None:
        keys = list(analysis.overall)
        document["variance"] = {
            "difference_min2": _by_key(keys, found.differences / SQUARE_MINUTE),
            "p_values": _by_key(keys, found.p_values),
            "mean_difference_min2": _number(found.mean_difference / SQUARE_MINUTE),
            "first_smaller": int((found.differences < 0).sum()),
            "p_value": found.p_value,
        }
    if scale is not None:
        document["control"] = {
            "modes": {first: list(scale.first_mode), second: list(scale.second_mode)},
            "u": scale.u,
            "p_value": scale.p_value,
            "cliffs_delta": scale.delta,
            "interval": list(scale.interval),
            "few": scale.few,
        }
    return document


def _start_times(found: StartTimeInfluence) -> dict[str, Json]:
    return {
        "t_spec_s": _list(found.t_spec),
        "variance_min2": _list(found.variances / SQUARE_MINUTE),
        "ratio": _number(found.ratio),
        "increasing": found.increasing,
        "growth": _number(found.growth),
    }


def _by_key(keys: list[str], values: Floats) -> Mapping[str, Json]:
    return dict(zip(keys, _list(values), strict=True))


def _list(values: Floats) -> list[Json]:
    return [_number(value) for value in np.asarray(values).tolist()]


def _number(value: float) -> float | None:
    """Six significant digits, which is more than any answer has; null where a value is not defined."""
    return float(f"{value:.6g}") if np.isfinite(value) else None
