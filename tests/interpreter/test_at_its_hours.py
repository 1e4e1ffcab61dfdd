"""Meals, and evenings out, for which a day is said are in their hours."""

from datetime import datetime

import pytest

from interpreter.telling import listed, notes, starts

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    ("line", "start"),
    [
        ("dinner with Ann on friday", "18:12"),
        ("have lunch with Bo tomorrow", "11:15"),
        ("tea with gran tomorrow", "16:15"),
        ("a late supper on saturday", "18:12"),
        ("have lunch", "11:15"),
        ("watch a film", "19:00"),
        ("go to bed", "21:45"),
        ("cinema on friday", "19:00"),
        ("go to the theatre tomorrow", "19:00"),
        ("wake me tomorrow", "06:45"),
        ("book the cinema for friday", "09:00"),
        ("buy party food tomorrow", "09:00"),
        ("film the match on saturday", "09:00"),
        ("bed in the plants on friday", "09:00"),
        ("get lunch boxes tomorrow", "09:00"),
        ("get tea and milk tomorrow", "09:00"),
        ("have breakfast in bed on friday", "07:15"),
        # What is done with a meal is no meal, nor is what it is of.
        ("buy lunch tomorrow", "09:00"),
        ("have a cup of tea tomorrow", "09:00"),
        # A time of day says when by itself.
        ("have dinner at three tomorrow", "15:00"),
        ("have breakfast before nine on friday", "07:00"),
    ],
)
def test_what_is_on_a_day_is_in_its_hours(line: str, start: str) -> None:
    assert list(starts(listed([line])).values()) == [start]


def test_a_day_and_its_meal_head_no_lines() -> None:
    assert list(starts(listed(["call mum at six", "sunday lunch", "feed the cat at seven"]))) == [
        "s1",
        "s2",
        "s3",
    ]


def test_hours_that_are_over_are_not_waited_for() -> None:
    made = listed(["have lunch"], now=datetime(2026, 3, 4, 15))  # noqa: DTZ001 - a wall clock
    assert list(starts(made).values()) == ["15:00"]


def test_what_is_repeated_on_days_is_in_its_hours_on_each() -> None:
    made = listed(["get up early every day"], now=datetime(2026, 3, 4, 9))  # noqa: DTZ001 - a wall clock
    assert set(starts(made).values()) == {"06:45"}
    assert set(starts(listed(["have lunch with Ola every friday"])).values()) == {"11:15"}
    # A part of the day says when by itself.
    assert "11:15" not in starts(listed(["have lunch every evening"])).values()


def test_the_hours_that_are_taken_are_told() -> None:
    told = notes(listed(["dinner with Ann on friday", "dinner with Bob at six", "sunday lunch"]))
    assert [note for note in told if "no time of day" in note] == [
        "dinner with Ann: 18:00 to 20:00 is taken, as no time of day is said"
    ]
