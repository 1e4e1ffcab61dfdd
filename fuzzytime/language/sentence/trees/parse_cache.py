"""Parses kept on disk, so that a text parsed before needs no model: a value that the caller passes in.

A row is keyed by the text, the model and this program's version. The cache only ever saves time: where its
file cannot be used (locked for long, on a full disk), texts are parsed as if it were empty. A damaged file
gives way to a new one.
"""

import hashlib
import json
import sqlite3
from collections.abc import Iterable, Sequence
from contextlib import closing, suppress
from dataclasses import dataclass
from pathlib import Path

from fuzzytime.language.grammar.lexicon import Lexicon
from fuzzytime.language.sentence.trees.model import ModelPackage
from fuzzytime.language.sentence.trees.tree import Node, Tree

FORMAT = 17
"""Number of the format of the rows; part of their keys."""

ROWS = 50_000
"""Rows kept at most; the oldest go."""

_SCHEMA = "CREATE TABLE IF NOT EXISTS parses (key BLOB PRIMARY KEY, tree TEXT NOT NULL) "
_READING = 0.5
_WRITING = 5.0
"""Seconds that a lock is waited for."""
_MOST_KEYS = 500


@dataclass(frozen=True, slots=True)
class ParseCache:
    """A cache of parses in one SQLite file."""

    path: Path

    def known(self, texts: Sequence[str], package: ModelPackage, lexicon: Lexicon) -> dict[str, Tree]:
        """Give the trees of those texts that are there."""
        keys = {_key(text, package): text for text in texts}
        found: dict[str, Tree] = {}
        if not self.path.is_file():
            return found
        try:
            with closing(sqlite3.connect(self.path, timeout=_READING)) as connection:
                asked = list(keys)
                for first in range(0, len(asked), _MOST_KEYS):
                    part = asked[first : first + _MOST_KEYS]
                    marks = ",".join("?" * len(part))
                    rows = connection.execute(f"SELECT key, tree FROM parses WHERE key IN ({marks})", part)  # noqa: S608
                    for key, row in rows:
                        found[keys[key]] = _read(keys[key], row, lexicon)
        except (sqlite3.Error, OSError, ValueError, TypeError, IndexError):
            return {}
        return found

    def keep(self, trees: Iterable[Tree], package: ModelPackage) -> None:
        """Add trees, in one transaction."""
        rows = [(_key(tree.text, package), _written(tree)) for tree in trees]
        if not rows:
            return
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            with closing(sqlite3.connect(self.path, timeout=_WRITING)) as connection, connection:
                # Writers hold the lock only shortly where they need not wait for the disk.
                connection.execute("PRAGMA journal_mode = WAL")
                connection.execute("PRAGMA synchronous = NORMAL")
                connection.execute(_SCHEMA)
                connection.executemany("INSERT OR REPLACE INTO parses VALUES (?, ?)", rows)
                (count,) = connection.execute("SELECT COUNT(*) FROM parses").fetchone()
                if count > ROWS:
                    oldest = "SELECT rowid FROM parses ORDER BY rowid LIMIT ?"
                    connection.execute(f"DELETE FROM parses WHERE rowid IN ({oldest})", (count - ROWS,))  # noqa: S608
        except (sqlite3.Error, OSError) as error:
            if getattr(error, "sqlite_errorcode", None) in {sqlite3.SQLITE_NOTADB, sqlite3.SQLITE_CORRUPT}:
                self._remove()

    def _remove(self) -> None:
        """Make room for a new file: a damaged one would never be of use again."""
        for end in ("", "-wal", "-shm"):
            with suppress(OSError):
                self.path.with_name(self.path.name + end).unlink(missing_ok=True)


def _key(text: str, package: ModelPackage) -> bytes:
    said = f"{FORMAT}\n{package.identity}\n{text}"
    return hashlib.sha256(said.encode("utf-8", "surrogatepass")).digest()


def _written(tree: Tree) -> str:
    rows = [
        [n.start, n.end, n.tag, n.lemma, n.relation, n.head, int(n.may_act), int(n.may_name)]
        for n in tree.nodes
    ]
    return json.dumps(rows, separators=(",", ":"))


def _read(text: str, row: str, lexicon: Lexicon) -> Tree:
    """Read a row; one that does not fit its text is a ValueError."""
    nodes = []
    rows = json.loads(row)
    for start, end, tag, lemma, relation, head, *may in rows:
        if not 0 <= start < end <= len(text) or not 0 <= head < len(rows):
            raise ValueError("a row must fit its text")
        acts, names = map(bool, may)
        nodes.append(
            Node(text[start:end], start, end, str(tag), str(lemma), str(relation), head, acts, names)
        )
    return Tree(text, tuple(nodes), lexicon)
