"""Which of the things asked for a line means: the next one, the second one, her; and what comes first."""

import pytest

from terminal.talking import Talk, talk_of

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    ("lines", "entries"),
    [
        ("call bob at six pm | call ann at five pm | skip the next one", ["call bob at six pm"]),
        (
            "call bob at six pm | call ann at five pm | move the next one to half past five pm",
            ["call bob at six pm", "call ann at half past five pm"],
        ),
        (
            "call ann at six pm | call bob at seven pm | the first one at 8 pm",
            ["call ann at 8 pm", "call bob at seven pm"],
        ),
        (
            "call ann at six pm | call bob at seven pm | the second one tomorrow",
            ["call ann at six pm", "call bob tomorrow at seven pm"],
        ),
        (
            "call ann at six pm | call bob at seven pm | the other one at 9 pm",
            ["call ann at 9 pm", "call bob at seven pm"],
        ),
        ("call ann at six pm | that one at 9 pm", ["call ann at 9 pm"]),
        ("call ann at six pm | tomorrow instead", ["call ann tomorrow at six pm"]),
        ("call ann at six pm | call her at 7 pm instead", ["call ann at 7 pm"]),
        (
            "call ann at six pm | wash the car at noon | no, call her at 7 pm",
            ["call ann at 7 pm", "wash the car at noon"],
        ),
        ("call ann at six pm | scratch that", []),
        ("call ann at six pm | no, scratch that", []),
        ("call ann at six pm | move it to 8 pm | scratch that", ["call ann at six pm"]),
        ("call ann at six pm | scratch the paint off", ["call ann at six pm", "scratch the paint off"]),
        (
            "call ann at six pm | wash the car at noon | i started the car",
            ["call ann at six pm", "wash the car right now"],
        ),
        ("call ann at six pm | started", ["call ann right now"]),
    ],
)
def test_a_line_means_one_of_those_asked_for(lines: str, entries: list[str]) -> None:
    talk = Talk()
    for line in lines.split(" | "):
        talk.say(line)
    assert talk.entries == entries


def test_the_next_of_a_repetition_is_left_out_by_its_day_or_not_at_all() -> None:
    talk = talk_of("walk the dog every day at noon", "skip the next one")
    assert talk.entries == ["walk the dog every day at noon except on 2026-03-04"]
    other = Talk()
    other.say("stir the soup every ten minutes from noon")
    assert "cannot be left out" in other.say("skip the next one")
    assert len(other.entries) == 1


def test_what_is_running_is_not_started_again() -> None:
    talk = talk_of("stir the soup right now")
    assert "has started, and is running" in talk.say("started")


@pytest.mark.parametrize("line", ["do the soup first", "the soup first", "do the second one first"])
def test_of_two_with_times_the_first_takes_the_time_of_the_other(line: str) -> None:
    talk = talk_of("boil the potatoes at six pm", "make the soup at seven pm")
    assert ":swap" in talk.say(line)
    assert talk.start("s2") < talk.start("s1")


@pytest.mark.parametrize("line", ["do the call first", "the call first"])
def test_of_more_the_first_is_as_soon_as_possible(line: str) -> None:
    talk = Talk()
    for wish in ("boil the potatoes at six pm", "make the soup at seven pm", "call ann at 8 pm"):
        talk.say(wish)
    talk.say(line)
    assert talk.entries[-1] == "call ann as soon as possible"
    assert talk.start("s3") < talk.start("s1") < talk.start("s2")


@pytest.mark.parametrize(
    "line", ["how long do I have before the call?", "how much time do we have until the call?"]
)
def test_how_long_there_is_before_something_is_until_then(line: str) -> None:
    talk = talk_of("call ann at 11 am")
    assert "in 2 h" in talk.say(line)
