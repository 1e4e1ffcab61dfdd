"""Answers as CSV (one row per sample) and JSON, for other programs and back.

A CSV file has the columns of `COLUMNS`, then one per question about the participant, called ``about_`` and
the question's key. Of those, ``participant``, ``instruction``, ``time_s`` and ``satisfaction`` must be there
to import, and ``actor`` where the design has several groups. What is true of a participant stands in each of
their rows. A cell that a spreadsheet would take for a formula is written with an apostrophe before it.
What is read may have been saved by a spreadsheet, with semicolons or tabs between cells and decimal commas.
"""

import csv
import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from itertools import chain
from typing import TextIO

import numpy as np

from fuzzytime.cells import delimiter_of, with_point
from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Floats
from fuzzytime.study.answers.participants import Answers, Origin, Participant
from fuzzytime.study.asking.design import Design

SCHEMA = "fuzzytime-study/1"

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
_MEASURED = ("time_s", "satisfaction")
_NEEDED = ("participant", "instruction", *_MEASURED)
_FORMULA = ("=", "+", "-", "@", "\t", "\r", "'")


def write_csv(answers: Answers, stream: TextIO) -> None:
    """Write one row per sample; a participant without a curve gets one row without a sample."""
    questions = [question.key for question in answers.design.demographics]
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow([*COLUMNS, *(ABOUT + key for key in questions)])
    times = [f"{time:.10g}" for time in answers.design.timeline.times.tolist()]
    for person in answers.participants:
        control = "" if person.control is None else str(person.control)
        fixed = [
            _guarded(person.name),
            _guarded(person.group),
            person.origin.value,
            str(int(person.finished)),
        ]
        fixed += [_guarded(person.excluded or ""), control]
        about = [_guarded(person.demographics.get(key, "")) for key in questions]
        if not person.curves:
            writer.writerow([*fixed, "", "", "", "", *about])
        for key in sorted(person.curves, key=lambda key: _shown(person, key)):
            at = [*fixed, str(_shown(person, key)), _guarded(key)]
            pairs = zip(times, person.curves[key].tolist(), strict=True)
            writer.writerows([*at, time, repr(value), *about] for time, value in pairs)


def write_json(answers: Answers, stream: TextIO) -> None:
    """Write the design as YAML text, the times, and each participant with the curves by instruction."""
    document = {
        "schema": SCHEMA,
        "design": answers.design.yaml,
        "times_s": answers.design.timeline.times.tolist(),
        "participants": [
            {
                "participant": person.name,
                "actor": person.group,
                "origin": person.origin.value,
                "finished": person.finished,
                "excluded": person.excluded,
                "control": person.control,
                "order": list(person.order),
                "about": dict(person.demographics),
                "curves": {key: curve.tolist() for key, curve in person.curves.items()},
            }
            for person in answers.participants
        ],
    }
    json.dump(document, stream, ensure_ascii=False, allow_nan=False)
    stream.write("\n")


def _shown(person: Participant, key: str) -> int:
    return person.order.index(key) + 1 if key in person.order else 0


def _guarded(text: str) -> str:
    return f"'{text}" if text.startswith(_FORMULA) else text


def _unguarded(text: str) -> str:
    return text[1:] if text.startswith("'") and text[1:].startswith(_FORMULA) else text


@dataclass(slots=True)
class _Rows:
    """One participant's rows so far."""

    group: str
    row: Mapping[str, str]
    line: int
    samples: dict[str, list[tuple[float, float]]] = field(default_factory=dict)
    shown: dict[str, int] = field(default_factory=dict)


def read_csv(stream: Iterable[str], design: Design, path: str = "answers.csv") -> Answers:
    """Read answers to a design; samples at other times than the design's are interpolated.

    Raises
    ------
    FuzzytimeError
        At the first line that breaks a rule, with its number.
    """
    rows: dict[str, _Rows] = {}
    for line, row in _records(stream, path):
        try:
            _take(rows, row, design, line)
        except FuzzytimeError as error:
            raise FuzzytimeError(f"{path}:{line}: {error}") from error
    people = []
    for name, found in rows.items():
        try:
            people.append(_participant(name, found, design))
        except FuzzytimeError as error:
            raise FuzzytimeError(f"{path}:{found.line}: participant {name!r}: {error}") from error
    return Answers(design, tuple(people))


def _records(stream: Iterable[str], path: str) -> Iterator[tuple[int, dict[str, str]]]:
    """Give the rows by column, with their lines; those of empty cells only are passed over."""
    lines, line = iter(stream), 1
    try:
        head = next(lines, None)
        if head is None:
            raise FuzzytimeError(f"{path}:1: a file of answers must have a header")
        delimiter = delimiter_of(head)
        reader = csv.reader(chain([head], lines), delimiter=delimiter, strict=True)
        names = [name.lstrip("\ufeff").strip() for name in next(reader)]
        missing = [name for name in _NEEDED if name not in names]
        if missing:
            raise FuzzytimeError(f"{path}:1: a file of answers must have the column {missing[0]!r}")
        for cells in reader:
            line = reader.line_num + 1
            if not any(map(str.strip, cells)):
                continue
            if len(cells) != len(names):
                raise FuzzytimeError(
                    f"{path}:{reader.line_num}: a row must have {len(names)} cells, got {len(cells)}"
                )
            row = dict(zip(names, cells, strict=True))
            yield reader.line_num, row | {name: with_point(row[name], delimiter) for name in _MEASURED}
    except (csv.Error, UnicodeDecodeError) as error:
        raise FuzzytimeError(f"{path}:{line}: not valid CSV: {error}") from error


def _take(rows: dict[str, _Rows], row: Mapping[str, str], design: Design, line: int) -> None:
    """Add a row to its participant's."""
    name = _unguarded(row["participant"]).strip()
    if not name:
        raise FuzzytimeError("a participant must have a name")
    group = _unguarded(row.get("actor", "")) or (next(iter(design.groups)) if len(design.groups) == 1 else "")
    if group not in design.groups:
        raise FuzzytimeError(f"actor must be one of {', '.join(design.groups)}, got {group[:40]!r}")
    found = rows.setdefault(name, _Rows(group, row, line))
    if found.group != group:
        raise FuzzytimeError(f"a participant must have one actor, got {group!r} and {found.group!r}")
    key = _unguarded(row["instruction"])
    if not key:
        return
    design.instruction(key)
    satisfaction = _number(row["satisfaction"], "satisfaction")
    if not 0 <= satisfaction <= 1:
        raise FuzzytimeError(f"satisfaction must lie in [0, 1], got {satisfaction:g}")
    found.samples.setdefault(key, []).append((_number(row["time_s"], "time_s"), satisfaction))
    if row.get("shown"):
        found.shown[key] = int(_number(row["shown"], "shown"))


def _number(text: str, name: str) -> float:
    try:
        value = float(text)
    except ValueError as error:
        raise FuzzytimeError(f"{name} must be a number, got {text[:40]!r}") from error
    if not np.isfinite(value):
        raise FuzzytimeError(f"{name} must be finite, got {text[:40]!r}")
    return value


def _participant(name: str, found: _Rows, design: Design) -> Participant:
    row = found.row
    control = row.get("control", "")
    answers = {
        question.key: question.checked(_unguarded(row.get(ABOUT + question.key, "")))
        for question in design.demographics
    }
    return Participant(
        name=name,
        group=found.group,
        order=tuple(sorted(found.samples, key=lambda key: found.shown.get(key, 0))),
        curves={key: resampled(samples, design) for key, samples in found.samples.items()},
        demographics={key: answer for key, answer in answers.items() if answer},
        control=int(_number(control, "control")) if control else None,
        origin=_origin(row.get("origin", "")),
        finished=row.get("finished", "1") != "0",
        excluded=_unguarded(row.get("excluded", "")) or None,
    )


def _origin(text: str) -> Origin:
    return Origin(text) if text in set(Origin) else Origin.IMPORTED


def resampled(samples: Iterable[tuple[float, float]], design: Design) -> Floats:
    """Give a curve of shape (samples,) at the design's times from pairs of time and satisfaction.

    Between the pairs it is linear; before the first and after the last the design's default holds.

    Raises
    ------
    FuzzytimeError
        If two pairs have the same time.
    """
    pairs = np.array(sorted(samples), float)
    if (np.diff(pairs[:, 0]) <= 0).any():
        twice = pairs[1:][np.diff(pairs[:, 0]) <= 0][0, 0]
        raise FuzzytimeError(f"samples of a curve must have different times, got {twice:g} s twice")
    times = design.timeline.times
    # Times written with ten digits stand for the design's own.
    near = np.searchsorted(times, pairs[:, 0] - 1e-6).clip(0, times.size - 1)
    own = np.where(np.abs(times[near] - pairs[:, 0]) <= 1e-6, times[near], pairs[:, 0])
    return np.asarray(np.interp(times, own, pairs[:, 1], left=design.default, right=design.default))


def read_json(text: str, path: str = "answers.json") -> Answers:
    """Read what `write_json` wrote, with the design in it.

    Raises
    ------
    FuzzytimeError
        If the text is no such document.
    """
    try:
        document = json.loads(text)
        if not isinstance(document, dict) or document.get("schema") != SCHEMA:
            raise FuzzytimeError(f"{path}: a study's answers must have the schema {SCHEMA!r}")
        design = Design.of_text(document["design"], f"{path}:design")
        times = document["times_s"]
        people = tuple(_person(entry, times, design) for entry in document["participants"])
    except json.JSONDecodeError as error:
        raise FuzzytimeError(f"{path}:{error.lineno}:{error.colno}: not valid JSON: {error.msg}") from error
    except (ValueError, RecursionError) as error:
        raise FuzzytimeError(f"{path}: not valid JSON: {error}") from error
    except (KeyError, TypeError, AttributeError) as error:
        raise FuzzytimeError(f"{path}: a study's answers are incomplete: {error}") from error
    return Answers(design, people)


def _person(entry: Mapping[str, object], times: list[float], design: Design) -> Participant:
    curves, about, order = entry["curves"], entry["about"], entry["order"]
    if not isinstance(curves, dict) or not isinstance(about, dict) or not isinstance(order, list):
        raise TypeError("curves and about must be objects, order a list")
    control, excluded = entry["control"], entry["excluded"]
    if not (control is None or type(control) is int) or not (excluded is None or isinstance(excluded, str)):
        raise TypeError("control must be a whole number and excluded a text, or null")
    for key in curves:
        design.instruction(key)
    return Participant(
        name=str(entry["participant"]),
        group=str(entry["actor"]),
        order=tuple(map(str, order)),
        curves={key: resampled(zip(times, values, strict=True), design) for key, values in curves.items()},
        demographics={str(key): str(answer) for key, answer in about.items()},
        control=control,
        origin=_origin(str(entry["origin"])),
        finished=bool(entry["finished"]),
        excluded=excluded,
    )
