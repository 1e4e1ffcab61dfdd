"""Questions about when one is free, what there is room for, and what was done."""

import pytest

from terminal.talking import Talk, talk_of

pytestmark = pytest.mark.model


def _day() -> Talk:
    talk = Talk()
    for line in ("dentist at noon", "call mum at 5 pm", "wash the car after the call"):
        talk.say(line)
    return talk


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        ("am I free at noon?", "no: s1 dentist is from 12:00 to 12:45"),
        ("am I free at 4 pm?", "yes: nothing is planned at 4 pm until 17:00, when s2 call mum begins"),
        ("are we free this afternoon?", "not all of it: s1 dentist is from 12:00 to 12:45"),
        ("when am I free?", "free from 09:00 to 12:00, from 12:45 to 17:00, from 17:40 on"),
        ("can I go at half past twelve?", "no: s1 dentist"),
        ("can I go at 6 pm?", "yes: nothing is planned at 6 pm"),
        ("is there time for a nap before noon?", "yes: a nap (30 min, assumed) fits in at 09:00"),
        ("is there time for a nap before the call?", "yes: a nap (30 min, assumed) fits in at 09:00"),
        ("is there time for a nap after the call?", "fits in at 17:40"),
        ("what am I doing at noon?", "s1 dentist: 12:00 to 12:45"),
        ("what's on tomorrow?", "nothing is planned then"),
        ("what do I do after the dentist?", "s2 call mum: at 17:00"),
        ("what comes before the call?", "s1 dentist: at 12:00"),
        ("what comes before the dentist?", "nothing is planned before the dentist"),
        ("what about the car?", "s3 wash the car: at 17:10"),
        ("what about the roof?", "nothing that is planned is about roof"),
        ("dentist when?", "s1 dentist: at 12:00"),
        ("did I wash the car?", "not yet: s3 wash the car: at 17:10"),
        ("did I feed the fish?", "nothing that is planned is about feed fish"),
        ("is the car done?", "not yet: s3 wash the car"),
        ("next?", "s1 dentist: at 12:00"),
        ("how long does it take in all?", "all is done at 17:40"),
    ],
)
def test_questions_are_answered_in_a_line(line: str, answer: str) -> None:
    talk = _day()
    before = talk.entries
    shown = talk.say(line)
    assert answer in shown
    assert len(shown.splitlines()) <= 3
    assert talk.entries == before


def test_what_was_done_is_known() -> None:
    talk = talk_of("feed the cat now")
    assert "not yet: s1 feed the cat is running until 09:02" in talk.say("did I feed the cat?")
    talk.wait(minutes=10)
    assert "yes: s1 feed the cat, from 09:00 to 09:02" in talk.say("have I fed the cat?")


def test_there_is_no_room_where_all_is_taken() -> None:
    talk = talk_of("paint the wall now for three hours")
    assert "no: a nap (30 min, assumed) does not fit in before 11:30" in talk.say(
        "is there time for a nap before half past eleven?"
    )
    assert "fits in at 12:00" in talk.say("is there time for a nap?")


def test_what_is_repeated_is_known_further_than_it_is_shown() -> None:
    talk = talk_of("feed the hens every day at eight am except on sunday")
    assert "feed the hens: Sat 08:00" in talk.say("what do I do on saturday?")
    assert "no: s1" in talk.say("am I free on saturday at eight am?")
    assert "nothing is planned then" in talk.say("what do I do on sunday?")


def test_nothing_planned_is_free() -> None:
    assert "free all the time" in Talk().say("when am I free?")


@pytest.mark.parametrize("line", ["can you go at five?", "what about calling Ann at 5 pm?"])
def test_what_is_asked_of_another_is_no_question_about_the_plan(line: str) -> None:
    talk = talk_of(line)
    assert talk.entries == [line]


def test_room_before_one_of_several_things_of_a_line_is_up_to_that() -> None:
    talk = talk_of("Mr Lee at half past nine, Sam at half past ten, Jo at noon")
    assert "to 10:30" in talk.say("have I got time before Sam?")
