"""Send the study's server requests that an attacker, or a broken client, might send: no 5xx, no crash.

``PYTHONPATH=.:tests python tests/trust/study_fuzz.py [REQUESTS]`` (10,000 by default).
"""

import argparse
import random
import sys
import tempfile
from collections import Counter
from pathlib import Path

from fuzzytime.study import Design
from study.raw_http import request, send
from study.serving import TOKEN, running

PATHS = ("/", "/design", "/join", "/resume", "/demographics", "/curve", "/control", "/finish", "/x", "/../..")
METHODS = ("GET", "POST", "PUT", "HEAD", "OPTIONS", "DELETE", "get", "POST\t", "")
NAMES = (
    "Host",
    "Origin",
    "Content-Type",
    "Content-Length",
    "Transfer-Encoding",
    "X-Study-Token",
    "Cookie",
    "Expect",
)
PIECES = (
    "null", "true", "[]", "{}", '"soon"', "1e400", "-1", "0.5", "NaN", '"\\ud800"', '"' + "a" * 3000 + '"',
    "[" * 400, '{"participant": "x"}', '{"consent": true}', "\x00", "é", "'; DROP TABLE curves; --",
)  # fmt: skip


def fuzzed(chance: random.Random, port: int, names: list[str]) -> bytes:
    """Make one request: mostly well formed, with some of its parts wrong."""
    method = chance.choice(METHODS) if chance.random() < 0.2 else chance.choice(("GET", "POST", "POST"))
    path = chance.choice(PATHS)
    if chance.random() < 0.2:
        path += chance.choice(
            ("?token=" + TOKEN, "?token=x", "%00", "?" + "a=b&" * 30, "/" * 50, "#", "\x80")
        )
    body = content(chance, names).encode("utf-8", "surrogatepass")
    headers = {
        "Host": f"127.0.0.1:{port}",
        "X-Study-Token": TOKEN,
        "Content-Type": "application/json",
        "Content-Length": str(len(body)),
    }
    for _ in range(chance.choice((0, 0, 0, 1, 2))):
        values = (
            "",
            "x",
            "chunked",
            "-5",
            "0",
            "99999999",
            "text/html",
            "http://evil.example",
            "100-continue",
        )
        headers[chance.choice(NAMES)] = chance.choice(values)
    version = chance.choice(("HTTP/1.0", "HTTP/3", "HTTP/9.9", "")) if chance.random() < 0.1 else "HTTP/1.1"
    lines = [f"{method} {path} {version}"]
    lines += [f"{name}: {value}" for name, value in headers.items() if chance.random() < 0.97]
    raw = ("\r\n".join(lines) + "\r\n\r\n").encode("latin-1", "replace") + body
    if chance.random() < 0.05:
        raw = raw[: chance.randrange(len(raw) + 1)]
    if chance.random() < 0.05:
        at = chance.randrange(len(raw) + 1)
        raw = raw[:at] + chance.randbytes(chance.randrange(1, 30)) + raw[at:]
    return raw


def content(chance: random.Random, names: list[str]) -> str:
    """Make a body: fields that the page sends, with values that it would not."""
    if chance.random() < 0.15:
        return chance.choice(PIECES)
    values = chance.choice(("[0.5]", "[" + ",".join(["0.25"] * 800) + "]", "[" + ",".join(["7"] * 800) + "]"))
    fields = {
        "participant": f'"{chance.choice(names)}"'
        if names and chance.random() < 0.8
        else chance.choice(PIECES),
        "instruction": chance.choice(('"soon"', '"in-10"', chance.choice(PIECES))),
        "values": chance.choice((values, chance.choice(PIECES))),
        "answer": chance.choice(("3", chance.choice(PIECES))),
        "answers": chance.choice(('{"age": "30"}', chance.choice(PIECES))),
        "consent": chance.choice(("true", chance.choice(PIECES))),
    }
    chosen = [f'"{name}": {value}' for name, value in fields.items() if chance.random() < 0.8]
    return "{" + ", ".join(chosen) + "}"


def main() -> int:
    """Send, count."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("requests", nargs="?", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=1)
    chosen = parser.parse_args()
    chance = random.Random(chosen.seed)
    counts: Counter[int] = Counter()
    with (
        tempfile.TemporaryDirectory() as folder,
        running(Path(folder) / "answers.sqlite", Design.shipped(), patience=2.0) as server,
    ):
        names: list[str] = []
        for number in range(chosen.requests):
            if number % 500 == 0:
                names.append(server.service.store.join(f"known-{number}", "").name)
            counts[send(server.port, fuzzed(chance, server.port, names), patience=5.0).status] += 1
        alive = request(server, "/design").status
    bad = sum(count for status, count in counts.items() if status >= 500)
    print(f"{chosen.requests} requests, {bad} answers of the 500s; by status: {dict(sorted(counts.items()))}")
    return 1 if bad or alive != 200 or not counts[200] else 0


if __name__ == "__main__":
    sys.exit(main())
