"""Moments that have a name: "call time 6:00"."""

from datetime import datetime

import pytest

from fuzzytime.language import Language
from interpreter.telling import starts, told

pytestmark = pytest.mark.model

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - a moment of no zone; a Wednesday


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("call time 6:00", "call time"),
        ("18:00 show time", "show time"),
        ("print time: 8 pm", "print time"),
        ("closing time 6 pm", "closing time"),
        ("story time at 7", "story time"),
    ],
)
def test_words_that_end_in_time_beside_a_clock_time_name_a_moment(text: str, name: str) -> None:
    reading = Language.shipped().read(text, now=NOW)
    (moment,) = reading.instructions
    assert moment.operation is not None
    assert (moment.operation.object, moment.operation.stated) == (name, True)
    assert not any("not understood" in remark.message for remark in reading.remarks)


@pytest.mark.parametrize("text", ["make time at six", "reset the time at six", "call Tim 6:00", "time 6:00"])
def test_what_is_to_be_done_names_no_moment(text: str) -> None:
    (wish,) = Language.shipped().read(text, now=NOW).instructions
    assert wish.operation is not None
    assert not wish.operation.stated


def test_others_count_from_a_named_moment_which_takes_no_time() -> None:
    made = told(["call time 10:00", "lunch is two hours after call time", "test the lamps before call time"])
    assert starts(made)["s2"] == "12:00"
    assert made.skills[0].skill.time_until_done == 0
