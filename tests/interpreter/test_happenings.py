"""What happens without a verb, what keeps who speaks, and clock times of the lines before."""

import pytest

from interpreter.telling import notes, order, starts, told

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    ("line", "name", "length"),
    [
        ("dinner at seven pm", "dinner", 3600),
        ("team meeting from two to three", "team meeting", 3600),
        ("dentist at nine am", "dentist", 2700),
        ("swimming lesson 5 to 5:30 pm", "swimming lesson", 1800),
        ("lunch with Anna at noon", "lunch with Anna", 2700),
    ],
)
def test_what_happens_needs_no_verb(line: str, name: str, length: float) -> None:
    (one,) = told([line]).skills
    assert (one.skill.name, one.skill.duration, one.skill.time_until_done) == (name, 0, length)


def test_a_meal_alone_among_lines_is_had_at_its_hours_and_others_count_from_it() -> None:
    made = told(["feed the hens at eight", "Lunch.", "nap after lunch"])
    assert [one.skill.name for one in made.skills] == ["feed the hens", "lunch", "nap"]
    assert starts(made)["s3"] > starts(made)["s2"]
    assert "11:00" <= starts(made)["s2"] <= "13:00"


def test_a_meal_alone_is_a_time_and_nothing_to_do() -> None:
    assert not told(["lunch"]).skills


def test_what_runs_once_it_is_begun_is_over_so_much_later() -> None:
    made = told(
        ["label the tubes at eight", "start the PCR once the tubes are labelled, it runs for 2 hours"]
    )
    skill = made.skills[-1].skill
    assert skill.time_until_done == skill.duration + 7200


@pytest.mark.parametrize(
    "line",
    [
        "cook dinner at seven pm",
        "schedule lunch at noon",
        "book a meeting at three pm",
        "serve lunch at noon",
    ],
)
def test_what_is_asked_for_is_no_happening(line: str) -> None:
    (one,) = told([line]).skills
    assert one.skill.duration > 0


def test_what_keeps_the_speaker_on_each_day_is_busy_on_each_day() -> None:
    made = told(["I have a standup every day from 9 to 9:15"])
    spans = [(made.instant(taken.start), made.instant(taken.end)) for taken in made.request.busy]
    assert [f"{start:%d %H:%M}-{end:%H:%M}" for start, end in spans] == ["04 09:00-09:15", "05 09:00-09:15"]


@pytest.mark.parametrize("length", ["for an hour", "for two hours"])
def test_what_the_speaker_has_keeps_them_as_long_as_is_said(length: str) -> None:
    (one,) = told([f"I have a meeting at 2 pm {length}"]).skills
    assert (one.skill.name, one.skill.duration) == ("a meeting", 0)


def test_what_goes_on_around_other_work_has_a_name_and_its_time() -> None:
    made = told(["I have the late shift from 2 to 10", "I have office hours from 1 to 3 pm"])
    assert [one.skill.name for one in made.skills] == ["the late shift", "have"]
    assert starts(made) == {"s1": "14:00", "s2": "13:00"}


def test_others_count_from_the_end_of_what_happens() -> None:
    assert starts(told(["lunch at noon", "wash up after lunch"]))["s2"] == "12:45"


def test_an_order_may_follow_what_happens() -> None:
    made = told(["lunch at half past twelve, cook it beforehand"])
    assert [one.skill.name for one in made.skills] == ["lunch", "cook lunch"]
    assert starts(made)["s1.2"] < "12:00"


def test_what_happens_may_overlap() -> None:
    made = told(["doctor's appointment at 8:30 am", "dentist at 9 am", "the train leaves at 9:10 am"])
    assert starts(made) == {"s1": "08:30", "s2": "09:00", "s3": "09:10"}


def test_what_happens_gives_way_to_no_work() -> None:
    made = told(
        ["the train leaves at 9 am", "I have a call from 10 to 11", "ring the bell at 9 am and at 10 am"]
    )
    assert (starts(made)["s1"], starts(made)["s2"]) == ("09:00", "10:00")


def test_the_half_of_the_day_comes_from_the_line_before() -> None:
    made = told(["dinner should be ready at half six", "bath the baby at seven", "read a story at eight"])
    assert starts(made)["s2"] == "19:00"
    assert starts(made)["s3"] == "20:00"
    assert any("taken as 19:00" in note for note in notes(made))


def test_a_line_far_from_the_one_before_stands_alone() -> None:
    assert starts(told(["finish the report by 4 pm", "call Tom at nine"]))["s2"] == "09:00"


def test_what_people_do_in_the_morning_stays_there() -> None:
    assert starts(told(["go to bed at ten pm", "have breakfast at eight"]))["s2"] == "08:00"


def test_work_goes_on_while_something_happens() -> None:
    made = told(["the train leaves at 9:15 am", "paint the fence at 9:05 am for 20 minutes"])
    assert starts(made) == {"s1": "09:15", "s2": "09:05"}
    assert made.schedule.satisfactions == (1.0, 1.0)


def test_what_comes_after_what_happens_waits_for_it() -> None:
    made = told(["the guests arrive at 10 am", "wash up at 9:55 am for 20 minutes", "then greet the guests"])
    assert starts(made)["s1"] == "10:00"
    assert starts(made)["s2"] == "09:55"
    assert starts(made)["s3"] >= "10:15"


@pytest.mark.parametrize("line", ["I fed the cat", "I've already called mum", "We have watered the plants"])
def test_what_was_done_is_not_planned_and_said(line: str) -> None:
    made = told([line])
    assert not made.skills
    assert [problem.message for problem in made.problems] == [
        f"{line!r} tells what was, and says nothing to do"
    ]


@pytest.mark.parametrize("line", ["I put the bins out", "I want the cat fed", "I have to call mum"])
def test_what_may_be_a_wish_is_planned(line: str) -> None:
    assert told([line]).skills


def test_appointments_that_overlap_are_pointed_at() -> None:
    lines = ["I have a meeting from 10 to 11", "I have a dentist appointment from half past ten to 12"]
    found = [note for note in notes(told(lines)) if "overlap" in note]
    assert found == ["a meeting (10:00 to 11:00) and a dentist appointment (10:30 to 12:00) overlap"]
    after = told([lines[0], "I have a call from 11 to 12"])
    assert not any("overlap" in note for note in notes(after))


def test_what_somebody_is_on_for_is_an_event_with_its_length() -> None:
    made = told(["We're on at 20:30 and play for 75 minutes", "iron the shirts an hour before we're on"])
    assert [one.skill.name for one in made.skills] == ["on", "iron the shirts"]
    assert made.skills[0].skill.time_until_done == 75 * 60
    assert starts(made)["s1"] == "20:30"
    assert order(made) == ["s2", "s1"]
