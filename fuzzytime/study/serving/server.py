"""The study's page over HTTP, by Python's own server: who is listened to, and for how long.

It listens where it is told, on loopback unless somebody asks for more. `fuzzytime.study.serving.handler`
answers.
"""

import socket
import threading
import time
from collections.abc import Callable, Iterable
from http.server import ThreadingHTTPServer
from typing import Any

from fuzzytime.study.serving.handler import Handler
from fuzzytime.study.serving.service import StudyService

REQUEST_SECONDS = 15.0
"""How long a request may take to arrive and be answered."""

MOST_CONNECTIONS = 64
"""Requests at one time; more are turned away, so that slow clients cannot use up the machine."""


class StudyServer(ThreadingHTTPServer):
    """Serve a study until `shutdown` is called.

    Parameters
    ----------
    address : tuple of str and int
        Host and port to listen on; port 0 takes a free one.
    service : StudyService
        What answers.
    token : str
        What every request must know.
    names : iterable of str
        Further host names by which this server may be called.
    tell : callable
        Takes a line about what went wrong.
    patience : float
        Seconds that a request may take.

    Raises
    ------
    OSError
        If it cannot listen there.
    """

    daemon_threads = True
    request_queue_size = 128

    def __init__(
        self,
        address: tuple[str, int],
        service: StudyService,
        token: str,
        *,
        names: Iterable[str] = (),
        tell: Callable[[str], None] = lambda _line: None,
        patience: float = REQUEST_SECONDS,
    ) -> None:
        self.service = service
        self.token = token
        self.tell = tell
        self.patience = patience
        self._open: dict[socket.socket, float] = {}
        self._guard = threading.Lock()
        if ":" in address[0]:
            self.address_family = socket.AF_INET6
        super().__init__(address, Handler)
        self.port = int(self.server_address[1])
        local = {"localhost", "127.0.0.1", "[::1]"}
        own = f"[{address[0]}]" if ":" in address[0] else address[0]
        self.hosts = frozenset(f"{name}:{self.port}" for name in {*local, own, *names})

    @property
    def url(self) -> str:
        """The page's address for participants, with the token."""
        host = str(self.server_address[0])
        shown = f"[{host}]" if ":" in host else "127.0.0.1" if host == "0.0.0.0" else host  # noqa: S104
        return f"http://{shown}:{self.port}/?token={self.token}"

    def process_request(self, request: Any, client_address: Any) -> None:  # noqa: ANN401 - as the base class
        """Take a connection, unless too many are open."""
        with self._guard:
            full = len(self._open) >= MOST_CONNECTIONS
            if not full:
                self._open[request] = time.monotonic() + self.patience
        if full:
            self._turn_away(request)
            return
        super().process_request(request, client_address)

    def _turn_away(self, request: socket.socket) -> None:
        request.settimeout(0.1)
        try:
            request.sendall(
                b"HTTP/1.1 429 Too Many Requests\r\nContent-Length: 0\r\nConnection: close\r\n\r\n"
            )
        except OSError:
            pass
        finally:
            self.shutdown_request(request)

    def shutdown_request(self, request: Any) -> None:  # noqa: ANN401 - as the base class
        """Forget a connection, and close it."""
        with self._guard:
            self._open.pop(request, None)
        super().shutdown_request(request)

    def service_actions(self) -> None:
        """End the requests that take too long; the base class calls this about twice a second."""
        now = time.monotonic()
        with self._guard:
            late = [request for request, deadline in self._open.items() if deadline < now]
        for request in late:
            try:
                request.shutdown(socket.SHUT_RDWR)
            except OSError:
                continue  # It ended by itself in between.

    def handle_error(self, request: Any, client_address: Any) -> None:  # noqa: ANN401, ARG002 - as the base class
        """Say that a connection broke; clients may leave at any moment."""
        self.tell("a connection broke before its request was answered")
