"""What is done once for each of several that others ask for, or tell."""

import pytest

from interpreter.telling import notes, starts, told

pytestmark = pytest.mark.model


def test_what_is_said_of_each_is_done_for_each_wherever_they_are_told() -> None:
    made = told(
        ["Feed the calves after each milking", "Milk the cows at 8 am and 5 pm", "Muck out between milkings"]
    )
    assert starts(made) == {"s1": "08:05", "s1.2": "17:05", "s2": "08:00", "s2.2": "17:00", "s3": "08:08"}


def test_what_is_done_before_each_is_done_near_it() -> None:
    made = told(["Feed the baby every three hours until 3 pm", "Change her before every feed"])
    assert [starts(made)[name] for name in ("s2", "s2.2")] == ["09:55", "12:55"]


def test_each_may_be_named_by_several_lines() -> None:
    lines = [
        "First dive at 9 am for 45 min",
        "Second dive at 11 am for 45 min",
        "Call the roll after each dive",
    ]
    found = starts(told([*lines, "Rinse the masks ten minutes before each dive"]))
    assert found == {
        "s1": "09:00",
        "s2": "11:00",
        "s3": "09:45",
        "s3.2": "11:45",
        "s4": "08:50",
        "s4.2": "10:50",
    }


def test_one_without_a_time_comes_where_it_was_said() -> None:
    lines = ["First dive at 9 am for 45 min", "Rest for an hour", "Second dive after the rest for 45 min"]
    found = starts(told([*lines, "Call the roll after each dive"]))
    assert found["s1"] == "09:00"
    assert found["s3"] > found["s1"]
    assert [found["s4"], found["s4.2"]] == ["09:45", "11:30"]


def test_every_one_of_what_comes_is_waited_for() -> None:
    made = told(["Trucks at 8 am and 11 am", "Unload every truck, 40 min", "Sweep the dock between trucks"])
    found = starts(made)
    assert "08:00" <= found["s2"] < "08:30"
    assert found["s2.2"] == "11:00"
    assert "08:00" <= found["s3"] < "11:00"
    assert "s3.2" not in found


def test_between_is_a_place_where_something_is_put() -> None:
    made = told(["Read plate 1 at 9 am", "Read plate 2 at 10 am", "Put a film between the plates"])
    assert "s3.2" not in starts(made)
    assert not notes(made)


def test_who_comes_and_goes_is_pointed_at_where_nobody_tells_when() -> None:
    made = told(["Wash your hands between patients"])
    assert any("when they come and go is not told" in note for note in notes(made))


def test_two_are_needed_to_be_between_them() -> None:
    made = told(["Milk the cows every day at 8 am until thursday", "Muck out between milkings"])
    assert any("too few" in note for note in notes(made)) or "s2" in starts(made)
