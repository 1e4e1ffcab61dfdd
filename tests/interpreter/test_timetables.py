"""Lines of a file whose times go up stand in that order; other lists of things to do stand in none."""

from datetime import datetime

import pytest

from fuzzytime.interpreter import Request, SpokenWish, plan
from interpreter.telling import SEVEN, interpreter, listed, order, starts

pytestmark = pytest.mark.model


def test_a_line_without_a_time_comes_behind_the_one_above() -> None:
    lines = ["get up at 7:30", "make coffee", "have breakfast at eight", "do the dishes", "leave at 9:15"]
    assert starts(listed([*lines, "lock the door"])) == {
        "s1": "07:30",
        "s2": "07:35",
        "s3": "08:00",
        "s4": "08:15",
        "s5": "09:15",
        "s6": "09:16",
    }


def test_what_stands_above_the_first_time_is_not_put_off() -> None:
    assert starts(listed(["pack the van", "8:00 leave", "9:00 set up", "10:00 doors open"]))["s1"] == "07:00"


def test_several_lines_between_two_times_follow_each_other() -> None:
    lines = ["9:45 mash in", "clean the sink", "weigh the hops", "11:00 sparge", "12:00 boil"]
    assert order(listed(lines)) == ["s1", "s2", "s3", "s4", "s5"]


def test_below_a_day_a_line_stands_where_it_is_written() -> None:
    lines = ["Saturday", "8:00 set up the stall", "9:00 doors open", "12:30 lunch", "count the till"]
    assert starts(listed([*lines, "16:00 pack up"]))["s5"] == "13:15"


def test_what_is_from_a_time_on_has_its_place_among_the_times() -> None:
    lines = ["lunch at half twelve", "fetch the bike any time after 2", "buy bread on the way home"]
    made = starts(listed([*lines, "school is out at quarter past three", "swimming at 5"]))
    assert (made["s2"], made["s3"]) == ("14:00", "14:05")
    # "After six" among the lines of the morning holds nothing up.
    lines = ["08:00 open up", "ring Leo any time after 6 pm", "count the till", "09:00 briefing", "10:00 van"]
    assert starts(listed(lines))["s3"] < "09:00"


def test_what_goes_on_by_itself_is_over_by_the_next_time() -> None:
    lines = ["18:00 kids arrive", "20:15 film", "wash the cups", "21:00 teeth", "22:00 lights out"]
    assert starts(listed(lines))["s3"] == "21:00"


@pytest.mark.parametrize(
    ("line", "expected"), [("pack the bags by 10:15", "08:45"), ("post the keys by 7:50", "07:00")]
)
def test_in_a_table_a_deadline_stands_where_it_is_written_if_that_is_in_time(
    line: str, expected: str
) -> None:
    lines = ["7:30 breakfast", "8:00 flag", "8:30 crafts, 15 min", line, "10:30 parents collect"]
    assert starts(listed(lines))["s4"] == expected


def test_in_sentences_a_deadline_says_all_there_is_to_say() -> None:
    lines = ["answer the mails at eight", "meet the new colleague at nine", "send the offer by noon"]
    assert starts(listed([*lines, "phone the client at eleven"]))["s3"] == "07:00"


def test_one_line_of_many_may_be_out_of_order() -> None:
    lines = ["8:00 set up", "9:00 doors", "van to the garage friday 8:30", "check the till", "11:00 break"]
    assert starts(listed([*lines, "12:00 lunch", "16:00 pack up"]))["s4"] == "09:00"


@pytest.mark.parametrize(
    "lines",
    [
        ["call mum at noon", "water the plants", "gym at six pm"],
        ["gym at six pm", "call mum at noon", "water the plants", "dentist at ten"],
        ["get up at 7:30", "leave at eight", "be back at nine", *("tidy up", "iron", "cook", "sweep") * 2],
    ],
)
def test_times_that_come_as_they_may_say_nothing_of_the_rest(lines: list[str]) -> None:
    assert listed(lines).interpretation.order == ()


def test_what_is_said_one_after_the_other_is_no_file() -> None:
    lines = ["get up at 7:30", "make coffee", "have breakfast at eight", "leave at nine"]
    wishes = tuple(SpokenWish(text=line, given=SEVEN) for line in lines)
    assert plan(Request(now=SEVEN, wishes=wishes), interpreter()).interpretation.order == ()


def test_lines_of_a_day_that_has_begun_stay_in_it() -> None:
    lines = ["Answer the mails from half past eight", "Meet Ann at quarter past nine", "Send it by ten"]
    said = datetime(2026, 3, 4, 8, 31)  # noqa: DTZ001 - the tests' moment is of no zone
    found = starts(listed([*lines, "Give the talk at two"], now=said))
    assert (found["s1"], found["s2"], found["s4"]) == ("08:31", "09:15", "14:00")


def test_a_line_alone_is_of_what_is_to_come() -> None:
    said = datetime(2026, 3, 4, 9, 5)  # noqa: DTZ001 - the tests' moment is of no zone
    assert starts(listed(["Call mum at nine"], now=said)) == {"s1": "21:00"}
    assert starts(listed(["Call mum at nine", "Dentist at ten"], now=said))["s1"] == "21:00"


def test_what_one_line_asks_for_in_a_stretch_shares_it() -> None:
    made = listed(["16:00-16:30 unpack the bags, sweep the hall and wash", "16:30-17:00 watch the news"])
    minutes = [one.skill.duration / 60 for one in made.skills]
    assert minutes == pytest.approx([10, 10, 10, 30])
    assert not any(made.schedule.rejected)
    assert order(made) == ["s1", "s1.2", "s1.3", "s2"]


def test_a_countdown_is_to_what_happens() -> None:
    lines = ["Fair at 4pm on saturday", "Two days before: order the tent", "The night before: load the van"]
    made = listed([*lines, "Six hours before: put up the tent", "An hour before: light the grill"])
    days = [f"{made.instant(time):%a %H:%M}" for time in made.schedule.start_times]
    assert days[:2] == ["Sat 16:00", "Thu 16:00"]
    assert days[2].startswith("Fri 2")
    assert days[3:] == ["Sat 10:00", "Sat 15:00"]


def test_lines_of_a_countdown_may_head_others() -> None:
    lines = ["The fair is on the 28th", "1) One week before", "- print the signs", "2) The day before"]
    made = listed([*lines, "- load the van", "3) Later", "- sweep the hall"])
    days = {
        one.skill.name: made.instant(time)
        for one, time in zip(made.skills, made.schedule.start_times, strict=True)
    }
    assert [days[name].day for name in ("print the signs", "load the van", "sweep the hall")] == [21, 27, 4]
