"""What the study's commands share: their arguments, the design, the study's file."""

from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fuzzytime_cli.faults import NoInputError, as_config

if TYPE_CHECKING:
    from fuzzytime.study import AnswerStore, Design

Database = Annotated[
    Path, typer.Argument(metavar="ANSWERS", help="The study's file, such as answers.sqlite.")
]
NewDatabase = Annotated[
    Path, typer.Option("--db", help="The study's file; it is begun where it is not there.")
]
DesignFile = Annotated[
    Path | None, typer.Option("--design", help="The study's design (YAML); the paper's if none is given.")
]


def read_design(path: Path | None) -> "Design":
    """Read a design file, or the shipped one.

    Raises
    ------
    NoInputError
        If there is no such file.
    ConfigError
        If it breaks rules.
    """
    from fuzzytime.study import Design

    if path is None:
        return Design.shipped()
    if not path.is_file():
        raise NoInputError(f"{path}: there is no such design")
    with as_config():
        return Design.of_file(path)


def opened(path: Path) -> "AnswerStore":
    """Open a study's file that must be there.

    Raises
    ------
    NoInputError
        If it is not.
    FuzzytimeError
        If it holds something else.
    """
    from fuzzytime.study import AnswerStore

    if not path.is_file():
        raise NoInputError(f"{path}: there is no such study")
    return AnswerStore.open(path)


def now() -> str:
    """Give the moment, for the record."""
    return datetime.now(UTC).isoformat(timespec="seconds")
