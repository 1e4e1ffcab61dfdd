"""Sessions survive: steps are durable, undoable, and none is lost between two terminals."""

import json
import os
import signal
import stat
import subprocess
import sys
from dataclasses import replace
from datetime import datetime, timedelta
from pathlib import Path

import pytest

from console import ROOT, environment
from fuzzytime.errors import FuzzytimeError
from fuzzytime.times import parse_zone
from fuzzytime_cli.session import (
    KeptBusy,
    KeptRating,
    KeptReading,
    SessionStore,
    Started,
    State,
    open_store,
    state_of,
    state_text,
)

NOW = datetime(2026, 3, 4, 9, tzinfo=parse_zone("Europe/Berlin"))


def test_a_state_is_read_back_as_it_was() -> None:
    state = replace(
        State().with_entry("stir \x1b the sœup \ud83d 😀", NOW).with_changed(1, hands_on=60.0, priority=2.0),
        readings=(KeptReading("pan_temp", NOW, 180.0, "degC"), KeptReading("timer", NOW)),
        busy=(KeptBusy(NOW, NOW + timedelta(hours=1), "lunch"),),
        agents=2,
        ratings=(KeptRating("s1", "stir", NOW, '{"score": 4}'),),
    )
    again = state_of(state_text(state))
    assert again == state
    assert str(again.entries[0].given.tzinfo) == "Europe/Berlin"


def test_a_state_from_before_there_were_ratings_has_none() -> None:
    document = json.loads(state_text(State().with_entry("stir", NOW)))
    del document["ratings"]
    assert state_of(json.dumps(document)) == State().with_entry("stir", NOW)


def test_ratings_are_of_all_sessions(tmp_path: Path) -> None:
    store = SessionStore(tmp_path / "sessions.sqlite")
    for name in ("kitchen", "garden"):
        kept = KeptRating("s1", name, NOW, "{}")
        store.change(name, ":rate", lambda state, kept=kept: state.with_rating(kept))  # type: ignore[misc]
    assert {kept.name for kept in store.ratings()} == {"kitchen", "garden"}
    store.undo("garden")
    assert [kept.name for kept in store.ratings()] == ["kitchen"]


@pytest.mark.parametrize(
    "text", ["", "{}", "[]", '{"schema": "other/1"}', '{"schema": "fuzzytime-session/1"}', "\x00"]
)
def test_what_is_no_state_is_refused(text: str) -> None:
    with pytest.raises(FuzzytimeError, match="fuzzytime-session/1"):
        state_of(text)


def test_steps_are_undone_and_done_again_across_restarts(tmp_path: Path) -> None:
    path = tmp_path / "sessions.sqlite"
    store = SessionStore(path)
    for text in ("one", "two", "three"):
        store.change("a", text, lambda state, text=text: state.with_entry(text, NOW))  # type: ignore[misc]
    assert store.undo("a") == "three"
    store.close()
    store = SessionStore(path)
    assert [entry.text for entry in store.state("a").entries] == ["one", "two"]
    assert store.undo("a") == "two"
    assert store.redo("a") == "two"
    assert store.redo("a") == "three"
    assert store.redo("a") == ""
    assert [entry.text for entry in store.state("a").entries] == ["one", "two", "three"]
    assert [store.undo("a") for _ in range(4)] == ["three", "two", "one", ""]
    assert store.state("a") == State()


def test_a_new_step_leaves_the_undone_ones_behind(tmp_path: Path) -> None:
    store = SessionStore(tmp_path / "sessions.sqlite")
    store.change("a", "one", lambda state: state.with_entry("one", NOW))
    store.undo("a")
    store.change("a", "two", lambda state: state.with_entry("two", NOW))
    assert store.redo("a") == ""
    assert [entry.text for entry in store.state("a").entries] == ["two"]


def test_numbers_are_not_given_twice(tmp_path: Path) -> None:
    store = SessionStore(tmp_path / "sessions.sqlite")
    store.change("a", "one", lambda state: state.with_entry("one", NOW))
    store.change("a", "drop", lambda state: state.without(1))
    state = store.change("a", "two", lambda state: state.with_entry("two", NOW))
    assert [entry.number for entry in state.entries] == [2]


def test_a_step_that_fails_changes_nothing(tmp_path: Path) -> None:
    store = SessionStore(tmp_path / "sessions.sqlite")
    with pytest.raises(FuzzytimeError, match="a number must be one of the list"):
        store.change("a", "drop", lambda state: state.without(7))
    assert store.version("a") == 0


def test_two_terminals_on_one_session_lose_no_step(tmp_path: Path) -> None:
    path = tmp_path / "sessions.sqlite"
    first, second = SessionStore(path), SessionStore(path)
    for number in range(20):
        store = first if number % 2 else second
        store.change("a", str(number), lambda state, n=number: state.with_entry(str(n), NOW))  # type: ignore[misc]
    assert [entry.text for entry in first.state("a").entries] == [str(number) for number in range(20)]
    assert first.version("a") == second.version("a")


def test_a_start_is_news_once(tmp_path: Path) -> None:
    path = tmp_path / "sessions.sqlite"
    first, second = SessionStore(path), SessionStore(path)
    started = Started("s1", "stir", NOW, NOW + timedelta(minutes=1), NOW + timedelta(minutes=5))
    assert first.note_started("a", started)
    assert not second.note_started("a", started)
    second.note_done("a", "s1", NOW + timedelta(seconds=30))
    (kept,) = first.started("a")
    assert kept.end == kept.done == NOW + timedelta(seconds=30)


def test_only_the_owner_may_read_a_session(tmp_path: Path) -> None:
    path = tmp_path / "sessions.sqlite"
    SessionStore(path).close()
    assert stat.S_IMODE(path.stat().st_mode) == 0o600


def test_where_nothing_can_be_written_the_session_is_kept_in_memory_and_that_is_said(tmp_path: Path) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("")
    store, trouble = open_store(blocked / "sessions.sqlite")
    assert str(blocked) in trouble
    assert store.path is None
    assert store.change("a", "one", lambda state: state.with_entry("one", NOW)).entries


def test_a_killed_process_loses_no_acknowledged_step(tmp_path: Path) -> None:
    from trust.kill_sessions import killed_once

    for round_number in range(5):
        acknowledged, kept = killed_once(tmp_path / "sessions.sqlite", f"s{round_number}", round_number)
        assert kept >= acknowledged


def test_a_conversation_that_is_killed_comes_back_whole(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "fuzzytime_cli", "repl", "kitchen", "--now", "2026-03-04T09:00"]
    variables = environment(tmp_path)
    talk = subprocess.Popen(
        command,
        cwd=ROOT,
        env=variables,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
    )
    assert talk.stdin is not None
    assert talk.stdout is not None
    talk.stdin.write(b"stir the soup in about ten minutes\n")
    talk.stdin.flush()
    while b"durations assumed" not in (line := talk.stdout.readline()):
        assert line
    os.kill(talk.pid, signal.SIGKILL)
    talk.communicate()
    again = subprocess.run(
        command, cwd=ROOT, env=variables, input=b":list\n", capture_output=True, check=False
    )
    assert b"stir the soup" in again.stdout


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"agents": "two"}, "'agents' cannot be two"),
        ({"agents": 1_000_000}, "at most 100 agents"),
        ({"agents": -5}, "at most 100 agents"),
        ({"agents": True}, "'agents' cannot be True"),
        ({"next_number": 1}, "numbers below the next one"),
        ({"entries": [{"number": 1, "text": 7, "given": "2026-03-04T09:00"}]}, "'text' cannot be 7"),
        ({"entries": [{"number": 1, "text": "stir", "given": "noon"}]}, "must look like"),
        (
            {"entries": [{"number": 1, "text": "stir", "given": "2026-03-04T09:00", "hands_on": -1}]},
            "at least 0",
        ),
        (
            {"entries": [{"number": 1, "text": "stir", "given": "2026-03-04T09:00", "priority": 1e9}]},
            "priorities",
        ),
        ({"entries": [{"number": 1, "text": "stir", "given": "2026-03-04T09:00"}] * 2}, "distinct numbers"),
        ({"busy": [{"start": "2026-03-04T10:00", "end": "2026-03-04T09:00"}]}, "end after they start"),
        (
            {"readings": [{"signal": "pan_temp", "at": "2026-03-04T09:00", "value": "hot"}]},
            "'value' cannot be hot",
        ),
        ({"colour": "red"}, "what is no state"),
    ],
)
def test_a_session_that_no_conversation_leads_to_is_refused(change: dict[str, object], said: str) -> None:
    document = json.loads(state_text(State().with_entry("stir", NOW)))
    with pytest.raises(FuzzytimeError, match=said):
        state_of(json.dumps({**document, **change}))
