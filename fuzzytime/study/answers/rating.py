"""A rating: what a person thought of one start, and how it is kept."""

import math
from dataclasses import dataclass
from enum import StrEnum

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Bell, Rectangle, Sampled, SatisfactionFunction, Trapezoid, Triangle

_MODELS: dict[str, type[Trapezoid | Triangle | Rectangle | Bell | Sampled]] = {
    kind.model: kind for kind in (Trapezoid, Triangle, Rectangle, Bell, Sampled)
}


class Direction(StrEnum):
    """Which way a start was wrong."""

    EARLY = "too early"
    LATE = "too late"


class CueKind(StrEnum):
    """Which words of an instruction say when."""

    PREPOSITION = "preposition"
    WORD = "word"


@dataclass(frozen=True, slots=True)
class Cue:
    """What a person may hear otherwise than others: "in", said with a number, or a word such as "soon"."""

    kind: CueKind
    text: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Rating:
    """What a person thought of one start.

    Parameters
    ----------
    satisfaction
        ψ by which the start was chosen, of the population's table.
    t_spec
        The time that was said, in seconds.
    start
        When it started, in seconds; both count from when the instruction was given.
    cue
        What was said with the time; None where it is not to be heard otherwise, as for a clock time.
    score
        From 1 to 5, None where none was given.
    direction
        Whether it was too early or too late, None where that was not said.

    Raises
    ------
    FuzzytimeError
        If neither score nor direction is given, the score is none, or a time is not finite.
    """

    satisfaction: SatisfactionFunction
    t_spec: float
    start: float
    cue: Cue | None = None
    score: int | None = None
    direction: Direction | None = None

    def __post_init__(self) -> None:
        if self.score is None and self.direction is None:
            raise FuzzytimeError("a rating must give a score or say what was wrong")
        if self.score is not None and not 1 <= self.score <= 5:
            raise FuzzytimeError(f"a score must be one of 1 to 5, got {self.score}")
        if not (math.isfinite(self.t_spec) and math.isfinite(self.start)):
            raise FuzzytimeError(f"times must be finite, got {self.t_spec} and {self.start}")


def document_of(rating: Rating) -> dict[str, object]:
    """Give a rating as a document that JSON can hold.

    Raises
    ------
    FuzzytimeError
        If its satisfaction function is none that can be kept.
    """
    function = rating.satisfaction
    if function.model not in _MODELS:
        known = ", ".join(_MODELS)
        raise FuzzytimeError(f"a rating's function must be one of {known}, got {function.model!r}")
    return {
        "model": function.model,
        "parameters": function.parameters,
        "t_spec_s": rating.t_spec,
        "start_s": rating.start,
        "cue": None if rating.cue is None else {rating.cue.kind: rating.cue.text},
        "score": rating.score,
        "direction": rating.direction,
    }


def rating_of(document: object) -> Rating:
    """Give the rating that a document holds.

    Raises
    ------
    FuzzytimeError
        If it holds none.
    """
    if not isinstance(document, dict):
        raise FuzzytimeError("a rating must be an object")
    try:
        kind = _MODELS[document["model"]]
        function: SatisfactionFunction = kind(**document["parameters"])
        direction, cue = document["direction"], document["cue"]
        return Rating(
            satisfaction=function,
            t_spec=float(document["t_spec_s"]),
            start=float(document["start_s"]),
            cue=None if cue is None else _cue(**cue),
            score=document["score"],
            direction=None if direction is None else Direction(direction),
        )
    except (KeyError, TypeError, ValueError) as error:
        raise FuzzytimeError(f"this is no rating: {error}") from error


def _cue(preposition: str | None = None, word: str | None = None) -> Cue:
    if (preposition is None) == (word is None):
        raise ValueError("a cue must be a preposition or a word")
    return Cue(CueKind.PREPOSITION, preposition) if preposition is not None else Cue(CueKind.WORD, str(word))
