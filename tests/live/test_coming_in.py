"""Clocks, the inbox, streams and followed files: what comes in keeps its order, its time and its bounds."""

import io
import json
import threading
import time
from datetime import datetime
from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.context import Hold, Signal
from fuzzytime.context.lines import LONGEST_LINE
from fuzzytime_cli.live.clock import BEAT, MachineClock, SimulatedClock
from fuzzytime_cli.live.feeds import follow_into, lines_of, play, read_into
from fuzzytime_cli.live.inbox import MOST_UNREAD, Arrival, Closed, Inbox, Line, Outcome
from fuzzytime_cli.live.messages import Listener, Read

LISTENER = Listener(
    datetime(2026, 3, 4, 18),  # noqa: DTZ001 - of no zone
    {"pan_temp": Signal(name="pan_temp", course=Hold()), "timer": Signal(name="timer", event=True)},
)


@given(
    st.lists(st.binary(max_size=20).map(lambda line: line.replace(b"\n", b"")), max_size=8), st.integers(1, 9)
)
def test_lines_are_the_same_however_they_come(lines: list[bytes], size: int) -> None:
    text = b"".join(line + b"\n" for line in lines)
    stream = io.BytesIO(text)
    assert list(lines_of(lambda: stream.read(size))) == lines


def test_of_a_line_without_end_only_its_beginning_is_kept() -> None:
    stream = io.BytesIO(b"x" * (10 * LONGEST_LINE) + b"\nnext")
    first, second = lines_of(lambda: stream.read(1000))
    assert (len(first), second) == (LONGEST_LINE + 1, b"next")


def test_what_is_held_comes_at_its_time_and_in_its_order() -> None:
    inbox = Inbox()
    for at, name in [(5.0, "a"), (3.0, "b"), (5.0, "c"), (9.0, "d")]:
        assert inbox.hold(at, Outcome(name))
    assert inbox.next_time == 3.0
    assert [one.identifier for one in inbox.take(5.0) if isinstance(one, Outcome)] == ["b", "a", "c"]
    assert inbox.is_open
    assert len(inbox.take(9.0)) == 1
    assert not inbox.is_open


def test_whoever_writes_faster_than_is_read_waits() -> None:
    inbox = Inbox()
    source = iter([b"{}\n" * (MOST_UNREAD + 500), b""])
    read_into(inbox, "there", lambda: next(source))
    deadline = time.monotonic() + 20
    taken: list[Arrival] = []
    while "there" in inbox.sources and time.monotonic() < deadline:
        inbox.wait(0.05)
        some = inbox.take(0.0)
        assert len(some) <= MOST_UNREAD + 1
        taken += some
    assert sum(isinstance(one, Line) for one in taken) == MOST_UNREAD + 500
    assert taken[-1] == Closed("there")


def test_a_faster_clock_waits_less() -> None:
    seconds = [0.0]

    class Waiting(Inbox):
        def wait(self, seconds_to_wait: float) -> None:
            seconds[0] += seconds_to_wait

    clock = MachineClock(60.0, lambda: seconds[0])
    clock.wait(30.0, Waiting())
    assert (seconds[0], clock.now) == (0.5, 30.0)
    clock.wait(100_000.0, Waiting())
    assert seconds[0] == 0.5 + BEAT


def test_simulated_time_jumps_and_never_runs_back() -> None:
    clock = SimulatedClock()
    for until, now in [(5.0, 5.0), (3.0, 5.0), (float("inf"), 5.0)]:
        clock.wait(until, Inbox())
        assert clock.now == now


def lines_within(inbox: Inbox, count: int, seconds: float = 20.0) -> list[bytes]:
    deadline = time.monotonic() + seconds
    found: list[bytes] = []
    while len(found) < count and time.monotonic() < deadline:
        inbox.wait(0.05)
        found += [one.text for one in inbox.take(0.0) if isinstance(one, Line)]
    return found


def test_a_followed_file_is_read_as_it_grows_is_replaced_and_is_cut(tmp_path: Path) -> None:
    inbox, over, path = Inbox(), threading.Event(), tmp_path / "readings.jsonl"
    follow_into(inbox, path, over)
    try:
        path.write_bytes(b"one\ntwo")
        assert lines_within(inbox, 1) == [b"one"]
        with path.open("ab") as stream:
            stream.write(b"!\nthree\n")
        assert lines_within(inbox, 2) == [b"two!", b"three"]
        fresh = tmp_path / "fresh"
        fresh.write_bytes(b"four, which is longer than all before\n")
        fresh.replace(path)
        assert lines_within(inbox, 1) == [b"four, which is longer than all before"]
        path.write_bytes(b"five\n")
        assert lines_within(inbox, 1) == [b"five"]
    finally:
        over.set()
    inbox.wait(5.0)
    assert inbox.take(0.0) == [Closed(str(path))]


def test_a_recording_need_not_be_in_order_and_announces_when_it_says_so() -> None:
    lines = [
        {"signal": "pan_temp", "value": 1, "at_s": 50},
        {"signal": "pan_temp", "value": 2, "at_s": 20},
        {"signal": "pan_temp", "value": 3},
        {"signal": "timer", "at_s": 90, "announced": True},
    ]
    stream = io.BytesIO("".join(json.dumps(line) + "\n" for line in lines).encode())
    inbox = Inbox()
    play(inbox, "there", lambda: stream.read(64), LISTENER)
    assert inbox.next_time == 20.0
    at_twenty = inbox.take(20.0)
    assert [one.reading.value for one in at_twenty if isinstance(one, Read)] == [2.0, 3.0, None]
    assert inbox.next_time == 50.0
