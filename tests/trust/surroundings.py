"""Run every command where streams are closed, nobody reads, or there is no home.

    PYTHONPATH=.:cli python tests/trust/surroundings.py

Prints how many runs ended as they should, and each that did not. A command runs in a fork of a process that
has loaded the model once, by the same `main` as in the shell.
"""

import gc
import io
import os
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parent.parent.parent
NOW = ("--now", "2026-03-04T09:00", "--zone", "Europe/Berlin")
WORDS = ("-i", "Stir the soup in about ten minutes, then set the table")


def commands(folder: Path) -> Mapping[str, Sequence[str]]:
    """Give every command that ends by itself, with arguments of its own."""
    study = str(folder / "answers.sqlite")
    return {
        "help": ("--help",),
        "version": ("--version",),
        "plan": ("plan", *WORDS, *NOW),
        "plan json": ("plan", "examples/breakfast.txt", "--format", "json", *NOW),
        "explain": ("explain", WORDS[1], *NOW),
        "repl": ("repl", "surroundings", "--forget", *NOW),
        "run": ("run", *WORDS, "--simulate", *NOW),
        "batch": ("batch", "examples/breakfast.txt", "--jobs", "1", *NOW),
        "parse": ("parse", *WORDS, *NOW),
        "rules check": ("rules", "check"),
        "rules show": ("rules", "show", "in about ten minutes"),
        "config show": ("config", "show", "--origin"),
        "doctor": ("doctor",),
        "study simulate": ("study", "simulate", "--participants", "2", "--db", f"{study}.new"),
        "study list": ("study", "list", study),
        "study export": ("study", "export", study, "--csv"),
    }


def _close(number: int) -> None:
    os.close(number)
    if number == 0:
        sys.stdin = None
    else:
        sys.stdout = None


def _reader_gone() -> None:
    reading, writing = os.pipe()
    os.dup2(writing, 1)
    os.close(reading)
    os.close(writing)


def _ascii() -> None:
    sys.stdout = io.TextIOWrapper(os.fdopen(1, "wb", closefd=False), "ascii", line_buffering=True)


def _set(name: str, value: str | None) -> Callable[[], None]:
    def change() -> None:
        if value is None:
            os.environ.pop(name, None)
        else:
            os.environ[name] = value

    return change


@dataclass(frozen=True)
class Surroundings:
    """What is unusual, the codes with which a command may end there, and how wide its lines may be."""

    name: str
    change: Sequence[Callable[[], None]]
    codes: frozenset[int] = frozenset({0})
    width: int | None = None


OWN = ("FUZZYTIME_DATA", "FUZZYTIME_CACHE", "FUZZYTIME_CONFIG")
ALL = (
    Surroundings("a reader that is gone", (_reader_gone,), frozenset({0, 141})),
    Surroundings("no standard output", (lambda: _close(1),)),
    Surroundings("no standard input", (lambda: _close(0),)),
    Surroundings("neither", (lambda: _close(0), lambda: _close(1))),
    Surroundings("no HOME", tuple(_set(name, None) for name in ("HOME", *OWN))),
    Surroundings(
        "a HOME that cannot be written to", (_set("HOME", os.devnull), *(_set(name, None) for name in OWN))
    ),
    Surroundings("TERM=dumb", (_set("TERM", "dumb"),), width=80),
    Surroundings("NO_COLOR", (_set("NO_COLOR", "1"), _set("FORCE_COLOR", "1")), width=80),
    Surroundings("40 columns", (_set("COLUMNS", "40"),), width=40),
    Surroundings("a terminal of ASCII", (_ascii,)),
)
PROSE = {"plan", "explain", "repl", "rules show", "doctor"}
"""What is fitted to the screen; lines of the others are as long as what they hold."""


@dataclass(frozen=True)
class Ended:
    """How one command ended in some surroundings."""

    command: str
    where: Surroundings
    code: int
    out: str
    err: str

    def faults(self) -> Iterator[str]:
        """Give what is not as it should be."""
        if self.code not in self.where.codes:
            yield f"ended with {self.code}"
        if "Traceback" in self.err or "should not happen" in self.err or "Exception ignored" in self.err:
            yield self.err.strip().splitlines()[-1]
        if "\x1b" in self.out + self.err:
            yield "wrote an escape sequence"
        widest = max(map(len, self.out.splitlines()), default=0)
        if self.where.width is not None and self.command in PROSE and widest > self.where.width:
            yield f"wrote {widest} columns"


def ended(name: str, arguments: Sequence[str], where: Surroundings, folder: Path) -> Ended:
    """Run a command in a fork, and say how it ended."""
    out, err = folder / "out", folder / "err"
    child = os.fork()
    if child == 0:
        code = 99
        try:
            for number, path, flags in ((0, Path(os.devnull), os.O_RDONLY), (1, out, _NEW), (2, err, _NEW)):
                os.dup2(os.open(path, flags, 0o600), number)
            for change in where.change:
                change()
            code = _main(arguments)
        finally:
            os._exit(code)
    _, status = os.waitpid(child, 0)
    texts = (path.read_text(encoding="utf-8", errors="replace") for path in (out, err))
    return Ended(name, where, os.waitstatus_to_exitcode(status), *texts)


_NEW = os.O_WRONLY | os.O_CREAT | os.O_TRUNC


def _main(arguments: Sequence[str]) -> int:
    from fuzzytime_cli.app import main

    sys.argv[1:] = arguments
    try:
        main()
    except SystemExit as stop:
        # As the interpreter does on its way out.
        for stream in (sys.stdout, sys.stderr):
            if stream is not None:
                stream.flush()
        return int(stop.code or 0)
    return 0


def everything() -> list[Ended]:
    """Run every command in all surroundings."""
    from fuzzytime_cli.app import run
    from fuzzytime_cli.entry import SELDOM

    gc.set_threshold(SELDOM)
    found = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for variable in OWN:
            os.environ[variable] = str(folder / variable.lower())
        os.environ |= {"COLUMNS": "80", "TZ": "UTC"}
        os.chdir(ROOT)
        quiet = str(folder / "quiet")
        run(["plan", *WORDS, *NOW, "-o", quiet])  # loads the model
        run(["study", "simulate", "--participants", "2", "--db", str(folder / "answers.sqlite")])
        sys.stdout.flush()
        gc.freeze()  # forks share what they do not look through
        for where in ALL:
            for command, arguments in commands(folder).items():
                found.append(ended(command, arguments, where, folder))
                (folder / "answers.sqlite.new").unlink(missing_ok=True)
    return found


def main() -> None:
    """Run, and print the figure."""
    sys.path[:0] = [str(ROOT), str(ROOT / "cli")]
    found = everything()
    faults = [f"{one.command} with {one.where.name}: {fault}" for one in found for fault in one.faults()]
    print("\n".join(faults))
    print(f"{len(found)} runs, {len(ALL)} surroundings: {len(faults)} faults")
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
