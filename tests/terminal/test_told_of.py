"""What is told of a thing that was asked for, or called by its time: "the gym is off", "my ten o'clock"."""

import pytest

from terminal.talking import Talk

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    ("wish", "told", "left"),
    [
        ("walk the dog at four pm", "the walk is off", []),
        ("gym at six pm", "gym's off today", []),
        ("gym at six pm", "gym is at seven pm today", ["gym at seven pm today"]),
        ("gym at six pm", "so the gym is half an hour later", ["gym at six pm"]),
        ("patient at ten am for 45 min", "the ten o'clock cancelled", []),
        ("patient at ten am for 45 min", "the 10am is off", []),
        ("patient at ten am for 45 min", "move my ten o'clock up to 9:30", ["patient at 9:30 for 45 min"]),
        ("call Ann at ten, call Bob at five pm", "cancel the ten o'clock", ["call Bob at five pm"]),
        # What only has to do with it stays.
        ("buy lunch at noon", "lunch is off", ["buy lunch at noon"]),
        ("gym at six pm", "gym's off on sunday", ["gym at six pm"]),
        ("patient at ten am", "cancel the four o'clock", ["patient at ten am"]),
    ],
)
def test_what_is_told_of_a_thing_changes_that_itself(wish: str, told: str, left: list[str]) -> None:
    talk = Talk()
    talk.say(wish)
    talk.say(told)
    assert talk.entries == left


@pytest.mark.parametrize(
    ("wish", "told", "answer"),
    [
        ("strip the wallpaper for an hour", "wallpaper's taking longer, another half hour", "10:30"),
        ("gel at ten am for an hour", "the gel's running slow, 20 minutes", ":duration 1 80min"),
        ("strip the wallpaper at ten am for an hour", "the wallpaper is taking longer", "by how much?"),
        ("guests come at seven pm", "guests are stuck in traffic, half an hour", "from 19:00 to 19:30"),
        ("meeting with tom at ten am", "tom's running late, about 20 minutes", "from 10:00 to 10:20"),
        ("walk the dog", "the loaf is taking longer, ten minutes", "nothing that is planned is about loaf"),
    ],
)
def test_by_how_much_something_is_late_or_longer_may_stand_behind_a_comma(
    wish: str, told: str, answer: str
) -> None:
    talk = Talk()
    talk.say(wish)
    assert answer in talk.say(told)


def test_of_several_that_start_then_one_must_be_named() -> None:
    talk = Talk()
    talk.say("call bob at ten")
    talk.say("call mum at ten")
    assert "several start then" in talk.say("cancel my ten o'clock")
    assert len(talk.entries) == 2
