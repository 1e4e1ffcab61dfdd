"""What goes on by itself overnight does so until the morning."""

import pytest

from interpreter.telling import listed, starts

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    ("line", "until"),
    [
        *(("incubate overnight", 23 * 3600), ("let the stain dry overnight", 23 * 3600)),
        *(("put the brine in the fridge overnight", 23 * 3600), ("run the dishwasher overnight", None)),
    ],
)
def test_what_goes_on_by_itself_takes_the_night(line: str, until: float | None) -> None:
    assert [one.skill.until for one in listed([line]).skills] == [until]


def test_a_step_is_left_overnight_from_the_step_before_on_and_again_in_the_next_night() -> None:
    lines = ["1. Stir the brine for 5 minutes", "2. Put the ham in the brine overnight"]
    made = starts(
        listed([*lines, "3. Rinse the ham for 10 minutes", "4. Let it dry overnight", "5. Smoke it"])
    )
    assert (made["s2"], made["s3"], made["s4"], made["s5"]) == ("07:05", "06:00", "06:10", "06:00")
