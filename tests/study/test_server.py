"""The page's server before people who mean harm."""

import os
import socket
import threading
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest

from fuzzytime.errors import FuzzytimeError
from fuzzytime.study import Design
from fuzzytime.study.serving.server import MOST_CONNECTIONS, StudyServer, origin_of
from fuzzytime.study.serving.service import body_limit
from study.raw_http import request, send
from study.serving import TOKEN, running


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[StudyServer]:
    with running(tmp_path_factory.mktemp("served") / "answers.sqlite", Design.shipped()) as server:
        yield server


def join(server: StudyServer) -> str:
    return str(request(server, "/join", {"consent": True}).document["participant"])


def curve(name: str, **changes: object) -> dict[str, object]:
    return {"participant": name, "instruction": "soon", "values": [0.5] * 800, **changes}


def test_the_page_comes_with_a_policy_that_lets_only_its_own_script_run(server: StudyServer) -> None:
    answer = request(server, f"/?token={TOKEN}")
    assert answer.status == 200
    policy = answer.headers["content-security-policy"]
    assert "default-src 'none'" in policy
    assert "unsafe" not in policy
    assert "frame-ancestors 'none'" in policy
    nonce = policy.split("'nonce-")[1].split("'")[0]
    assert answer.body.count(f'nonce="{nonce}"'.encode()) == 2
    for name, value in (
        ("x-content-type-options", "nosniff"),
        ("referrer-policy", "no-referrer"),
        ("cache-control", "no-store"),
    ):
        assert answer.headers[name] == value
    assert TOKEN.encode() not in answer.body


def test_what_is_acknowledged_is_in_the_store(server: StudyServer) -> None:
    name = join(server)
    assert request(server, "/curve", curve(name)).document == {"saved": True}
    assert request(server, "/demographics", {"participant": name, "answers": {"age": "40"}}).status == 200
    assert request(server, "/control", {"participant": name, "answer": 3}).status == 200
    assert request(server, "/finish", {"participant": name}).status == 200
    person = server.service.store.participant(name)
    assert (person.curves["soon"] == 0.5).all()
    assert person.finished
    state = request(server, "/resume", {"participant": name}).document
    assert state["finished"] is True
    assert state["begun"] is True
    assert list(state["curves"]) == ["soon"]  # type: ignore[call-overload]


def test_the_design_does_not_say_which_time_is_specified(server: StudyServer) -> None:
    design = request(server, "/design").document
    assert set(design["instructions"].values()) == {  # type: ignore[attr-defined]
        entry.text for entry in Design.shipped().instructions
    }
    assert "t_spec" not in str(design)


@pytest.mark.parametrize(
    "headers",
    [
        {"X-Study-Token": None},
        {"X-Study-Token": "wrong"},
        {"X-Study-Token": TOKEN[:-1]},
        {"X-Study-Token": "\xff" * 9},
        {"Host": "attacker.example"},
        {"Host": "attacker.example:80"},
        {"Host": None},
        {"Host": "127.0.0.1"},
        {"Origin": "http://attacker.example"},
        {"Origin": "null"},
        {"Origin": "https://127.0.0.1"},
        {"Sec-Fetch-Site": "cross-site"},
        {"Sec-Fetch-Site": "same-site"},
    ],
)
def test_who_is_not_the_page_is_refused(server: StudyServer, headers: dict[str, str | None]) -> None:
    before = len(server.service.store.answers().participants)
    assert request(server, "/join", {"consent": True}, headers).status == 403
    assert request(server, "/design", None, headers).status == 403
    assert len(server.service.store.answers().participants) == before


@pytest.mark.parametrize(
    "query", ["", "?token=", "?token=wrong", "?token[]=x", "?token=wrong&a=1&b=2", "?token=%ff%00"]
)
def test_the_page_needs_the_token_too(server: StudyServer, query: str) -> None:
    assert request(server, f"/{query}", None, {"X-Study-Token": None}).status in (400, 403)


@pytest.mark.parametrize("address", ["/?" + "a=1&" * 50, "//[", "/?token=%zz", "http://[::1", "*"])
def test_what_is_no_address_leads_nowhere(server: StudyServer, address: str) -> None:
    assert request(server, address).status in (400, 403, 404)
    assert request(server, address, {"consent": True}).status in (404, 405)


def test_its_own_origin_is_admitted(server: StudyServer) -> None:
    own = f"http://127.0.0.1:{server.port}"
    assert request(server, "/design", None, {"Origin": own, "Sec-Fetch-Site": "same-origin"}).status == 200
    host = f"localhost:{server.port}"
    assert request(server, "/design", None, {"Host": host, "Origin": f"http://{host}"}).status == 200


@pytest.mark.parametrize(
    "path",
    [
        "/../../etc/passwd",
        "/..%2f..%2fetc%2fpasswd",
        "/%2e%2e/%2e%2e/etc/passwd",
        "//etc/passwd",
        "/page.js",
        "/answers.sqlite",
        "/design/",
        "/curve/../design",
        "/\\..\\..\\windows\\win.ini",
        "/favicon.ico",
        "/%00",
        "/" + "a" * 4000,
    ],
)
def test_no_path_leads_to_a_file(server: StudyServer, path: str) -> None:
    for document in (None, {"consent": True}):
        answer = request(server, path, document)
        assert answer.status == 404
        assert b"root:" not in answer.body


@pytest.mark.parametrize("method", ["PUT", "DELETE", "PATCH", "OPTIONS", "TRACE", "CONNECT", "BREW", "HEAD"])
def test_other_methods_are_refused_without_a_5xx(server: StudyServer, method: str) -> None:
    assert request(server, "/design", method=method).status == 405


def test_methods_are_told_apart(server: StudyServer) -> None:
    assert request(server, "/curve").status == 405
    assert request(server, "/design", {}).status == 405


def test_ten_megabytes_are_refused_and_not_kept(server: StudyServer) -> None:
    answer = request(server, "/curve", body=b"[" + b"0," * 5_000_000 + b"0]")
    assert answer.status == 413
    assert str(body_limit(800)) in str(answer.document["error"])


@pytest.mark.parametrize(
    ("headers", "status"),
    [
        ({"Content-Type": "text/plain"}, 415),
        ({"Content-Type": "application/x-www-form-urlencoded"}, 415),
        ({"Content-Type": None}, 415),
        ({"Content-Length": None}, 411),
        ({"Content-Length": "-1"}, 411),
        ({"Content-Length": "1e3"}, 411),
        ({"Content-Length": "\xb3"}, 411),
        ({"Content-Length": "9" * 40}, 411),
        ({"Transfer-Encoding": "chunked"}, 411),
    ],
)
def test_bodies_of_another_kind_or_of_unknown_length_are_refused(
    server: StudyServer, headers: dict[str, str | None], status: int
) -> None:
    assert request(server, "/join", {"consent": True}, headers).status == status


@pytest.mark.parametrize(
    "change",
    [
        {"values": [0.5] * 799},
        {"values": [0.5] * 801},
        {"values": [1.5] * 800},
        {"values": [-0.0001] * 800},
        {"values": ["0.5"] * 800},
        {"values": [True] * 800},
        {"values": [None] * 800},
        {"values": [[0.5]] * 800},
        {"values": {"0": 1}},
        {"values": [10**400] * 800},
        {"instruction": "later"},
        {"instruction": "soon'; DROP TABLE curves; --"},
        {"instruction": 3},
        {"participant": "nobody"},
        {"participant": None},
        {"participant": "' OR 1=1 --"},
        {"participant": "\ud800"},
    ],
)
def test_an_answer_that_is_none_is_refused_and_changes_nothing(
    server: StudyServer, change: dict[str, object]
) -> None:
    name = join(server)
    answer = request(server, "/curve", curve(name, **change))
    assert answer.status == (413 if change.get("values") == [10**400] * 800 else 422)
    assert not server.service.store.participant(name).curves


@pytest.mark.parametrize(
    "body",
    [
        b"{",
        b"[]",
        b"null",
        b'"text"',
        b"\xff\xfe",
        b"[" * 20_000,
        b'{"participant": "x", "instruction": "soon", "values": [NaN]}',
        b'{"participant": "x", "instruction": "soon", "values": [Infinity]}',
        b'{"consent": "yes"}',
        b'{"consent": 1}',
    ],
)
def test_bodies_that_are_no_request_are_refused(server: StudyServer, body: bytes) -> None:
    for path in ("/curve", "/join", "/resume", "/demographics", "/control", "/finish"):
        assert request(server, path, body=body).status == 422


@pytest.mark.parametrize(
    "raw",
    [
        b"\r\n\r\n",
        b"GET\r\n\r\n",
        b"GET / HTTP/9.9\r\n\r\n",
        b"GET / FTP/1.0\r\n\r\n",
        b"GET / HTTP/1.1\r\n" + b"A: b\r\n" * 500 + b"\r\n",
        b"GET /" + b"a" * 70_000 + b" HTTP/1.1\r\n\r\n",
        b"GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\n\r\n",
        b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03",
        b"\x00" * 1000,
        b"",
    ],
)
def test_what_is_no_http_gets_no_5xx(server: StudyServer, raw: bytes) -> None:
    assert send(server.port, raw).status < 500


def test_a_slow_body_is_cut_off_and_others_are_served_meanwhile(tmp_path: Path, design: Design) -> None:
    with running(tmp_path / "answers.sqlite", design, patience=1.0) as server:
        head = f"POST /join HTTP/1.1\r\nHost: 127.0.0.1:{server.port}\r\nX-Study-Token: {TOKEN}\r\n"
        head += "Content-Type: application/json\r\nContent-Length: 1000\r\n\r\n"
        with socket.create_connection(("127.0.0.1", server.port), timeout=10) as slow:
            slow.sendall(head.encode())
            started = time.monotonic()
            ended = threading.Event()

            def drip() -> None:
                try:
                    while not ended.is_set():
                        slow.sendall(b" ")
                        time.sleep(0.1)
                except OSError:
                    ended.set()

            dripping = threading.Thread(target=drip)
            dripping.start()
            assert request(server, "/design").status == 200
            with suppress(OSError):
                slow.recv(1000)
            assert time.monotonic() - started < 8
            ended.set()
            dripping.join()
        assert request(server, "/design").status == 200


def test_many_idle_connections_do_not_keep_others_out(tmp_path: Path, design: Design) -> None:
    with running(tmp_path / "answers.sqlite", design, patience=1.0) as server:
        idle = [
            socket.create_connection(("127.0.0.1", server.port), timeout=10)
            for _ in range(MOST_CONNECTIONS + 20)
        ]
        try:
            deadline = time.monotonic() + 10
            while request(server, "/design").status != 200:
                assert time.monotonic() < deadline
                time.sleep(0.1)
        finally:
            for connection in idle:
                connection.close()


def test_a_disk_that_cannot_be_written_is_said_and_nothing_is_acknowledged(
    tmp_path: Path, design: Design, monkeypatch: pytest.MonkeyPatch
) -> None:
    with running(tmp_path / "answers.sqlite", design) as server:
        name = join(server)

        def full(*_arguments: object) -> None:
            raise OSError(28, "No space left on device")

        monkeypatch.setattr(server.service.store, "save_curve", full)
        answer = request(server, "/curve", curve(name))
        assert answer.status == 503
        assert "saved" in str(answer.document["error"])


def test_many_may_answer_at_once(server: StudyServer) -> None:
    names = [join(server) for _ in range(8)]
    failed: list[int] = []

    def answer_all(name: str, value: float) -> None:
        for entry in Design.shipped().instructions:
            document = curve(name, instruction=entry.key, values=[value] * 800)
            if request(server, "/curve", document).status != 200:
                failed.append(1)

    threads = [
        threading.Thread(target=answer_all, args=(name, position / 8)) for position, name in enumerate(names)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failed
    for position, name in enumerate(names):
        curves = server.service.store.participant(name).curves
        assert len(curves) == 14
        assert np.array(list(curves.values())) == pytest.approx(position / 8)


def test_it_listens_on_loopback_only(server: StudyServer) -> None:
    assert server.server_address[0] == "127.0.0.1"
    others = {str(entry[4][0]) for entry in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)}
    for address in others - {"127.0.0.1"}:
        if address.startswith("127."):
            continue
        with pytest.raises(OSError):  # noqa: PT011 - refused or unreachable, as the system says it
            socket.create_connection((address, server.port), timeout=2)


def test_another_address_can_be_asked_for(tmp_path: Path, design: Design) -> None:
    from fuzzytime.study import AnswerStore
    from fuzzytime.study.serving.service import StudyService

    with AnswerStore.create(tmp_path / "a.sqlite", design) as store:
        service = StudyService(store, lambda: "", lambda: os.urandom(8).hex())
        names = ("lab.example", "https://Study.example/")
        with StudyServer(("127.0.0.1", 0), service, TOKEN, names=names) as server:
            assert f"lab.example:{server.port}" in server.hosts
            assert server.urls == (
                f"http://127.0.0.1:{server.port}/?token={TOKEN}",
                f"http://lab.example:{server.port}/?token={TOKEN}",
                f"https://study.example/?token={TOKEN}",
            )
        with StudyServer(("0.0.0.0", 0), service, TOKEN) as server:  # noqa: S104 - closed at once
            assert server.url == f"http://127.0.0.1:{server.port}/?token={TOKEN}"


@pytest.mark.parametrize("host", ["127.0.0.1:{port}", "study.example"])
def test_a_proxy_with_tls_may_stand_before_it(tmp_path: Path, design: Design, host: str) -> None:
    with running(tmp_path / "a.sqlite", design, names=("https://study.example",)) as server:
        asked = {"Host": host.format(port=server.port), "Origin": "https://study.example"}
        assert request(server, "/join", {"consent": True}, asked).status == 200
        for other in ("http://study.example", "https://study.example.attacker", "https://127.0.0.1"):
            assert request(server, "/join", {"consent": True}, {**asked, "Origin": other}).status == 403


@pytest.mark.parametrize("name", ["", "a b", "https://", "ftp://a", "https://a/path", "a:b", "a\n", "[::1"])
def test_what_is_no_name_is_refused(name: str) -> None:
    with pytest.raises(FuzzytimeError, match="must be a host, or an address"):
        origin_of(name, 1)
