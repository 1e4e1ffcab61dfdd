"""Two processes on one session: ``python tests/trust/interleave_sessions.py --steps 1000``.

Both take steps as fast as they can; no step of either may be lost.
"""

import argparse
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).parent.parent.parent
CHILD = """
import sys
from datetime import datetime, timezone
from pathlib import Path
from fuzzytime_cli.session import SessionStore
store = SessionStore(Path(sys.argv[1]))
for number in range(int(sys.argv[3])):
    text = f"{sys.argv[2]} {number}"
    store.change("shared", text, lambda state: state.with_entry(text, datetime.now(timezone.utc)))
"""


def interleaved(path: Path, steps: int) -> int:
    """Let two processes take half of the steps each, and give how many were lost."""
    from fuzzytime_cli.session import SessionStore

    variables = {**os.environ, "PYTHONPATH": os.pathsep.join((str(ROOT), str(ROOT / "cli")))}
    children = [
        subprocess.Popen([sys.executable, "-c", CHILD, str(path), name, str(steps // 2)], env=variables)
        for name in ("left", "right")
    ]
    for child in children:
        child.wait()
    entries = SessionStore(path).state("shared").entries
    numbers = {entry.number for entry in entries}
    return 2 * (steps // 2) - min(len(entries), len(numbers))


def main() -> None:
    """Interleave, and print the figure."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--steps", type=int, default=1000)
    chosen = options.parse_args()
    sys.path[:0] = [str(ROOT), str(ROOT / "cli")]
    with tempfile.TemporaryDirectory() as folder:
        lost = interleaved(Path(folder) / "sessions.sqlite", chosen.steps)
    print(f"{chosen.steps} steps of two processes on one session: {lost} lost")
    sys.exit(lost > 0)


if __name__ == "__main__":
    main()
