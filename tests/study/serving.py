"""A running server, for tests of the page and of requests."""

import secrets
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from fuzzytime.study import AnswerStore, Design
from fuzzytime.study.serving.server import StudyServer
from fuzzytime.study.serving.service import StudyService

TOKEN = "a-token-for-tests"  # noqa: S105 - of a server that lives for one test


@contextmanager
def running(
    path: Path, design: Design, port: int = 0, patience: float = 15.0, names: tuple[str, ...] = ()
) -> Iterator[StudyServer]:
    """Serve a study in a thread, until the block ends."""
    with AnswerStore.create(path, design) as store:
        service = StudyService(store, lambda: "2026-03-04T09:00:00", lambda: secrets.token_urlsafe(12))
        server = StudyServer(("127.0.0.1", port), service, TOKEN, names=names, patience=patience)
        thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.05})
        thread.start()
        try:
            yield server
        finally:
            server.shutdown()
            thread.join()
            server.server_close()
