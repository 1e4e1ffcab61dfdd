"""Plain words about what was asked for already, in a conversation."""

from datetime import datetime

import pytest

from fuzzytime.language import AboutKind, about_wishes
from fuzzytime.language.finding import shipped_lexicon
from terminal.talking import Talk

NOW = datetime(2026, 3, 4, 15)  # noqa: DTZ001 - the tests' moment is of no zone


@pytest.mark.parametrize(
    ("line", "time"),
    [
        ("no, make it 6", "at 6"),
        ("actually, at half past seven", "at half past seven"),
        ("make it 20 minutes", "for 20 minutes"),
        ("sorry, in ten minutes", "in ten minutes"),
        ("move it to 7", "at 7"),
        ("postpone the call until six", "at six"),
        ("push the meeting back to four", "at four"),
    ],
)
def test_new_times_are_heard(line: str, time: str) -> None:
    about = about_wishes(line, NOW, shipped_lexicon())
    assert about is not None
    assert (about.kind, about.time) == (AboutKind.MOVE, time)


@pytest.mark.parametrize(
    "line",
    [
        "wait ten minutes",
        "make the bed at six",
        "put the soup on at 4",
        "set the table at six",
        "move the crate to station 4",
        "drop the kids at school at 8",
        "cancel the 7:42 at noon",
        "call mum at 5",
        "better",
        "what should I cook?",
    ],
)
def test_wishes_are_left_alone(line: str) -> None:
    assert about_wishes(line, NOW, shipped_lexicon()) is None


@pytest.mark.model
def test_a_correction_changes_the_last_instruction() -> None:
    talk = Talk()
    talk.say("stir the soup at 10")
    talk.say("call mum at 5 pm")
    assert ":edit 2 call mum at 6 pm" in talk.say("no, make it 6 pm")
    assert talk.entries == ["stir the soup at 10", "call mum at 6 pm"]


@pytest.mark.model
def test_what_is_named_is_moved_given_a_length_and_dropped() -> None:
    talk = Talk()
    talk.say("call mum at 5 pm")
    talk.say("simmer the soup at 10 am")
    talk.say("stir it at noon")
    talk.say("move the soup to 11 am")
    talk.say("make it 20 minutes")
    assert talk.entries == ["call mum at 5 pm", "simmer the soup at 11 am", "stir it at noon for 20 minutes"]
    talk.say("cancel the call")
    talk.say("never mind")
    assert talk.entries == ["simmer the soup at 11 am"]
    talk.say(":undo")
    assert len(talk.entries) == 2


@pytest.mark.model
def test_what_is_not_known_is_a_wish_of_its_own() -> None:
    talk = Talk()
    talk.say("call mum at 5 pm")
    talk.say("cancel the subscription")
    assert talk.entries == ["call mum at 5 pm", "cancel the subscription"]


@pytest.mark.model
def test_questions_are_answered() -> None:
    talk = Talk()
    assert "nothing is planned" in talk.say("what's next?")
    talk.say("call mum at 5 pm")
    talk.say("stir the soup at 10 am")
    assert "s2 stir the soup: at 10:00" in talk.say("what's next?")
    assert "s1 call mum: at 17:00" in talk.say("when do I call mum?")
    assert "nothing that is planned is about dentist" in talk.say("when is the dentist?")
    assert len(talk.entries) == 2


@pytest.mark.model
def test_of_several_times_none_is_guessed() -> None:
    talk = Talk()
    talk.say("feed the cat at 10 am and the dog at 11 am")
    assert "several times" in talk.say("no, make it noon")
