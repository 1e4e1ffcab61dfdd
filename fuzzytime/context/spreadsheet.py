"""Readings from comma-separated values, as data loggers and spreadsheets write them.

The head names the columns: either the fields of a reading (``signal,at_s,value,unit``), one reading a row;
or one time (``at`` or ``at_s``) and signals (``at,pan_temp,oven_temp``), one moment a row. A cell may be
empty, rows may come in any order, and semicolons or tabs may stand for the commas; numbers may have a decimal
comma then.
"""

import csv
import io
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from datetime import datetime
from itertools import chain

from fuzzytime.context.lines import KEYS, LONGEST_LINE, LineError, reading_of
from fuzzytime.context.readings import MAX_READINGS, Context, Reading
from fuzzytime.context.signals import Signal
from fuzzytime.documents.cells import delimiter_of, with_point
from fuzzytime.errors import DocumentError, FuzzytimeError, Mistake
from fuzzytime.spelling import suggestion

_TIMES = frozenset({"at", "at_s"})


def is_head(line: str) -> bool:
    """Say whether a file's first line is the head of a table of readings.

    >>> is_head("at_s,pan_temp"), is_head('{"signal": "pan_temp", "at_s": 0, "value": 3}')
    (True, False)
    """
    names = {name.strip().strip('"') for name in line.split(delimiter_of(line))}
    return not line.startswith("{") and bool({*_TIMES, "signal"} & names)


def read_rows(
    text: str, shown: str, now: datetime | None = None, signals: Mapping[str, Signal] | None = None
) -> Context:
    """Read a table of readings; parameters are those of `fuzzytime.context.read_context_lines`.

    Raises
    ------
    DocumentError
        With every mistake, its line and its column.
    """
    rows = _rows(text, shown)
    readings: list[Reading] = []
    mistakes: list[Mistake] = []
    head = next(rows)
    try:
        table = _Table.of(head.cells, signals)
    except LineError as error:
        raise DocumentError((head.mistake(shown, error, head.cells),)) from error
    for row in rows:
        try:
            readings += table.readings(row.cells, signals, now)
        except FuzzytimeError as error:
            mistakes.append(row.mistake(shown, error, table.columns))
        if max(len(readings), len(mistakes)) > MAX_READINGS:
            most = FuzzytimeError(f"a context must hold at most {MAX_READINGS:,} readings")
            raise DocumentError((*mistakes, row.mistake(shown, most, table.columns)))
    if mistakes:
        raise DocumentError(tuple(mistakes))
    return Context(tuple(readings))


@dataclass(frozen=True, slots=True)
class _Row:
    """The cells of a row, where it ends, counted from 1, and how its last line reads."""

    cells: tuple[str, ...]
    number: int
    line: str

    def mistake(self, shown: str, error: FuzzytimeError, columns: tuple[str, ...]) -> Mistake:
        """Make a mistake of what is wrong with a cell, or with the row."""
        name = (error.key or error.value_of) if isinstance(error, LineError) else ""
        before = self.cells[: columns.index(name)] if name in columns else ()
        column = 1 + sum(len(cell) + 1 for cell in before) if '"' not in self.line else 1
        return Mistake(shown, self.number, column, "", str(error), self.line)


def _rows(text: str, shown: str) -> Iterator[_Row]:
    """Give the rows that are not empty."""
    lines: list[str] = []

    def remembered(stream: Iterable[str]) -> Iterator[str]:
        for line in stream:
            lines[:] = [line.rstrip("\r\n")[:LONGEST_LINE]]
            yield line

    stream = io.StringIO(text, newline="")
    first = stream.readline()
    delimiter = delimiter_of(first)
    rows = csv.reader(remembered(chain([first], stream)), delimiter=delimiter, strict=True)
    try:
        for cells in rows:
            if any(map(str.strip, cells)):
                yield _Row(tuple(with_point(cell, delimiter) for cell in cells), rows.line_num, lines[0])
    except csv.Error as error:
        message = f"a row must be cells with commas between: {error}"
        raise DocumentError((Mistake(shown, rows.line_num, 1, "", message, *lines),)) from error


@dataclass(frozen=True, slots=True)
class _Table:
    """The columns of a table, and whether a row is one reading, or those of several signals at one time."""

    columns: tuple[str, ...]
    one_a_row: bool

    @classmethod
    def of(cls, head: tuple[str, ...], signals: Mapping[str, Signal] | None) -> "_Table":
        columns = tuple(map(str.strip, head))
        one_a_row = "signal" in columns
        known = KEYS if one_a_row else signals
        for place, name in enumerate(columns):
            if name in columns[:place]:
                raise LineError(f"columns must differ, got {name!r} twice", key=name)
            if known is not None and name not in known and name not in _TIMES:
                kind = "column" if one_a_row else "signal"
                raise LineError(f"unknown {kind} {name!r}{suggestion(name, known)}", key=name)
        return cls(columns, one_a_row)

    def readings(
        self, cells: tuple[str, ...], signals: Mapping[str, Signal] | None, now: datetime | None
    ) -> Iterator[Reading]:
        """Give the readings of a row.

        Raises
        ------
        LineError
            If the row is none, or a signal cannot have a value of it.
        """
        if len(cells) != len(self.columns):
            raise LineError(
                f"a row must have as many cells as the head, {len(self.columns)}, got {len(cells)}"
            )
        given = {name: cell.strip() for name, cell in zip(self.columns, cells, strict=True) if cell.strip()}
        fields = {name: _seconds(cell) if name == "at_s" else cell for name, cell in given.items()}
        if self.one_a_row:
            yield reading_of(fields, signals, now)
            return
        time = {name: fields.pop(name) for name in _TIMES & fields.keys()}
        if not time:
            raise LineError("a row must have a time")
        for name, value in fields.items():
            try:
                yield reading_of({"signal": name, "value": value, **time}, signals, now)
            except LineError as error:
                raise LineError(str(error), value_of=_column_of(error, name)) from error


def _column_of(error: LineError, signal: str) -> str:
    """Give the column of a table that what is wrong with a reading stands in."""
    field = error.key or error.value_of
    return field if field in _TIMES else signal


def _seconds(cell: str) -> float:
    try:
        return float(cell)
    except ValueError as error:
        raise LineError(f"'at_s' must be a number of seconds, got {cell[:40]!r}", value_of="at_s") from error
