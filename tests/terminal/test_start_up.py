"""Starting costs little: help and version import nothing heavy."""

import subprocess
import sys
from pathlib import Path

import pytest

from console import ROOT, environment

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
        env=environment(folder),
        capture_output=True,
        text=True,
        check=True,
    )
    return {name.partition(".")[0] for name in done.stderr.split()}
