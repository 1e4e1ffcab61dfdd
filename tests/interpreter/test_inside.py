"""What is done again and again while something goes on, and what one sentence joins."""

import pytest

from fuzzytime.times import MINUTE
from interpreter.telling import SEVEN, listed, notes, order, starts, told

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    "lines",
    [
        ["simmer the soup for an hour", "stir it every 20 minutes"],
        ["incubate the plate for an hour", "take a reading every 20 minutes during the incubation"],
        ["print the bracket", "the print takes an hour", "check on it every 20 minutes"],
    ],
)
def test_a_repetition_is_over_with_what_it_is_about(lines: list[str]) -> None:
    made = told(lines)
    assert sorted(starts(made).values()) == ["07:00", "07:20", "07:40"]
    assert any("as long as this goes on" in note for note in notes(made))


@pytest.mark.parametrize(
    "lines",
    [
        ["roast the duck for two hours", "baste it every 20 minutes for the last hour"],
        ["the party is from 7 am to 9 am", "pass the cake every 20 minutes in the last hour of the party"],
        ["simmer the stock for two hours", "during the last hour, skim it every 20 minutes"],
    ],
)
def test_a_repetition_in_the_end_of_something_counts_back_from_there(lines: list[str]) -> None:
    made = told(lines)
    assert sorted(starts(made).values()) == ["07:00", "08:00", "08:20", "08:40"]
    assert any("is the end of this" in note for note in notes(made))


def test_a_repetition_in_the_end_of_nothing_that_is_known_is_not_planned() -> None:
    assert not told(["baste the duck every 20 minutes for the last hour"]).skills
    assert not starts(told(["baste the duck every 20 minutes for the last hour of roasting"]))


def test_a_repetition_of_its_own_goes_on() -> None:
    made = told(["simmer the soup for an hour", "stretch every 20 minutes until noon"])
    assert len(made.skills) > 10


def test_after_a_repetition_inside_something_is_after_that() -> None:
    made = told(["simmer the soup for an hour", "stir it every 20 minutes", "serve the soup afterwards"])
    assert starts(made)["s3"] == "08:00"


def test_of_what_no_occurrence_can_satisfy_yet_one_waits() -> None:
    made = told(["take a sample every 15 minutes during the flood"])
    assert (len(made.skills), len(made.waiting)) == (0, 1)


@pytest.mark.parametrize(
    "line", ["reboot the servers at 9 am and wait ten minutes", "glue the lid and sand it"]
)
def test_what_one_sentence_goes_on_with_follows(line: str) -> None:
    made = told([line])
    assert starts(made)["s1"] < starts(made)["s1.2"]
    assert made.interpretation.order


def test_things_that_have_nothing_in_common_stay_free() -> None:
    assert not told(["buy the milk and call Anna"]).interpretation.order


def test_in_the_meantime_is_beside_the_line_before() -> None:
    made = told(["bake the bread for an hour at 9 am", "sort the racks in the meantime"])
    assert "09:00" <= starts(made)["s2"] < "10:00"


def test_them_is_what_the_clause_in_front_is_about() -> None:
    made = told(["bake the rolls", "wash the trays", "once the rolls have baked, sell them"])
    assert made.skills[2].skill.name == "sell the rolls"


def test_who_speaks_early_is_up() -> None:
    assert starts(told(["milk the cows at half past five"], now=SEVEN.replace(hour=5)))["s1"] == "05:30"


def test_counted_turns_begin_behind_what_they_follow() -> None:
    made = told(["stain the slide for 20 minutes, then rinse it three times, five minutes each"])
    assert starts(made) == {"s1": "07:00", "s1.2": "07:20", "s1.3": "07:25", "s1.4": "07:30"}


def test_counted_turns_begin_behind_what_was_done_with_the_same_thing() -> None:
    made = told(["mix the dough at eight", "fold it twice, half an hour apart, then shape it"])
    first, second = starts(made)["s2"], starts(made)["s2.2"]
    assert first > "08:00"
    assert order(made) == ["s1", "s2", "s2.2", "s2.3"]
    assert int(second[:2]) * 60 + int(second[3:]) - int(first[:2]) * 60 - int(first[3:]) == 30


def test_counted_turns_are_steps_among_others() -> None:
    made = told(["stain it for 5 min, wash 3 times for 2 min each, rinse twice, a minute each, mount it"])
    assert list(starts(made).values()) == ["07:00", "07:05", "07:07", "07:09", "07:11", "07:12", "07:13"]
    lines = listed(
        ["thaw the gel for 20 min", "wash twice, 1 min each", "after 2 min elute", "spin it", "store it"]
    )
    assert order(lines) == ["s1", "s2", "s2.2", "s3", "s4", "s5"]
    assert starts(lines)["s3"] == "07:24"


def test_of_two_that_are_said_to_last_the_second_follows() -> None:
    assert starts(told(["simmer the stew for an hour, rest 15"])) == {"s1": "07:00", "s1.2": "08:00"}


def test_no_turn_begins_before_the_one_before_it_is_over() -> None:
    made = told(["do three sets of press-ups, two minutes per set, with a minute between sets"])
    assert list(starts(made).values()) == ["07:00", "07:03", "07:06"]


def test_what_is_done_with_somebody_follows_what_was_asked_for_them() -> None:
    assert order(told(["collect the kids at three and take them to the park"])) == ["s1", "s1.2"]
    assert order(told(["wake Leo at eight", "give him a bath"])) == ["s1", "s2"]
    assert order(told(["feed the cat at eight and let her out"])) == ["s1", "s1.2"]


def test_what_is_needed_then_is_done_by_then() -> None:
    made = told(["charge the bike for an hour, I need it at nine"])
    assert len(made.skills) == 1
    assert starts(made)["s1"] <= "08:00"


def test_what_is_on_the_way_comes_behind() -> None:
    made = told(["take Leo to the dentist at half three and pick up a pizza on the way back"])
    assert order(made) == ["s1", "s1.2"]


@pytest.mark.parametrize(
    "lines",
    [["paint the door and give it a day", "sand it"], ["paint the door", "give it a day", "sand it"]],
)
def test_what_is_left_alone_leaves_the_hands_free(lines: list[str]) -> None:
    first = told(lines).skills[0].skill
    assert first.time_until_done == first.duration + 86400


def test_what_something_that_takes_long_needs_comes_before_it() -> None:
    made = told(["chill the pudding for four hours, so make it before noon"])
    assert starts(made)["s1.2"] < starts(made)["s1"]


@pytest.mark.parametrize(
    "text",
    [
        "simmer the stew at noon for three hours, stir it every twenty minutes for the first hour",
        "simmer the stew at noon for three hours. For the first hour, stir it every twenty minutes",
    ],
)
def test_what_is_repeated_for_the_first_hour_is_so_from_the_start_of_what_goes_on(text: str) -> None:
    at = starts(told([text]))
    assert list(at.values()) == ["12:00", "12:20", "12:40", "13:00"]


@pytest.mark.parametrize(
    "lines",
    [
        ["on friday roast the lamb for two hours, basting every half hour"],
        ["Friday:", "roast the lamb for two hours", "baste it every half hour"],
        ["Friday:", "mash for two hours, stirring every half hour"],
    ],
)
def test_what_goes_on_on_a_day_bounds_what_is_done_during_it(lines: list[str]) -> None:
    made = told(lines)
    roast, *turns = made.schedule.start_times
    assert [turn - roast for turn in turns] == [30 * MINUTE, 60 * MINUTE, 90 * MINUTE]


def test_another_day_is_not_bounded_by_what_goes_on_today() -> None:
    made = told(["roast the lamb for two hours", "on friday baste it every eight hours"])
    assert len(made.skills) == 4


def test_hours_on_a_line_above_are_no_length_of_what_is_below() -> None:
    made = told(["From 2 to 4 pm:", "mow the lawn", "call Ann at 3 pm"])
    assert starts(made)["s3"] == "15:00"


def test_what_words_name_may_last_for_one_turn_alone() -> None:
    made = told(
        ["rehearse from nine to half past eleven", "take a break every 90 minutes during the rehearsal"]
    )
    assert [time for name, time in starts(made).items() if name.startswith("s2")] == ["10:30"]
    assert made.schedule.satisfaction == 1.0
