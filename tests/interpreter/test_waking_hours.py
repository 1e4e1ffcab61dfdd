"""How far a repetition without an end is planned: as long as people are up, or for the night."""

from datetime import timedelta

import pytest

from fuzzytime.interpreter import Request, SpokenWish, plan
from interpreter.telling import SEVEN, interpreter, starts, told

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    ("line", "hour", "first", "last", "count"),
    [
        ("check the wires every half hour", 8, "08:30", "22:00", 28),
        ("turn the patient every two hours", 8, "10:00", "22:00", 7),
        ("check the pump every hour starting at 11 pm", 8, "23:00", "06:00", 8),
        ("check the pump every hour starting at 11 pm", 22, "23:00", "06:00", 8),
        ("check the pump every two hours", 23, "01:00", "05:00", 3),
        ("on thursday swap drivers every two hours", 8, "08:00", "22:00", 8),
        ("take the pill every eight hours", 8, "16:00", "08:00", 6),
        ("check the wires every half hour until midnight", 8, "08:30", "00:00", 32),
        ("take a break every hour for 20 hours", 8, "09:00", "04:00", 20),
    ],
)
def test_a_repetition_without_an_end_ends_with_the_day_or_the_night(
    line: str, hour: int, first: str, last: str, count: int
) -> None:
    found = list(starts(told([line], now=SEVEN.replace(hour=hour))).values())
    assert (found[0], found[-1], len(found)) == (first, last, count)


@pytest.mark.parametrize("hour", [2, 9, 21])
@pytest.mark.parametrize("often", ["twice", "three times"])
def test_what_is_done_so_often_a_day_is_done_while_people_are_up(often: str, hour: int) -> None:
    found = starts(told([f"take the pills {often} a day"], now=SEVEN.replace(hour=hour))).values()
    assert all("07:00" <= start <= "22:00" for start in found)


def test_a_horizon_says_how_far_else() -> None:
    wish = SpokenWish(text="check the wires every hour", given=SEVEN)
    made = plan(Request(now=SEVEN, wishes=(wish,), horizon=20 * 3600.0), interpreter())
    assert list(starts(made).values())[-1] == "03:00"


@pytest.mark.parametrize("hours", [2.0, 14.5, 15.2, 26.0])
def test_what_goes_on_for_days_is_planned_for_the_day_to_come(hours: float) -> None:
    now = SEVEN + timedelta(hours=hours)
    wish = SpokenWish(text="check the wires every hour", given=SEVEN)
    made = plan(Request(now=now, wishes=(wish,)), interpreter())
    found = list(starts(made).values())
    assert found[-1] == "22:00"
    assert "03:00" not in found
    assert len(found) <= 17


def test_what_begins_far_ahead_goes_on_until_people_sleep() -> None:
    for line in (
        "Water the pit every hour from 2 pm on saturday",
        "Saturday:\nwater the pit every hour from 2 pm",
    ):
        assert len(told(line.split("\n")).schedule.skills) == 9
