"""What falls with what is rejected, and what does not."""

import pytest

from interpreter.telling import starts, told

pytestmark = pytest.mark.model


def test_what_another_asked_to_come_before_does_not_fall_with_it() -> None:
    made = told(["check in online 24 hours before the flight", "the flight is at 12:40"])
    assert starts(made) == {"s2": "12:40"}


def test_an_order_from_when_to_when_fills_that_time() -> None:
    (one,) = told(["debrief the wardens from 10:30 to 10:45 am"]).skills
    assert one.skill.duration == 900


def test_between_leaves_open_when() -> None:
    (one,) = told(["debrief the wardens between 10:30 and 11:45 am"]).skills
    assert one.skill.duration < 4500


def test_everyone_is_whoever_was_meant_before() -> None:
    made = told(["count everybody at the gate", "give the sign once everyone has been counted"])
    assert starts(made)["s2"] > starts(made)["s1"]


def test_when_you_are_done_is_when_the_line_before_is() -> None:
    made = told(["paint the fence for an hour", "text me when you are finished"])
    assert starts(made)["s2"] == "08:00"
