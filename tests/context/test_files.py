"""Readings from files of JSON lines, assignments, and the context of a task file."""

from datetime import datetime
from pathlib import Path
from zoneinfo import ZoneInfo

import pytest

from fuzzytime.context import (
    Context,
    Reading,
    Signal,
    parse_assignment,
    read_context_file,
    read_context_lines,
    read_context_node,
)
from fuzzytime.documents.nodes import Reader
from fuzzytime.errors import DocumentError, FuzzytimeError

SIGNALS = {
    "pan_temp": Signal(name="pan_temp", unit="degC", low=0, high=350),
    "timer": Signal(name="timer", event=True),
}
NOW = datetime(2026, 3, 4, 9, 0, tzinfo=ZoneInfo("Europe/Berlin"))


def test_lines_give_readings() -> None:
    raw = (
        b'\xef\xbb\xbf{"signal": "pan_temp", "at_s": -30, "value": 120, "unit": "degC"}\r\n'
        b"\n"
        b'{"signal": "pan_temp", "value": "356 degF"}\n'
        b'{"signal": "timer", "at": "2026-03-04T08:59:00"}\n'
        b'{"signal": "timer", "at": "2026-03-04T08:10:00+00:00"}'
    )
    context = read_context_lines(raw, "readings.jsonl", NOW, SIGNALS)
    assert [(r.signal, r.at) for r in context.readings] == [
        ("pan_temp", -30.0),
        ("pan_temp", 0.0),
        ("timer", -60.0),
        ("timer", 600.0),
    ]
    assert context.readings[1].value == pytest.approx(180)


MISTAKES = [
    (b"{", 2, "a line must be a JSON object"),
    (b"[1]", 1, "a line must be a JSON object, got '[1]'"),
    (b'{"signal": "pan_tmp", "value": 1}', 12, "unknown signal 'pan_tmp' (did you mean 'pan_temp'?)"),
    (b'{"signal": "pan_temp", "valu": 1}', 24, "unknown key 'valu' (did you mean 'value'?)"),
    (b'{"signal": "pan_temp", "value": NaN}', 1, "numbers must be finite, got NaN"),
    (b'{"signal": "pan_temp", "value": 1e999}', 33, "'value' must be finite, got inf"),
    (b'{"signal": "pan_temp", "value": 1' + b"0" * 400 + b"}", 33, "'value' must be finite"),
    (b'{"signal": "pan_temp", "value": true}', 33, "'value' must be a number, got 'True'"),
    (b'{"signal": "pan_temp", "value": 900}', 33, "'pan_temp' must lie between 0 and 350 degC, got 900"),
    (b'{"signal": "pan_temp", "value": 20, "value": 30}', 24, "keys must differ, got 'value' twice"),
    (b'{"signal": "pan_temp", "at_s": 5, "value": 20}', 32, "must not lie in the future, got 5 s"),
    (b'{"signal": "pan_temp", "at": "soon", "value": 20}', 30, "a date and time must look like"),
    (b'{"signal": "pan_temp", "at": 3, "value": 20}', 30, "'at' must be a date and time, got '3'"),
    (b'{"signal": "timer", "at": "2026-03-04T09:00", "at_s": 0}', 21, "by 'at' or by 'at_s', not both"),
    (b'{"signal": 3}', 12, "'signal' must be a name, got 3"),
    (b'{"signal": "timer", "unit": 3}', 29, "'unit' must be a text, got 3"),
    (b'{"signal": "\xff"}', 13, "text must be UTF-8, got byte 0xff"),
    (b'{"a":' * 500 + b"1" + b"}" * 500, 2, "unknown key 'a'"),
    (b"[" * 4000, 1, "a line must be a"),
    (b'{"signal": "' + b"x" * 5000 + b'"}', 1, "must not be longer than 4096 bytes"),
]


@pytest.mark.parametrize(("line", "column", "message"), MISTAKES)
def test_a_line_that_is_no_reading_is_named(line: bytes, column: int, message: str) -> None:
    with pytest.raises(DocumentError) as caught:
        read_context_lines(b'{"signal": "timer"}\n' + line, "readings.jsonl", NOW, SIGNALS)
    (mistake,) = caught.value.mistakes
    assert (mistake.path, mistake.line, mistake.column) == ("readings.jsonl", 2, column)
    assert message in mistake.message


def test_all_mistakes_come_at_once() -> None:
    raw = b"\n".join(line for line, _, _ in MISTAKES)
    with pytest.raises(DocumentError) as caught:
        read_context_lines(raw, "readings.jsonl", NOW, SIGNALS)
    assert [mistake.line for mistake in caught.value.mistakes] == list(range(1, len(MISTAKES) + 1))


def test_an_instant_needs_a_moment_to_count_from() -> None:
    with pytest.raises(DocumentError, match="needs a moment to count from"):
        read_context_lines(b'{"signal": "timer", "at": "2026-03-04T08:00"}', "r.jsonl")


def test_a_file_is_read(tmp_path: Path) -> None:
    path = tmp_path / "readings.jsonl"
    path.write_text('{"signal": "timer"}\n')
    assert read_context_file(path) == Context.of({"timer": None})


def test_a_file_that_is_missing_is_a_mistake(tmp_path: Path) -> None:
    with pytest.raises(DocumentError, match="cannot be read: No such file"):
        read_context_file(tmp_path / "missing.jsonl")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("pan_temp=180", Reading("pan_temp", 0.0, 180.0)),
        (" pan_temp = 180 degC ", Reading("pan_temp", 0.0, 180.0, "degC")),
        ("timer", Reading("timer", 0.0)),
    ],
)
def test_an_assignment_is_a_reading_now(text: str, expected: Reading) -> None:
    assert parse_assignment(text, SIGNALS) == expected


@pytest.mark.parametrize(
    "text", ["", "=180", "pan_temp=", "pan_temp=hot", "pan_tmp=180", "timer=3", "pan_temp"]
)
def test_what_is_no_assignment_is_refused(text: str) -> None:
    with pytest.raises(FuzzytimeError):
        parse_assignment(text, SIGNALS)


def node_context(text: str) -> tuple[Context, list[str]]:
    reader = Reader("task.yaml", text)
    context = read_context_node(reader, reader.root(), "context", SIGNALS)
    return context, [f"{m.line}:{m.column}: {m.key}: {m.message}" for m in reader.mistakes]


def test_the_context_of_a_task_file_is_read() -> None:
    context, mistakes = node_context(
        "pan_temp: [{at: -60 s, value: 120}, {value: 356, unit: degF}]\ntimer: {at: 5 min}\n"
    )
    assert mistakes == []
    assert [(r.signal, r.at, r.value and round(r.value)) for r in context.readings] == [
        ("pan_temp", -60.0, 120),
        ("pan_temp", 0.0, 180),
        ("timer", 300.0, None),
    ]
    assert node_context("{pan_temp: 180, timer: null}")[0] == Context.of(
        {"pan_temp": "180 degC", "timer": None}
    )


def test_mistakes_in_a_task_file_s_context_are_placed() -> None:
    _, mistakes = node_context(
        "pan_tmp: 3\npan_temp: [{at: 0 s, value: hot}, {at: soon, value: 3}, {at: 0 s, vlue: 3}, [4]]\n"
    )
    places = [mistake.split(": ")[0] for mistake in mistakes]
    assert places == ["1:1", "2:29", "2:40", "2:67", "2:57", "2:77"]
    assert "did you mean 'pan_temp'" in mistakes[0]
