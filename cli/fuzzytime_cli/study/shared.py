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
NewDatabase = Annotated[Path, typer.Option("--db", help="The study's file; created if it does not exist.")]
DESIGN = "The study's design (YAML); if not given, that of the existing study, or the paper's."
DesignFile = Annotated[
    Path | None,
    typer.Option(
        "--design",
        help=DESIGN,
    ),
]


def design_of(database: Path, path: Path | None) -> "Design":
    """Give the design of a file; where none is named that of the study that is there, or the shipped one.

    Raises
    ------
    NoInputError
        If there is no such file.
    ConfigError
        If it breaks rules.
    """
    from fuzzytime.study import Design

    if path is None and database.is_file() and database.stat().st_size:
        with opened(database) as store:
            return store.design
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
