"""Times that count from the lines before: inside what goes on, and on the day after."""

from datetime import datetime

import pytest

from fuzzytime.times import MINUTE
from interpreter.telling import SEVEN, notes, starts, told

pytestmark = pytest.mark.model

ROAST = "roast the chicken for 90 minutes"


@pytest.mark.parametrize(
    ("line", "inside"),
    [
        ("turn it halfway through", 45),
        ("halfway through, turn it", 45),
        ("add the potatoes when there are 30 minutes left", 60),
        ("with ten minutes to go, warm the plates", 80),
    ],
)
def test_times_inside_what_goes_on_count_in_it(line: str, inside: int) -> None:
    times = told([ROAST, "wipe the table", line]).schedule.start_times
    assert times[2] - times[0] == inside * MINUTE


def test_a_length_told_afterwards_counts_too() -> None:
    made = told(["put the roast in the oven at five pm", "it takes two hours", "turn it halfway through"])
    assert starts(made)["s3"] == "18:00"


@pytest.mark.parametrize(
    "line",
    [
        "it should be done by noon",
        "the report must be finished by noon",
        "that has to be done by noon",
    ],
)
def test_when_something_must_be_done_is_told_of_it(line: str) -> None:
    made = told(["write the report for two hours", line, "write the letter at 8 am"])
    (report, _) = made.skills
    assert [part.text for part in report.requirements] == ["by noon"]
    assert report.skill.duration == 7200


@pytest.mark.parametrize(
    ("lines", "start"),
    [
        (["put the pie in at noon. Take it out after forty minutes"], "12:41"),
        (["put the pie in at noon, take it out after forty minutes"], "12:41"),
        (["put the pie in at noon, then take it out after forty minutes"], "12:41"),
        (["put the pie in at noon and take it out in forty minutes"], "12:41"),
        (["put the pie in at noon", "take it out after forty minutes"], "12:41"),
        (["put the pie in at noon", "take the pie out after forty minutes"], "12:41"),
        # How long eggs boil is said, so that nothing is assumed.
        (["boil the eggs at noon and take them out after seven minutes"], "12:08"),
        (["boil the eggs at noon", "take them out seven minutes later"], "12:08"),
        (["roast the beef at noon for an hour", "turn it after ten minutes"], "12:10"),
        (["roast the beef at noon for an hour", "serve it ten minutes later"], "13:10"),
    ],
)
def test_so_long_after_counts_from_what_was_asked_for_of_the_same_thing(lines: list[str], start: str) -> None:
    assert list(starts(told(lines)).values()) == ["12:00", start]


@pytest.mark.parametrize(
    ("do", "undo"), [("put the pie in", "take the pie out"), ("open the windows", "close the windows")]
)
def test_what_is_undone_after_so_long_counts_from_when_it_was_done(do: str, undo: str) -> None:
    times = told(["wipe the table", do, f"{undo} after forty minutes"]).schedule
    assert times.start_times[2] - times.start_times[1] == times.skills[1].duration + 40 * MINUTE


@pytest.mark.parametrize(
    "lines",
    [
        ["feed the cat at noon", "feed the cat after forty minutes"],
        ["feed the cat at noon", "brush the dog after forty minutes"],
        ["feed the cat at noon", "brush the cat in forty minutes"],
        ["feed the cat every day at noon", "brush it after forty minutes"],
        ["feed the cat", "brush it in forty minutes"],
        ["don't feed the cat at noon", "brush it after forty minutes"],
    ],
)
def test_so_long_from_now_counts_from_now_elsewhere(lines: list[str]) -> None:
    assert "07:40" in starts(told(lines)).values()


def test_it_is_what_was_set_going_whatever_is_done_with_it_later() -> None:
    made = told(
        ["put the pie in at noon", "take it out after forty minutes", "make the salad while it bakes"]
    )
    assert starts(made)["s3"] == "12:01"


def test_a_deadline_on_a_day_is_in_the_hours_of_people() -> None:
    assert (
        "07:00" <= starts(told(["call mum tomorrow before ten"], now=SEVEN.replace(hour=17)))["s1"] < "10:00"
    )


@pytest.mark.parametrize("clause", ["the pie is baking", "it bakes", "the pie is in the oven"])
def test_while_something_goes_on_is_after_what_sets_it_going(clause: str) -> None:
    made = told(["put the pie in the oven at noon", f"make the salad while {clause}"])
    assert starts(made) == {"s1": "12:00", "s2": "12:01"}
    assert any(note.startswith(f"nothing tells 'while {clause}': taken as once") for note in notes(made))


def test_while_something_goes_on_is_not_after_what_has_nothing_to_do_with_it() -> None:
    made = told(["make the salad", "stir the soup while it simmers"])
    assert list(starts(made)) == ["s1"]


@pytest.mark.parametrize("meal", ["dinner is at seven pm", "serve the dinner at seven pm"])
def test_who_eats_is_at_the_meal_that_something_is_about(meal: str) -> None:
    made = told(["open the wine half an hour before we eat", meal, "wash up after we have eaten"])
    assert starts(made)["s1"] == "18:30"
    assert starts(made)["s3"] > "19:00"


def test_what_is_done_is_named_by_its_noun() -> None:
    made = told(["bathe the kids at seven pm", "put the kids to bed after their bath"])
    assert starts(made)["s2"] > starts(made)["s1"] == "19:00"


@pytest.mark.parametrize(
    ("lines", "due"),
    [
        (["charge the drill", "it needs to be full by noon"], "by noon"),
        (["charge the drill, it must be charged by noon"], "by noon"),
        (["paint the door. It has to be dry by noon"], "by noon"),
    ],
)
def test_what_must_be_so_by_then_is_due_then(lines: list[str], due: str) -> None:
    (skill,) = told(lines).skills
    assert [part.text for part in skill.requirements] == [due]
    assert skill.requirements[0].reference.value == "finish"


@pytest.mark.parametrize(
    "lines", [["mow the lawn", "it must be sunny by noon"], ["call Ann", "she has to be at work by noon"]]
)
def test_what_must_be_so_by_itself_is_no_deadline_of_what_was_asked_for(lines: list[str]) -> None:
    assert not told(lines).skills[0].requirements


@pytest.mark.parametrize("word", ["then", "after that,", "afterwards"])
def test_what_goes_on_telling_goes_on_from_what_was_last_planned(word: str) -> None:
    made = told(["simmer the soup for 20 minutes, stirring occasionally", f"{word} serve the soup"])
    assert starts(made)["s2"] == "07:20"
    assert not any("refers to" in note for note in notes(made))


def test_what_goes_on_meanwhile_does_so_beside_what_was_last_planned() -> None:
    made = told(["simmer the soup at 8 am for 20 minutes. Don't open the lid", "meanwhile, set the table"])
    assert "08:00" <= starts(made)["s2"] < "08:20"


def test_a_length_counts_from_nothing_else_than_what_it_was_said_after() -> None:
    made = told(["fry the fish", "stir the soup occasionally", "ten minutes later, serve the soup"])
    assert any("refers to 'ten minutes later'" in note for note in notes(made))


def test_what_nothing_before_is_about_is_asked_for_itself() -> None:
    made = told(["call mum at 8 am", "the soup must be ready by noon"])
    assert len(made.skills) == 2


def test_what_comes_is_waited_for() -> None:
    made = told(["the truck arrives at 10 am", "unload it within 45 minutes", "sign for the truck"])
    assert "10:00" <= starts(made)["s2"] <= "10:45"
    assert starts(made)["s3"] >= "10:00"


def test_before_they_come_is_before_the_latest_who_do() -> None:
    made = told(
        ["the guests come at 6 pm", "wipe the table", "open the wine half an hour before they arrive"]
    )
    assert starts(made)["s3"] == "17:30"


@pytest.mark.parametrize(
    "line", ["add the peas an hour before it's done", "add the peas an hour before the end"]
)
def test_before_it_is_done_counts_back_from_the_end(line: str) -> None:
    assert starts(told(["simmer the broth for three hours", line]))["s2"] == "09:00"


@pytest.mark.parametrize(
    ("words", "start"),
    [
        ("ten minutes before the roast is done", "10:50"),
        ("ten minutes before the roast's finished", "10:50"),
        ("shortly before the roast is ready", "10:52"),
        ("when the roast is done", "11:00"),
        ("ten minutes before the roast", "09:20"),
    ],
)
def test_before_something_is_done_counts_back_from_its_end(words: str, start: str) -> None:
    made = told(["put the roast in the oven at 9.30 am for 90 minutes", f"set the table {words}"])
    assert starts(made)["s2"] == start


@pytest.mark.parametrize(
    ("line", "start"),
    [
        ("then serve it right away", "10:01"),
        ("then immediately serve it", "10:01"),
        ("after that feed the cat soon", "10:01"),
        ("then serve it later", "10:31"),
        ("feed the cat soon", "07:00"),
    ],
)
def test_soon_and_at_once_behind_another_count_from_when_that_is_done(line: str, start: str) -> None:
    made = told(["stir the soup at 10 am", line])
    assert starts(made)["s2"] == start
    assert made.schedule.satisfactions == (1, 1)


def test_inside_of_nothing_is_told() -> None:
    assert any("none was given so far" in note for note in notes(told(["turn it halfway through"])))


def test_the_same_time_is_that_of_the_line_before() -> None:
    assert starts(told(["call mum at 6 pm", "same time tomorrow call dad"]))["s2"] == "18:00"


def test_the_day_after_counts_from_the_day_of_the_line_before() -> None:
    made = told(["paint the shelf at 5 pm tomorrow", "the day after, hang it up"])
    assert made.instant(made.schedule.start_times[1]).day == 6


def test_the_next_morning_without_a_day_before_is_that_of_tomorrow() -> None:
    made = told(["sweep the floor the next morning"])
    assert made.instant(made.schedule.start_times[0]).day == 5


def test_what_is_unloaded_waits_for_the_latest_that_comes() -> None:
    made = told(
        ["the truck arrives at 9 am", "the truck arrives at 11 am", "unload the truck", "wash the car"]
    )
    assert starts(made)["s3"] >= "11:00"
    assert starts(made)["s4"] < "11:00"


def test_before_they_get_here_is_before_the_latest_who_come() -> None:
    made = told(["the movers come at 10 am", "strip the beds 30 minutes before they get here"])
    assert starts(made)["s2"] == "09:30"


def test_while_somebody_is_asleep_is_not_while_something_else_is() -> None:
    made = told(["lunch is at noon", "mop the hall while he is asleep"])
    assert list(starts(made)) == ["s1"]


def test_what_begins_beyond_the_last_year_is_read_all_the_same() -> None:
    last = datetime(9999, 12, 30, 23, 59)  # noqa: DTZ001 - the tests' moment is of no zone
    assert told(["boil the eggs in 84 hours", "peel them after ten minutes"], now=last).skills


def test_a_condition_behind_what_comes_first_is_no_part_of_it() -> None:
    made = told(["Nap from one till two", "Walk the dog after the nap if the path is dry"])
    (instruction,) = made.waiting[0].requirements[:1]
    assert instruction.anchor is not None
    assert instruction.anchor.target == 0
    assert not any("none so far does" in note for note in notes(made))


def test_what_is_not_to_be_done_for_so_long_after_another_is_that_long_after_it() -> None:
    lines = [
        "Give the baby the antibiotic at ten",
        "Don't give the baby milk for two hours after the antibiotic",
    ]
    for said in (lines, lines[::-1]):
        made = told(said)
        medicine, milk = sorted(made.schedule.start_times)
        assert made.skills[0].skill.name.startswith("give")
        assert (medicine, milk - medicine >= 7200) == (3 * 3600, True)
        assert list(made.schedule.satisfactions) == [1, 1]


def test_minutes_to_the_hour_that_a_line_before_said_are_before_it() -> None:
    assert starts(told(["Vet at ten", "Leave at twenty to"]))["s2"] == "09:40"


def test_an_hour_behind_what_happens_later_is_near_it() -> None:
    made = told(["Dinner is at seven, lay the table at half six"], now=datetime(2026, 3, 4, 6))  # noqa: DTZ001
    assert starts(made) == {"s1": "19:00", "s1.2": "18:30"}


@pytest.mark.parametrize(
    "lines",
    [
        ["supper on saturday at 7 pm", "light the fire an hour before supper"],
        ["supper on saturday at 7 pm", "light the fire an hour before dinner"],
        ["supper on saturday at 7 pm", "light the fire an hour before supper on saturday"],
        ["Saturday", "light the fire an hour before supper", "supper at 7 pm"],
        ["Saturday", "light the fire an hour before the meeting", "meeting at 7 pm"],
    ],
)
def test_what_counts_from_another_is_on_its_day(lines: list[str]) -> None:
    made = told(lines)
    (fire,) = (
        time
        for one, time in zip(made.skills, made.schedule.start_times, strict=True)
        if "fire" in one.skill.name
    )
    assert f"{made.instant(fire):%d %H:%M}" == "07 18:00"
    assert min(made.schedule.satisfactions) == 1


def test_a_meal_that_nothing_tells_of_is_on_the_day_above() -> None:
    made = told(["Saturday", "light the fire an hour before supper"])
    assert f"{made.instant(made.schedule.start_times[0]):%d %H:%M}" == "07 17:00"


@pytest.mark.parametrize("line", ["rain from 9 am", "heavy rain from 9 am", "there is snow from 9 am"])
def test_what_happens_from_a_time_on_begins_then(line: str) -> None:
    made = told([line, "feed the hens right before that"])
    assert starts(made)["s1"] == "09:00"
    assert made.skills[0].stated
