"""Answers as CSV, one row per sample, for other programs and back.

A file has the columns of `COLUMNS`, then one per question about the participant, called ``about_`` and the
question's key. Of those, ``participant``, ``instruction``, ``time_s`` and ``satisfaction`` must be there to
import, and ``actor`` where the design has several groups. What is true of a participant stands in each of
their rows, or in some of them. A cell that a spreadsheet would take for a formula is written with an
apostrophe before it. What is read may have been saved by a spreadsheet, with semicolons or tabs between cells
and decimal commas.
"""

import csv
import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from functools import partial
from typing import TextIO, TypeVar

from fuzzytime.errors import FuzzytimeError
from fuzzytime.study.answers.csv_rows import ABOUT, COLUMNS, MEASURED, Row, guarded, rows_of
from fuzzytime.study.answers.participants import Answers, Origin, Participant
from fuzzytime.study.answers.sampling import resampled
from fuzzytime.study.asking.design import Design

_T = TypeVar("_T")

_TRUTHS = {"1": True, "true": True, "yes": True, "0": False, "false": False, "no": False}


def write_csv(answers: Answers, stream: TextIO) -> None:
    """Write one row per sample; a participant without a curve gets one row without a sample."""
    questions = [question.key for question in answers.design.demographics]
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow([*COLUMNS, *(ABOUT + key for key in questions)])
    times = [f"{time:.10g}" for time in answers.design.timeline.times.tolist()]
    for person in answers.participants:
        control = "" if person.control is None else str(person.control)
        fixed = [
            guarded(person.name),
            guarded(person.group),
            person.origin.value,
            str(int(person.finished)),
            guarded(person.excluded or ""),
            control,
        ]
        about = [guarded(person.demographics.get(key, "")) for key in questions]
        if not person.curves:
            writer.writerow([*fixed, "", "", "", "", *about])
        for key in sorted(person.curves, key=lambda key: _shown(person, key)):
            at = [*fixed, str(_shown(person, key)), guarded(key)]
            pairs = zip(times, person.curves[key].tolist(), strict=True)
            writer.writerows([*at, time, repr(value), *about] for time, value in pairs)


def _shown(person: Participant, key: str) -> int:
    return person.order.index(key) + 1 if key in person.order else 0


@dataclass(slots=True)
class _Person:
    """What the rows so far say of one participant.

    ``own`` has, by column, the first row that says something of the participant; ``said`` is what the last
    row said.
    """

    own: dict[str, Row] = field(default_factory=dict)
    said: tuple[str, ...] = ()
    samples: dict[str, dict[float, float]] = field(default_factory=dict)
    shown: dict[str, int] = field(default_factory=dict)

    def read(self, column: str, rule: Callable[[str], _T], otherwise: _T) -> _T:
        """Give what a rule makes of the participant's cell; something else where it is empty in all rows."""
        return self.own[column].ruled_by(column, rule) if column in self.own else otherwise


def read_csv(stream: Iterable[str], design: Design, path: str = "answers.csv") -> Answers:
    """Read answers to a design; samples at other times than the design's are interpolated.

    Raises
    ------
    DocumentError
        At the first cell that breaks a rule, with its place.
    """
    own = (
        "actor",
        "origin",
        "finished",
        "excluded",
        "control",
        *(ABOUT + q.key for q in design.demographics),
    )
    people: dict[str, _Person] = {}
    for row in rows_of(stream, design, path):
        name = row.text("participant")
        if not name:
            raise row.wrong("participant", "a participant must have a name")
        person = people.setdefault(name, _Person())
        _take_own(person, row, own)
        if "actor" not in person.own and len(design.groups) > 1:
            raise row.wrong("actor", f"actor must be one of {', '.join(design.groups)}, got ''")
        _take_sample(person, row, design)
    return Answers(design, tuple(_participant(name, person, design) for name, person in people.items()))


def _take_own(person: _Person, row: Row, columns: tuple[str, ...]) -> None:
    """Take what a row says of the participant: the same as the rows before, or nothing."""
    said = tuple(row.cells.get(column, "") for column in columns)
    if said == person.said:
        return
    for column in columns:
        text = row.text(column)
        before = person.own.setdefault(column, row).text(column) if text else ""
        if text != before:
            raise row.wrong(column, f"a participant must have one {column}, got {text!r} and {before!r}")
    person.said = said


def _take_sample(person: _Person, row: Row, design: Design) -> None:
    key = row.text("instruction")
    if not key:
        return
    row.ruled_by("instruction", design.instruction)
    time, satisfaction = (row.ruled_by(name, partial(_number, name)) for name in MEASURED)
    if not 0 <= satisfaction <= 1:
        raise row.wrong("satisfaction", f"satisfaction must lie in [0, 1], got {satisfaction:g}")
    samples = person.samples.setdefault(key, {})
    if time in samples:
        raise row.wrong("time_s", f"samples of a curve must have different times, got {time:g} s twice")
    samples[time] = satisfaction
    if row.text("shown"):
        person.shown[key] = row.ruled_by("shown", partial(_whole, "shown"))


def _participant(name: str, person: _Person, design: Design) -> Participant:
    about = {
        question.key: person.read(ABOUT + question.key, question.checked, "")
        for question in design.demographics
    }
    return Participant(
        name=name,
        group=person.read("actor", partial(_group, design), next(iter(design.groups))),
        order=tuple(sorted(person.samples, key=lambda key: person.shown.get(key, 0))),
        curves={key: resampled(samples.items(), design) for key, samples in person.samples.items()},
        demographics={key: answer for key, answer in about.items() if answer},
        control=person.read("control", partial(_control, design), None),
        origin=person.read("origin", _origin, Origin.IMPORTED),
        finished=person.read("finished", _truth, otherwise=True),
        excluded=person.read("excluded", str, None),
    )


def _number(name: str, text: str) -> float:
    try:
        value = float(text)
    except ValueError as error:
        raise FuzzytimeError(f"{name} must be a number, got {text[:40]!r}") from error
    if not math.isfinite(value):
        raise FuzzytimeError(f"{name} must be finite, got {text[:40]!r}")
    return value


def _whole(name: str, text: str) -> int:
    value = _number(name, text)
    if value != int(value):
        raise FuzzytimeError(f"{name} must be a whole number, got {text[:40]!r}")
    return int(value)


def _group(design: Design, text: str) -> str:
    if text not in design.groups:
        raise FuzzytimeError(f"actor must be one of {', '.join(design.groups)}, got {text[:40]!r}")
    return text


def _control(design: Design, text: str) -> int | None:
    return design.control_answer(_whole("control", text))


def _origin(text: str) -> Origin:
    if text not in set(Origin):
        raise FuzzytimeError(f"origin must be one of {', '.join(Origin)}, got {text[:40]!r}")
    return Origin(text)


def _truth(text: str) -> bool:
    if text.lower() not in _TRUTHS:
        raise FuzzytimeError(f"finished must be 1 or 0, got {text[:40]!r}")
    return _TRUTHS[text.lower()]
