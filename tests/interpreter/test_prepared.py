"""What is made, or made ready, for what happens comes before that."""

import pytest

from interpreter.telling import listed, starts

pytestmark = pytest.mark.model

DAY = [
    "9am standup",
    "10:00-10:45 client call",
    "1:1 with Sarah at 2",
    "call the supplier at 1 pm",
    "gym at 6 pm",
]


@pytest.mark.parametrize(
    ("line", "by"),
    [
        ("prep slides for the client call (30 min)", "09:30"),
        ("print handouts for the call", "09:59"),
        ("get the room ready for the 1:1", "13:55"),
        ("pack the bag for the gym", "17:59"),
        ("draft questions for the supplier call", "12:50"),
    ],
)
def test_what_is_for_an_event_comes_before_it_wherever_it_is_written(line: str, by: str) -> None:
    assert "07:00" <= starts(listed([*DAY, line]))["s6"] <= by


@pytest.mark.parametrize(
    "line", ["thank Jo for the client call", "write up notes from the client call", "wrap a book for Sarah"]
)
def test_what_is_for_nothing_that_happens_stands_behind_the_line_above(line: str) -> None:
    assert starts(listed([*DAY, line]))["s6"] >= "18:00"
