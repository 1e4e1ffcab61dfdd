"""Sessions in SQLite: every step durable before it is acknowledged, and undoable."""

import errno
import json
import sqlite3
import weakref
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from dataclasses import asdict, dataclass, replace
from datetime import datetime
from pathlib import Path

from fuzzytime_cli.faults import NoInputError
from fuzzytime_cli.render import plain
from fuzzytime_cli.session.document import instant_text, started_of, state_of, state_text
from fuzzytime_cli.session.state import KeptRating, Started, State

KEPT_STEPS = 1_000
"""How many steps can be undone."""

WAIT = 10.0
"""Seconds to wait for another terminal that writes."""

_TABLES = """
CREATE TABLE IF NOT EXISTS sessions (name TEXT PRIMARY KEY, head INTEGER NOT NULL);
CREATE TABLE IF NOT EXISTS steps (
    session TEXT NOT NULL, number INTEGER NOT NULL, parent INTEGER, what TEXT NOT NULL, state TEXT NOT NULL,
    PRIMARY KEY (session, number)
);
CREATE TABLE IF NOT EXISTS started (
    session TEXT NOT NULL, identifier TEXT NOT NULL, skill TEXT NOT NULL, PRIMARY KEY (session, identifier)
);
"""


_HEAD = "SELECT {} FROM steps JOIN sessions ON name = session AND head = number WHERE name = ?"


_CHANGED = "UPDATE started SET skill = ? WHERE session = ? AND identifier = ?"
_FORGOTTEN = "DELETE FROM started WHERE session = ? AND identifier = ?"


@dataclass(frozen=True, slots=True)
class _Told:
    """What was told of a skill behind a step, and how it was kept before; None where it had not started."""

    version: int
    identifier: str
    name: str
    before: str | None


class NotKeptError(OSError):
    """A step could not be written, as where the disk is full; what was kept before is whole."""


class SessionStore:
    """Sessions in one SQLite file: every step is durable before it is acknowledged.

    Steps form a tree; the head is where the conversation stands. Terminals that share a session apply their
    steps to the newest state, one after the other, so that none is lost.
    """

    def __init__(self, path: Path | None) -> None:
        """Open or make the file; None keeps everything in memory."""
        self.path = path
        if path is not None:
            path.parent.mkdir(parents=True, exist_ok=True)
            if not path.exists():
                path.touch(mode=0o600)
        self._connection = sqlite3.connect(
            str(path) if path is not None else ":memory:",
            timeout=WAIT,
            isolation_level=None,
            check_same_thread=False,
        )
        # One that nobody closed is closed when nobody has it any more.
        weakref.finalize(self, self._connection.close)
        try:
            self._connection.execute("PRAGMA journal_mode=WAL")
            self._connection.execute("PRAGMA synchronous=FULL")
            self._connection.executescript(_TABLES)
        except sqlite3.Error:
            self._connection.close()
            raise
        self._told: dict[str, _Told] = {}

    def close(self) -> None:
        """Close the file."""
        self._connection.close()

    @contextmanager
    def _writing(self) -> Iterator[sqlite3.Connection]:
        """Hold the file's one write lock from reading the newest state to writing the next."""
        connection = self._connection
        try:
            connection.execute("BEGIN IMMEDIATE")
            yield connection
            connection.execute("COMMIT")
        except BaseException as error:
            if connection.in_transaction:
                connection.execute("ROLLBACK")
            if isinstance(error, sqlite3.Error):
                message = f"this is not kept, and not done: {error}"
                raise NotKeptError(errno.EIO, message, str(self.path)) from error
            raise

    def names(self) -> tuple[str, ...]:
        """Give the names of all sessions."""
        rows = self._connection.execute("SELECT name FROM sessions ORDER BY name").fetchall()
        return tuple(row[0] for row in rows)

    def version(self, name: str) -> int:
        """Give the head's number, by which another terminal's step is noticed; 0 for a new session."""
        row = self._connection.execute("SELECT head FROM sessions WHERE name = ?", (name,)).fetchone()
        return int(row[0]) if row is not None else 0

    def state(self, name: str) -> State:
        """Give the state that a session stands at; an empty one for a new session."""
        row = self._connection.execute(
            _HEAD.format("state"),
            (name,),
        ).fetchone()
        return state_of(row[0]) if row is not None else State()

    def ratings(self) -> tuple[KeptRating, ...]:
        """Give the ratings of all sessions: they are one person's."""
        return tuple(kept for name in self.names() for kept in self.state(name).ratings)

    def change(self, name: str, what: str, step: Callable[[State], State]) -> State:
        """Apply a step to the newest state, keep the result, and give it.

        Raises
        ------
        FuzzytimeError
            From the step; nothing is changed then.
        """
        with self._writing() as connection:
            head = self.version(name)
            new = step(self.state(name))
            number = 1 + int(
                connection.execute(
                    "SELECT COALESCE(MAX(number), 0) FROM steps WHERE session = ?", (name,)
                ).fetchone()[0]
            )
            connection.execute(
                "INSERT INTO steps VALUES (?, ?, ?, ?, ?)",
                # Bytes that are no text (lone surrogates) SQLite does not take; JSON writes them as escapes.
                (name, number, head, plain(what), state_text(new)),
            )
            self._move(name, number)
            connection.execute(
                "DELETE FROM steps WHERE session = ? AND number <= ?", (name, number - KEPT_STEPS)
            )
        return new

    def _move(self, name: str, head: int) -> None:
        self._connection.execute(
            "INSERT INTO sessions VALUES (?, ?) ON CONFLICT (name) DO UPDATE SET head = excluded.head",
            (name, head),
        )

    def undo(self, name: str) -> str:
        """Go back one step and say which; empty where there is none."""
        if told := self._untold(name):
            return told
        with self._writing() as connection:
            row = connection.execute(
                _HEAD.format("parent, what"),
                (name,),
            ).fetchone()
            if row is None:
                return ""
            parent = connection.execute(
                "SELECT 1 FROM steps WHERE session = ? AND number = ?", (name, row[0])
            ).fetchone()
            if row[0] and parent is None:
                return ""  # too long ago: the step before is not kept
            self._move(name, int(row[0]))
            return str(row[1])

    def redo(self, name: str) -> str:
        """Go forward again to the step undone last and say which; empty where there is none."""
        with self._writing() as connection:
            row = connection.execute(
                "SELECT number, what FROM steps WHERE session = ? AND parent = ? ORDER BY number DESC",
                (name, self.version(name)),
            ).fetchone()
            if row is None:
                return ""
            self._move(name, int(row[0]))
            return str(row[1])

    # -- what has started is kept beside the steps; undo takes back only what was told of it last, and here --

    def started(self, name: str) -> tuple[Started, ...]:
        """Give the skills that have started."""
        rows = self._connection.execute(
            "SELECT skill FROM started WHERE session = ? ORDER BY rowid", (name,)
        ).fetchall()
        return tuple(started_of(text) for (text,) in rows)

    def note_started(self, name: str, started: Started) -> bool:
        """Note that a skill has started, and say whether it is news: another terminal may have noted it."""
        with self._writing() as connection:
            cursor = connection.execute(
                "INSERT OR IGNORE INTO started VALUES (?, ?, ?)",
                (name, started.identifier, json.dumps(asdict(started), default=instant_text)),
            )
            return cursor.rowcount == 1

    def note_over(self, name: str, started: Started) -> None:
        """Note that a skill that had not started is told to be done."""
        if self.note_started(name, started):
            self._told[name] = _Told(self.version(name), started.identifier, started.name, None)

    def note_done(self, name: str, identifier: str, at: datetime) -> None:
        """Note that a started skill was done at an instant."""
        self._note(name, identifier, lambda one: replace(one, done=at, end=min(one.end, at)))

    def note_until(self, name: str, identifier: str, end: datetime, done: datetime) -> None:
        """Note that a started skill keeps its agent until one instant, and is done at another."""
        self._note(name, identifier, lambda one: replace(one, end=end, done=done))

    def _note(self, name: str, identifier: str, change: Callable[[Started], Started]) -> None:
        with self._writing() as connection:
            row = connection.execute(
                "SELECT skill FROM started WHERE session = ? AND identifier = ?", (name, identifier)
            ).fetchone()
            if row is None:
                raise NoInputError(f"{identifier} has not started")
            before = started_of(row[0])
            changed = json.dumps(asdict(change(before)), default=instant_text)
            connection.execute(_CHANGED, (changed, name, identifier))
        self._told[name] = _Told(self.version(name), identifier, before.name, row[0])

    def _untold(self, name: str) -> str:
        """Take back what was told last of what has started, if no step was taken since, and say of which."""
        told = self._told.get(name)
        if told is None or told.version != self.version(name):
            return ""
        del self._told[name]
        with self._writing() as connection:
            if told.before is None:
                connection.execute(_FORGOTTEN, (name, told.identifier))
            else:
                connection.execute(_CHANGED, (told.before, name, told.identifier))
        return f"what was told of {told.name}"


def open_store(path: Path | None) -> tuple[SessionStore, str]:
    """Open the store; where it cannot be written, go on with what it holds in memory, and say why."""
    try:
        return SessionStore(path), ""
    except (OSError, sqlite3.Error) as error:
        reason = error.strerror if isinstance(error, OSError) else None
        return _copied(path), f"{path}: {reason or error}"


def damage_of(path: Path) -> str:
    """Say what is wrong with a store's file that is no database, or a broken one; nothing is written."""
    try:
        with closing(sqlite3.connect(f"{path.absolute().as_uri()}?mode=ro", uri=True)) as file:
            (found,) = file.execute("PRAGMA quick_check(1)").fetchone()
    except sqlite3.OperationalError:  # locked, or on a disk that cannot be written: whole all the same
        return ""
    except sqlite3.DatabaseError as error:
        return str(error)
    return "" if found == "ok" else str(found)


def _copied(path: Path | None) -> SessionStore:
    """Copy a file that can only be read into memory; of one that cannot be read nothing comes."""
    # Where no file may be made beside it, SQLite reads a file only if told that nobody writes it.
    for how in ("mode=ro", "mode=ro&immutable=1"):
        store = SessionStore(None)
        try:
            with closing(sqlite3.connect(f"{Path(path or '').absolute().as_uri()}?{how}", uri=True)) as file:
                file.backup(store._connection)  # noqa: SLF001 - this module's own
            store.names()
        except sqlite3.Error:
            store.close()
        else:
            return store
    return SessionStore(None)
