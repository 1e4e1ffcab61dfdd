"""What follows each turn of something repeated."""

import pytest

from interpreter.telling import starts, told

pytestmark = pytest.mark.model


def test_what_comes_then_follows_each_turn_in_its_stretch() -> None:
    made = told(["Every morning feed the cat, then walk the dog"])
    cat, dog = (
        [skill for skill in made.schedule.skills if skill.name == name]
        for name in ("feed the cat", "walk the dog")
    )
    assert len(cat) == len(dog) == 2
    for first, second in zip(cat, dog, strict=True):
        assert first.end <= second.start < first.end + 3600


def test_a_third_step_follows_each_second() -> None:
    made = told(["Every day at 8 am feed the cat, then walk the dog, then make the bed"])
    found = starts(made)
    assert [found[name] for name in ("s1", "s1.2")] == ["08:00", "08:00"]
    assert found["s1"] < found["s1.3"] < found["s1.5"] < "09:00"
    assert found["s1.2"] < found["s1.4"] < found["s1.6"] < "09:00"
