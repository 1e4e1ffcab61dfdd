"""Who is to be somewhere by a time goes there shortly before, and errands are run at once."""

import pytest

from interpreter.telling import starts, told

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    "line",
    [
        "go home by 5 pm",
        "get to the station by 5 pm",
        "walk home by 5 pm",
        "everyone out by 5 pm",
        "put the kids to bed by 5 pm",
        "get Leo to bed by 5 pm",
    ],
)
def test_who_goes_somewhere_by_a_time_goes_shortly_before(line: str) -> None:
    assert starts(told([line])) == {"s1": "16:45"}


@pytest.mark.parametrize(
    "line",
    [
        "go to the bank by 5 pm",
        "get milk by 5 pm",
        "get the letter to Ann by 5 pm",
        "walk by 5 pm",
        "put the mattress on the bed by 5 pm",
    ],
)
def test_an_errand_is_run_at_once(line: str) -> None:
    assert starts(told([line])) == {"s1": "07:00"}


def test_bedtime_is_in_the_evening_whatever_was_said_before() -> None:
    found = starts(told(["unload the van before eight am", "put the kids to bed no later than 8:30"]))
    assert found["s2"] == "20:15"
