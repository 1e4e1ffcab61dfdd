"""Answers in words to which of several times is meant."""

import pytest

from terminal.talking import NINE, talk_of

EVENING, MORNING = "call mum at 18:00 on 2026-03-04", "call mum at 06:00 on 2026-03-05"

pytestmark = pytest.mark.model


@pytest.mark.parametrize(
    ("answer", "entry"),
    [
        ("evening", EVENING),
        ("in the evening, please", EVENING),
        ("pm", EVENING),
        ("18:00", EVENING),
        ("6 pm", EVENING),
        ("tonight", EVENING),
        ("yes", EVENING),
        ("either is fine", EVENING),
        ("the first one", EVENING),
        ("the earlier", EVENING),
        ("am", MORNING),
        ("06:00", MORNING),
        ("at six am", MORNING),
        ("the morning one", MORNING),
        ("i mean the morning", MORNING),
        ("no, the other one", MORNING),
        ("the later", MORNING),
        ("the second", MORNING),
        ("the latter", MORNING),
        ("option 2", MORNING),
        ("two", MORNING),
        ("tomorrow", MORNING),
    ],
)
def test_an_answer_in_words_takes_the_time_it_means(answer: str, entry: str) -> None:
    talk = talk_of("call mum at six")
    answered = talk.say(answer)
    assert "taken as" in answered
    assert "Which time" not in answered
    assert talk.entries == [entry]


@pytest.mark.parametrize("answer", ["no", "neither", "both of them"])
def test_where_none_is_chosen_the_question_is_put_again(answer: str) -> None:
    talk = talk_of("call mum at six")
    assert "Which time" in talk.say(answer)
    assert talk.entries == ["call mum at six"]
    talk.say("the later one")
    assert talk.entries == [MORNING]


@pytest.mark.parametrize(
    ("answer", "entries"),
    [
        ("water the plants at noon", ["call mum at six", "water the plants at noon"]),
        ("at half past seven", ["call mum at half past seven"]),
        ("no, tomorrow", ["call mum tomorrow at six"]),
        ("no, at eight", ["call mum at eight"]),
        ("forget it", []),
    ],
)
def test_what_answers_something_else_is_taken_as_it_is_said(answer: str, entries: list[str]) -> None:
    talk = talk_of("call mum at six", answer)
    assert talk.entries == entries


def test_an_hour_of_the_clock_stays_in_its_half_of_the_day() -> None:
    talk = talk_of("call mum at six pm", "06:00")
    assert talk.entries == ["call mum at 06:00"]
    assert talk.start("s1").hour == 6 != NINE.hour
