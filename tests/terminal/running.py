"""The command, run inside the test: what it writes, and how it ends."""

import contextlib
import io
import os
import sys
from dataclasses import dataclass
from pathlib import Path
from unittest import mock

from console import ROOT, environment
from fuzzytime_cli.app import run


@dataclass(frozen=True)
class Ran:
    """Standard output, standard error, exit code."""

    out: str
    err: str
    code: int


def ran(*arguments: str, folder: Path, stdin: bytes = b"", **variables: str) -> Ran:
    """Run the command from the repository's root, with nothing of this machine's settings."""
    out, err = (io.TextIOWrapper(io.BytesIO(), "utf-8", write_through=True) for _ in range(2))
    here = Path.cwd()
    source = io.TextIOWrapper(io.BytesIO(stdin), encoding="utf-8")
    with mock.patch.dict(os.environ, {**environment(folder), **variables}, clear=True):
        os.chdir(ROOT)
        try:
            with (
                contextlib.redirect_stdout(out),
                contextlib.redirect_stderr(err),
                mock.patch.object(sys, "stdin", source),
            ):
                code = run(list(arguments))
        finally:
            os.chdir(here)
    return Ran(written(out), written(err), int(code))


def written(stream: io.TextIOWrapper) -> str:
    """Give what was written to a stream in memory."""
    assert isinstance(stream.buffer, io.BytesIO)
    return stream.buffer.getvalue().decode("utf-8")
