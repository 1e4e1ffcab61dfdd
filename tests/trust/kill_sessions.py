"""Kill a process while it keeps steps, again and again: ``python tests/trust/kill_sessions.py --kills 1000``.

A child takes steps as fast as it can and acknowledges each on its standard output; it is killed at a random
moment; every acknowledged step must be in the session.
"""

import argparse
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).parent.parent.parent
CHILD = """
import sys
from datetime import datetime, timezone
from pathlib import Path
from fuzzytime_cli.session import SessionStore
store = SessionStore(Path(sys.argv[1]))
number = 0
while True:
    number += 1
    text = f"step {number}"
    store.change(sys.argv[2], text, lambda state: state.with_entry(text, datetime.now(timezone.utc)))
    sys.stdout.write(f"{number}\\n")
    sys.stdout.flush()
"""


def killed_once(path: Path, session: str, seed: int) -> tuple[int, int]:
    """Run a child, kill it, and give the steps it acknowledged and the steps that are kept."""
    from fuzzytime_cli.session import SessionStore

    variables = {**os.environ, "PYTHONPATH": os.pathsep.join((str(ROOT), str(ROOT / "cli")))}
    child = subprocess.Popen(
        [sys.executable, "-c", CHILD, str(path), session], env=variables, stdout=subprocess.PIPE
    )
    assert child.stdout is not None
    child.stdout.readline()
    time.sleep(random.Random(seed).uniform(0.0, 0.03))
    os.kill(child.pid, signal.SIGKILL)
    rest = child.communicate()[0].decode().split("\n")
    acknowledged = max((int(line) for line in rest[:-1] if line), default=1)
    store = SessionStore(path)
    kept = len(store.state(session).entries)
    store.close()
    return acknowledged, kept


def main() -> None:
    """Kill, and print the figure."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--kills", type=int, default=1000)
    chosen = options.parse_args()
    sys.path[:0] = [str(ROOT), str(ROOT / "cli")]
    lost = total = 0
    with tempfile.TemporaryDirectory() as folder:
        for number in range(chosen.kills):
            acknowledged, kept = killed_once(Path(folder) / "sessions.sqlite", f"s{number}", number)
            lost += kept < acknowledged
            total += acknowledged
    print(f"{chosen.kills} kills while {total} steps were acknowledged: {lost} sessions lost a step")
    sys.exit(lost > 0)


if __name__ == "__main__":
    main()
