"""The tables of a study's file, and how their rows become participants."""

import json
import sqlite3
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Floats
from fuzzytime.study.answers.participants import Origin, Participant
from fuzzytime.study.asking.design import Design

KIND = 0x667A7431
"""Marks the file as a study's."""

SCHEMA = 1

TABLES = """
CREATE TABLE study (
    only INTEGER PRIMARY KEY CHECK (only = 1),
    design TEXT NOT NULL,
    token TEXT NOT NULL DEFAULT ''
);
CREATE TABLE participants (
    position INTEGER PRIMARY KEY,
    name TEXT NOT NULL UNIQUE,
    actor TEXT NOT NULL,
    instructions TEXT NOT NULL,
    origin TEXT NOT NULL,
    control INTEGER,
    finished INTEGER NOT NULL DEFAULT 0,
    excluded TEXT,
    joined TEXT NOT NULL DEFAULT ''
);
CREATE TABLE demographics (
    participant TEXT NOT NULL REFERENCES participants (name),
    question TEXT NOT NULL,
    answer TEXT NOT NULL,
    PRIMARY KEY (participant, question)
);
CREATE TABLE curves (
    participant TEXT NOT NULL REFERENCES participants (name),
    instruction TEXT NOT NULL,
    samples BLOB NOT NULL,
    saved TEXT NOT NULL DEFAULT '',
    PRIMARY KEY (participant, instruction)
);
"""


def participants_in(
    connection: sqlite3.Connection, design: Design, where: str = "", values: tuple[str, ...] = ()
) -> Iterator[Participant]:
    """Read participants with all their answers; ``where`` is SQL of the program's own, never of people.

    Raises
    ------
    FuzzytimeError
        If somebody else wrote into the file, and a participant has an answer that is none.
    """
    rows = connection.execute(
        "SELECT name, actor, instructions, origin, control, finished, excluded "  # noqa: S608 - two fixed texts
        f"FROM participants {where} ORDER BY position",
        values,
    ).fetchall()
    for name, group, order, origin, control, finished, excluded in rows:
        curves = connection.execute(
            "SELECT instruction, samples FROM curves WHERE participant = ? ORDER BY rowid", (name,)
        )
        demographics = connection.execute(
            "SELECT question, answer FROM demographics WHERE participant = ?", (name,)
        )
        try:
            person = Participant(
                name=name,
                group=group,
                order=tuple(json.loads(order)),
                curves={key: np.frombuffer(samples, "<f8").astype(float) for key, samples in curves},
                demographics=dict(demographics.fetchall()),
                control=None if control is None else int(control),
                origin=Origin(origin),
                finished=bool(finished),
                excluded=excluded,
            )
            checked = checked_participant(person, design)
        except (FuzzytimeError, TypeError, ValueError) as error:
            raise FuzzytimeError(f"participant {str(name)[:80]!r}: {error}") from error
        yield checked


def must_exist(connection: sqlite3.Connection, name: str) -> None:
    """Check that there is a participant of a name.

    Raises
    ------
    FuzzytimeError
        If there is none.
    """
    if not connection.execute("SELECT 1 FROM participants WHERE name = ?", (name,)).fetchone():
        raise FuzzytimeError(f"there is no participant {name[:80]!r}")


def checked_participant(person: Participant, design: Design) -> Participant:
    """Give a participant whose answers are all to what the design asks.

    Raises
    ------
    FuzzytimeError
        If one is not.
    """
    if person.group not in design.groups:
        raise FuzzytimeError(f"a group must be one of {', '.join(design.groups)}, got {person.group!r}")
    for key in (*person.order, *person.curves):
        design.instruction(str(key))
    about = {key: design.question(key).checked(answer) for key, answer in person.demographics.items()}
    if person.control is not None:
        design.control_answer(person.control)
    return replace(
        person,
        curves={key: checked_curve(curve, design) for key, curve in person.curves.items()},
        demographics={key: answer for key, answer in about.items() if answer},
    )


def checked_curve(values: ArrayLike, design: Design) -> Floats:
    """Give a curve as an array of shape (samples,).

    Raises
    ------
    FuzzytimeError
        If there are not as many satisfactions as the design has samples, or one is not in [0, 1].
    """
    try:
        curve = np.asarray(values, float)
    except (TypeError, ValueError, OverflowError) as error:
        raise FuzzytimeError("a curve must be a list of numbers") from error
    if curve.shape != (design.timeline.samples,):
        raise FuzzytimeError(f"a curve must have {design.timeline.samples} samples, got shape {curve.shape}")
    if not ((curve >= 0) & (curve <= 1)).all():
        raise FuzzytimeError("satisfactions must lie in [0, 1]")
    return curve
