"""Errands on the lines below where somewhere opens are not done before that."""

import pytest

from interpreter.telling import listed, starts

pytestmark = pytest.mark.model


def test_errands_below_where_a_shop_opens_wait_for_that() -> None:
    found = starts(listed(["shop opens at 8", "buy bread", "post the parcel", "sweep the yard"]))
    assert found["s4"] < "08:00" <= min(found["s2"], found["s3"])


def test_what_stands_behind_another_chore_does_not_wait() -> None:
    assert starts(listed(["shop opens at 8", "sweep the yard", "buy bread"]))["s3"] < "08:00"


def test_in_between_is_behind_the_first_of_two() -> None:
    assert "11:00" <= starts(listed(["meetings at 10 and 2, snack in between"]))["s1.3"] < "14:00"


def test_a_meal_is_cooked_by_then() -> None:
    assert starts(listed(["dinner at seven, takes 40 min to cook"])) == {"s1": "19:00", "s1.2": "18:20"}
