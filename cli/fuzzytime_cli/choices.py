"""Closed sets of words that flags and settings may take."""

from enum import StrEnum
from pathlib import Path
from typing import Self


class ProfileChoice(StrEnum):
    """A profile of widths."""

    EVERYDAY = "everyday"
    STUDY = "study"


class ActorChoice(StrEnum):
    """Who acts."""

    ROBOT = "robot"
    PERSON = "person"


class SolverChoice(StrEnum):
    """A way to find the schedule."""

    AUTO = "auto"
    EXACT = "exact"
    EXHAUSTIVE = "exhaustive"
    HILL_CLIMBING = "hill-climbing"
    ANNEALING = "annealing"
    GENETIC = "genetic"


class PlanFormat(StrEnum):
    """What a plan is written as."""

    TABLE = "table"
    JSON = "json"
    JSONL = "jsonl"
    CSV = "csv"
    ICS = "ics"
    HTML = "html"
    SVG = "svg"

    @classmethod
    def of_file(cls, path: Path | None) -> Self | None:
        """Give the format that a file's name ends in, if it does."""
        ending = path.suffix.lower().removeprefix(".") if path is not None else ""
        return next((kind for kind in cls if kind == ending), None)


class RunFormat(StrEnum):
    """What the events of a run are written as."""

    TEXT = "text"
    JSONL = "jsonl"


class BatchBackend(StrEnum):
    """Where a batch is worked out, by joblib's names."""

    LOKY = "loky"
    THREADING = "threading"
    DASK = "dask"
    RAY = "ray"
