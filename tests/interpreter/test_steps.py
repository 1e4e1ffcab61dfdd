"""Files of steps: what bounds them, and leads to what; what counts from the step before, or is done again."""

from collections.abc import Sequence

import pytest

from interpreter.telling import listed, notes, order, starts

pytestmark = pytest.mark.model

ROAST = ["1. Roast the chicken for 80 minutes", "2. After 20 minutes turn the oven down"]
ROAST += ["3. Halfway through, add the potatoes", "4. Rest the chicken for 15 minutes", "5. Carve it"]

BREAD = ["In the evening mix the dough and leave it for 30 minutes", "Stretch and fold the dough"]
BREAD += ["Put it in the fridge overnight", "Next morning, shape the loaf and let it prove for an hour"]
BREAD += ["Bake for 25 minutes", "Let it cool"]


def _numbered(*lines: str) -> list[str]:
    return [f"{number}. {line}" for number, line in enumerate(lines, 1)]


def test_so_long_after_counts_from_the_step_before_and_from_its_begin_where_that_lasts_longer() -> None:
    made = starts(listed(ROAST))
    assert (made["s2"], made["s3"], made["s4"]) == ("07:20", "07:40", "08:20")


def test_parts_of_the_day_that_follow_each_other_leave_lines_steps() -> None:
    made = listed(BREAD)
    assert order(made) == ["s1", "s1.2", "s2", "s2.2", "s3", "s4", "s4.2", "s5", "s6"]


def test_a_line_that_only_says_when_all_begins_or_is_due_is_no_step() -> None:
    steps = ["Sand the door", "Paint it for an hour", "Hang it"]
    made = starts(listed(_numbered("Start at nine", *steps)))
    assert made == {"s2": "09:00", "s3": "09:10", "s4": "10:10"}
    due = listed(_numbered(*steps, "Deadline 4 pm"))
    assert list(starts(due)) == ["s1", "s2", "s3"]
    assert due.skills[-1].requirements[0].text == "Deadline 4 pm"


@pytest.mark.parametrize("last", ["Dinner is at eight", "We eat at 8 pm", "Serve at eight in the evening"])
def test_steps_that_lead_to_a_meal_are_done_shortly_before_it(last: str) -> None:
    made = starts(
        listed(_numbered("Chop the leeks", "Fry them for 10 minutes", "Bake for half an hour", last))
    )
    assert (made["s1"], made["s3"], made["s4"]) == ("19:16", "19:30", "20:00")


def test_steps_that_lead_to_anything_else_are_done_as_soon_as_they_can_be() -> None:
    made = starts(listed(_numbered("Pack the samples", "Label them", "The courier comes at four")))
    assert (made["s1"], made["s3"]) == ("07:00", "16:00")


def test_what_is_done_again_is_what_its_line_says_or_else_the_one_above() -> None:
    lines = _numbered(
        "Wash the blot for 5 minutes", "Repeat twice", "Spin it for 10 minutes and go again", "Dry it"
    )
    made = listed(lines)
    assert order(made) == ["s1", "s1.2", "s1.3", "s3", "s3.2", "s4"]
    assert starts(made)["s4"] == "07:35"
    apart = starts(listed(_numbered("Fold the dough. Repeat twice, half an hour apart", "Bake it")))
    assert (apart["s1.2"], apart["s1.3"], apart["s2"]) == ("07:32", "08:02", "08:04")


def test_what_goes_on_meanwhile_is_a_chain_and_beside_what_lasts() -> None:
    lines = ["Soak the beans for an hour", "Meanwhile peel the carrots, slice them and grate the cheese"]
    made = starts(listed(_numbered(*lines, "Drain the beans")))
    assert (made["s2.3"] < "07:20", made["s3"]) == (True, "08:00")
    turns = [
        "Simmer the sauce for an hour",
        "Stir it every 10 minutes",
        "Meanwhile boil the rice for 12 minutes",
    ]
    assert starts(listed(_numbered(*turns)))["s3"] < "07:10"
    glue = [
        "Glue the leg and leave it for an hour",
        "While the glue sets, sort the screws and sweep the bench",
    ]
    assert starts(listed(_numbered(*glue, "Sand it")))["s2.2"] < "07:25"


def test_what_is_heated_holds_up_only_what_uses_it() -> None:
    lines = ["Preheat the oven", "Fry the onions for 5 minutes", "Mix them with the eggs", "Bake for an hour"]
    made = starts(listed(_numbered(*lines)))
    assert (made["s2"], made["s4"]) == ("07:00", "07:12")
    made = starts(listed(_numbered("Charge the drill for an hour", "Measure the shelf", "Drill the holes")))
    assert (made["s2"] < "07:05", made["s3"]) == (True, "08:00")


def test_who_does_something_is_asked_to() -> None:
    made = listed(_numbered("Ana peels the carrots, Ben boils the rice for 9 minutes", "Ben drains the rice"))
    assert [(one.operation.addressee, one.skill.name) for one in made.skills if one.operation] == [
        ("Ana", "peel the carrots"),
        ("Ben", "boil the rice"),
        ("Ben", "drain the rice"),
    ]


@pytest.mark.parametrize(
    "lines",
    [
        [
            "Mushroom risotto for 4",
            "300 g rice, 1 litre stock",
            "2 onions",
            "Salt and pepper",
            "Boil the rice",
        ],
        ["Release 2.4", "- freeze the branch", "- run the tests", "- tag it", "- upload it"],
        [
            "Changing the filter",
            *_numbered("Switch the pump off", "Swap the filter", "Switch it on", "Test it"),
        ],
    ],
)
def test_titles_and_what_is_needed_ask_for_nothing(lines: Sequence[str]) -> None:
    made = listed(lines)
    asked = {one.wish.line for one in made.skills}
    assert 1 not in asked
    assert "1" not in {note for note in notes(made) if "nothing to do" in note}
    assert asked == ({5} if lines[-1] == "Boil the rice" else {2, 3, 4, 5})


def test_how_long_all_takes_is_no_step() -> None:
    assert [one.wish.line for one in listed(["Takes 2 hours in total", "Bake the cake"]).skills] == [2]


def test_turns_that_begin_while_the_hands_are_kept_are_done_in_passing() -> None:
    made = starts(listed(["Cook the sauce for an hour", "Stir it every 10 minutes"]))
    assert made["s2"] == "07:10"


def test_what_is_hung_to_dry_keeps_no_hands() -> None:
    made = listed(["Hang the film to dry for 3 hours", "Allow two hours to cool"])
    assert [one.skill.duration for one in made.skills] == [60, 60]


def test_at_once_in_a_step_is_right_after_the_step_before() -> None:
    made = starts(
        listed(
            _numbered(
                "Chill the tubes for 20 minutes", "Warm them for 2 minutes", "Immediately chill them again"
            )
        )
    )
    assert made["s3"] == "07:22"


def test_what_shares_a_delay_follows_and_counts_from_a_step_that_lasts_as_long() -> None:
    made = starts(
        listed(_numbered("Smoke the ham for 2 hours", "After 2 hours open the lid and spray the ham"))
    )
    assert (made["s2"], made["s2.2"]) == ("09:00", "09:00")


def test_a_step_goes_on_until_a_state_and_not_until_a_step_before_it() -> None:
    steps = _numbered("Let the loaf rise for an hour", "Bake it for half an hour, or until risen", "Cool it")
    made = starts(listed(steps))
    assert (made["s2"], made["s3"]) == ("08:00", "08:30")


def test_for_the_first_minute_is_how_long_a_step_goes_on() -> None:
    made = starts(
        listed(_numbered("Soak the print for 4 minutes", "Rock the tray for the first 2 minutes", "Drain it"))
    )
    assert made["s3"] == "07:06"
