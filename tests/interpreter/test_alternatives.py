"""Of several times one of which is enough, the plan takes the one that suits everything else."""

import pytest

from fuzzytime.requirement import asked_words
from interpreter.telling import notes, starts, told

pytestmark = pytest.mark.model


def test_the_first_of_two_times_is_taken_where_both_are_free() -> None:
    assert starts(told(["Call mum at six or at eight"])) == {"s1": "18:00"}
    assert starts(told(["Call mum at eight tonight or at six"])) == {"s1": "20:00"}


def test_the_other_is_taken_where_the_first_is_not_free() -> None:
    lines = ["Call mum at six or at eight", "Mow the lawn from half past five to half past seven"]
    made = told(lines)
    assert starts(made) == {"s1": "20:00", "s2": "17:30"}
    assert list(made.schedule.satisfactions) == [1, 1]


def test_what_follows_one_of_several_times_follows_the_one_that_is_taken() -> None:
    lines = [
        "Call mum at six or at eight",
        "Ten minutes later call dad",
        "Mow the lawn from half past five to half past seven",
    ]
    assert starts(told(lines)) == {"s1": "20:00", "s2": "20:10", "s3": "17:30"}
    assert starts(told(lines[:2])) == {"s1": "18:00", "s2": "18:10"}


def test_of_what_happens_nobody_chooses() -> None:
    made = told(["The guests come at six or at eight", "Mow the lawn from half past five to half past seven"])
    assert starts(made)["s1"] == "18:00"
    assert any("'at eight' is not used" in note for note in notes(made))


def test_three_times_may_be_offered() -> None:
    lines = ["Call mum on monday, tuesday or wednesday at noon", "Call dad on monday at noon for an hour"]
    made = told(lines)
    assert notes(made) == []
    assert list(made.schedule.satisfactions) == [1, 1]


def test_bounds_may_stand_for_each_other() -> None:
    made = told(["Water the beds before nine or after five", "Clean the attic from seven to half past nine"])
    early, late = (made.skills[0].skill.satisfaction([hour * 3600.0]) for hour in (1, 11))
    assert (float(early[0]), float(late[0])) == (1, 1)
    assert float(made.skills[0].skill.satisfaction(5 * 3600.0)) == 0
    assert starts(made)["s1"] == "17:00"


def test_what_else_is_said_holds_for_all_of_them() -> None:
    made = told(["Call mum at six or at eight pm, but not before seven pm"])
    assert starts(made) == {"s1": "20:00"}
    open_ends = told(["Water the beds before nine or after five, but not before 8 am"])
    assert starts(open_ends) == {"s1": "08:00"}


def test_an_end_may_be_at_either_time() -> None:
    made = told(["Have the soup ready at noon or at two", "Meet Ann from eleven to one"])
    assert list(made.schedule.satisfactions) == [1, 1]
    soup = made.skills[0].skill
    assert made.schedule.start_times[0] + soup.time_until_done == 7 * 3600
    assert notes(told(["Have the soup ready by noon or by one"])) == []


def test_a_time_that_is_over_leaves_the_other() -> None:
    made = told(["Feed the cat at 6 am today or at 8 pm today"])
    assert starts(made) == {"s1": "20:00"}
    assert made.skills[0].reason == ""
    assert [problem.kind for problem in made.problems] == []
    gone = told(["Feed the cat at 5 am today or at 6 am today"])
    assert starts(gone) == {}
    assert gone.skills[0].reason


@pytest.mark.parametrize(
    ("line", "start"),
    [
        ("Call mum today if you can, otherwise tomorrow at ten am", "07:00"),
        ("Call mum this evening or tomorrow at ten am", "18:24"),
        ("Call mum by noon or at five pm", "07:00"),
        ("Call mum this afternoon or at eight", "12:36"),
        ("Call mum at six or tomorrow at noon", "18:00"),
        ("Call mum at 18:00 or on friday", "18:00"),
        ("Call mum at 18:00 today or at 18:00 on 4 march 2040", "18:00"),
        ("Not before 8 pm, call mum at six or at eight", "20:00"),
    ],
)
def test_what_is_free_is_taken_as_it_was_said_first(line: str, start: str) -> None:
    made = told([line])
    assert starts(made) == {"s1": start}
    assert made.schedule.start_times[0] < 24 * 3600


def test_soon_behind_one_of_several_times_is_behind_the_one_that_is_taken() -> None:
    lines = [
        "Call mum at six or at eight",
        "Mow the lawn from half past five to half past seven",
        "After calling mum, serve dinner soon",
    ]
    assert starts(told(lines)) == {"s1": "20:00", "s2": "17:30", "s3": "20:10"}


def test_open_bounds_hold_together() -> None:
    assert starts(told(["Not before 9 am, call mum after 10 am"])) == {"s1": "10:00"}
    assert starts(told(["Not before 8 pm, call mum this evening"])) == {"s1": "20:00"}


def test_one_evening_this_week_is_the_one_that_is_free_and_said_once() -> None:
    made = told(["Water the pots one evening this week", "I am out from 5 pm to 11 pm today"])
    watering = made.skills[0]
    assert asked_words(watering.requirements) == "one evening this week"
    assert made.instant(made.schedule.start_times[0]).hour in range(18, 22)
    assert made.instant(made.schedule.start_times[0]).date() > made.instant(0).date()
