"""Requests as bytes, so that tests can send what no client would."""

import json
import socket
from collections.abc import Mapping
from dataclasses import dataclass

from fuzzytime.study.serving.server import StudyServer
from study.serving import TOKEN


@dataclass(frozen=True)
class Answer:
    """What came back; status 0 where the connection was closed without an answer."""

    status: int
    headers: dict[str, str]
    body: bytes

    @property
    def document(self) -> dict[str, object]:
        found = json.loads(self.body)
        assert isinstance(found, dict)
        return found


def send(port: int, raw: bytes, patience: float = 10.0) -> Answer:
    """Send bytes and read what comes back until the server closes."""
    with socket.create_connection(("127.0.0.1", port), timeout=patience) as connection:
        try:
            connection.sendall(raw)
            connection.shutdown(socket.SHUT_WR)
        except OSError:
            pass  # The server may have closed already: what it said is still to be read.
        received = b""
        try:
            while chunk := connection.recv(65536):
                received += chunk
        except OSError:
            pass
    head, _, body = received.partition(b"\r\n\r\n")
    lines = head.decode("latin-1").split("\r\n")
    if not lines[0].startswith("HTTP/"):
        return Answer(0, {}, received)
    pairs = (line.split(": ", 1) for line in lines[1:] if ": " in line)
    headers = {name.lower(): value for name, value in pairs}
    return Answer(int(lines[0].split()[1]), headers, body)


def request(
    server: StudyServer,
    path: str,
    document: object = None,
    headers: Mapping[str, str | None] | None = None,
    *,
    method: str | None = None,
    body: bytes | None = None,
) -> Answer:
    """Send a request as the page would, but for the headers that are given (None leaves one out)."""
    content = body if body is not None else b"" if document is None else json.dumps(document).encode()
    verb = method or ("GET" if document is None and body is None else "POST")
    fields: dict[str, str | None] = {
        "Host": f"127.0.0.1:{server.port}",
        "X-Study-Token": TOKEN,
        "Content-Type": "application/json" if content else None,
        "Content-Length": str(len(content)) if verb == "POST" else None,
    }
    fields |= headers or {}
    head = "".join(f"{name}: {value}\r\n" for name, value in fields.items() if value is not None)
    return send(server.port, f"{verb} {path} HTTP/1.1\r\n{head}\r\n".encode("latin-1") + content)
