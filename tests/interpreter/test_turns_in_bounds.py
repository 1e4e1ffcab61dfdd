"""What is repeated until something else is, before it, or once it is over."""

import pytest

from interpreter.telling import starts, told

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    "lines",
    [
        ["the guests come at 12:30", "turn the spit every two hours until the guests come"],
        ["turn the spit every two hours until the guests come", "the guests come at 12:30"],
        ["handover at 12:30", "turn Mr Lee every two hours until handover"],
        ["meeting at 12:30", "water the plants every two hours before the meeting"],
        ["call mum at 12:30", "water the plants every two hours until you call mum"],
        ["water the plants every two hours until an hour before the meeting", "the meeting is at one"],
    ],
)
def test_turns_are_over_when_what_bounds_them_is_there(lines: list[str]) -> None:
    turns = sorted(time for name, time in starts(told(lines)).items())
    assert turns[:2] == ["09:00", "11:00"]
    assert len(turns) == len(["09:00", "11:00", "12:30"])


@pytest.mark.parametrize(
    ("lines", "first"),
    [
        (["meeting from 10 to 12", "water the plants every two hours after the meeting"], "14:00"),
        (["water the plants every two hours after the meeting", "meeting from 10 to 12"], "13:00"),
        (["call mum at noon for half an hour, then water the plants every two hours"], "14:30"),
    ],
)
def test_turns_begin_once_what_bounds_them_is_over(lines: list[str], first: str) -> None:
    made = told(lines)
    turns = [one.identifier for one in made.skills if one.repeats]
    assert starts(made)[turns[0]] == first
    assert not any(made.schedule.rejected)


def test_what_can_have_no_turn_is_told_once() -> None:
    made = told(["call mum at eight", "water the plants every two hours until you call mum"])
    assert list(made.schedule.rejected).count(True) == 1
    assert len(made.skills) == len(["call", "water"])
