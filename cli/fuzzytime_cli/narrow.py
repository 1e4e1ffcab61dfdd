"""Help on a narrow terminal: what an option does stands under it, not beside it."""

import shutil
import textwrap
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING

import typer

if TYPE_CHECKING:
    from typer._click.formatting import HelpFormatter

NARROW = 52
"""Columns below which two do not stand side by side."""

_INDENT = 4


def width_of_help() -> int | None:
    """Give the columns that help has on a narrow terminal; None leaves it to Typer, which wants 50."""
    columns = shutil.get_terminal_size().columns
    return max(20, columns - 2) if columns < NARROW else None


@contextmanager
def help_that_fits() -> Iterator[int | None]:
    """Let lists of options stack where the terminal is narrow; give the columns that help has."""
    width = width_of_help()
    if width is None:
        yield width
        return
    # Typer passes on no formatter; every context that its commands make takes this one.
    (context,) = typer.Context.__bases__
    formatter = context.formatter_class  # type: ignore[attr-defined]
    context.formatter_class = type("Stacked", (formatter,), {"write_dl": _stacked})  # type: ignore[attr-defined]
    try:
        yield width
    finally:
        context.formatter_class = formatter  # type: ignore[attr-defined]


def _stacked(
    self: "HelpFormatter", rows: Sequence[tuple[str, str]], col_max: int = 30, col_spacing: int = 2
) -> None:
    """Write a list of terms, each with what it means under it."""
    del col_max, col_spacing
    first = " " * self.current_indent
    for term, meaning in rows:
        # Where a long choice may be broken: "<table| json| csv>".
        said = textwrap.wrap(
            term.replace("|", "| "), self.width, initial_indent=first, subsequent_indent=first + "  "
        )
        under = first + " " * _INDENT
        told = textwrap.wrap(meaning, self.width, initial_indent=under, subsequent_indent=under)
        self.write("".join(f"{line}\n" for line in (*said, *told)))
