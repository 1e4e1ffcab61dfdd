"""What is told in words of its own: how long something takes, how far it is, when all must be done."""

import pytest

from interpreter.telling import notes, starts, told

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    "lines",
    [
        ["Copy the worksheets, 25 minutes should do."],
        ["Copy the worksheets. Twenty-five minutes will be enough."],
        ["Copy the worksheets", "25 minutes is plenty"],
        ["Copy the worksheets (allow 25 minutes)"],
        ["Copy the worksheets, give it 25 minutes."],
    ],
)
def test_a_length_is_told_of_what_is_beside_it(lines: list[str]) -> None:
    (one,) = told(lines).skills
    assert (one.skill.name, one.skill.duration) == ("copy the worksheets", 1500)


def test_what_takes_part_gets_a_length() -> None:
    made = told(["Maths test at nine am, they get 40 minutes", "Collect the tests when the maths test ends"])
    assert [one.skill.name for one in made.skills] == ["Maths test", "collect the tests"]
    assert starts(made)["s2"] == "09:40"


@pytest.mark.parametrize(
    "far",
    [
        "It's 40 minutes away.",
        "It's a 40 minute drive",
        "The drive takes 40 minutes",
        "It takes 40 minutes to get there",
    ],
)
def test_who_has_an_appointment_goes_there_before(far: str) -> None:
    made = told(["I have a dentist appointment at 10 am", far])
    assert starts(made) == {"s1": "10:00", "s2": "09:20"}
    assert [(taken.start, taken.end) for taken in made.request.busy] == [(10800, 13500), (8400, 10800)]


def test_who_does_something_elsewhere_goes_there_before() -> None:
    made = told(["Pick up Leo at 3 pm, it's 20 minutes away"])
    assert [one.skill.name for one in made.skills] == ["pick up Leo", "travel to pick up Leo"]
    assert starts(made) == {"s1": "15:00", "s1.2": "14:40"}


@pytest.mark.parametrize(
    "told_way",
    [
        "It takes 20 minutes to get to the framer",
        "It's 20 minutes to the framer",
        "It's 20 minutes to work",
        "It's 20 minutes to get there",
    ],
)
def test_how_far_a_place_is_is_travelled(told_way: str) -> None:
    made = told(["Collect the frames at 3 pm", told_way])
    assert [one.skill.name for one in made.skills] == ["collect the frames", "travel to collect the frames"]
    assert starts(made)["s2"] == "14:40"


@pytest.mark.parametrize("line", ["It's 20 minutes to the meeting", "It's 20 minutes to nine"])
def test_how_long_it_is_to_an_event_is_no_way(line: str) -> None:
    made = told(["Collect the frames at 3 pm", line])
    assert [one.skill.name for one in made.skills] == ["collect the frames"]


@pytest.mark.parametrize("line", ["Stay ten minutes away from it", "Take a 20 minute walk"])
def test_how_far_is_told_of_nothing_that_is_asked_for(line: str) -> None:
    assert len(told([line]).skills) <= 1


def test_everything_is_all_that_was_asked_before() -> None:
    lines = ["wash the car", "sweep the floor", "Everything must be done by 8 am", "call mum"]
    made = told(lines)
    bound = [any(part.text == "by 8 am" for part in one.requirements) for one in made.skills]
    assert bound == [True, True, False]
    assert [one.skill.name for one in made.skills] == ["wash the car", "sweep the floor", "call mum"]


@pytest.mark.parametrize("line", ["We have to be finished by 8 am", "Everything has to be ready by 8 am"])
def test_everything_is_all_that_comes_where_nothing_came_before(line: str) -> None:
    made = told([line, "wash the car", "sweep the floor"])
    assert [one.requirements[-1].text for one in made.skills] == ["by 8 am", "by 8 am"]
    assert notes(told([line])) == ["says when all must be done, and nothing is asked for"]


@pytest.mark.parametrize(
    "need",
    [
        "They need it by noon",
        "Ann needs it by noon",
        "The boys from next door will need it by noon",
        "You need it by noon",
        "Need it by noon",
        "She needs it at noon",
        "It's needed by noon",
    ],
)
def test_what_somebody_needs_is_done_by_then(need: str) -> None:
    for lines in ([f"Print the poster. {need}"], ["Print the poster", need]):
        (poster,) = told(lines).skills
        assert poster.skill.name.lower() == "print the poster"
        last = 5 * 3600 - poster.skill.time_until_done
        early, due, late = poster.skill.satisfaction([last - 3600.0, last, last + 600.0])
        assert (early, due, late) == (1, 1, 0)


@pytest.mark.parametrize(
    "line", ["They don't need it by noon", "Do they need it by noon?", "Ann needs milk by noon"]
)
def test_what_nobody_needs_then_is_not_bounded(line: str) -> None:
    poster, *_ = told(["Print the poster", line]).skills
    assert not poster.requirements


def test_what_is_asked_for_later_keeps_its_time() -> None:
    made = told(["wash the car", "call mum at 7 pm", "Everything must be done by noon"])
    assert starts(made)["s2"] == "19:00"
    assert notes(made) == ["call mum is asked for later than 'by noon', and keeps its time"]


def test_what_begins_with_its_day_is_asked_for_and_no_news() -> None:
    made = told(["Monday: vacuum their own rooms", "Wednesday: clean my own bathroom"])
    assert [one.skill.name for one in made.skills] == ["vacuum their own rooms", "clean my own bathroom"]
    assert not notes(made)


def test_everything_may_be_done_before_something_happens() -> None:
    lines = ["wash the car", "The shift ends at 2 pm; all of it must be done before that"]
    (wash, _) = told(lines).skills
    assert wash.skill.satisfaction.support.high == 7 * 3600 - wash.skill.time_until_done


def test_a_bound_behind_then_counts_from_what_was_before() -> None:
    made = told(["Weld the frame at noon for 10 minutes. Then mount the cover within 5 minutes."])
    assert "12:10" <= starts(made)["s1.2"] <= "12:15"


def test_the_end_of_something_is_a_moment() -> None:
    made = told(["The shift ends at 2 pm", "Sweep the floor when the shift ends"])
    assert starts(made) == {"s1": "14:00", "s2": "14:00"}


def test_what_happens_gives_way_to_nothing_that_should_come_before_it() -> None:
    made = told(["call mum at 7 pm", "It must be done before the guests come", "the guests come at 6 pm"])
    assert starts(made) == {"s3": "18:00"}
    assert notes(made) == ["call mum: its time does not go together with 'the guests come'"]


def test_a_meal_under_a_day_is_the_one_that_was_told() -> None:
    made = told(["Thursday:", "lunch break at one for half an hour", "unload the van after lunch"])
    assert starts(made) == {"s2": "13:00", "s3": "13:30"}


def test_what_is_finished_is_what_is_done() -> None:
    made = told(["Weld the frame at noon for 10 minutes", "Clean the nozzle once you have finished welding"])
    assert starts(made)["s2"] == "12:10"


def test_lines_of_an_evening_go_on_into_the_night() -> None:
    made = told(["The interval is at 20:35", "Strike the set when the show is over at ten"])
    assert starts(made)["s2"] == "22:00"


def test_a_length_told_of_what_goes_on_is_none_of_what_is_repeated_in_it() -> None:
    made = told(["put the sausages on at 9 am, turn them every 4 minutes, they take about 15 minutes"])
    assert starts(made) == {"s1": "09:00", "s1.2": "09:04", "s1.3": "09:08", "s1.4": "09:12"}


def test_the_same_said_again_with_a_length_tells_that() -> None:
    made = told(["soak the seeds at 8 am, they have to soak for 3 hours"])
    assert [(one.skill.name, one.skill.time_until_done) for one in made.skills] == [("soak the seeds", 10800)]


def test_the_end_is_that_of_what_goes_on() -> None:
    made = told(["The exam begins at 9 am and lasts 90 minutes", "Collect the papers at the end"])
    assert starts(made)["s2"] == "10:30"


def test_what_is_over_is_what_was_told_before() -> None:
    made = told(["The film is at 8 pm and lasts two hours", "Tidy up when it is over"])
    assert starts(made)["s2"] == "22:00"


def test_what_has_to_be_done_is_what_was_asked_before() -> None:
    made = told(["Put out the papers, has to be done before the students come in at 8:45 am"])
    assert [part.text for part in made.skills[0].requirements] == ["before the students come in at 8:45 am"]


def test_them_that_are_told_something_are_people() -> None:
    made = told(["Put out the papers", "Tell them to wait"])
    assert made.skills[1].skill.name.startswith("tell them")


def test_a_noun_at_a_time_and_after_another_happens() -> None:
    made = told(["Incision at 8:00 am", "Soundcheck 9:30-10:30", "Dinner for the band after soundcheck"])
    assert starts(made) == {"s1": "08:00", "s2": "09:30", "s3": "10:30"}


def test_who_is_busy_until_then_is_busy_from_now_on() -> None:
    made = told(["I'm busy until three pm", "Call the bank"])
    assert starts(made) == {"s1": "07:00", "s2": "15:00"}


def test_what_is_so_until_then_on_a_day_to_come_is_so_from_its_beginning() -> None:
    made = told(["Tomorrow I'm away until three pm"])
    assert [(one.skill.preferred, one.skill.elapsed) for one in made.skills] == [(61200, 54000)]


def test_a_plan_looks_as_far_ahead_as_it_waits_for_what_has_no_time() -> None:
    made = told(["Feed the hens", "An hour later wash the cups"])
    assert starts(made)["s2"] == "08:03"


def test_an_appointment_of_who_speaks_keeps_them_busy() -> None:
    made = told(["My interview is at ten am", "Wash the car after 9:55 am"])
    assert starts(made)["s2"] == "10:45"


def test_what_is_done_more_often_then_begins_where_the_first_series_ends() -> None:
    made = told(["Turn the pork every twenty minutes for 40 minutes, then every ten minutes until 8 am"])
    assert list(starts(made).values()) == ["07:20", "07:40", "07:50", "08:00"]


def test_who_asks_for_something_before_another_tells_no_new_time() -> None:
    made = told(["Ann washes the dishes tonight", "I need the car at 5 pm, so wash it before then"])
    names = [one.skill.name for one in made.skills]
    assert "wash the car" in names
    assert [part.text for part in made.skills[0].requirements] == ["tonight"]
