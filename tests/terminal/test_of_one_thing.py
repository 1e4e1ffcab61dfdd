"""What is said of one thing that is planned is of that, however it was told, and changes nothing else."""

from datetime import datetime, timedelta

import pytest

from terminal.talking import NINE, Talk, talk_of

FOUR = NINE.replace(hour=16)
FRIDAY_TEN = NINE.replace(hour=10) + timedelta(days=2)

ALONE = ("dentist at ten",)
AMONG_OTHERS = ("feed the cat at quarter past nine, dentist at ten and lock the shed at one",)
FIRST = ("dentist at ten and ring Ann at one",)
TOMORROW = ("dentist tomorrow at ten",)


def starts(talk: Talk) -> dict[str, datetime]:
    plan = talk.turns.plan
    assert plan is not None
    return {one.skill.name: talk.start(one.identifier) for one in plan.skills}


@pytest.mark.parametrize("told", [ALONE, AMONG_OTHERS, FIRST])
@pytest.mark.parametrize(
    ("said", "then"),
    [
        ("move the dentist to four", FOUR),
        ("dentist at four instead", FOUR),
        ("the dentist is at four now", FOUR),
        ("the dentist has been moved to four", FOUR),
        ("move the dentist to friday", FRIDAY_TEN),
        ("the dentist is on friday now", FRIDAY_TEN),
        ("cancel the dentist", None),
        ("the dentist is done", None),
    ],
)
def test_what_is_said_of_one_thing_changes_no_other(
    told: tuple[str, ...], said: str, then: datetime | None
) -> None:
    talk = talk_of("buy stamps at two", *told, "set the alarm at five")
    before = starts(talk)
    talk.say(said)
    expected = before | {"dentist": then}
    assert starts(talk) == {name: start for name, start in expected.items() if start is not None}


@pytest.mark.parametrize(
    "said",
    [
        "move the dentist to four",
        "the dentist is at four now",
        "no, dentist at four",
        "dentist at four instead",
    ],
)
def test_a_new_hour_is_on_the_old_day_and_none_of_the_night(said: str) -> None:
    talk = talk_of(*TOMORROW)
    talk.say(said)
    assert starts(talk) == {"dentist": FOUR + timedelta(days=1)}


@pytest.mark.parametrize(
    "said",
    [
        "the samples should be at four",
        "the samples are not till four",
        "samples at four instead",
        "the samples have been moved to four",
        "spin at four instead",
    ],
)
def test_what_something_is_done_with_stands_for_it(said: str) -> None:
    talk = talk_of("spin the samples at ten")
    talk.say(said)
    assert starts(talk) == {"spin the samples": FOUR}


def test_lunch_that_is_at_one_is_none_of_what_is_bought_for_it() -> None:
    talk = talk_of("buy lunch at ten")
    talk.say("lunch is at one")
    assert len(talk.entries) == 2


@pytest.mark.parametrize("said", ["the lesson is an hour today", "the lesson is an hour now"])
def test_how_long_something_is_is_told(said: str) -> None:
    talk = talk_of("piano lesson at two for 45 minutes")
    talk.say(said)
    assert talk.entries == ["piano lesson at two for an hour"]


def test_how_long_something_takes_is_none_of_its_condition() -> None:
    talk = talk_of("water the plants at ten if it's dry")
    talk.say("make the plants ninety minutes")
    assert talk.entries == ["water the plants at ten for ninety minutes if it's dry"]


@pytest.mark.parametrize("asked", ["is gym before lunch?", "is the gym before lunch?", "is gym tomorrow?"])
def test_a_question_changes_nothing(asked: str) -> None:
    talk = talk_of("gym at ten")
    assert "s1 gym: at 10:00" in talk.say(asked)
    assert talk.entries == ["gym at ten"]


def test_what_stays_of_a_line_keeps_its_label_and_the_moment_it_was_said() -> None:
    talk = talk_of("feed the cat at ten, call mum in half an hour and lock the shed at one")
    talk.wait(minutes=5)
    assert "moved" not in talk.say("forget the cat")
    assert starts(talk)["call mum"] == talk.start("s1.2") == NINE + timedelta(minutes=30)
    assert "s1.2 call mum" in talk.say("why 1")
    talk.say("forget mum")
    assert talk.start("s1.3") == NINE.replace(hour=13)


def test_what_stood_between_two_is_said_apart_with_a_time_of_its_own() -> None:
    talk = talk_of("dentist at ten, then write the report for an hour, then lunch at one")
    talk.say("do the report at two instead")
    assert starts(talk) == {
        "dentist": NINE.replace(hour=10),
        "lunch": NINE.replace(hour=13),
        "write the report": NINE.replace(hour=14),
    }
    assert talk.start("s1.2") == NINE.replace(hour=14)


@pytest.mark.parametrize(
    ("said", "left"),
    [
        ("forget the dentist, they've got flu", {"feed the cat", "lock the shed"}),
        ("forget the dentist, call Ann at six", {"feed the cat", "lock the shed", "call Ann"}),
    ],
)
def test_what_is_said_in_place_of_one_thing_leaves_the_others(said: str, left: set[str]) -> None:
    talk = talk_of(*AMONG_OTHERS)
    talk.say(said)
    assert set(starts(talk)) == left


def test_what_was_not_planned_of_a_line_takes_nothing_else_of_it_along() -> None:
    talk = talk_of("gym at ten, then lunch with Dan at one and shopping at three")
    talk.say("lunch is off, Dan has a meeting")
    assert starts(talk)["gym"] == NINE.replace(hour=10)


def test_one_of_what_is_done_at_once_is_dropped_and_the_others_stay() -> None:
    talk = talk_of("feed the cat at ten, wash the car and the van at one and lock the shed at three")
    talk.say("forget the van")
    assert set(starts(talk)) == {"feed the cat", "wash the car", "lock the shed"}


def test_two_of_a_line_change_places_and_back() -> None:
    talk = talk_of("interview with Priya at ten and with Dominic at eleven, 45 minutes each")
    before = starts(talk)
    talk.say("swap Priya and Dominic")
    assert list(starts(talk).values()) == list(before.values())[::-1]
    talk.say("no, put them back")
    assert starts(talk) == before
    talk.say("Dominic asks whether he could come at four instead")
    assert starts(talk) == before | {"interview with Dominic": FOUR}


def test_a_new_time_is_in_place_of_what_is_vague() -> None:
    talk = talk_of("dentist at ten", "send the invoice tomorrow at some point")
    talk.say("can the invoice go at four?")
    assert starts(talk)["send the invoice"] == FOUR + timedelta(days=1)


@pytest.mark.parametrize("said", ["cancel the gym", "no gym"])
def test_a_correction_that_is_dropped_brings_nothing_back(said: str) -> None:
    talk = talk_of("gym at six and call mum at seven")
    talk.wait(minutes=1)
    talk.say("gym at seven")
    talk.say(said)
    assert talk.entries == ["call mum at seven"]
    assert talk.start("s1.2") == NINE.replace(hour=19)


def test_which_of_two_is_not_to_be_today_is_asked() -> None:
    talk = talk_of("gym at ten", "gym at two as well", "call mum at five")
    assert "which one" in talk.say("no gym today")
    talk.say("the first one")
    assert talk.left == ["gym at two as well", "call mum at five"]


@pytest.mark.parametrize(
    ("told", "said"),
    [
        ("put the bins out at four", "I've put the bins out"),
        ("cut the grass at four", "we've cut the grass"),
        ("feed the cat at four", "I've fed the cat, call Bob at two"),
    ],
)
def test_what_was_done_is_told_also_with_a_verb_that_is_alike(told: str, said: str) -> None:
    talk = talk_of(told)
    assert "done: " in talk.say(said)
    assert told not in talk.left


def test_what_one_has_got_is_nothing_to_do() -> None:
    talk = talk_of("buy strings at two", "call mum at five")
    talk.say("forget the strings, I've got some")
    assert talk.entries == ["call mum at five"]
    talk.say("we've run out of milk")
    assert talk.entries == ["call mum at five"]


@pytest.mark.parametrize(
    ("told", "said"),
    [
        ("bake the loaves at eleven", "bake at half past eleven"),
        ("hand over the keys at three", "keys at four the landlord says"),
    ],
)
def test_what_may_be_the_same_is_said(told: str, said: str) -> None:
    assert "if they are one: drop s1" in talk_of(told).say(said)


def test_what_is_running_may_be_the_same() -> None:
    talk = talk_of("make the soup")
    talk.wait(minutes=1)
    assert "beside s1 make the soup (running), which stays" in talk.say("soup at five")


@pytest.mark.parametrize(
    "said",
    [
        "the gym isn't happening",
        "I don't need to do the gym any more",
        "we don't need the gym",
        "no need for the gym",
    ],
)
def test_what_is_not_needed_is_not_done(said: str) -> None:
    talk = talk_of("gym at ten", "feed the cat at two")
    talk.say(said)
    assert starts(talk) == {"feed the cat": NINE.replace(hour=14)}


def test_what_is_not_needed_and_not_planned_is_pointed_at() -> None:
    talk = talk_of("feed the cat at two")
    assert "not to be done" in talk.say("we don't need to hurry")
    assert talk.entries == ["feed the cat at two"]


def test_a_time_that_is_not_another_is_the_new_one_of_a_thing() -> None:
    talk = talk_of("gym at ten", "feed the cat at two")
    talk.say("the gym at four, not ten")
    assert starts(talk)["gym"] == FOUR


def test_what_names_one_of_several_things_in_another_form_is_of_that() -> None:
    talk = talk_of("count the till at ten, restock the shelves at eleven and ring the supplier at noon")
    talk.say("supplier rang us, so no need to")
    assert talk.entries == ["count the till at ten, restock the shelves at eleven"]
    assert "if they are one: drop s1\n" in talk.say("count the till with Jo")
    talk.say("restock tomorrow instead")
    assert talk.start("s1.2") == NINE.replace(hour=11) + timedelta(days=1)


def test_what_names_some_things_of_a_line_drops_no_others() -> None:
    talk = talk_of("call mum at ten, call dad at eleven and feed the cat at noon")
    assert "which one" in talk.say("cancel the calls")
    assert len(starts(talk)) == len(("mum", "dad", "cat"))


def test_what_one_got_done_of_something_is_nothing_to_do() -> None:
    assert "says nothing to do" in talk_of("mark the essays at ten").say("I only got through half the essays")
