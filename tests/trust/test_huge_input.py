"""Huge input is refused in few words and bounded memory, or answered."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from console import ROOT, environment
from fuzzytime_cli.exits import Exit

MEMORY = 600 << 20
"""Bytes: the language model takes about half of them by itself."""


BETWEEN = """
import os, sys
child = os.posix_spawn(sys.executable, [sys.executable, *sys.argv[2:]], os.environ)
_, status, usage = os.wait4(child, 0)
with open(sys.argv[1], "w") as told:
    told.write(str(usage.ru_maxrss))
sys.exit(os.waitstatus_to_exitcode(status))
"""
"""A small process between the test and the command: one that begins inherits the most that its parent had."""


def ended(arguments: list[str], folder: Path) -> tuple[int, bytes, bytes, int]:
    """Run the command in a process of its own; give code, output, errors and the most memory in bytes."""
    told = folder / "memory"
    done = subprocess.run(
        [sys.executable, "-c", BETWEEN, str(told), "-m", "fuzzytime_cli", *arguments],
        cwd=ROOT,
        env=environment(folder, cold=True),
        stdin=subprocess.DEVNULL,
        capture_output=True,
        check=False,
    )
    unit = 1 if sys.platform == "darwin" else 1024
    return done.returncode, done.stdout, done.stderr, int(told.read_text()) * unit


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("".join(f"Stir the soup in {n} minutes\n" for n in range(100_000)), b"at most 2,000 instructions"),
        ("Stir the soup " + "very " * 2_000_000 + "soon", b"must not be longer than"),
        ("Stir the soup soon\n" * 1_000_000, b"must not be larger than 16,777,216 bytes"),
        ("now: 2026-03-04T09:00\ninstructions:\n" + "  - Stir the soup soon\n" * 100_000, b""),
    ],
    ids=["100,000 lines", "a line of 10 MB", "19 MB", "a task file of 100,000"],
)
def test_what_is_too_much_is_refused_in_few_words(text: str, message: bytes, tmp_path: Path) -> None:
    path = tmp_path / "huge.txt"
    path.write_text(text)
    code, out, err, memory = ended(["plan", str(path)], tmp_path)
    assert code == Exit.BAD_DATA
    assert message in err
    assert (len(out) < 1000, len(err) < 2000, b"Traceback" in err) == (True, True, False)
    assert memory < MEMORY


def test_fifty_thousand_readings_are_planned_by_or_refused(tmp_path: Path) -> None:
    readings = tmp_path / "readings.jsonl"
    lines = (
        json.dumps({"signal": "pan_temp", "at_s": -second / 100, "value": 150.0}) for second in range(50_000)
    )
    readings.write_text("\n".join(lines))
    arguments = ["plan", "-i", "Flip the pancakes when the pan is hot", "--context", str(readings)]
    code, _, err, memory = ended([*arguments, "--format", "json", "--now", "2026-03-04T09:00"], tmp_path)
    assert (code in {Exit.FINE, Exit.BAD_DATA}, b"Traceback" in err) == (True, False), err
    assert memory < MEMORY
