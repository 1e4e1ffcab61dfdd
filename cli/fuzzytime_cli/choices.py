"""Closed sets of words that flags and settings may take."""

from enum import StrEnum
from pathlib import Path
from typing import Self

from fuzzytime_cli.faults import UsageError


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


UNWRITTEN = frozenset(
    {"pdf", "png", "jpg", "jpeg", "gif", "webp", "eps", "ps", "xls", "xlsx", "ods", "doc", "docx", "odt"}
    | {"xml", "tsv", "yaml", "yml", "toml", "htm", "zip"}
)
"""Endings of documents that a plan is not written as."""


TEXTS = frozenset({"", "txt", "text", "md", "log", "out"})
"""Endings of what a table may be kept in, and whoever does so expects one."""


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
        ending = _ending(path)
        return next((kind for kind in cls if kind == ending), None)

    @classmethod
    def written_to(cls, path: Path | None) -> Self:
        """Give the format that a file's name asks for: a table where it ends in none.

        Raises
        ------
        UsageError
            If it ends as a document of another kind does, which a table would not be.
        """
        if (ending := _ending(path)) in UNWRITTEN:
            known = ", ".join(f".{kind}" for kind in cls if kind is not cls.TABLE)
            raise UsageError(f"-o: a plan is not written as .{ending}, but as {known}, or else as a table")
        return cls.of_file(path) or cls.TABLE

    @classmethod
    def is_guessed(cls, path: Path | None) -> bool:
        """Whether a file's name ends in nothing that says what is written to it."""
        return _ending(path) not in {*TEXTS, *cls}


def _ending(path: Path | None) -> str:
    return path.suffix.lower().removeprefix(".") if path is not None else ""


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
