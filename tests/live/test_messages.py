"""Lines that come in: understood with their times, or said why not; nothing else."""

import json
from datetime import datetime

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.context import Hold, Reading, Signal
from fuzzytime_cli.live.messages import Listener, Message, Read, Said, Told, Unreadable, Word

SIX = datetime(2026, 3, 4, 18)  # noqa: DTZ001 - the run is of no zone
SIGNALS = {
    "pan_temp": Signal(name="pan_temp", unit="degC", low=-10, high=400, course=Hold()),
    "timer": Signal(name="timer", event=True),
}
LISTENER = Listener(SIX, SIGNALS)


def heard(line: object, now: float = 100.0) -> Message | None:
    return LISTENER.heard(json.dumps(line).encode(), "here:1", now)


def test_a_reading_without_a_time_is_of_the_moment_at_which_it_comes() -> None:
    message = heard({"signal": "pan_temp", "value": "180 degC"})
    assert message == Read(at=100, comes=100, reading=Reading("pan_temp", 100.0, 180.0, "degC"))


@pytest.mark.parametrize("time", [{"at_s": 130}, {"at": "2026-03-04T18:02:10"}])
def test_a_line_about_a_time_ahead_comes_then(time: dict[str, object]) -> None:
    message = heard({"signal": "pan_temp", "value": 20, **time})
    assert isinstance(message, Read)
    assert (message.at, message.comes, message.reading.at) == (130, 130, 130)


def test_a_line_about_a_time_past_comes_now() -> None:
    message = heard({"done": "s1", "at_s": 40})
    assert message == Told(at=40, comes=100, word=Word.DONE, identifier="s1")


def test_an_event_that_is_announced_comes_now() -> None:
    message = heard({"signal": "timer", "at_s": 500, "announced": True})
    assert isinstance(message, Read)
    assert (message.at, message.comes) == (500, 100)


def test_an_instruction_brings_what_a_task_file_may_say() -> None:
    message = heard({"say": " stir ", "hands_on": "1 min", "elapsed": "1h30", "priority": 2, "after": "s1"})
    assert isinstance(message, Said)
    wish = message.wish
    assert (wish.text, wish.given) == ("stir", datetime(2026, 3, 4, 18, 1, 40))  # noqa: DTZ001 - as the run
    assert (wish.hands_on, wish.elapsed, wish.priority, wish.after) == (60, 5400, 2, ("s1",))


def test_an_empty_line_says_nothing() -> None:
    assert LISTENER.heard(b" \r\n", "here:1", 0) is None


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ({}, "must hold one of signal, say, done"),
        ({"say": "stir", "done": "s1"}, "must hold one of"),
        ({"signal": "pan", "value": 1}, "unknown signal 'pan'"),
        ({"signal": "pan_temp", "value": 1, "colour": "red"}, "unknown key 'colour'"),
        ({"signal": "pan_temp", "value": 4000}, "between -10 and 400"),
        ({"signal": "pan_temp"}, "must have a value"),
        ({"signal": "pan_temp", "value": 1, "at_s": 500, "announced": True}, "'announced'"),
        ({"signal": "timer", "at_s": 500, "announced": "yes"}, "'announced'"),
        ({"signal": "timer", "at_s": 1e300}, "must lie within"),
        ({"say": ""}, "must not be empty"),
        ({"say": 3}, "must be a text"),
        ({"say": "stir", "at_s": 1e300}, "years 1 to 9999"),
        ({"say": "stir", "duration": "1 min", "elapsed": "1 min"}, "give it alone"),
        ({"say": "stir", "duration": 4}, "must be a text"),
        ({"say": "stir", "duration": "-4 min"}, "at least 0"),
        ({"say": "stir", "hands_on": "4 min", "elapsed": "1 min"}, "must not be shorter"),
        ({"say": "stir", "priority": 0}, "from 0.001 to 1000"),
        ({"say": "stir", "id": "../s1"}, "an id such as s1"),
        ({"say": "stir", "after": 3}, "a list of ids"),
        ({"done": ["s1"]}, "must be a text"),
        ({"done": "s1", "reason": "x"}, "unknown key 'reason'"),
        ([1], "a line must be a JSON object"),
    ],
)
def test_a_line_that_breaks_a_rule_says_which(line: object, message: str) -> None:
    found = heard(line)
    assert isinstance(found, Unreadable)
    assert message in found.message
    assert found.place == "here:1"


KEYS = st.sampled_from(
    [
        "signal",
        "say",
        "done",
        "failed",
        "drop",
        "value",
        "unit",
        "at",
        "at_s",
        "id",
        "after",
        "announced",
        "x",
    ]
)
VALUES = st.one_of(
    st.none(),
    st.booleans(),
    st.integers(),
    st.floats(),
    st.text(max_size=20),
    st.sampled_from(["pan_temp", "timer", "s1", "4 min", "2026-03-04T18:00"]),
    st.lists(st.text(max_size=3), max_size=2),
)


@given(st.dictionaries(KEYS, VALUES, max_size=5), st.floats(0, 1e6))
def test_any_object_is_a_message_and_never_comes_before_it_is_there(line: object, now: float) -> None:
    message = LISTENER.heard(json.dumps(line).encode(), "here:1", now)
    assert message is not None
    assert message.comes >= now


@given(st.binary(max_size=200))
def test_any_bytes_are_a_message_or_nothing(line: bytes) -> None:
    LISTENER.heard(line, "here:1", 0.0)


def test_who_types_words_is_shown_the_line_that_says_them() -> None:
    told = LISTENER.heard(b"stir the soup soon\n", "<stdin>:1", 0.0)
    assert isinstance(told, Unreadable)
    assert told.message.endswith('words are said so: {"say": "stir the soup soon"}')
    told = LISTENER.heard(b'{"say": }\n', "<stdin>:2", 0.0)
    assert isinstance(told, Unreadable)
    assert "words" not in told.message
