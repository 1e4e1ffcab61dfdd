"""The study's page over HTTP, by Python's own server: one page, a few JSON requests, nothing else.

It listens where it is told, on loopback unless somebody asks for more. Every request must name a host that
is this server, come from its own page if it says from where, and know the study's token; bodies are JSON,
small, and must arrive in time. No path leads to a file.
"""

import base64
import hmac
import html
import re
import socket
import threading
import time
from collections.abc import Callable, Iterable
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any, ClassVar
from urllib.parse import parse_qs, urlsplit

from fuzzytime.errors import FuzzytimeError
from fuzzytime.study.assets import asset
from fuzzytime.study.service import Document, StudyService, body_limit, read_document, written

REQUEST_SECONDS = 15.0
"""How long a request may take to arrive and be answered."""

MOST_CONNECTIONS = 64
"""Requests at one time; more are turned away, so that slow clients cannot use up the machine."""


MOST_DRAINED = 1 << 24
"""Bytes of a refused request that are taken in and thrown away, so that its sender reads the refusal."""


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
        super().__init__(address, _Handler)
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


class _Handler(BaseHTTPRequestHandler):
    """One request."""

    server: StudyServer
    server_version = "fuzzytime"
    sys_version = ""
    protocol_version = "HTTP/1.1"
    default_request_version = "HTTP/1.0"

    _READ: ClassVar[frozenset[str]] = frozenset({"/", "/design"})
    _unread: bool = True

    def setup(self) -> None:
        """Give the socket a time limit of its own as well."""
        super().setup()
        self.connection.settimeout(self.server.patience)

    def finish(self) -> None:
        """Take in what a refused request still sends: closing on it would reset the answer away."""
        left = MOST_DRAINED
        try:
            self.connection.settimeout(0.3)
            while self._unread and left > 0:
                chunk = self.rfile.read1(1 << 16)
                left = left - len(chunk) if chunk else 0
        except OSError:
            pass
        super().finish()

    def do_GET(self) -> None:
        """Give the page, or the design that it shows."""
        self._unread = "Content-Length" in self.headers
        path, token = self._asked()
        if not self._admitted():
            return
        if path == "/":
            if self._knows(token):
                self._page()
        elif path == "/design":
            if self._knows(self.headers.get("X-Study-Token", "")):
                self._send(HTTPStatus.OK, self.server.service.design())
        elif path in StudyService.paths():
            self._refuse(HTTPStatus.METHOD_NOT_ALLOWED, "only POST serves here")
        else:
            self._refuse(HTTPStatus.NOT_FOUND, "there is nothing here")

    def do_POST(self) -> None:
        """Save an answer."""
        path, _ = self._asked()
        if not self._admitted() or not self._knows(self.headers.get("X-Study-Token", "")):
            return
        if path not in StudyService.paths():
            known = path in self._READ
            status = HTTPStatus.METHOD_NOT_ALLOWED if known else HTTPStatus.NOT_FOUND
            self._refuse(status, "only GET serves here" if known else "there is nothing here")
            return
        body = self._body()
        if body is None:
            return
        try:
            self._send(HTTPStatus.OK, self.server.service.answer(path, read_document(body)))
        except FuzzytimeError as error:
            self._refuse(HTTPStatus.UNPROCESSABLE_ENTITY, str(error))
        except OSError as error:
            self.server.tell(f"an answer could not be saved: {error}")
            self._refuse(HTTPStatus.SERVICE_UNAVAILABLE, "the answer could not be saved")

    def _asked(self) -> tuple[str, str]:
        """Give the path and the token of the address; what is no address leads nowhere."""
        try:
            split = urlsplit(self.path)
            return split.path, parse_qs(split.query, max_num_fields=8).get("token", [""])[0]
        except ValueError:
            return "", ""

    # -- who may ask ----------------------------------------------------------------------------------------

    def _admitted(self) -> bool:
        """Refuse other hosts' names (rebinding), other sites' pages, and bodies of unknown length."""
        hosts = self.headers.get_all("Host") or []
        if len(hosts) != 1 or hosts[0].lower() not in self.server.hosts:
            self._refuse(HTTPStatus.FORBIDDEN, "this server has another name")
            return False
        origins = self.headers.get_all("Origin") or []
        if any(origin.lower() != f"http://{hosts[0].lower()}" for origin in origins):
            self._refuse(HTTPStatus.FORBIDDEN, "only the study's own page may ask")
            return False
        if self.headers.get("Sec-Fetch-Site", "none").lower() not in ("none", "same-origin"):
            self._refuse(HTTPStatus.FORBIDDEN, "only the study's own page may ask")
            return False
        if "Transfer-Encoding" in self.headers:
            self._refuse(HTTPStatus.LENGTH_REQUIRED, "a body must say its length")
            return False
        return True

    def _knows(self, token: str) -> bool:
        right = hmac.compare_digest(token.encode("utf-8", "replace"), self.server.token.encode())
        if not right:
            self._refuse(HTTPStatus.FORBIDDEN, "the token is wrong: use the address that the study gives")
        return right

    def _body(self) -> bytes | None:
        """Read the body; None where it was refused."""
        if (self.headers.get_content_type() or "") != "application/json":
            self._refuse(HTTPStatus.UNSUPPORTED_MEDIA_TYPE, "a body must be application/json")
            return None
        lengths = self.headers.get_all("Content-Length") or []
        if len(lengths) != 1 or not (lengths[0].isascii() and lengths[0].isdigit()) or len(lengths[0]) > 12:
            self._refuse(HTTPStatus.LENGTH_REQUIRED, "a body must say its length")
            return None
        length, limit = int(lengths[0]), body_limit(self.server.service.store.design.timeline.samples)
        if length > limit:
            self._refuse(HTTPStatus.REQUEST_ENTITY_TOO_LARGE, f"a body must not be larger than {limit} bytes")
            return None
        self._unread = False
        body = self.rfile.read(length)
        if len(body) < length:
            self._refuse(HTTPStatus.REQUEST_TIMEOUT, "the body did not arrive in time")
            return None
        return body

    # -- what is answered -----------------------------------------------------------------------------------

    def _page(self) -> None:
        design = self.server.service.store.design
        nonce = base64.b64encode(
            hmac.digest(self.server.token.encode(), self.path.encode(), "sha256")
        ).decode()
        words = {
            "{{title}}": html.escape(design.title),
            "{{language}}": html.escape(str(design.texts["language"])),
            "{{style}}": asset("page.css"),
            "{{drawing}}": asset("drawing.js"),
            "{{script}}": asset("page.js"),
            "{{nonce}}": nonce,
        }
        page = re.sub(r"\{\{\w+\}\}", lambda place: words[place[0]], asset("page.html"))
        self._write(HTTPStatus.OK, page.encode(), "text/html; charset=utf-8", nonce)

    def _send(self, status: HTTPStatus, document: Document) -> None:
        self._write(status, written(document), "application/json")

    def _refuse(self, status: HTTPStatus, reason: str) -> None:
        self._send(status, {"error": reason})

    def _write(self, status: HTTPStatus, body: bytes, kind: str, nonce: str = "") -> None:
        own = (
            f"script-src 'nonce-{nonce}'; style-src 'nonce-{nonce}'; connect-src 'self'; img-src data:; "
            if nonce
            else ""
        )
        self.close_connection = True
        try:
            self.send_response(status)
            self.send_header("Content-Type", kind)
            self.send_header("Content-Length", str(len(body)))
            self.send_header("Connection", "close")
            self.send_header("Cache-Control", "no-store")
            self.send_header("X-Content-Type-Options", "nosniff")
            self.send_header("Referrer-Policy", "no-referrer")
            self.send_header("Cross-Origin-Opener-Policy", "same-origin")
            self.send_header("Cross-Origin-Resource-Policy", "same-origin")
            self.send_header(
                "Content-Security-Policy",
                f"default-src 'none'; {own}base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
            )
            self.end_headers()
            if self.command != "HEAD":
                self.wfile.write(body)
        except OSError:
            self.server.tell("a client left before its answer was written")

    def send_error(self, code: int, message: str | None = None, explain: str | None = None) -> None:
        """Answer what the base class refuses: as JSON, and as the client's mistake, which it is."""
        del explain
        status = HTTPStatus(code)
        if status == HTTPStatus.NOT_IMPLEMENTED:
            status = HTTPStatus.METHOD_NOT_ALLOWED
        elif status >= HTTPStatus.INTERNAL_SERVER_ERROR:
            status = HTTPStatus.BAD_REQUEST
        if not hasattr(self, "command") or self.command is None:
            self.command = ""
        self._refuse(status, message or status.phrase)

    def log_message(self, format: str, *args: object) -> None:  # noqa: A002 - as the base class
        """Write nothing: a log would hold the token."""
