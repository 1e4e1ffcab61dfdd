"""What goes on by itself overnight does so until the morning."""

import pytest

from interpreter.telling import listed

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
