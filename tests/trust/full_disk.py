"""Let the disk run full while steps are kept: ``python tests/trust/full_disk.py --rounds 200``.

A child takes steps as fast as it can and acknowledges each on its standard output, until one cannot be kept:
then it must end with 74 and a message. Every acknowledged step must be in the session, and the session whole.
The disk is a small one of its own where this may be mounted; elsewhere files may not grow beyond a limit.
"""

import argparse
import os
import random
import resource
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parent.parent.parent
CHILD = """
import sys
from datetime import datetime, timezone
from pathlib import Path
from fuzzytime_cli.faults import exit_of
from fuzzytime_cli.session import NotKeptError, open_store
store, trouble = open_store(Path(sys.argv[1]))
number = 0
try:
    if trouble:
        raise NotKeptError(f"this is not kept: {trouble}")
    while True:
        number += 1
        text = f"step {number}"
        store.change("full", text, lambda state: state.with_entry(text, datetime.now(timezone.utc)))
        sys.stdout.write(f"{number}\\n")
        sys.stdout.flush()
except OSError as error:
    sys.exit(exit_of(error))
"""


@dataclass(frozen=True)
class Outcome:
    """What a round came to."""

    acknowledged: int
    kept: int
    code: int
    message: str

    @property
    def lost(self) -> bool:
        return self.kept < self.acknowledged

    @property
    def clear(self) -> bool:
        return self.code == 74 and "is not kept" in self.message and "Traceback" not in self.message


def ran_full(path: Path, limit: int | None) -> Outcome:
    """Run a child until nothing more can be written, by a limit of bytes a file or else by the disk's."""
    from fuzzytime_cli.session import open_store

    def limited() -> None:
        if limit is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    variables = {**os.environ, "PYTHONPATH": os.pathsep.join((str(ROOT), str(ROOT / "cli")))}
    child = subprocess.run(
        [sys.executable, "-c", CHILD, str(path)],
        env=variables,
        capture_output=True,
        preexec_fn=limited,
        text=True,
        check=False,
    )
    store, _ = open_store(path)
    kept = len(store.state("full").entries)
    store.close()
    acknowledged = max(map(int, child.stdout.split()), default=0)
    return Outcome(acknowledged, kept, child.returncode, child.stderr)


@contextmanager
def small_disk(folder: Path, size: int) -> Iterator[bool]:
    """Mount a disk of so many bytes at a folder, where this is allowed; say whether it is there."""
    folder.mkdir(exist_ok=True)
    mount = ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(folder)]
    mounted = subprocess.run(mount, capture_output=True, check=False).returncode == 0
    try:
        yield mounted
    finally:
        if mounted:
            subprocess.run(["umount", "-l", str(folder)], check=True)  # noqa: S607 - the system's own


def main() -> None:
    """Fill, and print the figure."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--rounds", type=int, default=200)
    chosen = options.parse_args()
    sys.path[:0] = [str(ROOT), str(ROOT / "cli")]
    lost = unclear = total = disks = 0
    for number in range(chosen.rounds):
        size = random.Random(number).randrange(64 << 10, 400 << 10)
        with tempfile.TemporaryDirectory() as name, small_disk(Path(name) / "disk", size) as mounted:
            outcome = ran_full(Path(name) / "disk" / "sessions.sqlite", None if mounted else size)
        disks += mounted
        lost += outcome.lost
        unclear += not outcome.clear
        total += outcome.acknowledged
    print(
        f"{chosen.rounds} times full ({disks} of them a disk) after {total} acknowledged steps in all: "
        f"{lost} sessions lost a step, {unclear} ended without 74 and a message"
    )
    sys.exit(bool(lost or unclear))


if __name__ == "__main__":
    main()
