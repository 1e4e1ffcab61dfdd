"""A file or standard input, read whole within a limit, with errors that say what is wrong with it."""

import errno
import io
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from fuzzytime.errors import DocumentError, Mistake
from fuzzytime_cli.faults import NoInputError

MAX_BYTES = 16 << 20
STDIN = "-"


def is_piped() -> bool:
    """Tell whether standard input is there and is not a terminal, where nobody would know what is awaited."""
    return sys.stdin is not None and not sys.stdin.isatty()


@dataclass(frozen=True, slots=True)
class Source:
    """Where text came from, as a person would name it, and the text."""

    name: str
    text: str
    path: Path | None = None


def read_source(where: str) -> Source:
    """Read a file by its path, or standard input by ``-``.

    Raises
    ------
    NoInputError
        If there is no such file, it is a folder, or it is empty.
    DocumentError
        If it is not UTF-8 text, or larger than `MAX_BYTES`.
    """
    return _with_instructions(read_exactly(where, MAX_BYTES))


def source_of(raw: bytes, path: Path) -> Source:
    """Take a file's bytes, read before; errors are those of `read_source`."""
    return _with_instructions(_source(raw, str(path), path, MAX_BYTES))


def _with_instructions(source: Source) -> Source:
    if not source.text.strip():
        raise NoInputError(f"{source.name}: the input must hold at least one instruction, and it is empty")
    return Source(source.name, source.text.replace("\r\n", "\n").replace("\r", "\n"), source.path)


def read_exactly(where: str, limit: int) -> Source:
    """Read a file by its path, or standard input by ``-``, with its ends of lines as they are.

    Raises
    ------
    NoInputError
        If there is no such file, or it is a folder.
    DocumentError
        If it is not UTF-8 text, or larger than ``limit`` bytes.
    """
    name, path = ("<stdin>", None) if where == STDIN else (where, Path(where))
    return _source(bytes_of(where, limit), name, path, limit)


def bytes_of(where: str, limit: int = MAX_BYTES) -> bytes:
    """Read a file by its path, or standard input by ``-``: all, or one byte more than may be.

    Raises
    ------
    NoInputError
        If there is no such file, or it is a folder.
    """
    with open_stream(where) as stream:
        return stream.read(limit + 1)


def _source(raw: bytes, name: str, path: Path | None, limit: int) -> Source:
    if len(raw) > limit:
        raise DocumentError((Mistake(name, 1, 1, "", f"input must not be larger than {limit:,} bytes"),))
    return Source(name, _decoded(name, raw), path)


def _opened(path: Path) -> BinaryIO:
    try:
        return path.open("rb")
    except (FileNotFoundError, NotADirectoryError) as error:
        hint = f"; if these are the words themselves, say: -i {str(path)!r}" if " " in str(path) else ""
        raise NoInputError(f"{path}: there is no such file{hint}") from error
    except IsADirectoryError as error:
        raise NoInputError(f"{path}: must be a file, and it is a folder (see: fuzzytime batch)") from error
    except OSError as error:
        if error.errno == errno.ENAMETOOLONG:
            raise NoInputError("a file's name must be shorter; to plan words, use -i") from error
        raise
    except ValueError as error:  # a NUL in the name
        raise NoInputError("a file's name must not hold a NUL character") from error


def _decoded(name: str, raw: bytes) -> str:
    """Decode UTF-8, or UTF-16 with its mark; say where it is neither."""
    encoding = "utf-16" if raw[:2] in {b"\xff\xfe", b"\xfe\xff"} else "utf-8-sig"
    at, what = -1, ""
    text = ""
    try:
        text = raw.decode(encoding)
    except UnicodeDecodeError as error:
        at, what = error.start, f"text must be UTF-8, got byte 0x{raw[error.start]:02x}"
    nul = raw.find(b"\0") if encoding == "utf-8-sig" else -1
    if nul >= 0 and (at < 0 or nul < at):
        at, what = nul, "text must not hold NUL: this looks like a binary file"
    if at >= 0:
        before = raw[:at].decode("utf-8", "replace")
        line, column = before.count("\n") + 1, len(before) - before.rfind("\n")
        raise DocumentError((Mistake(name, line, column, "", what),))
    return text


@contextmanager
def open_stream(where: str | None) -> Iterator[BinaryIO]:
    """Open a file, or standard input by ``-``, to be read bit by bit; None gives an empty stream.

    Raises
    ------
    NoInputError
        If there is no such file.
    """
    if where is None or (where == STDIN and sys.stdin is None):
        yield io.BytesIO()
    elif where == STDIN:
        yield sys.stdin.buffer
    else:
        with _opened(Path(where)) as stream:
            yield stream
