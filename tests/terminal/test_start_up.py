"""Starting costs little: help and version import nothing heavy; who stops it meanwhile sees no traceback."""

import os
import signal
import subprocess
import sys
import time
import tomllib
from pathlib import Path

import pytest

from console import ROOT, environment
from fuzzytime_cli.entry import INTERRUPTED
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.faults import exit_of

HEAVY = {
    "numpy",
    "scipy",
    "spacy",
    "matplotlib",
    "rich",
    "prompt_toolkit",
    "icalendar",
    "yaml",
    "asyncio",
    "sqlite3",
}


@pytest.mark.parametrize(
    "arguments",
    [
        ["--version"],
        ["--help"],
        ["plan", "--help"],
        ["run", "--help"],
        ["batch", "--help"],
        ["study", "--help"],
        ["rules", "check", "--help"],
    ],
)
def test_help_and_version_import_nothing_heavy(arguments: list[str], tmp_path: Path) -> None:
    loaded = imported_by(f"from fuzzytime_cli.app import run\nassert run({arguments!r}) == 0", tmp_path)
    assert not HEAVY & loaded
    assert "pydantic" not in loaded


def test_options_that_are_texts_import_no_converter(tmp_path: Path) -> None:
    file = tmp_path / "weld.yaml"
    skill = "{name: weld, duration: 90 s, satisfaction: {trapezoid: [0 s, 0 s, 60 s, 90 s]}}"
    file.write_text(f"skills: [{skill}]\n", encoding="utf-8")
    words = ["plan", str(file), "--now", "2026-03-04T07:00", "--ctx", "pan_temp=20"]
    loaded = imported_by(f"from fuzzytime_cli.app import run\nassert run({words!r}) == 0", tmp_path)
    assert "numpy" in loaded
    assert "pydantic" not in loaded


def test_importing_the_library_imports_no_library(tmp_path: Path) -> None:
    assert not HEAVY & imported_by("import fuzzytime", tmp_path)


def imported_by(code: str, folder: Path) -> set[str]:
    """Run code in a Python of its own, and give the packages that are there afterwards."""
    done = subprocess.run(
        [sys.executable, "-c", f"import sys\n{code}\nprint(*sys.modules, file=sys.stderr)"],
        cwd=ROOT,
        env=environment(folder, cold=True),
        capture_output=True,
        text=True,
        check=True,
    )
    return {name.partition(".")[0] for name in done.stderr.split()}


@pytest.mark.skipif(os.name != "posix", reason="signals")
@pytest.mark.parametrize("seconds", [0.0, 0.02, 0.05, 0.1, 0.2, 0.4])
def test_a_command_that_is_stopped_while_it_begins_ends_quietly(seconds: float, tmp_path: Path) -> None:
    # The first thing that is done where Ctrl-C is no error tells that it has begun.
    program = (
        "import gc, sys; from fuzzytime_cli.entry import main\n"
        "sys.argv = ['fuzzytime', 'plan', '-i', 'Call mum around noon']\n"
        "gc.set_threshold = lambda seldom: print('begun', flush=True)\n"
        "main()"
    )
    with subprocess.Popen(
        [sys.executable, "-c", program],
        env=environment(tmp_path, cold=True),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    ) as process:
        assert process.stdout is not None
        process.stdout.readline()
        time.sleep(seconds)
        process.send_signal(signal.SIGINT)
        _, said = process.communicate(timeout=60)
    assert said == b""
    # By the signal itself it ends where Python is on its way out.
    assert process.returncode in {130, 0, -signal.SIGINT}


def test_ctrl_c_while_a_class_is_made_is_no_fault(capsys: pytest.CaptureFixture[str]) -> None:
    class Named:
        def __set_name__(self, owner: type, name: str) -> None:
            raise KeyboardInterrupt

    # Before 3.12 Python makes another error of it.
    with pytest.raises((RuntimeError, KeyboardInterrupt)) as caught:
        type("Made", (), {"named": Named()})
    assert exit_of(caught.value) is Exit.INTERRUPT
    assert capsys.readouterr().err == ""
    assert exit_of(RuntimeError("of its own")) is Exit.FAILURE
    assert "this should not happen" in capsys.readouterr().err


@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_ctrl_c_while_something_is_tidied_away_is_not_lost(tmp_path: Path) -> None:
    program = (
        "import sys, time\n"
        "from fuzzytime_cli.entry import interrupt_again\n"
        "sys.unraisablehook = interrupt_again\n"
        "class Tidied:\n"
        "    def __del__(self):\n"
        "        raise KeyboardInterrupt\n"
        "try:\n"
        "    Tidied()\n"
        "    time.sleep(60)\n"
        "except KeyboardInterrupt:\n"
        "    sys.exit(3)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", program],
        env=environment(tmp_path),
        capture_output=True,
        check=False,
        timeout=50,  # it ends what is waited for
    )
    assert (done.returncode, done.stderr) == (3, b"")


def test_the_command_is_the_one_of_the_package() -> None:
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    assert settings["project"]["scripts"] == {"fuzzytime": "fuzzytime_cli.entry:main"}
    assert INTERRUPTED == Exit.INTERRUPT
