"""Commands for skills: their argument lists, how they end, and that none outlives what it is for."""

import os
import sys
import time
from datetime import datetime
from pathlib import Path

import pytest

from fuzzytime_cli.faults import NoInputError, UsageError
from fuzzytime_cli.live.events import Start
from fuzzytime_cli.live.inbox import Arrival, Inbox, Outcome, Output
from fuzzytime_cli.live.programs import Command, Programs, Rehearsal

SIX = datetime(2026, 3, 4, 18)  # noqa: DTZ001 - of no zone
START = Start(
    at=90.0,
    id="s1",
    name="stir the soup; rm -rf $HOME",
    instruction="Stir the soup",
    planned_s=90.0,
    end_s=150.0,
    done_s=150.0,
    agent=1,
    satisfaction=0.75,
    parameters={"verb": "stir", "object": "the soup"},
    fuzzy_parameters=(),
)


def python(code: str, *arguments: str) -> Command:
    return Command(sys.executable, ("-c", code.replace("{", "{{").replace("}", "}}"), *arguments))


def outcome_of(command: Command, start: Start = START, seconds: float = 20.0) -> tuple[Outcome, list[str]]:
    inbox = Inbox()
    Programs(command, SIX, inbox).begin(start)
    return awaited(inbox, seconds)


def awaited(inbox: Inbox, seconds: float = 20.0) -> tuple[Outcome, list[str]]:
    deadline, written = time.monotonic() + seconds, []
    while time.monotonic() < deadline:
        inbox.wait(0.05)
        arrivals: list[Arrival] = inbox.take(0.0)
        written += [one.text for one in arrivals if isinstance(one, Output)]
        for one in arrivals:
            if isinstance(one, Outcome):
                return one, written
    raise TimeoutError


def test_arguments_are_filled_in_and_no_shell_reads_them() -> None:
    command = python("import sys; print(sys.argv[1:])", "{name}", "{id} {{x}} {verb}", "{place}", "{start}")
    outcome, written = outcome_of(command)
    assert outcome == Outcome("s1", 0)
    assert written == ["['stir the soup; rm -rf $HOME', 's1 {x} stir', '', '2026-03-04T18:01:30.000']"]


def test_the_environment_tells_the_same() -> None:
    code = "import os; e = os.environ; print(e['FUZZYTIME_SKILL_OBJECT'], e['FUZZYTIME_SKILL_DURATION_S'])"
    assert outcome_of(python(code))[1] == ["the soup 60"]


def test_a_rehearsal_says_the_command_and_runs_nothing() -> None:
    rehearsal = Rehearsal(Command("no_such_program", ("{id}",)), SIX)
    assert rehearsal.command_for(START) == ("no_such_program", "s1")
    rehearsal.begin(START)


@pytest.mark.parametrize("argument", ["{nam}", "{}", "{name!r}", "{0}"])
def test_an_unknown_placeholder_is_refused(argument: str) -> None:
    with pytest.raises(UsageError, match="unknown placeholder"):
        Command.of([sys.executable, argument])


def test_a_program_that_is_not_there_is_refused_before_anything_starts() -> None:
    with pytest.raises(NoInputError, match="there is no program"):
        Command.of(["no_such_program_of_ours"])


@pytest.mark.parametrize(
    ("command", "trouble"),
    [
        (python("raise SystemExit(3)"), "exit code 3"),
        (python("import os; os.kill(os.getpid(), 9)"), "ended by SIGKILL"),
        (Command("/no/such/program"), "cannot be run: No such file"),
        (python("", "{name}\0"), "cannot be run: embedded null byte"),
    ],
)
def test_a_command_that_fails_says_how(command: Command, trouble: str) -> None:
    assert trouble in outcome_of(command)[0].trouble


def test_bytes_that_are_no_text_are_shown_as_such() -> None:
    code = "import sys; sys.stdout.buffer.write(b'a\\xff\\r\\nb')"
    assert outcome_of(python(code))[1] == ["a\N{REPLACEMENT CHARACTER}", "b"]


def is_running(process: int) -> bool:
    try:
        state = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state != "Z"


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="looks at processes through /proc")
def test_a_command_that_hangs_is_ended_with_what_it_started() -> None:
    stubborn = (
        "import os, signal, subprocess, sys, time\n"
        "signal.signal(signal.SIGTERM, signal.SIG_IGN)\n"
        "child = subprocess.Popen([sys.executable, '-c', 'import time; time.sleep(60)'])\n"
        "print(os.getpid(), child.pid, flush=True)\n"
        "time.sleep(60)\n"
    )
    inbox = Inbox()
    programs = Programs(python(stubborn), SIX, inbox)
    programs.begin(START)
    written: list[str] = []
    while not written:
        inbox.wait(0.05)
        written += [one.text for one in inbox.take(0.0) if isinstance(one, Output)]
    programs.stop("s1")
    outcome, _ = awaited(inbox)
    assert outcome.trouble == "the command was ended by SIGKILL"
    processes = [int(word) for word in written[0].split()]
    deadline = time.monotonic() + 20
    while any(map(is_running, processes)) and time.monotonic() < deadline:
        time.sleep(0.05)
    assert not any(map(is_running, processes))


def test_closing_ends_what_still_runs() -> None:
    inbox = Inbox()
    programs = Programs(python("import time; time.sleep(60)"), SIX, inbox)
    programs.begin(START)
    began = time.monotonic()
    programs.close()
    assert programs.processes["s1"].poll() is not None
    assert time.monotonic() - began < 40
    assert os.getpid() != programs.processes["s1"].pid
