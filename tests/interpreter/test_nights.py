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


def test_lines_that_begin_in_the_evening_go_on_through_the_night() -> None:
    lines = ["Handover 19:30", "Check drugs at 8", "Give meds at 10", "Lights down 11"]
    lines += ["Do obs at 10, 2 and 6", "Take my break 1:00 - 1:30", "Take bloods at 5", "Hand over at 7:30"]
    found = starts(told(lines, now=_at(9)))
    assert [found[name] for name in ("s5", "s5.2", "s5.3")] == ["22:00", "02:00", "06:00"]
    assert [found[name] for name in ("s6", "s7", "s8")] == ["01:00", "05:00", "07:30"]


@pytest.mark.parametrize(
    ("line", "start"),
    [("bath at 7:30", "19:30"), ("courier comes at 8:15", "20:15"), ("tidy at 11", "11:00")],
)
def test_lines_that_are_mostly_in_order_are_in_that_order(line: str, start: str) -> None:
    lines = ["boiler man comes at 8", "take the pills at 7:10", "school run at 8:25", "call Tom at 10"]
    lines += ["lunch is at 12:45, leave by 12:20", "call the bank at 9:30", "pick Finn up at 3:15", line]
    assert start in starts(told(lines, now=_at(6, 30))).values()


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("Bottles at 7, 11 and 3", ["07:00", "11:00", "15:00"]),
        ("Be in theatre at 11", ["11:00"]),
        ("Go to the theatre at 7:30", ["19:30"]),
    ],
)
def test_what_is_a_little_before_the_first_line_is_in_its_half_of_the_day(
    line: str, expected: list[str]
) -> None:
    lines = [
        "Drop Ella off at 7:20",
        "Drop Noah off at 8",
        "Breakfast at 8:10",
        "Leave at 8:35",
        "Nap 9:30-11",
    ]
    found = starts(told([*lines, line], now=_at(6)))
    assert [start for name, start in found.items() if name.startswith("s6")] == expected


@pytest.mark.parametrize(("now", "title"), [(_at(5), "Saturday: jumble sale"), (_at(20), "Call sheet")])
def test_the_first_line_is_as_early_as_the_lines_below_go_on(now: datetime, title: str) -> None:
    lines = [title, "van at 5:50", "set up stalls at 8:05", "lunch at 1", "doors at 3 pm", "clear up at 8:30"]
    found = [start for name, start in starts(told(lines, now=now)).items() if name != "s1"]
    assert found == ["05:50", "08:05", "13:00", "15:00", "20:30"]
