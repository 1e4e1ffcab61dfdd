"""A person's ratings on disk: added, undone, exported."""

import json
from pathlib import Path
from types import TracebackType
from typing import Self

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import Bell, Rectangle, Sampled, SatisfactionFunction, Trapezoid, Triangle
from fuzzytime.study.database import Database
from fuzzytime.study.personal import Direction, Rating

KIND = 0x667A7432
"""Marks the file as one of ratings."""

SCHEMA = 1

_TABLES = """
CREATE TABLE ratings (
    position INTEGER PRIMARY KEY,
    given TEXT NOT NULL,
    rating TEXT NOT NULL,
    undone INTEGER NOT NULL DEFAULT 0
)
"""

_MODELS: dict[str, type[Trapezoid | Triangle | Rectangle | Bell | Sampled]] = {
    kind.model: kind for kind in (Trapezoid, Triangle, Rectangle, Bell, Sampled)
}


class RatingStore:
    """A person's ratings, in one SQLite file that is begun where it is not there.

    Raises
    ------
    OSError
        If the file cannot be read or written.
    FuzzytimeError
        If it holds something else.
    """

    def __init__(self, path: Path) -> None:
        self._database = Database(path, KIND, SCHEMA, _TABLES, create=True)

    def close(self) -> None:
        """Close the file."""
        self._database.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def add(self, rating: Rating, at: str) -> None:
        """Keep a rating; ``at`` says when it was given.

        Raises
        ------
        FuzzytimeError
            If its satisfaction function is none that can be kept.
        """
        text = json.dumps(document_of(rating))
        with self._database.writing() as connection:
            connection.execute("INSERT INTO ratings (given, rating) VALUES (?, ?)", (at, text))

    def undo(self) -> Rating | None:
        """Take back the last rating that counts, and give it; None where none is left."""
        with self._database.writing() as connection:
            row = connection.execute(
                "SELECT position, rating FROM ratings WHERE NOT undone ORDER BY position DESC LIMIT 1"
            ).fetchone()
            if row is None:
                return None
            connection.execute("UPDATE ratings SET undone = 1 WHERE position = ?", (row[0],))
        return rating_of(json.loads(row[1]))

    def ratings(self) -> tuple[Rating, ...]:
        """Give the ratings that count, in the order in which they were given."""
        with self._database.reading() as connection:
            rows = connection.execute("SELECT rating FROM ratings WHERE NOT undone ORDER BY position")
            return tuple(rating_of(json.loads(text)) for (text,) in rows.fetchall())

    def export(self) -> str:
        """Give all ratings as JSON lines, those that were undone as well."""
        with self._database.reading() as connection:
            rows = connection.execute(
                "SELECT given, rating, undone FROM ratings ORDER BY position"
            ).fetchall()
        lines = [{"given": given, **json.loads(text), "undone": bool(undone)} for given, text, undone in rows]
        return "".join(json.dumps(line) + "\n" for line in lines)


def document_of(rating: Rating) -> dict[str, object]:
    """Give a rating as a document that JSON can hold.

    Raises
    ------
    FuzzytimeError
        If its satisfaction function is none that can be kept.
    """
    function = rating.satisfaction
    if function.model not in _MODELS:
        known = ", ".join(_MODELS)
        raise FuzzytimeError(f"a rating's function must be one of {known}, got {function.model!r}")
    return {
        "model": function.model,
        "parameters": function.parameters,
        "t_spec_s": rating.t_spec,
        "start_s": rating.start,
        "preposition": rating.preposition,
        "score": rating.score,
        "direction": rating.direction,
    }


def rating_of(document: object) -> Rating:
    """Give the rating that a document holds.

    Raises
    ------
    FuzzytimeError
        If it holds none.
    """
    if not isinstance(document, dict):
        raise FuzzytimeError("a rating must be an object")
    try:
        kind = _MODELS[document["model"]]
        function: SatisfactionFunction = kind(**document["parameters"])
        direction = document["direction"]
        return Rating(
            satisfaction=function,
            t_spec=float(document["t_spec_s"]),
            start=float(document["start_s"]),
            preposition=document["preposition"],
            score=document["score"],
            direction=None if direction is None else Direction(direction),
        )
    except (KeyError, TypeError, ValueError) as error:
        raise FuzzytimeError(f"this is no rating: {error}") from error
