"""Kill the study's server again and again: no acknowledged answer may be lost.

``PYTHONPATH=. python tests/trust/study_kills.py [KILLS]`` (1,000 by default). Each round starts the
server as a process of its own, saves curves as fast as it answers, kills it with SIGKILL after a random
while, and then reads the file: every curve that was acknowledged must be there, as it was sent.
"""

import argparse
import json
import os
import random
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from fuzzytime.study import AnswerStore, Design

TOKEN = "kill-test"  # noqa: S105 - of a server that lives for a second
ROOT = Path(__file__).parents[2]
SERVER = """
import secrets, sys
from pathlib import Path
from fuzzytime.study import AnswerStore, Design
from fuzzytime.study.serving.server import StudyServer
from fuzzytime.study.serving.service import StudyService
store = AnswerStore.create(Path(sys.argv[1]), Design.shipped())
service = StudyService(store, lambda: "now", lambda: secrets.token_urlsafe(12))
server = StudyServer(("127.0.0.1", 0), service, sys.argv[2])
print(server.port, flush=True)
server.serve_forever()
"""


def post(port: int, path: str, document: object) -> dict[str, object] | None:
    """Send a request; None where no complete answer came."""
    body = json.dumps(document).encode()
    head = (
        f"POST {path} HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nX-Study-Token: {TOKEN}\r\n"
        f"Content-Type: application/json\r\nContent-Length: {len(body)}\r\n\r\n"
    ).encode()
    try:
        with socket.create_connection(("127.0.0.1", port), timeout=10) as connection:
            connection.sendall(head + body)
            received = b""
            while chunk := connection.recv(65536):
                received += chunk
    except OSError:
        return None
    start, _, content = received.partition(b"\r\n\r\n")
    if not start.startswith(b"HTTP/1.1 200"):
        return None
    try:
        found = json.loads(content)
    except ValueError:
        return None
    return found if isinstance(found, dict) else None


def kill_once(path: Path, chance: random.Random, acknowledged: dict[tuple[str, str], float]) -> None:
    """Run the server until it is killed, and note what it acknowledged."""
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    with subprocess.Popen(
        [sys.executable, "-c", SERVER, str(path), TOKEN], stdout=subprocess.PIPE, env=environment
    ) as process:
        assert process.stdout is not None
        port = int(process.stdout.readline())
        deadline = time.monotonic() + chance.uniform(0.0, 0.15)
        keys = [entry.key for entry in Design.shipped().instructions]
        person = post(port, "/join", {"consent": True})
        while person is not None and time.monotonic() < deadline:
            key, value = chance.choice(keys), round(chance.random(), 6)
            name = str(person["participant"])
            document = {"participant": name, "instruction": key, "values": [value] * 800}
            # An unanswered request may have been saved, or not: neither is a promise kept or broken.
            acknowledged.pop((name, key), None)
            if post(port, "/curve", document) == {"saved": True}:
                acknowledged[name, key] = value
        os.kill(process.pid, signal.SIGKILL)


def lost(path: Path, acknowledged: dict[tuple[str, str], float]) -> int:
    """Count the acknowledged answers that are not in the file."""
    with AnswerStore.open(path) as store:
        people = {person.name: person for person in store.answers().participants}
    missing = 0
    for (name, key), value in acknowledged.items():
        curve = people[name].curves.get(key) if name in people else None
        missing += curve is None or not (curve == value).all()
    return missing


def main() -> int:
    """Kill, read, count."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("kills", nargs="?", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    chosen = parser.parse_args()
    chance = random.Random(chosen.seed)
    total = missing = 0
    with tempfile.TemporaryDirectory() as folder:
        for count in range(chosen.kills):
            # A file grows; a new one now and then keeps reading it quick.
            path = Path(folder) / f"answers{count // 50}.sqlite"
            acknowledged: dict[tuple[str, str], float] = {}
            kill_once(path, chance, acknowledged)
            total += len(acknowledged)
            missing += lost(path, acknowledged)
    print(f"{chosen.kills} kills, {total} acknowledged answers, {missing} lost")
    return 1 if missing or not total else 0


if __name__ == "__main__":
    sys.exit(main())
