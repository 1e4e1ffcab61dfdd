"""Files written whole or not at all."""

import io
import os
import sys
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path

NEW = 0o644
"""What a file that was not there may be used for, as far as the umask lets it."""


def replace_file(path: Path, text: str | Iterable[str]) -> None:
    """Write a text, or its pieces one after the other, beside the file, then put it durably in its place.

    Raises
    ------
    OSError
        If that is not possible; the file is then as it was.
    """
    target = path.resolve() if path.is_symlink() else path
    pieces = (text,) if isinstance(text, str) else text
    with about_file(path):
        if target.exists() and not target.is_file():  # /dev/stdout, a FIFO
            target.write_text("".join(pieces), encoding="utf-8")
        else:
            _put_in_place(target, pieces)


@contextmanager
def about_file(path: Path) -> Iterator[None]:
    """Let errors name the file that was asked for, not the one beside it, and not none."""
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from error


def _put_in_place(target: Path, pieces: Iterable[str]) -> None:
    descriptor, beside = tempfile.mkstemp(dir=target.parent, prefix=f".{target.name}.")
    try:
        with open(descriptor, "w", encoding="utf-8", newline="") as stream:  # noqa: PTH123 - a descriptor
            stream.writelines(pieces)
            stream.flush()
            os.fsync(stream.fileno())
        umask = os.umask(0)
        os.umask(umask)
        Path(beside).chmod(target.stat().st_mode & 0o777 if target.exists() else NEW & ~umask)
        Path(beside).replace(target)
    except BaseException:
        Path(beside).unlink(missing_ok=True)
        raise


def write_out(path: Path | None, text: str) -> None:
    """Write a text in a file's place, or to standard output where there is no file: there, too, in UTF-8.

    A calendar or a page says that it is UTF-8; in a pipe it must be, whatever the terminal's encoding is.

    Raises
    ------
    OSError
        If that is not possible; the file is then as it was.
    """
    if path is None:
        if isinstance(sys.stdout, io.TextIOWrapper) and not sys.stdout.isatty():
            sys.stdout.reconfigure(encoding="utf-8")
        sys.stdout.write(text)
    else:
        replace_file(path, text)
