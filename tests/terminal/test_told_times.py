"""What a clause tells of something planned, in any words: when it is to be, by when, or how long it takes."""

import pytest

from terminal.talking import Talk, talk_of

pytestmark = pytest.mark.model

ASKED = (
    "ice the giant cake at three",
    "physio at four",
    "viewing at two",
    "homework for forty minutes at one",
    "call Mum at seven pm",
)


def entries(talk: Talk) -> dict[str, str]:
    return {entry.identifier: entry.text for entry in talk.turns.conversation.state.entries}


@pytest.mark.parametrize(
    ("line", "label", "entry"),
    [
        ("customer wants the giant by half two", "s1", "ice the giant cake by half two"),
        ("physio can only see me at five", "s2", "physio at five"),
        ("the physio could only squeeze us in at ten past five", "s2", "physio at ten past five"),
        ("they've put the viewing back to quarter past four", "s3", "viewing at quarter past four"),
        ("physio has put it back to quarter to five", "s2", "physio at quarter to five"),
        ("the viewing can't be later than half one", "s3", "viewing not later than half one"),
        ("homework needs to be finished before half one", "s4", "homework for forty minutes before half one"),
        ("no homework before five", "s4", "homework for forty minutes not before five"),
        ("no homework before six, Ann sleeps late", "s4", "homework for forty minutes not before six"),
        ("it's raining so leave the homework till five", "s4", "homework for forty minutes at five"),
        ("the homework probably takes an hour", "s4", "homework for an hour at one"),
        ("Mum can't talk before eight", "s5", "call Mum not before eight"),
        ("Mum can't eat before eight", "s5", "call Mum at seven pm"),
        ("Mum can't come before eight", "s5", "call Mum not before eight"),
        ("make that half past eight, I misread the card", "s5", "call Mum at half past eight"),
    ],
)  # fmt: skip
def test_what_is_told_of_one_thing_changes_that(line: str, label: str, entry: str) -> None:
    talk = talk_of(*ASKED)
    talk.turns.pending = None
    before = entries(talk)
    talk.say(line)
    assert entries(talk) == before | {label: entry}


def test_two_things_are_told_in_one_line() -> None:
    talk = talk_of("roast the chicken at four")
    talk.say("the chicken needs an hour and a half and has to be out by half six")
    assert talk.entries == ["roast the chicken at four for an hour and a half"]
    talk.say("the chicken needs an hour, and it has to be done before half four")
    assert talk.entries == ["roast the chicken for an hour before half four"]


def test_what_is_over_by_then_anyway_stays() -> None:
    talk = talk_of("homework for forty minutes at four", "tea at six")
    assert "16:00" in talk.say("homework has to be done before tea")
    assert talk.entries == ["homework for forty minutes at four", "tea at six"]


def test_it_is_the_other_of_two_where_one_is_what_it_comes_before() -> None:
    talk = talk_of("walk the dog at three", "viewing at two")
    talk.say("he has to be back before the viewing")
    assert talk.entries == ["walk the dog before the viewing", "viewing at two"]
    talk = talk_of("walk the dog at three", "gym at five", "viewing at two")
    assert "say it with its name" in talk.say("he has to be back before the viewing")


def test_another_of_what_is_planned_is_named_so() -> None:
    talk = talk_of("viewing at two", "another viewing at half three")
    assert talk.entries == ["viewing at two", "another viewing at half three"]
    talk.say("cancel the viewing")
    assert talk.entries == ["viewing at two"]
    talk.say("restore the viewing")
    assert talk.entries == ["viewing at two", "another viewing at half three"]


def test_what_is_between_two_comes_behind_the_first() -> None:
    talk = talk_of("mow the lawn at ten", "lunch at noon", "rest for half an hour between the lawn and lunch")
    assert talk.entries[2] == "rest for half an hour after the lawn and before lunch"


def test_a_pause_of_everything_asks_how_long() -> None:
    talk = talk_of("mow the lawn at ten", "pause everything")
    assert talk.entries == ["mow the lawn at ten"]
    assert ":delay all 30min" in talk.say("half an hour")
