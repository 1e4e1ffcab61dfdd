"""What is said at night, and what was: which half of the day a clock time without am or pm is in."""

from datetime import datetime

import pytest

from interpreter.telling import notes, starts, told

pytestmark = pytest.mark.model


def _at(hour: int, minute: int = 0) -> datetime:
    return datetime(2026, 3, 4, hour, minute)  # noqa: DTZ001 - of no zone


@pytest.mark.parametrize(
    ("now", "line", "start"),
    [
        (_at(1, 50), "mix the dough at three", "03:00"),
        (_at(1, 50), "call the bank at nine", "09:00"),
        (_at(23, 30), "page the backup at 4:30", "04:30"),
        (_at(23, 30), "call the plumber at six", "18:00"),
        (_at(23, 30), "lunch with Ann is at one", "13:00"),
        (_at(21, 40), "run the migration at eleven", "23:00"),
        (_at(22, 30), "call mum at three", "15:00"),
        (_at(17, 30), "call mum at nine", "21:00"),
    ],
)
def test_what_comes_soon_is_meant_whatever_the_hour(now: datetime, line: str, start: str) -> None:
    assert starts(told([line], now=now)) == {"s1": start}


@pytest.mark.parametrize("shift", ["night shift, 19:30 to 07:30", "the shift is from 19:30 to 7:30"])
def test_within_a_shift_over_midnight_times_are_of_it(shift: str) -> None:
    made = told([shift, "I'm on break from 2 to 3", "handover is at quarter past seven"], now=_at(19, 10))
    assert starts(made) == {"s1": "19:30", "s2": "02:00", "s3": "07:15"}


def test_a_shift_that_is_far_off_says_nothing_of_today() -> None:
    made = told(["the shift is from 10 pm to 6 am", "call the bank at three"], now=_at(9))
    assert starts(made)["s2"] == "15:00"


@pytest.mark.parametrize("line", ["her last turn was at six", "Mr L. had his tablets at six"])
def test_what_was_lies_before_now_and_steers_nothing(line: str) -> None:
    made = told([line, "walk the dog at nine"], now=_at(6, 45))
    assert starts(made) == {"s2": "09:00"}
    assert not any("18:00" in note for note in notes(made))
