"""What is done again and again beside something that takes longer than the time between."""

import pytest

from interpreter.telling import notes, starts, told

pytestmark = pytest.mark.model


def test_a_look_now_and_then_puts_off_no_work() -> None:
    made = told(["Stir the mix for an hour", "Check the ewe every 20 minutes until 9 am"])
    assert starts(made) | {"s1": "07:00", "s2": "07:20", "s2.2": "07:40"} == starts(made)
    assert not any(made.schedule.rejected)
    assert notes(made) == [
        "check the ewe is done in passing: stir the mix takes longer than the time between"
    ]


def test_what_has_its_time_keeps_it_beside_repetitions() -> None:
    made = told(["Milk the cows at 9 am for two hours", "Look at the hens every hour until noon"])
    assert starts(made)["s1"] == "09:00"
    assert made.schedule.geometric_mean > 0.99


def test_what_finds_room_between_is_not_done_in_passing() -> None:
    made = told(["Stir the mix for ten minutes", "Check the ewe every 20 minutes until 9 am"])
    assert not any(one.skill.in_passing for one in made.skills)


def test_what_takes_long_itself_is_not_done_in_passing() -> None:
    made = told(["Write for two hours", "Walk the dog for 25 minutes every 50 minutes until noon"])
    assert not any(one.skill.in_passing for one in made.skills)


def test_where_another_has_free_hands_nothing_is_done_in_passing() -> None:
    look, stir = "Check the ewe every 20 minutes until 9 am", "Stir the mix for an hour"
    assert not any(one.skill.in_passing for one in told([stir, look], agents=2).skills)
    both = told([stir, "Paint the door for two hours", look], agents=2)
    assert [one.skill.in_passing for one in both.skills[:3]] == [False, False, True]


def test_who_is_asked_for_both_does_one_in_passing_though_another_is_free() -> None:
    lines = ["Robot 1, stir the mix for an hour", "Robot 1, check the ewe every 20 minutes until 9 am"]
    made = told(lines, agents=2)
    assert [one.skill.in_passing for one in made.skills[:2]] == [False, True]
    other = told([lines[0], lines[1].replace("1,", "2,")], agents=2)
    assert not any(one.skill.in_passing for one in other.skills)
