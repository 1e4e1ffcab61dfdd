"""Lines of plans as people write them: headings, times, and what is said of other lines."""

import pytest

from interpreter.telling import starts, told

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    ("lines", "expected"),
    [
        (["Swimming 9:30-10:15", "Snack straight after swimming"], {"s2": "10:15"}),
        (["Doors open at noon", "Briefing ten minutes before opening"], {"s2": "11:50"}),
        (["Nap for the little one 1 till 3 pm", "Call Ana while she naps"], {"s2": "13:00"}),
        (["The 1:1 is from 3 to 4 pm", "Send the minutes right after the 1:1"], {"s2": "16:00"}),
    ],
)
def test_what_happens_may_have_the_name_of_what_is_done(lines: list[str], expected: dict[str, str]) -> None:
    found = starts(told(lines))
    assert {name: found[name] for name in expected} == expected


def test_what_is_left_in_the_oven_goes_in_and_comes_out() -> None:
    lines = ["Score the loaves just before they go in", "Bake the loaves at 10 am for 40 minutes"]
    made = told(
        [*lines, "Call Ana 20 minutes before the loaves come out", "Set the table when they come out"]
    )
    found = starts(made)
    assert "09:50" <= found["s1"] < "10:00"
    assert (found["s2"], found["s3"], found["s4"]) == ("10:00", "10:20", "10:40")


def test_what_is_opened_at_a_time_is_shut_behind_that_and_shortly_before_it_is_due() -> None:
    found = starts(told(["Tomorrow", "Open the vents at 9 am, shut them by 5 pm"]))
    assert found["s2"] == "09:00"
    assert "12:00" < found["s2.2"] < "17:00"


@pytest.mark.parametrize(
    ("line", "expected"),
    [("Kids in bed by 9 pm", "20:45"), ("Be off the pitch by 11 am", "10:45"), ("Leave by 9 am", "08:45")],
)
def test_a_deadline_below_a_day_is_kept_as_late_as_one_on_its_own(line: str, expected: str) -> None:
    assert starts(told([line])) == {"s1": expected}
    assert starts(told(["Sunday", line])) == {"s2": expected}
