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
    ],
)
def test_help_and_version_import_nothing_heavy(arguments: list[str], tmp_path: Path) -> None:
    code = (
        "import sys\nfrom fuzzytime_cli.app import run\n"
        f"run({arguments!r})\n"
        "print('\\n'.join(sorted({name.partition('.')[0] for name in sys.modules})), file=sys.stderr)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=ROOT,
        env=environment(tmp_path),
        capture_output=True,
        text=True,
        check=True,
    )
    loaded = set(done.stderr.split())
    assert not HEAVY & loaded
    assert "pydantic" not in loaded or len(arguments) > 1


def test_options_that_are_texts_import_no_converter(tmp_path: Path) -> None:
    file = tmp_path / "weld.yaml"
    skill = "{name: weld, duration: 90 s, satisfaction: {trapezoid: [0 s, 0 s, 60 s, 90 s]}}"
    file.write_text(f"skills: [{skill}]\n", encoding="utf-8")
    code = (
        "import sys\nfrom fuzzytime_cli.app import run\n"
        f"assert run(['plan', {str(file)!r}, '--now', '2026-03-04T07:00', '--ctx', 'pan_temp=20']) == 0\n"
        "assert 'pydantic' not in sys.modules\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=ROOT,
        env=environment(tmp_path),
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr


def test_importing_the_library_imports_no_library(tmp_path: Path) -> None:
    code = "import sys, fuzzytime\nprint('\\n'.join(sys.modules))"
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=ROOT,
        env=environment(tmp_path),
        capture_output=True,
        text=True,
        check=True,
    )
    assert not HEAVY & {name.partition(".")[0] for name in done.stdout.split()}
