"""Console blocks of Markdown files, run: so that what the documents show is what the program does.

A block starts with ```console; a line ``$ command`` is run from the repository's root, and the lines that
follow are what it must write, standard output and error together. A line ``…`` stands for any lines.
Figures of time spent are not compared. Where a block follows a line <!-- scratch -->, its commands and those
of the file's other such blocks are run one after the other in one folder, and find each other's files.
"""

import contextlib
import io
import os
import re
import shlex
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).parent.parent
_BLOCK = re.compile(r"^(<!-- scratch -->\n)?```console\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_SPENT = re.compile(r"\d+\.\d+ s\)|(?<=\"seconds\": )[\d.e-]+")


@dataclass(frozen=True)
class Example:
    """One command of a document, with what it is said to write."""

    path: Path
    line: int
    command: str
    expected: str
    scratch: bool = False

    def __str__(self) -> str:
        return f"{self.path.relative_to(ROOT)}:{self.line}: {self.command}"


def examples_of(path: Path) -> Iterator[Example]:
    """Give the commands of all console blocks of a file."""
    text = path.read_text(encoding="utf-8")
    for block in _BLOCK.finditer(text):
        line = text.count("\n", 0, block.start(2)) + 1
        for part in re.split(r"^(?=\$ )", block[2], flags=re.MULTILINE):
            if part.startswith("$ "):
                command, _, expected = part[2:].partition("\n")
                yield Example(path, line, command, expected, bool(block[1]))
            line += part.count("\n")


def blocks_of(path: Path, language: str) -> list[str]:
    """Give the texts of all blocks of a file in a language: python, pycon."""
    block = re.compile(rf"^```{language}\n(.*?)^```$", re.MULTILINE | re.DOTALL)
    return block.findall(path.read_text(encoding="utf-8"))


CACHE = "FUZZYTIME_TESTS_CACHE"
"""Where the tests of one session keep tables and parses together, if they do."""


def environment(folder: Path, *, cold: bool = False) -> dict[str, str]:
    """Give an environment in which nothing of this machine shows; a cold one has nothing kept, either."""
    kept = {name: os.environ[name] for name in ("PATH", "HOME", "LANG", "TMPDIR") if name in os.environ}
    return {
        **kept,
        "PYTHONPATH": os.pathsep.join((str(ROOT), str(ROOT / "cli"))),
        "PYTHONUTF8": "1",
        "COLUMNS": "80",
        "TZ": "UTC",
        "FUZZYTIME_CACHE": str(folder / "cache") if cold else os.environ.get(CACHE, str(folder / "cache")),
        "FUZZYTIME_CONFIG": str(folder / "config.yaml"),
        "FUZZYTIME_DATA": str(folder / "data"),
    }


@cache
def written_in_scratch(path: Path) -> dict[int, str]:
    """Run a file's commands that share a folder, and give what each writes, by its line."""
    with tempfile.TemporaryDirectory() as name:
        here = Path(name) / "here"
        here.mkdir()
        shared = [example for example in examples_of(path) if example.scratch]
        return {example.line: written_by(example.command, Path(name), here) for example in shared}


def written_for(example: Example, folder: Path) -> str:
    """Run an example and give what it writes."""
    if example.scratch:
        return written_in_scratch(example.path)[example.line]
    return written_by(example.command, folder)


def written_by(command: str, folder: Path, working: Path = ROOT) -> str:
    """Run a command and give what it writes; simple ones in this process, as loading the model takes long."""
    if re.search(r"[|<>&;]", command):
        return _in_shell(command, folder, working)
    words = shlex.split(command)
    if words[0] != "fuzzytime":
        return _in_shell(command, folder, working)
    from fuzzytime_cli.app import run

    stream = io.TextIOWrapper(io.BytesIO(), encoding="utf-8", write_through=True)
    here = Path.cwd()
    with mock.patch.dict(os.environ, environment(folder), clear=True):
        os.chdir(working)
        try:
            with (
                contextlib.redirect_stdout(stream),
                contextlib.redirect_stderr(stream),
                mock.patch.object(sys, "stdin", io.TextIOWrapper(io.BytesIO(), encoding="utf-8")),
            ):
                run(words[1:])
        finally:
            os.chdir(here)
    raw = stream.buffer
    assert isinstance(raw, io.BytesIO)
    return raw.getvalue().decode("utf-8")


def _in_shell(command: str, folder: Path, working: Path) -> str:
    shim = folder / "bin" / "fuzzytime"
    shim.parent.mkdir(exist_ok=True)
    shim.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m fuzzytime_cli "$@"\n')
    shim.chmod(0o755)
    variables = environment(folder)
    variables["PATH"] = f"{shim.parent}{os.pathsep}{variables['PATH']}"
    done = subprocess.run(
        ["bash", "-c", command],  # noqa: S607 - the shell that the document's reader uses
        cwd=working,
        env=variables,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        stdin=subprocess.DEVNULL,
        check=False,
    )
    return done.stdout.decode("utf-8")


def compared(text: str) -> str:
    """Give what is compared of a text: no figures of time spent, no spaces at the ends of lines."""
    lines = (line.rstrip() for line in _SPENT.sub("· s)", text).strip("\n").split("\n"))
    return "\n".join(lines)


def fits(expected: str, written: str) -> bool:
    """Say whether what was written is what was expected; ``…`` alone on a line stands for any lines."""
    pattern = re.escape(f"\n{compared(expected)}\n")
    pattern = pattern.replace(re.escape("\n…\n"), "\n(?:.*\n)*?")
    return re.fullmatch(pattern, f"\n{compared(written)}\n") is not None
