"""Answers kept in a file, a line each, so that a batch that was ended goes on where it was."""

import json
import os
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from types import TracebackType
from typing import Any, BinaryIO, Self

from fuzzytime.errors import DocumentError, Mistake
from fuzzytime_cli.batch.answers import SCHEMA, Job, Recipe
from fuzzytime_cli.files import about_file, replace_file


@dataclass(frozen=True, slots=True)
class _Kept:
    """What an answer is of, and where it stands."""

    sha256: str | None
    settings: str
    begin: int
    end: int


@dataclass(slots=True)
class Journal:
    """A file of answers that is added to; each is with the system before the next is worked out."""

    path: Path
    resume: bool = False
    _stream: BinaryIO = field(init=False)
    _end: int = field(default=0, init=False)
    _kept: dict[str, _Kept] = field(default_factory=dict, init=False)
    _order: list[str] = field(default_factory=list, init=False)

    def __enter__(self) -> Self:
        """Open the file; to resume, read what it holds.

        Raises
        ------
        DocumentError
            If it holds something else than answers.
        OSError
            If it cannot be written.
        """
        self._stream = self.path.open("r+b" if self.resume and self.path.exists() else "w+b")
        try:
            if self.resume:
                self._read()
        except BaseException:
            self._stream.close()
            raise
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Make it durable, and close it."""
        with suppress(OSError):  # a pipe or a device
            os.fsync(self._stream.fileno())
        self._stream.close()

    def _read(self) -> None:
        """Note what is answered; of a last line that was cut short nothing stays."""
        for number, line in enumerate(self._stream, 1):
            if not line.endswith(b"\n"):
                break
            self._note(line, number)
        self._stream.seek(self._end)
        self._stream.truncate()

    def _note(self, line: bytes, number: int) -> None:
        found = _object(line)
        if found.get("schema") != SCHEMA:
            rule = "to resume, a file must hold nothing but the answers of a batch"
            raise DocumentError((Mistake(str(self.path), number, 1, "", rule),))
        name, sha256, settings = str(found.get("file")), found.get("sha256"), str(found.get("settings"))
        self._kept[name] = _Kept(sha256, settings, self._end, self._end + len(line))
        self._order.append(name)
        self._end += len(line)

    def holds(self, job: Job, recipe: Recipe) -> bool:
        """Say whether a file with this content is answered already, by the same settings."""
        kept = self._kept.get(job.name)
        wanted = (job.sha256, recipe.fingerprint)
        return kept is not None and job.sha256 is not None and (kept.sha256, kept.settings) == wanted

    def add(self, line: str) -> None:
        """Add an answer."""
        raw = line.encode()
        with about_file(self.path):
            self._stream.write(raw)
            self._stream.flush()
        self._note(raw, len(self._order) + 1)

    def put_in_order(self, names: Sequence[str]) -> None:
        """Leave of each file its last answer, in the order given; nothing is written where that is so."""
        if self._order == list(names) or not self.path.is_file():
            return
        replace_file(self.path, map(self._text, names))

    def _text(self, name: str) -> str:
        kept = self._kept[name]
        self._stream.seek(kept.begin)
        return self._stream.read(kept.end - kept.begin).decode()


def _object(line: bytes) -> dict[str, Any]:
    """Read a line as a JSON object, empty where it is none."""
    try:
        found = json.loads(line)
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}
