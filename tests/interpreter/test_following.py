"""Times that count from the lines before: inside what goes on, and on the day after."""

import pytest

from interpreter.telling import notes, starts, told

pytestmark = pytest.mark.model

ROAST = "roast the chicken for 90 minutes"


@pytest.mark.parametrize(
    ("line", "start"),
    [
        ("turn it halfway through", "07:45"),
        ("halfway through, turn it", "07:45"),
        ("add the potatoes when there are 30 minutes left", "08:00"),
        ("with ten minutes to go, warm the plates", "08:20"),
    ],
)
def test_times_inside_what_goes_on_count_in_it(line: str, start: str) -> None:
    assert starts(told([ROAST, "wipe the table", line]))["s3"] == start


def test_a_length_told_afterwards_counts_too() -> None:
    made = told(["put the roast in the oven at five pm", "it takes two hours", "turn it halfway through"])
    assert starts(made)["s3"] == "18:00"


def test_inside_of_nothing_is_told() -> None:
    assert any("none was given so far" in note for note in notes(told(["turn it halfway through"])))


def test_the_same_time_is_that_of_the_line_before() -> None:
    assert starts(told(["call mum at 6 pm", "same time tomorrow call dad"]))["s2"] == "18:00"


def test_the_day_after_counts_from_the_day_of_the_line_before() -> None:
    made = told(["paint the shelf at 5 pm tomorrow", "the day after, hang it up"])
    assert made.instant(made.schedule.start_times[1]).day == 6


def test_the_next_morning_without_a_day_before_is_that_of_tomorrow() -> None:
    made = told(["sweep the floor the next morning"])
    assert made.instant(made.schedule.start_times[0]).day == 5
