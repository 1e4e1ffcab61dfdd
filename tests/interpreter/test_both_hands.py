"""What is to be done during something else: beside it, in passing, or behind it, which is said."""

import pytest

from interpreter.telling import notes, starts, told

pytestmark = pytest.mark.model


def test_what_goes_on_by_itself_leaves_the_hands_free() -> None:
    made = told(["Simmer the soup at 10 am for 50 minutes", "Chop the nuts during the simmering"])
    assert "10:00" < starts(made)["s2"] < "10:50"
    assert not [note for note in notes(made) if "hands" in note or "passing" in note]


def test_what_takes_a_moment_is_done_in_passing() -> None:
    made = told(["Mix the dough at 10 am for ten minutes", "Add the salt two minutes into the mixing"])
    assert starts(made) == {"s1": "10:00", "s2": "10:02"}
    assert "add the salt is done in passing: mix the dough goes on" in notes(made)


def test_what_has_gone_on_for_so_long_has_not_just_begun() -> None:
    made = told(
        ["Mix the dough at 10 am for ten minutes", "Add the salt when it has been mixed for 4 minutes"]
    )
    assert starts(made) == {"s1": "10:00", "s2": "10:04"}


def test_what_keeps_both_hands_comes_behind_and_that_is_said() -> None:
    made = told(["Mix the dough at 10 am for five minutes", "Chop the nuts during the mixing"])
    assert starts(made) == {"s1": "10:00", "s2": "10:05"}
    assert "chop the nuts comes behind mix the dough, and not during it: both keep the hands" in notes(made)


def test_what_comes_behind_anyway_is_not_pointed_at() -> None:
    made = told(["Mix the dough at 10 am for five minutes", "Chop the nuts after the mixing"])
    assert starts(made) == {"s1": "10:00", "s2": "10:05"}
    assert not [note for note in notes(made) if "hands" in note]


def test_what_waits_for_both_waits_for_the_later() -> None:
    made = told(
        [
            "Cook the rice at 10 am for 50 minutes",
            "Cook the beans at 10.05 am for half an hour",
            "Serve once both are done",
        ]
    )
    assert starts(made)["s3"] == "10:50"


@pytest.mark.parametrize(
    ("line", "start"),
    [
        ("Take notes during the workshop", "10:00"),
        ("Call Ann ten minutes before the end of the workshop", "11:50"),
        ("Call Ann an hour into the workshop", "11:00"),
    ],
)
def test_what_is_inside_of_an_event_that_one_attends_is_done_in_passing(line: str, start: str) -> None:
    made = told(["Workshop from 10 am to noon", line])
    assert starts(made)["s2"] == start
    assert any("in passing: Workshop goes on" in note for note in notes(made))


def test_what_takes_long_is_not_done_in_passing_of_an_event() -> None:
    made = told(["Meeting from 10 to 11 am", "Write the minutes during the meeting"])
    assert starts(made)["s2"] == "11:00"


def test_a_shift_alone_keeps_nobody_from_what_is_done_in_it() -> None:
    made = told(["Shift 14:00-22:00", "break at 6 pm"])
    assert starts(made)["s2"] == "18:00"
