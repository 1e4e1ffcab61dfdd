"""What is planned, said with its verb: later or earlier, begun, on another day, or not at all."""

import pytest

from terminal.talking import talk_of

pytestmark = pytest.mark.model

DAY = ("paint the fence at ten for two hours", "call the bank at two", "lunch with Priya at half twelve")


@pytest.mark.parametrize(
    ("line", "taken"),
    [
        ("call the bank an hour later", ":delay 2 60min"),
        ("call them half an hour earlier", ":delay 2 -30min"),
        ("could I call the bank a bit later?", ":delay 2 10min"),
        ("have lunch half an hour later then", ":delay 3 30min"),
        ("start lunch at one", ":edit 3 lunch with Priya at one"),
        ("start the fence at eleven then", ":edit 1 paint the fence at eleven for two hours"),
        ("don't call the bank", ":drop 2"),
        ("I won't call the bank", ":drop 2"),
        ("don't call them before four", ":edit 2 call the bank not before four"),
        ("everything's running ten minutes late", ":delay all 10min"),
        ("I've lost half an hour", ":busy 09:00:00 09:30:00 late"),
        ("skip the next call", ":drop 2"),
        ("move the next call to three", ":edit 2 call the bank at three"),
        ("not before three though", ":edit 3 lunch with Priya not before three"),
        ("but not before three", ":edit 3 lunch with Priya not before three"),
        ("swap the first two", ":swap 1 2"),
        ("make the fence shorter, an hour", ":edit 1 paint the fence at ten for an hour"),
    ],
)
def test_what_is_planned_is_meant_by_its_verb(line: str, taken: str) -> None:
    assert f"taken as {taken}" in talk_of(*DAY).say(line)


def test_pronouns_are_what_is_done_so() -> None:
    talk = talk_of("feed the cat at six", "wash the car at four")
    assert "taken as :delay 1 -60min" in talk.say("feed it an hour earlier")
    assert "by how much?" in talk.say("wash the car earlier, I'm going out")
    assert talk.entries == ["feed the cat at six", "wash the car at four"]


def test_all_or_several_move_to_another_day_in_one_step() -> None:
    talk = talk_of(*DAY)
    talk.say("move everything after noon to tomorrow")
    assert talk.entries == [
        DAY[0],
        "call the bank tomorrow at two",
        "lunch with Priya tomorrow at half twelve",
    ]
    talk.say("undo")
    assert talk.entries == list(DAY)
    talk.say("move the fence and lunch to friday")
    assert talk.entries[1] == DAY[1]
    assert "friday" in talk.entries[0]
    assert "friday" in talk.entries[2]


def test_what_follows_another_is_later_behind_it() -> None:
    talk = talk_of("lunch at one for an hour", "nap for the baby after lunch for an hour")
    assert ":edit 2 nap for the baby 30 minutes after lunch" in talk.say("push the nap back by half an hour")
    assert "cannot be earlier than that" in talk.say("bring the nap forward by an hour")
    talk.say("lunch is at two")
    assert talk.start("s2").hour == 15


def test_what_is_running_takes_as_long_as_is_told() -> None:
    talk = talk_of("pack the kitchen now for two hours")
    talk.wait(minutes=30)
    assert "goes on until 12:00:00" in talk.say("it takes three hours")
    assert "goes on until 10:00:00" in talk.say("it takes an hour")
    assert "goes on until 11:00:00" in talk.say("this will take another hour")
    assert talk.entries == ["pack the kitchen now for two hours"]


@pytest.mark.parametrize("told", ["pasta's in", "the pasta went in", "the pasta is in now"])
def test_what_is_waited_for_is_told_in_other_words_and_is_no_row(told: str) -> None:
    talk = talk_of(
        "when the pasta is in set a timer for nine minutes", "drain the pasta when the timer rings"
    )
    assert "nothing to do" in talk.say("pasta's out")
    talk.say(told)
    assert len(talk.entries) == 2
    assert talk.start("s1").hour == 9
    talk.wait(minutes=6)
    assert "taken as :ctx timer" in talk.say("the timer rang")


def test_what_others_come_before_is_told_by_its_verb() -> None:
    talk = talk_of("clean the machine half an hour before closing")
    talk.say("we close at six")
    assert (talk.start("s1").hour, talk.start("s1").minute) == (17, 30)
    talk.say("actually we close at five today")
    assert (talk.start("s1").hour, talk.start("s1").minute) == (16, 30)
