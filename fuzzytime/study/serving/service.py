"""What the study's page may ask of the server: requests as checked values, answers as JSON documents."""

import json
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import ClassVar

from fuzzytime.errors import FuzzytimeError
from fuzzytime.study.answers.participants import Participant
from fuzzytime.study.storing.store import AnswerStore

Document = Mapping[str, object]
"""What one JSON object holds."""


@dataclass(frozen=True, slots=True)
class StudyService:
    """The study's side of the page, apart from how requests come.

    Parameters
    ----------
    store : AnswerStore
        Where answers go; each is on the disk when its request is answered.
    clock : callable
        Gives the time, for the record.
    new_name : callable
        Gives a new participant's name, which nobody can guess: who knows it may go on with the answers.
    """

    store: AnswerStore
    clock: Callable[[], str]
    new_name: Callable[[], str]

    def design(self) -> Document:
        """Give what the page shows; an instruction is its words only, not the time that they specify."""
        design = self.store.design
        control = design.control
        return {
            "title": design.title,
            "timeline": {
                "start": design.timeline.start,
                "end": design.timeline.end,
                "samples": design.timeline.samples,
            },
            "default": design.default,
            "instructions": {entry.key: entry.text for entry in design.instructions},
            "demographics": [
                {
                    "key": entry.key,
                    "ask": entry.ask,
                    "choices": entry.choices,
                    "whole": entry.whole,
                    "length": entry.length,
                }
                for entry in design.demographics
            ],
            "control": None
            if control is None
            else {
                "text": control.text,
                "points": control.points,
                "lowest": control.lowest,
                "highest": control.highest,
            },
            "texts": dict(design.texts),
        }

    def answer(self, path: str, document: Document) -> Document:
        """Do what a request of the page asks.

        Raises
        ------
        FuzzytimeError
            If the request breaks a rule.
        OSError
            If the answer cannot be saved.
        """
        return self._ROUTES[path](self, document)

    @classmethod
    def paths(cls) -> frozenset[str]:
        """Give the paths that `answer` knows."""
        return frozenset(cls._ROUTES)

    def _join(self, document: Document) -> Document:
        if document.get("consent") is not True:
            raise FuzzytimeError("taking part needs consent")
        return self._state(self.store.join(self.new_name(), self.clock()))

    def _resume(self, document: Document) -> Document:
        return self._state(self.store.participant(_text(document, "participant")))

    def _demographics(self, document: Document) -> Document:
        answers = document.get("answers")
        if not isinstance(answers, dict) or not all(isinstance(value, str) for value in answers.values()):
            raise FuzzytimeError("answers must be an object of texts")
        self.store.save_demographics(_text(document, "participant"), answers)
        return _SAVED

    def _curve(self, document: Document) -> Document:
        values = document.get("values")
        if not isinstance(values, list) or not all(type(value) in (int, float) for value in values):
            raise FuzzytimeError("values must be a list of numbers")
        name, key = _text(document, "participant"), _text(document, "instruction")
        self.store.save_curve(name, key, values, self.clock())
        return _SAVED

    def _control(self, document: Document) -> Document:
        answer = document.get("answer")
        if type(answer) is not int:
            raise FuzzytimeError("answer must be a whole number")
        self.store.save_control(_text(document, "participant"), answer)
        return _SAVED

    def _finish(self, document: Document) -> Document:
        self.store.finish(_text(document, "participant"))
        return _SAVED

    def _state(self, person: Participant) -> Document:
        """Give where a participant stands."""
        return {
            "participant": person.name,
            "actor": self.store.design.groups[person.group],
            "order": person.order,
            "curves": {key: curve.tolist() for key, curve in person.curves.items()},
            "begun": bool(person.demographics or person.curves),
            "finished": person.finished,
        }

    _ROUTES: ClassVar[Mapping[str, Callable[["StudyService", Document], Document]]] = {
        "/join": _join,
        "/resume": _resume,
        "/demographics": _demographics,
        "/curve": _curve,
        "/control": _control,
        "/finish": _finish,
    }


_SAVED: Document = {"saved": True}


def _text(document: Document, key: str) -> str:
    value = document.get(key)
    if not isinstance(value, str):
        raise FuzzytimeError(f"{key} must be a text")
    return value


def read_document(body: bytes) -> Document:
    """Read a request's body.

    Raises
    ------
    FuzzytimeError
        If it is no JSON object; NaN and infinite numbers are none either.
    """

    def refused(name: str) -> float:
        raise FuzzytimeError(f"numbers must be finite, got {name}")

    try:
        document = json.loads(body.decode("utf-8"), parse_constant=refused)
    except (ValueError, RecursionError) as error:
        raise FuzzytimeError("a request's body must be JSON in UTF-8") from error
    if not isinstance(document, dict):
        raise FuzzytimeError("a request's body must be a JSON object")
    return document


def written(document: Document) -> bytes:
    """Write an answer's body."""
    return json.dumps(document, ensure_ascii=False, allow_nan=False).encode("utf-8", "backslashreplace")


def body_limit(samples: int) -> int:
    """Give the most bytes that a request may have: a curve, with room for its digits."""
    return 4096 + 32 * math.ceil(samples)
