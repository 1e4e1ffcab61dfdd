"""What is called alike: which one is meant is asked, unless it was spoken of last, or is the next one."""

import pytest

from terminal.talking import talk_of

pytestmark = pytest.mark.model

CALLS = ["call mum at six pm", "call the plumber at noon"]
OTHER = "feed the dog at four pm"


@pytest.mark.parametrize("answer", ["the plumber", "the first one", "s2", "2", "plumber please"])
def test_which_of_two_calls_is_asked(answer: str) -> None:
    talk = talk_of(*CALLS, OTHER)
    assert talk.say("cancel the call") == "which one: call the plumber (s2, 12:00) or call mum (s1, 18:00)?"
    assert ":drop 2" in talk.say(answer)


@pytest.mark.parametrize(
    ("line", "answer", "command"),
    [
        ("move the call to five pm", "mum", ":edit 1 call mum at five pm"),
        ("push the call back by an hour", "the second one", ":delay 1 60min"),
        ("bring the call forward", "mum", "by how much?"),
        ("cancel the call", "both", ":drop 1,2"),
        ("cancel the call", "never mind", "nothing is changed"),
        ("cancel the call", "no", "nothing is changed"),
    ],
)
def test_an_answer_does_what_was_said(line: str, answer: str, command: str) -> None:
    talk = talk_of(*CALLS, OTHER)
    assert "which one" in talk.say(line)
    assert command in talk.say(answer)


def test_what_was_spoken_of_last_is_meant_and_so_are_all() -> None:
    assert ":drop 2" in talk_of(*CALLS).say("cancel the call")
    assert ":drop 1,2" in talk_of(*CALLS, OTHER).say("cancel the calls")


def test_what_is_swapped_is_asked_for_and_swapped_back() -> None:
    talk = talk_of(*CALLS, OTHER)
    assert "Say: swap s1 and s2" in talk.say("swap the call and the dog")
    talk.say("swap s1 and the dog")
    swapped = talk.entries
    assert "undone" in talk.say("no wait, swap them back")
    assert talk.entries == [*CALLS, OTHER] != swapped


def test_the_next_one_is_done() -> None:
    talk = talk_of("feed the cat at noon", "feed the cat at six pm", OTHER)
    talk.say("the cat is fed")
    assert talk.left == ["feed the cat at six pm", OTHER]


@pytest.mark.parametrize("answer", ["dad", "the second one", "s1.2"])
def test_which_of_several_of_a_line_is_asked(answer: str) -> None:
    talk = talk_of("call mum at noon and call dad at two pm")
    assert talk.say("cancel the call") == "which one: call mum (s1, 12:00) or call dad (s1.2, 14:00)?"
    talk.say(answer)
    assert talk.entries == ["call mum at noon"]


def test_what_is_asked_back_may_be_left_alone() -> None:
    talk = talk_of("call mum at six pm")
    assert "by how much?" in talk.say("bring it forward")
    assert talk.say("never mind") == "nothing is changed"
    assert talk.entries == ["call mum at six pm"]
