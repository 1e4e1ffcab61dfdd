"""What the study's server answers: one page, a few JSON requests, nothing else.

Every request must name a host that is this server, come from its own page if it says from where, and know the
study's token; bodies are JSON, small, and must arrive in time. No path leads to a file.
"""

import base64
import hmac
import html
import re
from collections.abc import Callable
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler
from typing import ClassVar, Protocol
from urllib.parse import parse_qs, urlsplit

from fuzzytime.errors import FuzzytimeError
from fuzzytime.study.assets import asset
from fuzzytime.study.serving.service import Document, StudyService, body_limit, read_document, written

MOST_DRAINED = 1 << 24
"""Bytes of a refused request that are taken in and thrown away, so that its sender reads the refusal."""


SCRIPTS = ("elements.js", "talking.js", "painting.js", "points.js", "drawing.js", "page.js")
"""The page's script, in the order in which its parts need each other."""


class Serving(Protocol):
    """What a handler needs to know of its server."""

    service: StudyService
    token: str
    patience: float
    hosts: frozenset[str]
    origins: frozenset[str]
    tell: Callable[[str], None]


class Handler(BaseHTTPRequestHandler):
    """One request to a `fuzzytime.study.serving.server.StudyServer`."""

    server: Serving  # type: ignore[assignment]
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
        if any(origin.lower() not in self.server.origins for origin in origins):
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
            "{{no_script}}": html.escape(str(design.texts["no_script"])),
            "{{style}}": asset("page.css"),
            "{{script}}": "\n".join(map(asset, SCRIPTS)),
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
