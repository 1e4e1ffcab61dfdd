"""What is to be ready when something begins, and what is to be done right beside something else."""

import pytest

from interpreter.telling import notes, starts, told

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    "line",
    [
        "Fry the bacon for 10 minutes so that it's ready when the guests come",
        "Have the table set for 10 minutes when the guests come",
    ],
)
def test_what_is_to_be_ready_when_something_begins_is_over_by_then(line: str) -> None:
    made = told(["The guests come at 11 am", line])
    assert starts(made)["s2"] == "10:50"


def test_what_is_to_be_ready_when_another_is_done_is_over_by_then() -> None:
    made = told(["Roast the meat at 5 pm for 2 hours", "Have the plates warm when the roast is done"])
    assert starts(made)["s2"] == "18:55"


def test_just_before_something_is_right_before_it() -> None:
    lines = ["The guests come at 11 am", "Light the candles just before the guests come"]
    assert "10:50" <= starts(told(lines))["s2"] <= "10:59"


def test_a_meal_that_was_told_is_meant_by_its_hour() -> None:
    made = told(["Lunch is at 1:15 pm", "Call Leo at lunchtime", "Remind them of the trip just before lunch"])
    assert starts(made)["s2"] == "13:15"
    assert "13:05" <= starts(made)["s3"] <= "13:14"


def test_what_is_over_may_say_when() -> None:
    assert starts(told(["Strike the set when the show is over at ten pm"]))["s1"] == "22:00"


@pytest.mark.parametrize(("words", "latest"), [("Right", 12), ("Shortly", 25)])
def test_what_comes_right_behind_is_near(words: str, latest: int) -> None:
    lines = [
        "Put the roast in at five pm",
        f"{words} after that peel the potatoes",
        "Sweep the floor at 5:01 pm",
    ]
    made = told(lines)
    roast, potatoes = (made.schedule.skills[place] for place in (0, 1))
    assert 0 <= potatoes.start - roast.end <= latest * 60
    assert notes(made) == []
    (order,) = made.schedule.task.precedences
    assert order.wished_lag is not None


def test_what_lasts_goes_on_by_itself_where_something_is_done_meanwhile() -> None:
    made = starts(told(["Degas the solvent for 20 minutes", "Meanwhile weigh out the salt for a minute"]))
    assert made["s1"] == "07:00"
    assert made["s2"] < "07:20"


def test_what_is_done_meanwhile_is_beside_what_lasts() -> None:
    lines = ["Rest the steaks for five minutes, then plate them", "Meanwhile warm the plates for two minutes"]
    made = starts(told(lines))
    assert made["s1"] == made["s2"] == "07:00"
    assert made["s1.2"] >= "07:05"


def test_who_is_called_for_what_lasts_keeps_at_it_while_another_does_something() -> None:
    made = told(["Anna, degas the solvent for 20 minutes", "Meanwhile weigh out the salt for a minute"])
    assert next(one for one in made.skills if one.identifier == "s1").skill.duration == 20 * 60


def test_what_needs_hands_to_its_end_keeps_them() -> None:
    made = starts(told(["Mix the flour for five minutes", "Meanwhile grease the tin for two minutes"]))
    assert made["s2"] == "07:05"


def test_what_is_put_in_without_a_verb_goes_on_by_itself() -> None:
    made = starts(told(["Ribs in at 8:30, two hours", "Baste them halfway through"]))
    assert made == {"s1": "08:30", "s2": "09:30"}


def test_it_is_what_has_changed_by_then() -> None:
    lines = ["Mix the dough for 12 minutes", "Let it prove for an hour", "Scale the butter for five minutes"]
    made = told([*lines, "When the dough has risen, shape it"])
    assert next(one.skill.name for one in made.skills if one.identifier == "s4") == "shape the dough"
