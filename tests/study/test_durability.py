"""A handful of kills and of fuzzed requests; the scripts in tests/trust do thousands."""

import random
from pathlib import Path

from fuzzytime.study import Design
from study.raw_http import request, send
from study.serving import running
from trust.study_fuzz import fuzzed
from trust.study_kills import kill_once, lost


def test_a_killed_server_loses_no_acknowledged_answer(tmp_path: Path) -> None:
    path, chance = tmp_path / "answers.sqlite", random.Random(7)  # noqa: S311 - moments of kills, no secrets
    acknowledged: dict[tuple[str, str], float] = {}
    for _ in range(4):
        kill_once(path, chance, acknowledged)
    assert acknowledged
    assert lost(path, acknowledged) == 0


def test_fuzzed_requests_get_no_5xx(tmp_path: Path, design: Design) -> None:
    chance = random.Random(3)  # noqa: S311 - fuzz, no secrets
    with running(tmp_path / "answers.sqlite", design, patience=2.0) as server:
        known = [server.service.store.join("known", "").name]
        statuses = [send(server.port, fuzzed(chance, server.port, known)).status for _ in range(600)]
        assert request(server, "/design").status == 200
    assert max(statuses) < 500
    assert statuses.count(200) > 5
