"""What is made of documents, kept on disk, so that a program's next start need not read them again.

It only ever saves time: what cannot be kept, or is damaged, is made anew. A file that somebody else could
have written is not read, as it says what words mean.
"""

import hashlib
import os
import stat
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TypeVar, cast

from fuzzytime.documents.plain import made_again, written

MOST = 4
"""Files of one name that are kept: as many tables as one person goes between."""

CODE = Path(__file__).parent.parent
"""The library's own modules: with another library, everything is made anew."""

_Made = TypeVar("_Made")


@dataclass(frozen=True, slots=True)
class Kept:
    """A folder where what is made of documents is kept."""

    folder: Path

    def made(self, name: str, files: Sequence[Path], make: Callable[[], _Made]) -> _Made:
        """Give what ``make`` makes of files: as it was kept, or made now and kept.

        It is made anew where a file has other contents or another place, and by another library or Python.

        Parameters
        ----------
        name
            What is made; with other choices than before, it must have another name.
        files
            All that it is made of, in their order.
        make
            Makes it. What it gives must not be changed afterwards.

        Raises
        ------
        OSError
            If a file cannot be read.
        """
        code = _code_as_it_is()
        if not code:
            return make()
        path = self.folder / f"{name}-{_key(code, files)}.json"
        known = _read(path)
        if known is not None:
            return cast("_Made", known)
        made = make()
        with suppress(Exception):  # a full disk, or what is nested too deeply to be written
            self.folder.mkdir(parents=True, exist_ok=True)
            _write(path, made)
            for old in _by_age(self.folder, f"{name}-*.json")[MOST:]:
                old.unlink(missing_ok=True)
        return made


@cache
def _code_as_it_is() -> bytes:
    """Give what changes with the library's modules and with Python; nothing where they are no files."""
    found = sorted(_modules(CODE))
    return repr((sys.version, found)).encode() if found else b""


def _modules(folder: Path | str) -> Iterator[tuple[str, int, int]]:
    """Give the modules in a folder and below it: their places, when each was written, and their sizes."""
    with suppress(OSError), os.scandir(folder) as entries:
        for entry in entries:
            if entry.name.endswith(".py"):
                written = entry.stat()
                yield entry.path, written.st_mtime_ns, written.st_size
            elif entry.is_dir() and not entry.name.startswith(("_", ".")):
                yield from _modules(entry.path)


def _key(code: bytes, files: Sequence[Path]) -> str:
    digest = hashlib.sha256(code)
    for file in files:
        digest.update(repr(str(file)).encode())
        digest.update(hashlib.sha256(file.read_bytes()).digest())
    return digest.hexdigest()[:32]


def _read(path: Path) -> object | None:
    """Give what is in a file of one's own, or None."""
    try:
        with path.open(encoding="utf-8") as stream:
            return made_again(stream.read()) if _is_ones_own(os.fstat(stream.fileno())) else None
    except Exception:  # noqa: BLE001 - a damaged file may hold anything, and is as none
        return None


def _is_ones_own(status: os.stat_result) -> bool:
    """Whether nobody else may have written a file; where files have no owners, the folder is one's own."""
    if not hasattr(os, "getuid"):
        return True
    return status.st_uid == os.getuid() and not status.st_mode & (stat.S_IWGRP | stat.S_IWOTH)


def _write(path: Path, made: object) -> None:
    """Put a file in its place at once, as another program may be reading it."""
    from tempfile import NamedTemporaryFile

    text = written(made)
    with NamedTemporaryFile("w", encoding="utf-8", dir=path.parent, prefix=path.name, delete=False) as stream:
        try:
            stream.write(text)
            stream.close()
            Path(stream.name).replace(path)
        except BaseException:
            Path(stream.name).unlink(missing_ok=True)
            raise


def _by_age(folder: Path, pattern: str) -> list[Path]:
    """Give files that are there, the newest first."""
    ages = []
    for path in folder.glob(pattern):
        with suppress(OSError):
            ages.append((-path.stat().st_mtime_ns, path))
    return [path for _, path in sorted(ages)]
