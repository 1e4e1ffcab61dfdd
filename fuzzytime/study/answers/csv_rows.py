"""The rows of a CSV file of answers: their columns, and cells that know their places."""

import csv
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import chain
from typing import TypeVar

from fuzzytime.documents.cells import delimiter_of, with_point
from fuzzytime.errors import DocumentError, FuzzytimeError, Mistake
from fuzzytime.spelling import suggestion
from fuzzytime.study.asking.design import Design

_T = TypeVar("_T")

COLUMNS = (
    "participant",
    "actor",
    "origin",
    "finished",
    "excluded",
    "control",
    "shown",
    "instruction",
    "time_s",
    "satisfaction",
)
"""Columns that every exported file has; ``shown`` counts from 1 in the order of the participant's pages."""

ABOUT = "about_"
"""What the columns of questions about the participant begin with."""

MEASURED = ("time_s", "satisfaction")
_NEEDED = ("participant", "instruction", *MEASURED)
_FORMULA = ("=", "+", "-", "@", "\t", "\r", "'")


def guarded(text: str) -> str:
    """Give a cell that no spreadsheet takes for a formula.

    >>> guarded("=1+1"), unguarded(guarded("=1+1"))
    ("'=1+1", '=1+1')
    """
    return f"'{text}" if text.startswith(_FORMULA) else text


def unguarded(text: str) -> str:
    """Give what was guarded."""
    return text[1:] if text.startswith("'") and text[1:].startswith(_FORMULA) else text


@dataclass(frozen=True, slots=True)
class Row:
    """The cells of a row by column, and where it stands: its file, its last line's number, and that line."""

    path: str
    number: int
    line: str
    cells: Mapping[str, str]

    def text(self, column: str) -> str:
        """Give a cell without its guard; an empty one where the column is not there."""
        return unguarded(self.cells.get(column, "")).strip()

    def wrong(self, column: str, message: str) -> DocumentError:
        """Say what is wrong with a cell, or with the row."""
        columns = list(self.cells)
        before = columns[: columns.index(column)] if column in columns and '"' not in self.line else []
        place = 1 + sum(len(self.cells[name]) + 1 for name in before)
        return DocumentError((Mistake(self.path, self.number, place, "", message, self.line.rstrip("\r\n")),))

    def ruled_by(self, column: str, rule: Callable[[str], _T]) -> _T:
        """Give what a rule makes of a cell; what breaks it is said to stand there."""
        try:
            return rule(self.text(column))
        except FuzzytimeError as error:
            raise self.wrong(column, str(error)) from error


@dataclass(slots=True)
class _Lines:
    """Lines, and the last one that was read."""

    ahead: Iterator[str]
    last: str = ""

    def __iter__(self) -> Iterator[str]:
        return self

    def __next__(self) -> str:
        self.last = next(self.ahead)
        return self.last


def rows_of(stream: Iterable[str], design: Design, path: str) -> Iterator[Row]:
    """Give the rows by column; those of empty cells only are passed over.

    Raises
    ------
    DocumentError
        If a row is none, or the columns are not those of the design's answers.
    """
    ahead = iter(stream)
    head = next(ahead, "")
    delimiter = delimiter_of(head)
    lines = _Lines(chain([head], ahead))
    rows = csv.reader(lines, delimiter=delimiter, strict=True)
    columns: tuple[str, ...] = ()
    try:
        for cells in rows:
            if not columns:
                columns = _columns(Row(path, rows.line_num, lines.last, {}), cells, design)
            elif any(map(str.strip, cells)):
                row = Row(path, rows.line_num, lines.last, dict(zip(columns, cells, strict=False)))
                if len(cells) != len(columns):
                    raise row.wrong("", f"a row must have {len(columns)} cells, got {len(cells)}")
                measured = {name: with_point(row.cells[name], delimiter) for name in MEASURED}
                yield replace(row, cells={**row.cells, **measured})
    except (csv.Error, UnicodeDecodeError) as error:
        row = Row(path, max(rows.line_num, 1), lines.last, {})
        raise row.wrong("", f"not valid CSV: {error}") from error


def _columns(head: Row, cells: Iterable[str], design: Design) -> tuple[str, ...]:
    """Give the names of the columns; others than ours may stand among them."""
    columns = tuple(cell.lstrip("\ufeff").strip() for cell in cells)
    if not any(columns):
        raise head.wrong("", "a file of answers must have a header")
    head = replace(head, cells={name: name for name in columns})
    for name in _NEEDED:
        if name not in columns:
            raise head.wrong("", f"a file of answers must have the column {name!r}")
    known = [ABOUT + question.key for question in design.demographics]
    for position, name in enumerate(columns):
        if name and name in columns[:position]:
            raise head.wrong(name, f"columns must differ, got {name!r} twice")
        if name.startswith(ABOUT) and name not in known:
            raise head.wrong(name, f"the study asks nothing for {name!r}{suggestion(name, known)}")
    return columns
