"""Every command ends well where streams are closed, nobody reads, there is no home, or lines are short."""

import subprocess
import sys

from console import ROOT


def test_every_command_ends_well_in_all_surroundings() -> None:
    # In a process of its own: it forks, and has no threads.
    done = subprocess.run(
        [sys.executable, str(ROOT / "tests" / "trust" / "surroundings.py")],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert "160 runs, 10 surroundings: 0 faults" in done.stdout
