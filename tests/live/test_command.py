"""`fuzzytime run` as it is typed: what it writes, how it ends, in simulated and in real time."""

import json
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from console import ROOT, environment
from fuzzytime_cli.exits import Exit
from live.story import SCHEMA, Json
from terminal.running import Ran, ran

pytestmark = pytest.mark.model

NOW = ("--now", "2026-03-04T18:00", "--zone", "Europe/Berlin")
STIR = ("-i", "Stir the soup now")


def events_of(text: str) -> list[Json]:
    events = [json.loads(line) for line in text.splitlines()]
    for event in events:
        SCHEMA.validate(event)
    return events


def run(*arguments: str, folder: Path, stdin: bytes = b"") -> Ran:
    return ran("run", *NOW, *arguments, folder=folder, stdin=stdin)


def test_the_kitchen_s_story_flips_when_the_pan_is_hot_and_plans_anew_when_it_stalls(tmp_path: Path) -> None:
    lines = (ROOT / "examples" / "kitchen.jsonl").read_bytes()
    done = ran("run", "examples/kitchen.yaml", "--simulate", folder=tmp_path, stdin=lines)
    assert (done.code, done.err) == (Exit.FINE, "")
    events = events_of(done.out)
    heat = {event["read_s"]: event["value"] for event in events if event["type"] == "context"}
    flip = next(event for event in events if event["type"] == "start" and event["id"] == "flip")
    assert 170 <= heat[round(flip["at_s"], -1)] <= 250
    fate = [event for event in events if event.get("id") == "flip"]
    stalled = next(event for event in fate if event["type"] == "rejected")
    assert stalled["reason"].startswith("never: pan_temp settles at 13")
    assert 100 < stalled["at_s"] < 420
    back = next(event for event in fate if event["type"] == "moved" and event["before_s"] is None)
    assert stalled["at_s"] < back["at_s"] < flip["at_s"]
    assert set(events[-1]["done"]) == {"mix", "flip", "boil", "table", "serve", "stir"}


def test_a_followed_file_is_a_recording_where_time_is_simulated(tmp_path: Path) -> None:
    lines = tmp_path / "lines.jsonl"
    lines.write_text('{"signal": "pan_temp", "value": 200, "at_s": 60}\n')
    arguments = ("--simulate", "--follow", str(lines), "-i", "Flip the pancakes when the pan is hot")
    events = events_of(run(*arguments, folder=tmp_path).out)
    assert next(event for event in events if event["type"] == "start")["at_s"] == pytest.approx(60, abs=30)
    assert run("--simulate", "--follow", "no_such_file", *STIR, folder=tmp_path).code == Exit.NO_INPUT


def test_a_rehearsal_tells_the_commands(tmp_path: Path) -> None:
    arguments = ("--simulate", *STIR, "--exec", sys.executable, "-c", "x", "--limit", "{name}")
    start = events_of(run(*arguments, folder=tmp_path).out)[2]
    assert start["command"] == [sys.executable, "-c", "x", "--limit", "stir the soup"]


def test_a_person_reads_lines_and_no_control_character_reaches_them(tmp_path: Path) -> None:
    said = json.dumps({"say": "stir \x1b[31mthe soup\x07 soon", "at_s": 5}).encode()
    done = run("--simulate", "--format", "text", "-i", "Set the table now", folder=tmp_path, stdin=said)
    assert "18:00:00  start     set the table (s1), until 18:05:00" in done.out
    assert "finished" in done.out
    assert not {character for character in done.out if character < " " and character != "\n"}


def test_what_comes_on_another_day_names_it(tmp_path: Path) -> None:
    done = run("--simulate", "--format", "text", "-i", "Feed the cat tomorrow at 7 am", folder=tmp_path)
    assert "Thu 07:00:00  start     feed the cat" in done.out


def test_one_who_stays_needs_no_plan_to_begin_with(tmp_path: Path) -> None:
    said = b'{"say": "Stir the soup now", "at_s": 60}\n{"say": "Set the table now", "at_s": 600}\n'
    done = run("--simulate", "--stay", folder=tmp_path, stdin=said)
    starts = {event["id"]: event["at_s"] for event in events_of(done.out) if event["type"] == "start"}
    assert starts == {"s1": 60, "s2": 600}


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        ((), Exit.USAGE),
        ((*STIR, "--limit", "soon"), Exit.USAGE),
        ((*STIR, "--speed", "0"), Exit.USAGE),
        (("--simulate", "--speed", "3", *STIR), Exit.USAGE),
        (("--simulate", "--limit", "1 min", *STIR), Exit.USAGE),
        ((*STIR, "--wait-for-done", "--exec", sys.executable), Exit.USAGE),
        ((*STIR, "--exec"), Exit.USAGE),
        ((*STIR, "--exec", sys.executable, "{nam}"), Exit.USAGE),
        ((*STIR, "--exec", "no_such_program_of_ours"), Exit.NO_INPUT),
        (("no_such_file",), Exit.NO_INPUT),
        (("-i", "in ten minutes"), Exit.BAD_DATA),
        (("tests/data/unknown_after.yaml",), Exit.BAD_DATA),
    ],
)
def test_an_end_has_its_code(arguments: tuple[str, ...], code: Exit, tmp_path: Path) -> None:
    done = ran("run", "--simulate", *NOW, *arguments, folder=tmp_path)
    assert done.code == code, done.err
    assert done.err
    assert "Traceback" not in done.err


# -- in real time -------------------------------------------------------------------------------------------


LONGEST = 120.0
"""Seconds after which a run is ended, so that a test that waits for what never comes fails."""


@contextmanager
def started(folder: Path, *arguments: str) -> "Iterator[subprocess.Popen[str]]":
    with subprocess.Popen(
        [sys.executable, "-m", "fuzzytime_cli", "run", *NOW, *arguments],
        cwd=ROOT,
        env=environment(folder),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    ) as process:
        end = threading.Timer(LONGEST, process.kill)
        end.start()
        try:
            yield process
        finally:
            end.cancel()


def told_by(process: "subprocess.Popen[str]") -> Iterator[Json]:
    assert process.stdout is not None
    for line in process.stdout:
        event: Json = json.loads(line)
        SCHEMA.validate(event)
        yield event


def next_of(process: "subprocess.Popen[str]", kind: str) -> Json:
    for event in told_by(process):
        if event["type"] == kind:
            return event
    raise AssertionError(f"the run ended without {kind}")


def say(process: "subprocess.Popen[str]", line: Json) -> None:
    assert process.stdin is not None
    process.stdin.write(json.dumps(line) + "\n")
    process.stdin.flush()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_one_who_stops_it_is_told_what_was_started_and_commands_are_ended(
    number: int, tmp_path: Path
) -> None:
    code = "import time; print('begun', flush=True); time.sleep(60)"
    wishes = (*STIR, "-i", "Set the table in about ten minutes")
    with started(tmp_path, *wishes, "--exec", sys.executable, "-c", code) as process:
        assert next_of(process, "output")["text"] == "begun"
        began = time.monotonic()
        process.send_signal(number)
        stopped = next_of(process, "stopped")
        assert (stopped["running"], stopped["waiting"]) == (["s1"], ["s2"])
        assert next_of(process, "finished")["unfinished"] == ["s1", "s2"]
        assert process.wait(40) == Exit.INTERRUPT
        assert time.monotonic() - began < 40


def test_at_sixty_times_the_speed_a_pan_that_gets_hot_is_used(tmp_path: Path) -> None:
    with started(tmp_path, "-i", "Flip the pancakes when the pan is hot", "--speed", "60") as process:
        assert next_of(process, "waits")["reason"] == "not enough readings of pan_temp"
        say(process, {"signal": "pan_temp", "value": 60})
        assert next_of(process, "moved")["before_s"] is None
        hot = {"signal": "pan_temp", "value": 205}
        say(process, hot)
        read = next_of(process, "context")
        assert read["matters"]
        for event in told_by(process):
            # On a slow machine the pan may seem to get too hot, until more readings tell that it stays so.
            if event["type"] == "start":
                break
            say(process, hot)
        assert event["id"] == "s1"
        assert event["planned_s"] >= read["at_s"]
        assert next_of(process, "finished")["done"] == ["s1"]
        assert process.stdin is not None
        process.stdin.close()
        assert process.wait(40) == Exit.FINE


def test_a_reader_that_has_gone_ends_it_without_noise(tmp_path: Path) -> None:
    code = f"{sys.executable} -m fuzzytime_cli run --simulate -i 'Stir the soup now' < /dev/null | head -1"
    done = subprocess.run(
        ["bash", "-c", code],  # noqa: S607 - the shell that a pipeline needs
        cwd=ROOT,
        env=environment(tmp_path),
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.stdout.count("\n"), done.stderr) == (1, "")
