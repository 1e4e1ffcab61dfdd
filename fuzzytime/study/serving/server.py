"""The study's page over HTTP, by Python's own server: who is listened to, and for how long.

It listens where it is told, on loopback unless somebody asks for more. `fuzzytime.study.serving.handler`
answers.
"""

import re
import socket
import threading
import time
from collections.abc import Callable, Iterable
from http.server import ThreadingHTTPServer
from typing import Any

from fuzzytime.errors import FuzzytimeError
from fuzzytime.study.serving.handler import Handler
from fuzzytime.study.serving.service import StudyService

LOCAL = ("localhost", "127.0.0.1", "[::1]")
"""Names that every computer has for itself."""

EVERYWHERE = {"0.0.0.0": "127.0.0.1", "::": "[::1]"}  # noqa: S104 - what to call them, not where to listen
"""Addresses that mean all of a computer's own, and by which of them its page is reached there."""

REQUEST_SECONDS = 15.0
"""How long a request may take to arrive and be answered."""

MOST_CONNECTIONS = 64
"""Requests at one time; more are turned away, so that slow clients cannot use up the machine."""


_NAME = re.compile(r"(?:(https?)://)?([a-z0-9._-]+|\[[0-9a-f:.]+\])(?::(\d{1,5}))?/?")


def origin_of(name: str, port: int) -> str:
    """Give what browsers call the origin of a page that people reach by a name.

    Parameters
    ----------
    name : str
        A host, or an address as a proxy with TLS has it.
    port : int
        Where the server listens, for a host without an address of its own.

    Raises
    ------
    FuzzytimeError
        If it is neither.

    >>> origin_of("lab.example", 8765), origin_of("https://study.example/", 8765)
    ('http://lab.example:8765', 'https://study.example')
    """
    found = _NAME.fullmatch(name.lower())
    if found is None:
        rule = "a name must be a host, or an address such as https://study.example"
        raise FuzzytimeError(f"{rule}, got {name[:80]!r}")
    scheme, host, own_port = found.groups()
    if scheme is None:
        return f"http://{host}:{own_port or port}"
    return f"{scheme}://{host}" + (f":{own_port}" if own_port else "")


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
        Further hosts and addresses by which people reach the page, as `origin_of` takes them.
    tell : callable
        Takes a line about what went wrong.
    patience : float
        Seconds that a request may take.

    Raises
    ------
    OSError
        If it cannot listen there.
    FuzzytimeError
        If a name is none.
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
        given = tuple(names)
        for name in given:
            origin_of(name, 0)
        if ":" in address[0]:
            self.address_family = socket.AF_INET6
        super().__init__(address, Handler)
        self.port = int(self.server_address[1])
        host = str(self.server_address[0])
        own = EVERYWHERE.get(host, f"[{host}]" if ":" in host else host)
        self._named = tuple(origin_of(name, self.port) for name in (own, *given))
        further = LOCAL if ":" in address[0] else (*LOCAL, address[0])
        self.origins = frozenset((*self._named, *(origin_of(name, self.port) for name in further)))
        self.hosts = frozenset(origin.partition("://")[2] for origin in self.origins)

    @property
    def urls(self) -> tuple[str, ...]:
        """The page's addresses for participants, with the token: here, then by each further name."""
        return tuple(f"{origin}/?token={self.token}" for origin in self._named)

    @property
    def url(self) -> str:
        """The page's address on this computer."""
        return self.urls[0]

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
