"""Whole days as people write them: hours in front, nights, meals, what is opened and shut."""

from datetime import datetime

import pytest

from interpreter.telling import listed, starts, told

pytestmark = pytest.mark.model


def _at(hour: int, minute: int = 0) -> datetime:
    return datetime(2026, 3, 4, hour, minute)  # noqa: DTZ001 - of no zone


def test_numbers_in_front_that_go_up_through_the_day_are_hours() -> None:
    lines = [
        "7 handover",
        "7.30 drug round",
        "8 breakfasts then obs",
        "10 ward round",
        "12 lunches",
        "2.30 handover",
    ]
    found = starts(listed(lines, now=_at(6, 40)))
    assert [found[f"s{n}"] for n in range(1, 7)] == ["07:00", "07:30", "08:00", "10:00", "12:00", "14:30"]


def test_amounts_in_front_are_no_hours() -> None:
    lines = ["2 eggs", "3 onions", "call mum at 8.30", "1.5 kg flour", "4 lemons", "dentist 9.15"]
    assert starts(listed(lines))["s3"] == "08:30"


def test_what_stands_beside_a_typed_hour_is_named_by_any_words() -> None:
    lines = ["18:00 crew in", "18:25 the half", "18:55 beginners", "20:15 interval", "me out 9pm-10pm"]
    found = starts(listed(lines))
    assert (found["s2"], found["s5"]) == ("18:25", "21:00")


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (["rounds at 11, 2 and 5"], ["23:00", "02:00", "05:00"]),
        (
            ["start at 10", "sandwich at midnight", "check boilers at 2", "finish at 6"],
            ["22:00", "00:00", "02:00", "05:55"],
        ),
        (["night shift till 6", "tea at 2", "stock check 3.30"], ["21:15", "02:00", "03:30"]),
        (["9 standup", "11:00 call Bob", "12.30 lunch", "2.15 review"], ["09:00", "11:00", "12:30", "14:15"]),
    ],
)
def test_lines_of_a_night_are_in_it(lines: list[str], expected: list[str]) -> None:
    assert list(starts(listed(lines, now=_at(21, 15))).values()) == expected


def test_an_alarm_behind_bedtime_is_in_the_morning() -> None:
    made = listed(["dinner 6", "lights out 10:30", "alarm 6:45"])
    assert starts(made)["s3"] == "06:45"


@pytest.mark.parametrize(
    ("line", "start"),
    [
        ("evening feed at six", "18:00"),
        ("night feed at 2", "02:00"),
        ("morning feed at 8", "08:00"),
        ("buy night cream at 8", "08:00"),
    ],
)
def test_a_part_of_the_day_in_a_name_tells_which_half_is_meant(line: str, start: str) -> None:
    assert starts(told([line], now=_at(6))) == {"s1": start}


def test_a_meal_alone_is_amid_its_hours_where_nothing_else_is() -> None:
    assert starts(told(["call the bank at 10", "lunch", "supper"])) == {
        "s1": "10:00",
        "s2": "12:00",
        "s3": "19:00",
    }


def test_what_is_opened_is_shut_as_late_as_that_is_due() -> None:
    found = starts(told(["open the vents", "lunch at 1", "shut the vents before it gets dark"]))
    assert found["s3"] == "18:00"


def test_all_of_an_afternoon_is_until_its_end() -> None:
    made = told(["paint the fence all afternoon", "read for the rest of the evening"])
    ends = [skill.until for skill in made.schedule.task.skills]
    assert ends == [11 * 3600, 15 * 3600]


@pytest.mark.parametrize(
    ("lines", "starts_at", "length"),
    [
        (["9:30 group meeting, should be done by 10:30"], "09:30", 3600),
        (["interview at 2, finished by 3"], "14:00", 3600),
        (["school play at 6, should be over by 7.30"], "18:00", 5400),
        (["The gel takes 90 minutes, start it at 10"], "10:00", 5400),
    ],
)
def test_when_something_is_over_or_how_long_it_takes_is_told_beside_it(
    lines: list[str], starts_at: str, length: float
) -> None:
    made = told(lines)
    assert starts(made) == {"s1": starts_at}
    assert made.schedule.task.skills[0].time_until_done == length


@pytest.mark.parametrize(
    ("line", "start"),
    [
        ("ring the accountant, she's only there mornings", "08:30"),
        ("visit the library, they're only open afternoons", "12:45"),
        ("see Dr Shah (only in on mornings)", "08:30"),
    ],
)
def test_on_what_part_of_a_day_somebody_is_there_is_when_once(line: str, start: str) -> None:
    assert starts(told([line])) == {"s1": start}


@pytest.mark.parametrize(
    ("lines", "start"),
    [
        (["fight call at 17:45, 15 mins", "preset props after the fight call"], "18:00"),
        (["the break is at 1", "get batteries in the break"], "13:00"),
        (["in bed by 11", "bed by half past ten"], "22:15"),
    ],
)
def test_what_a_line_calls_so_is_meant(lines: list[str], start: str) -> None:
    assert starts(told(lines))["s2"] == start


def test_the_first_thing_of_a_day_is_early_for_who_is_up() -> None:
    assert starts(told(["feed the hens first thing"], now=_at(6, 30)))["s1"] < "08:00"


def test_what_is_named_on_the_way_or_last_is_to_be_done() -> None:
    lines = ["school run 8:20", "10:00 call", "gym on the way home", "tea 6 pm", "hoover last"]
    made = listed(lines)
    assert [one.skill.name for one in made.skills][2::2] == ["gym on the way home", "hoover"]
    assert starts(made)["s5"] >= "18:00"


@pytest.mark.parametrize("line", ["taxi booked for 11:40", "courier booked for 4pm"])
def test_what_is_booked_for_a_time_is_told(line: str) -> None:
    (made,) = told([line]).skills
    assert made.stated
