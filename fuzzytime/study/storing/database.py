"""One SQLite file whose acknowledged transactions survive a kill and a power cut: WAL, synchronous FULL."""

import os
import sqlite3
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from fuzzytime.errors import FuzzytimeError


class Database:
    """A file of tables, created with them where it is empty; one object may serve several threads.

    Parameters
    ----------
    path : Path
        The file.
    kind : int
        What the file must be: SQLite's ``application_id``.
    schema : int
        The version of the tables that this program knows.
    tables : str
        SQL that creates them.
    create : bool
        Whether to create the file where there is none.

    Raises
    ------
    OSError
        If the file cannot be read or, where it is new, written.
    FuzzytimeError
        If it holds something else, or tables of a later version.
    """

    def __init__(self, path: Path, kind: int, schema: int, tables: str, *, create: bool) -> None:
        self.path = path
        self._lock = threading.RLock()
        with path.open("ab" if create else "rb"):
            pass
        self._connection = self._connected()
        try:
            with self.reading() as connection:
                found, version, count = (
                    int(connection.execute(question).fetchone()[0])
                    for question in (
                        "PRAGMA application_id",
                        "PRAGMA user_version",
                        "SELECT COUNT(*) FROM sqlite_master",
                    )
                )
                empty = not count
                if not (empty and create):
                    self._admit(found == kind and not empty, version <= schema)
                if not self._immutable:
                    connection.execute("PRAGMA journal_mode = WAL")
                    connection.execute("PRAGMA synchronous = FULL")
                    connection.execute("PRAGMA foreign_keys = ON")
            if empty:
                with self.writing() as connection:
                    for statement in tables.split(";"):
                        connection.execute(statement)
                    connection.execute(f"PRAGMA application_id = {kind}")
                    connection.execute(f"PRAGMA user_version = {schema}")
        except BaseException:
            self._connection.close()
            raise

    def _admit(self, right: bool, known: bool) -> None:  # noqa: FBT001 - two facts about the file
        if not right:
            raise FuzzytimeError(f"{self.path} holds none of fuzzytime's answers")
        if not known:
            raise FuzzytimeError(f"{self.path} was written by a later version of fuzzytime")

    def close(self) -> None:
        """Close the file."""
        with self._lock:
            self._connection.close()

    @contextmanager
    def reading(self) -> Iterator[sqlite3.Connection]:
        """Read, alone among threads."""
        with self._lock, self._errors():
            yield self._connection

    @contextmanager
    def writing(self) -> Iterator[sqlite3.Connection]:
        """Write in one transaction, on the disk at its end; inside another it is part of that one."""
        with self._lock, self._errors():
            if self._connection.in_transaction:
                yield self._connection
                return
            self._connection.execute("BEGIN IMMEDIATE")
            try:
                yield self._connection
                self._connection.commit()
            except BaseException:
                self._connection.rollback()
                raise

    @contextmanager
    def _errors(self) -> Iterator[None]:
        """Say what is wrong: a file that cannot be written, or was closed, is an `OSError`."""
        try:
            yield
        except (sqlite3.OperationalError, sqlite3.ProgrammingError) as error:
            raise OSError(f"{self.path}: {error}") from error
        except (sqlite3.DatabaseError, ValueError) as error:
            raise FuzzytimeError(f"{self.path} holds nothing that can be read: {error}") from error

    @property
    def _immutable(self) -> bool:
        """Whether the file or its folder cannot be written."""
        return not (os.access(self.path, os.W_OK) and os.access(self.path.absolute().parent, os.W_OK))

    def _connected(self) -> sqlite3.Connection:
        with self._errors():
            if not self._immutable:
                return sqlite3.connect(self.path, timeout=30.0, check_same_thread=False, isolation_level=None)
            beside = self.path.with_name(self.path.name + "-wal")
            if beside.exists() and beside.stat().st_size:
                raise FuzzytimeError(f"{self.path} has answers in {beside.name}: its folder must be writable")
            # SQLite would want to write beside the file unless it is told that nothing changes.
            address = f"{self.path.absolute().as_uri()}?mode=ro&immutable=1"
            return sqlite3.connect(address, uri=True, check_same_thread=False, isolation_level=None)
