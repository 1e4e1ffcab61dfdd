"""Commands that do the skills: an argument list each, without a shell, watched and ended when they hang."""

import contextlib
import os
import re
import shutil
import signal
import subprocess
import threading
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime

from fuzzytime.spelling import suggestion
from fuzzytime.times import instant_after
from fuzzytime_cli.faults import NoInputError, UsageError
from fuzzytime_cli.live.events import Start
from fuzzytime_cli.live.feeds import CHUNK, lines_of
from fuzzytime_cli.live.inbox import Inbox, Outcome, Output

GRACE = 2.0
"""Seconds of the machine between asking a command to end and ending it."""

_PLACEHOLDER = re.compile(r"\{\{|\}\}|\{([^{}]*)\}")
PLACEHOLDERS = (
    "id",
    "name",
    "instruction",
    "verb",
    "object",
    "place",
    "agent",
    "start",
    "duration_s",
    "satisfaction",
)
VARIABLE = "FUZZYTIME_SKILL_"
"""Beginning of the environment variables that hold the same values."""


def values_of(start: Start, origin: datetime) -> dict[str, str]:
    """Give what a command may know of a skill; what was not said is empty."""
    values = {
        "id": start.id,
        "name": start.name,
        "instruction": start.instruction or "",
        **{name: start.parameters.get(name, "") for name in ("verb", "object", "place")},
        "agent": str(start.agent),
        "start": instant_after(origin, start.at).isoformat(timespec="milliseconds"),
        "duration_s": f"{start.end_s - start.at:g}",
        "satisfaction": f"{start.satisfaction:.4f}",
    }
    return {name: values[name] for name in PLACEHOLDERS}


@dataclass(frozen=True, slots=True)
class Command:
    """A program and its arguments, in which ``{name}`` and others stand for what a skill is.

    >>> Command.of(["echo", "{{{id}}}"]).filled({"id": "s1"})
    ('echo', '{s1}')
    """

    program: str
    arguments: tuple[str, ...] = ()

    @classmethod
    def of(cls, words: Sequence[str]) -> "Command":
        """Take a command as it was given.

        Raises
        ------
        UsageError
            If it holds a placeholder that there is none of.
        NoInputError
            If there is no such program.
        """
        program, *arguments = words
        for argument in arguments:
            for match in _PLACEHOLDER.finditer(argument):
                if match[1] is not None and match[1] not in PLACEHOLDERS:
                    raise UsageError(
                        f"--exec: unknown placeholder {match[0]!r}{suggestion(match[1], PLACEHOLDERS)};"
                        " write {{ for a brace"
                    )
        if shutil.which(program) is None:
            raise NoInputError(f"--exec: there is no program {program!r}")
        return cls(program, tuple(arguments))

    def filled(self, values: Mapping[str, str]) -> tuple[str, ...]:
        """Give the argument list for a skill."""

        def value(match: re.Match[str]) -> str:
            return values[match[1]] if match[1] is not None else match[0][0]

        return (self.program, *(_PLACEHOLDER.sub(value, argument) for argument in self.arguments))


@dataclass(frozen=True, slots=True)
class Rehearsal:
    """An executor that only says which commands it would run."""

    command: Command
    origin: datetime

    def command_for(self, start: Start) -> tuple[str, ...]:
        """Give the command of a start."""
        return self.command.filled(values_of(start, self.origin))

    def begin(self, start: Start) -> None:
        """Do nothing."""

    def stop(self, identifier: str) -> None:
        """Do nothing."""


@dataclass(slots=True)
class Programs:
    """An executor that runs a command for each skill, in a group of processes of its own."""

    command: Command
    origin: datetime
    inbox: Inbox
    processes: dict[str, subprocess.Popen[bytes]] = field(default_factory=dict)

    def command_for(self, start: Start) -> tuple[str, ...]:
        """Give the command of a start."""
        return self.command.filled(values_of(start, self.origin))

    def begin(self, start: Start) -> None:
        """Run the command; what it writes and how it ends come to the inbox."""
        values = values_of(start, self.origin)
        variables = {f"{VARIABLE}{name.upper()}": value for name, value in values.items()}
        try:
            process = subprocess.Popen(  # noqa: S603 - the program is the user's own, and there is no shell
                start.command or self.command_for(start),
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                env={**os.environ, **variables},
                start_new_session=True,
            )
        except (OSError, ValueError) as error:  # ValueError: a NUL, or a character that no argument can hold
            reason = error.strerror if isinstance(error, OSError) else str(error)
            self.inbox.put(Outcome(start.id, trouble=f"the command cannot be run: {reason}"))
            return
        self.processes[start.id] = process
        threading.Thread(target=self._watch, args=(start.id, process), daemon=True).start()

    def _watch(self, identifier: str, process: "subprocess.Popen[bytes]") -> None:
        reader = threading.Thread(target=self._read, args=(identifier, process), daemon=True)
        reader.start()
        code = process.wait()
        # What the command left running may keep the pipe open for ever.
        reader.join(GRACE)
        self.inbox.put(Outcome(identifier, code, _trouble(code)))

    def _read(self, identifier: str, process: "subprocess.Popen[bytes]") -> None:
        if process.stdout is None:
            return
        with process.stdout as stream, contextlib.suppress(OSError):
            descriptor = stream.fileno()
            for line in lines_of(lambda: os.read(descriptor, CHUNK)):
                self.inbox.put(Output(identifier, line.decode("utf-8", "replace").rstrip("\r")))

    def stop(self, identifier: str) -> None:
        """Ask a command and what it started to end; where they do not, end them."""
        process = self.processes[identifier]
        _signal(process, signal.SIGTERM)
        ending = threading.Timer(GRACE, _signal, (process, signal.SIGKILL))
        ending.daemon = True
        ending.start()

    def close(self) -> None:
        """End every command that still runs, and wait for that."""
        running = [process for process in self.processes.values() if process.poll() is None]
        for process in running:
            _signal(process, signal.SIGTERM)
        for process in running:
            with contextlib.suppress(subprocess.TimeoutExpired):
                process.wait(GRACE)
            _signal(process, signal.SIGKILL)


def _signal(process: "subprocess.Popen[bytes]", number: signal.Signals) -> None:
    if process.poll() is None:
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(process.pid, number)


def _trouble(code: int) -> str:
    if code == 0:
        return ""
    if code > 0:
        return f"the command ended with exit code {code}"
    try:
        return f"the command was ended by {signal.Signals(-code).name}"
    except ValueError:
        return f"the command was ended by signal {-code}"
