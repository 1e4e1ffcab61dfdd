"""Starts that nobody named are at round times of the clock, if nothing is lost by that."""

from datetime import timedelta

import pytest

from interpreter.telling import SEVEN, order, starts, told

pytestmark = pytest.mark.model

AT_FOUR = SEVEN.replace(hour=16)


@pytest.mark.parametrize(
    ("line", "time"),
    [
        ("sharpen the clippers this evening", "18:30"),
        ("buy milk in the morning", "08:30"),
        ("wash the van tomorrow afternoon", "12:45"),
        ("call mum at 6:07 pm", "18:07"),
        ("call mum after 6:07 pm", "18:07"),
    ],
)
@pytest.mark.parametrize("past", [0, 7.5])
def test_a_vague_time_begins_at_a_round_one(line: str, time: str, past: float) -> None:
    made = told([line], now=AT_FOUR + timedelta(minutes=past))
    assert starts(made) == {"s1": time}
    assert made.schedule.satisfaction == 1.0


def test_what_follows_keeps_the_order_said() -> None:
    made = told(
        ["bathe the dog this evening", "bake bread this evening", "call mum this evening"], now=AT_FOUR
    )
    assert order(made) == ["s1", "s2", "s3"]
    assert starts(made)["s1"] == "18:30"


def test_what_waits_for_something_is_prompt() -> None:
    made = told(["have lunch at 6:03 pm for 20 minutes", "wash up after lunch"], now=AT_FOUR)
    assert starts(made)["s2"] == "18:23"


@pytest.mark.parametrize("microseconds", [0, 300_000, 999_999])
def test_what_is_round_already_stays_whatever_the_second_it_was_said_in(microseconds: int) -> None:
    made = told(["feed the cat every day"], now=SEVEN + timedelta(hours=2, microseconds=microseconds))
    assert starts(made) == {"s1": "09:00", "s1.2": "09:00", "s1.3": "09:00"}
