"""Where the disk is full or may only be read, nothing that was acknowledged is lost, and it is said."""

import errno
import io
import os
import resource
import subprocess
import sys
from pathlib import Path

import pytest

from console import ROOT, environment
from fuzzytime_cli.exits import Exit
from fuzzytime_cli.render import Screen
from fuzzytime_cli.repl.start import Dialogue
from fuzzytime_cli.session import NotKeptError, SessionStore
from terminal.running import Ran, ran
from terminal.talking import NINE, Talk
from trust.full_disk import ran_full, small_disk

STEP = ("repl", "kitchen", "--now", "2026-03-04T09:00")


def typed(text: str, folder: Path, limit: int | None = None) -> Ran:
    """Type into a conversation of its own process, whose files may not grow beyond a limit."""

    def limited() -> None:
        if limit is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    done = subprocess.run(
        [sys.executable, "-m", "fuzzytime_cli", *STEP],
        cwd=ROOT,
        env=environment(folder, cold=limit is not None),
        input=text,
        capture_output=True,
        preexec_fn=limited,
        text=True,
        check=False,
    )
    return Ran(done.stdout, done.stderr, done.returncode)


def filled(path: Path) -> SessionStore:
    """Give a store that has no room for more than it holds."""
    store = SessionStore(path)
    store._connection.execute("PRAGMA max_page_count = 1")  # SQLite makes it as many as there are
    return store


@pytest.mark.parametrize("limit", [110_000, 200_000])
def test_what_was_acknowledged_before_the_disk_was_full_is_kept(limit: int, tmp_path: Path) -> None:
    with small_disk(tmp_path / "disk", limit) as mounted:
        outcome = ran_full(tmp_path / "disk" / "sessions.sqlite", None if mounted else limit)
    assert outcome.acknowledged > 0
    assert not outcome.lost
    assert outcome.clear, outcome


def test_a_step_that_cannot_be_kept_is_not_done(tmp_path: Path) -> None:
    path = tmp_path / "sessions.sqlite"
    SessionStore(path).change("test", "one", lambda state: state.with_entry("one", NINE))
    store = filled(path)
    with pytest.raises(NotKeptError, match="not kept, and not done: database or disk is full") as caught:
        store.change("test", "two", lambda state: state.with_entry("two " * 10_000, NINE))
    assert (caught.value.filename, caught.value.errno) == (str(path), errno.EIO)
    assert [entry.text for entry in SessionStore(path).state("test").entries] == ["one"]
    store._connection.execute("PRAGMA max_page_count = 100000")
    store.change("test", "three", lambda state: state.with_entry("three", NINE))
    assert [entry.text for entry in store.state("test").entries] == ["one", "three"]


def test_what_a_person_typed_that_cannot_be_kept_stands_on_the_prompt_again(tmp_path: Path) -> None:
    screen = io.StringIO()
    turns = Talk(tmp_path / "sessions.sqlite").turns
    talk = Dialogue(
        turns, lambda: NINE, Screen(screen, 80, colour=False, unicode=True, interactive=True), bell=False
    )
    talk.take("Stir the soup in ten minutes")
    turns.conversation.store._connection.execute("PRAGMA max_page_count = 1")
    long = f"Set the {'very ' * 1_500}table soon"
    going, words = talk.take(f":busy 12:00 13:00 {long}")
    assert (going, words) == (True, f":busy 12:00 13:00 {long}")
    assert "is not kept, and not done: database or disk is full" in screen.getvalue()
    assert turns.conversation.state.busy == ()


def test_a_pipe_ends_with_74_where_nothing_more_can_be_kept_and_loses_nothing(tmp_path: Path) -> None:
    folder = tmp_path / "home"
    folder.mkdir()
    assert typed("Stir the soup in ten minutes\n", folder).code == Exit.FINE
    many = "".join(f"Set the table in {minutes} minutes\n" for minutes in range(2, 40))
    ended = typed(many, folder, limit=40_000)
    assert ended.code == Exit.IO_ERROR
    assert "is not kept" in ended.err
    assert "Traceback" not in ended.err
    assert "stir the soup" in typed(":list\n", folder).out


def test_a_session_that_can_only_be_read_is_shown_and_goes_on_in_memory(tmp_path: Path) -> None:
    folder = tmp_path / "home"
    folder.mkdir()
    typed("Stir the soup in ten minutes\n", folder)
    again = typed("Set the table soon\n", folder, limit=0)
    assert again.code == Exit.FINE
    assert "this session is not kept" in again.err
    assert "stir the soup" in again.out
    assert "set the table" in again.out
    assert "set the table" not in typed(":list\n", folder).out


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full: no full device is tried")
@pytest.mark.parametrize(
    "arguments",
    [
        ("plan", "-i", "Stir the soup now", "--format", "json"),
        ("batch", "examples/breakfast.txt", "--jobs", "1"),
    ],
    ids=["plan", "batch"],
)
def test_a_file_on_a_full_disk_is_named(arguments: tuple[str, ...], tmp_path: Path) -> None:
    done = ran(*arguments, "-o", "/dev/full", folder=tmp_path)
    assert done.code == Exit.IO_ERROR
    assert done.err == f"fuzzytime: /dev/full: {os.strerror(errno.ENOSPC)}\n"


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="there is no /dev/full: no full device is tried")
@pytest.mark.parametrize(
    "arguments",
    [
        ("plan", "-i", "Stir the soup now"),
        ("run", "-i", "Stir the soup now", "--simulate"),
        ("batch", "examples/breakfast.txt", "--jobs", "1"),
    ],
    ids=["plan", "run", "batch"],
)
def test_output_that_has_no_room_ends_with_74(arguments: tuple[str, ...], tmp_path: Path) -> None:
    with Path("/dev/full").open("wb") as full:
        done = subprocess.run(
            [sys.executable, "-m", "fuzzytime_cli", *arguments],
            cwd=ROOT,
            env=environment(tmp_path),
            stdin=subprocess.DEVNULL,
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
            check=False,
        )
    assert (done.returncode, done.stderr) == (Exit.IO_ERROR, f"fuzzytime: {os.strerror(errno.ENOSPC)}\n")
