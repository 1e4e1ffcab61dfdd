"""What is only assumed to last so long is over when something else is said to begin."""

import pytest

from interpreter.telling import starts, told

pytestmark = pytest.mark.model


def test_people_who_meet_have_met_when_the_next_thing_begins() -> None:
    made = told(["Meet in the yard at 8:15", "Register the class at 8:20", "Call Ann at 9"])
    assert starts(made) == {"s1": "08:15", "s2": "08:20", "s3": "09:00"}
    assert made.skills[0].skill.duration == 300.0


def test_work_is_cut_short_by_half_at_most() -> None:
    short = told(["Call mum at 6 pm", "Call Ann at 6:05 pm"])
    assert starts(short) == {"s1": "18:00", "s2": "18:05"}
    whole, alone = (told(["Paint the hall at 9", *more]) for more in (["Call Ann at 9:05"], []))
    assert whole.skills[0].skill.duration == alone.skills[0].skill.duration


def test_a_length_that_is_said_gives_way_to_nothing() -> None:
    made = told(["Meet in the yard at 8:15 for ten minutes", "Register the class at 8:20"])
    assert made.skills[0].skill.duration == 600.0


def test_with_more_hands_nothing_gives_way() -> None:
    made = told(["Meet in the yard at 8:15", "Register the class at 8:20"], agents=2)
    assert made.skills[0].skill.duration == 3600.0
