"""A study's answers in one SQLite file: what was acknowledged is on the disk.

Every write is one transaction of a `Database`. The file holds the design as YAML, so that it can be analysed
without any other file. Curves are little-endian doubles, one per sample.
"""

import json
import sqlite3
from collections.abc import Iterable, Mapping
from pathlib import Path
from types import TracebackType
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.errors import FuzzytimeError
from fuzzytime.study.answers.participants import Answers, Origin, Participant
from fuzzytime.study.asking.design import Design
from fuzzytime.study.storing.database import Database
from fuzzytime.study.storing.store_rows import (
    KIND,
    SCHEMA,
    TABLES,
    checked_curve,
    checked_participant,
    must_exist,
    participants_in,
)


class AnswerStore:
    """The answers of one study, on disk; one object may serve several threads.

    Open it by `create` or `open`, and close it, or use it as a context manager.
    """

    def __init__(self, database: Database, design: Design) -> None:
        self.design = design
        self._database = database

    @classmethod
    def create(cls, path: Path, design: Design) -> "AnswerStore":
        """Begin a study's file, or open it where it is there with the same design.

        Raises
        ------
        OSError
            If the file cannot be written.
        FuzzytimeError
            If it is there and is no study, or one with another design.
        """
        database = Database(path, KIND, SCHEMA, TABLES, create=True)
        with database.writing() as connection:
            connection.execute("INSERT OR IGNORE INTO study (only, design) VALUES (1, ?)", (design.yaml,))
        store = cls._of(database)
        if store.design.yaml != design.yaml:
            store.close()
            begun = store.design.name
            other = (
                f"another version of {begun!r}" if begun == design.name else f"{begun!r}, got {design.name!r}"
            )
            raise FuzzytimeError(f"a study keeps its design: {path} was begun with {other}")
        return store

    @classmethod
    def open(cls, path: Path) -> "AnswerStore":
        """Open a study's file.

        Raises
        ------
        OSError
            If it cannot be read.
        FuzzytimeError
            If it is no study, or one of a later version of fuzzytime.
        """
        return cls._of(Database(path, KIND, SCHEMA, TABLES, create=False))

    @classmethod
    def _of(cls, database: Database) -> "AnswerStore":
        try:
            with database.reading() as connection:
                row = connection.execute("SELECT design FROM study").fetchone()
            return cls(database, Design.of_text(str(row[0]) if row else "", f"{database.path}:design"))
        except BaseException:
            database.close()
            raise

    def close(self) -> None:
        """Close the file."""
        self._database.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def token(self, new: str) -> str:
        """Give the token that requests to this study must know; the first time, it becomes ``new``.

        A study keeps it, so that participants may come back after its server was started again.
        """
        with self._database.writing() as connection:
            connection.execute("UPDATE study SET token = ? WHERE token = ''", (new,))
            return str(connection.execute("SELECT token FROM study").fetchone()[0])

    # -- writing --------------------------------------------------------------------------------------------

    def join(self, name: str, at: str, *, origin: Origin = Origin.PAGE) -> Participant:
        """Add a participant: to the smallest group, with the instructions in a random order of their own.

        Group and order follow from how many came before and from the name, so that they can be repeated.

        Parameters
        ----------
        name : str
            A new random identifier.
        at : str
            When, for the record.
        """
        with self._database.writing() as connection:
            rows = connection.execute("SELECT actor, COUNT(*) FROM participants GROUP BY actor").fetchall()
            sizes = {str(actor): int(count) for actor, count in rows}
            smallest = min(sizes.get(group, 0) for group in self.design.groups)
            open_groups = [group for group in self.design.groups if sizes.get(group, 0) == smallest]
            generator = np.random.default_rng([*name.encode()])
            group = str(generator.choice(open_groups))
            order = [str(key) for key in generator.permutation([e.key for e in self.design.instructions])]
            connection.execute(
                "INSERT INTO participants (name, actor, instructions, origin, joined) VALUES (?, ?, ?, ?, ?)",
                (name, group, json.dumps(order), origin.value, at),
            )
        return Participant(
            name=name, group=group, order=tuple(order), curves={}, origin=origin, finished=False
        )

    def save_demographics(self, name: str, answers: Mapping[str, str]) -> None:
        """Save answers about a participant in place of earlier ones; those left open are not kept.

        Raises
        ------
        FuzzytimeError
            If there is no such participant, question or answer.
        """
        checked = {key: self.design.question(key).checked(answer) for key, answer in answers.items()}
        with self._database.writing() as connection:
            must_exist(connection, name)
            connection.execute("DELETE FROM demographics WHERE participant = ?", (name,))
            connection.executemany(
                "INSERT INTO demographics VALUES (?, ?, ?)",
                [(name, key, answer) for key, answer in checked.items() if answer],
            )

    def save_curve(self, name: str, key: str, values: ArrayLike, at: str) -> None:
        """Save a participant's curve for an instruction in place of an earlier one.

        Parameters
        ----------
        values : array of shape (samples,)
            Satisfactions in [0, 1] at the design's times.

        Raises
        ------
        FuzzytimeError
            If there is no such participant or instruction, or the values are none.
        """
        self.design.instruction(key)
        samples = checked_curve(values, self.design)
        with self._database.writing() as connection:
            must_exist(connection, name)
            connection.execute(
                "INSERT OR REPLACE INTO curves VALUES (?, ?, ?, ?)",
                (name, key, samples.astype("<f8").tobytes(), at),
            )

    def save_control(self, name: str, answer: int) -> None:
        """Save the answer to the control question.

        Raises
        ------
        FuzzytimeError
            If there is no such participant, or no such point on the scale.
        """
        self.design.control_answer(answer)
        with self._database.writing() as connection:
            must_exist(connection, name)
            connection.execute("UPDATE participants SET control = ? WHERE name = ?", (answer, name))

    def finish(self, name: str) -> None:
        """Note that a participant reached the end.

        Raises
        ------
        FuzzytimeError
            If there is no such participant.
        """
        with self._database.writing() as connection:
            must_exist(connection, name)
            connection.execute("UPDATE participants SET finished = 1 WHERE name = ?", (name,))

    def exclude(self, name: str, reason: str | None) -> None:
        """Exclude a participant for a reason, or take that back with None; the answers stay.

        Raises
        ------
        FuzzytimeError
            If there is no such participant, or the reason is empty.
        """
        if reason is not None and not reason.strip():
            raise FuzzytimeError("excluding a participant needs a reason")
        with self._database.writing() as connection:
            must_exist(connection, name)
            connection.execute("UPDATE participants SET excluded = ? WHERE name = ?", (reason, name))

    def add(self, participants: Iterable[Participant], at: str = "") -> int:
        """Add whole participants, all or none, and say how many.

        Raises
        ------
        FuzzytimeError
            If a name is there already, or an answer is none that the design asks for.
        """
        count = 0
        with self._database.writing() as connection:
            for person in participants:
                self._add(connection, person, at)
                count += 1
        return count

    def _add(self, connection: sqlite3.Connection, person: Participant, at: str) -> None:
        checked_participant(person, self.design)
        if connection.execute("SELECT 1 FROM participants WHERE name = ?", (person.name,)).fetchone():
            raise FuzzytimeError(
                f"participants must differ, and {person.name!r} is already in {self._database.path}"
            )
        connection.execute(
            "INSERT INTO participants "
            "(name, actor, instructions, origin, control, finished, excluded, joined) "
            "VALUES (?, ?, ?, ?, ?, ?, ?, ?)",
            (
                person.name,
                person.group,
                json.dumps(person.order),
                person.origin.value,
                person.control,
                int(person.finished),
                person.excluded,
                at,
            ),
        )
        self.save_demographics(person.name, person.demographics)
        for key, values in person.curves.items():
            self.save_curve(person.name, key, values, at)
        if person.control is not None:
            self.save_control(person.name, person.control)

    # -- reading --------------------------------------------------------------------------------------------

    def participant(self, name: str) -> Participant:
        """Give one participant's answers.

        Raises
        ------
        FuzzytimeError
            If there is none of that name.
        """
        with self._database.reading() as connection:
            must_exist(connection, name)
            return next(participants_in(connection, self.design, "WHERE name = ?", (name,)))

    def answers(self) -> Answers:
        """Give everybody's answers, in the order in which they came."""
        with self._database.reading() as connection:
            return Answers(self.design, tuple(participants_in(connection, self.design)))
