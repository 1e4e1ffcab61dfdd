"""What goes on around other work, what others do, and where a journey leads."""

import pytest

from interpreter.telling import notes, starts, told

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    "line",
    [
        "My shift is from 7 to 3",
        "Maintenance window: 7:00 to 15:00",
        "I have the early shift from 7 am to 3 pm",
    ],
)
def test_a_frame_keeps_nobody_from_other_work(line: str) -> None:
    made = told(
        [line, "Sweep the floor when the shift starts" if "shift" in line else "Sweep the floor at 8 am"]
    )
    assert made.request.busy == ()
    assert starts(made)["s2"] in {"07:00", "08:00"}


@pytest.mark.parametrize(
    "line",
    ["Tom has his break from 10 to 10:20 am", "she will do the balloons", "he picks up Leo at four pm"],
)
def test_what_others_do_is_not_asked_for(line: str) -> None:
    (one,) = told([line]).skills
    assert one.operation is not None
    assert one.operation.stated
    assert one.skill.duration == 0


def test_who_leaves_gets_there() -> None:
    made = told(
        [
            "we leave at 9:30 am",
            "the drive takes three quarters of an hour",
            "set up the stall when we get there",
        ]
    )
    assert starts(made) == {"s1": "09:30", "s3": "10:15"}


def test_a_word_for_what_is_done_names_where_it_is_done() -> None:
    made = told(
        [
            "Put the plates into the incubator at 8 am for 4 hours",
            "Change the medium an hour into the incubation",
            "Stain the plates when the incubation is over",
        ]
    )
    assert starts(made) == {"s1": "08:00", "s2": "09:00", "s3": "12:00"}


def test_what_goes_in_is_what_is_baked() -> None:
    made = told(["Preheat the oven 20 minutes before the cake goes in", "Bake the cake at 9 am"])
    assert starts(made)["s1"] == "08:40"


def test_one_after_the_other_is_no_time() -> None:
    made = told(["patch the servers one after the other, ten minutes each"])
    assert made.problems == ()
    assert [one.skill.duration for one in made.skills] == [600]


def test_behind_then_nothing_is_asked() -> None:
    made = told(
        ["Bake the cake at 8 am - it needs 45 minutes in the oven and then has to cool for two hours."]
    )
    assert starts(made) == {"s1": "08:00", "s1.3": "08:45"} or list(starts(made).values()) == [
        "08:00",
        "08:45",
    ]
    assert not [note for note in notes(made) if "asks" in note]


def test_lines_at_night_go_on_behind_midnight() -> None:
    made = told(["Drain it at 22:00", "Put it back by 1:30 at the latest"])
    (bound,) = (part for part in made.skills[1].requirements if part.latest is not None)
    assert bound.latest == 18.5 * 3600
