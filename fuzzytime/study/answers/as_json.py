"""Answers as one JSON document, which holds its design, for other programs and back."""

import json
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TextIO, TypeVar

from fuzzytime.errors import DocumentError, FuzzytimeError, Mistake
from fuzzytime.satisfaction import Floats
from fuzzytime.study.answers.participants import Answers, Origin, Participant
from fuzzytime.study.answers.places import path_text, place_of
from fuzzytime.study.answers.sampling import resampled
from fuzzytime.study.asking.design import Design
from fuzzytime.study.asking.questions import is_writable

_T = TypeVar("_T")

SCHEMA = "fuzzytime-study/1"

Path = tuple[str | int, ...]
"""Keys and positions that lead to a value of the document."""


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


def read_json(text: str, path: str = "answers.json") -> Answers:
    """Read what `write_json` wrote, with the design in it.

    Raises
    ------
    DocumentError
        At the first value that breaks a rule, with its place.
    """
    try:
        document = json.loads(text, parse_constant=_no_constant)
    except json.JSONDecodeError as error:
        raise _mistake(text, path, (), f"not valid JSON: {error.msg}", (error.lineno, error.colno)) from error
    except (ValueError, RecursionError) as error:
        raise _mistake(text, path, (), f"not valid JSON: {error}", (1, 1)) from error
    try:
        return _answers(document, path)
    except _WrongError as error:
        raise _mistake(text, path, error.path, str(error), place_of(text, error.path)) from error


def _no_constant(name: str) -> float:
    raise ValueError(f"numbers must be finite, got {name}")


def _mistake(text: str, path: str, where: Path, message: str, place: tuple[int, int]) -> DocumentError:
    line, column = place
    lines = text.split("\n", line)
    source = lines[line - 1] if line <= len(lines) else ""
    return DocumentError((Mistake(path, line, column, path_text(where), message, source),))


class _WrongError(FuzzytimeError):
    """What rule a value of the document breaks, and where the value stands."""

    def __init__(self, path: Path, message: str) -> None:
        super().__init__(message)
        self.path = path


@dataclass(frozen=True, slots=True)
class _Value:
    """A value of the document, and the path to it."""

    value: object
    path: Path = ()

    def wrong(self, rule: str) -> _WrongError:
        return _WrongError(self.path, rule)

    def ruled_by(self, rule: Callable[[], _T]) -> _T:
        """Give what a rule makes of this value; what breaks it is said to stand here."""
        try:
            return rule()
        except FuzzytimeError as error:
            raise self.wrong(str(error)) from error

    def member(self, key: str) -> "_Value":
        """Give a member that must be there."""
        members = self.members()
        if key not in members:
            raise self.wrong(f"missing key {key!r}")
        return members[key]

    def members(self) -> Mapping[str, "_Value"]:
        if not isinstance(self.value, dict):
            raise self.wrong("must be an object")
        return {key: _Value(value, (*self.path, key)) for key, value in self.value.items()}

    def items(self) -> Sequence["_Value"]:
        if not isinstance(self.value, list):
            raise self.wrong("must be a list")
        return [_Value(value, (*self.path, position)) for position, value in enumerate(self.value)]

    def text(self) -> str:
        if not isinstance(self.value, str) or not is_writable(self.value):
            raise self.wrong("must be a text")
        return self.value

    def truth(self) -> bool:
        if not isinstance(self.value, bool):
            raise self.wrong("must be true or false")
        return self.value

    def numbers(self, low: float = -math.inf, high: float = math.inf) -> list[float]:
        """Give a list of finite numbers between two bounds."""
        values = self.value
        if not isinstance(values, list):
            raise self.wrong("must be a list of numbers")
        for position, value in enumerate(values):
            if type(value) not in (int, float) or not math.isfinite(value):
                raise _WrongError((*self.path, position), "must be a finite number")
            if not low <= value <= high:
                raise _WrongError((*self.path, position), f"must lie in [{low:g}, {high:g}], got {value:g}")
        return values


def _answers(document: object, path: str) -> Answers:
    root = _Value(document)
    schema = root.member("schema")
    if schema.value != SCHEMA:
        raise schema.wrong(f"a study's answers must have the schema {SCHEMA!r}")
    design = Design.of_text(root.member("design").text(), f"{path}:design")
    times_s = root.member("times_s")
    times = times_s.numbers()
    people: dict[str, Participant] = {}
    for entry in root.member("participants").items():
        person = _person(entry, times, design)
        if person.name in people:
            raise entry.member("participant").wrong(f"participants must differ, got {person.name!r} twice")
        people[person.name] = person
    return Answers(design, tuple(people.values()))


def _person(entry: _Value, times: list[float], design: Design) -> Participant:
    name, actor, origin = (entry.member(key) for key in ("participant", "actor", "origin"))
    if not name.text().strip():
        raise name.wrong("a participant must have a name")
    if actor.text() not in design.groups:
        raise actor.wrong(f"must be one of {', '.join(design.groups)}, got {actor.text()[:40]!r}")
    if origin.text() not in set(Origin):
        raise origin.wrong(f"must be one of {', '.join(Origin)}, got {origin.text()[:40]!r}")
    excluded = entry.member("excluded")
    if excluded.value is not None and not excluded.text().strip():
        raise excluded.wrong("excluding a participant needs a reason")
    about = {key: _about(key, value, design) for key, value in entry.member("about").members().items()}
    return Participant(
        name=name.text(),
        group=actor.text(),
        order=_order(entry.member("order"), design),
        curves={
            key: _curve(key, value, times, design) for key, value in entry.member("curves").members().items()
        },
        demographics={key: answer for key, answer in about.items() if answer},
        control=_control(entry.member("control"), design),
        origin=Origin(origin.text()),
        finished=entry.member("finished").truth(),
        excluded=None if excluded.value is None else excluded.text(),
    )


def _about(key: str, value: _Value, design: Design) -> str:
    answer = value.text()
    return value.ruled_by(lambda: design.question(key).checked(answer))


def _order(value: _Value, design: Design) -> tuple[str, ...]:
    keys = []
    for item in value.items():
        key = item.text()
        item.ruled_by(partial(design.instruction, key))
        if key in keys:
            raise item.wrong(f"instructions must differ, got {key!r} twice")
        keys.append(key)
    return tuple(keys)


def _curve(key: str, value: _Value, times: list[float], design: Design) -> Floats:
    values = value.numbers(0.0, 1.0)
    if len(values) != len(times):
        raise value.wrong(f"a curve must have as many samples as times, {len(times)}, got {len(values)}")
    value.ruled_by(lambda: design.instruction(key))
    return value.ruled_by(lambda: resampled(zip(times, values, strict=True), design))


def _control(value: _Value, design: Design) -> int | None:
    if value.value is None:
        return None
    answer = value.value
    if type(answer) is not int:
        raise value.wrong("must be a whole number or null")
    return value.ruled_by(lambda: design.control_answer(answer))
