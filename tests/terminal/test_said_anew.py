"""What is said again, in other words or with another time."""

from datetime import datetime, timedelta

import pytest

from fuzzytime.language.about_wishes import AboutKind, about_wishes
from fuzzytime.language.finding import shipped_lexicon
from terminal.talking import Talk, talk_of

NOW = datetime(2026, 3, 4, 15)  # noqa: DTZ001 - the tests' moment is of no zone


@pytest.mark.model
def test_what_is_tied_to_what_happens_stays_with_it() -> None:
    talk = talk_of("call mum at 5 pm", "the guests come at 7 pm", "have the soup ready when they come")
    starts = [talk.start("s1"), talk.start("s3")]
    assert "rejected" not in talk.say("push everything back by ten minutes")
    assert [talk.start("s1"), talk.start("s3")] == [starts[0] + timedelta(minutes=10), starts[1]]
    assert "follows another one's time" in talk.say("delay the soup by an hour")


@pytest.mark.model
def test_what_is_said_anew_when_it_is_over_is_planned_again() -> None:
    talk = talk_of("water the plants now")
    talk.wait(minutes=1)
    talk.wait(minutes=30)
    talk.say("do the plants after lunch")
    assert talk.start("s2").hour == 13


def test_what_has_not_begun_is_planned_anew() -> None:
    talk = talk_of("stir the soup for 20 minutes")
    talk.wait(minutes=5)
    answer = talk.say("I haven't started yet")
    assert "no longer running: stir the soup" in answer
    assert talk.start("s2") == talk.now
    assert talk.say("I haven't started the call") == "nothing is running"


def test_a_part_of_the_day_is_a_new_time() -> None:
    about = about_wishes("can you move the parcel to the afternoon?", NOW, shipped_lexicon())
    assert about is not None
    assert (about.kind, about.time) == (AboutKind.MOVE, "in the afternoon")


@pytest.mark.model
@pytest.mark.parametrize(
    ("first", "anew", "entry"),
    [
        ("feed the dog at six pm", "no, feed the dog at half past six", "feed the dog at half past six"),
        ("feed the dog at six pm", "actually feed the dog at seven pm", "feed the dog at seven pm"),
        ("feed the dog at six pm", "Feed the dog at seven pm instead.", "feed the dog at seven pm"),
        ("put the bins out at six pm", "no, put them out at seven pm", "put the bins out at seven pm"),
        ("call mum every day at six pm", "sorry, call mum every day at noon", "call mum every day at noon"),
        # What it says no more of stays.
        (
            "take the bins out and feed the cat at six pm",
            "wait, feed the cat at seven pm",
            "take the bins out and feed the cat at seven pm",
        ),
        (
            "boil the eggs for six minutes at noon",
            "no, boil the eggs at one pm",
            "boil the eggs for six minutes at one pm",
        ),
        (
            "if it rains, close the window at six pm",
            "no, close the window at seven pm",
            "if it rains, close the window at seven pm",
        ),
    ],
)
def test_what_is_said_again_behind_a_correction_is_said_anew(first: str, anew: str, entry: str) -> None:
    talk = talk_of(first, "wash the car tomorrow")
    assert ":edit 1" in talk.say(anew)
    assert talk.entries == [entry, "wash the car tomorrow"]


@pytest.mark.model
def test_a_condition_stays_where_the_time_beside_it_moves() -> None:
    talk = talk_of("if it rains, close the window at six pm", "no, make it seven pm")
    assert talk.entries == ["if it rains, close the window at seven pm"]


@pytest.mark.model
@pytest.mark.parametrize(
    ("first", "anew", "entry"),
    [
        ("call mum tomorrow at six pm", "no, make it seven pm", "call mum tomorrow at seven pm"),
        ("call mum at six pm on friday", "move it to saturday", "call mum saturday at six pm"),
        ("call mum at noon on march 6", "no, on march 9", "call mum on march 9 at noon"),
        ("call mum tomorrow morning", "make it the afternoon", "call mum tomorrow in the afternoon"),
        ("call mum tomorrow by six pm", "no, by seven pm", "call mum tomorrow by seven pm"),
        ("call mum every day at six pm", "no, at seven pm", "call mum every day at seven pm"),
        ("call mum this afternoon", "no, tomorrow", "call mum tomorrow afternoon"),
        # A new time that says all of it leaves nothing of the old one.
        ("call mum tomorrow at six pm", "no, in ten minutes", "call mum in ten minutes"),
        ("call mum tomorrow at six pm", "no, tonight", "call mum tonight"),
        ("call mum tomorrow", "no, today", "call mum today"),
    ],
)
def test_a_new_time_keeps_what_it_leaves_open(first: str, anew: str, entry: str) -> None:
    talk = talk_of(first, anew)
    assert talk.entries == [entry]


@pytest.mark.model
@pytest.mark.parametrize(
    ("first", "anew", "entry"),
    [
        ("walk the dog at seven pm", "make that half past", "walk the dog at half past 7 pm"),
        ("walk the dog at seven pm", "make it quarter to", "walk the dog at quarter to 7 pm"),
        ("walk the dog at seven pm", "sorry, ten to", "walk the dog at ten to 7 pm"),
        ("walk the dog at half past seven pm", "no, quarter to", "walk the dog at quarter to 8 pm"),
        ("walk the dog at quarter past six pm", "no, half past", "walk the dog at half past 6 pm"),
        ("walk the dog before seven pm", "no, by half past", "walk the dog by half past 7 pm"),
        ("walk the dog at midnight", "no, ten to", "walk the dog at ten to 12 pm"),
        ("walk the dog tomorrow at seven am", "no, half past", "walk the dog tomorrow at half past 7 am"),
        ("walk the dog every day at six pm", "no, half past", "walk the dog every day at half past 6 pm"),
        # No hour was said that could be kept, or a new one is.
        ("walk the dog in ten minutes", "no, half past", "walk the dog at half past"),
        ("walk the dog at seven pm", "no, half past eight pm", "walk the dog at half past eight pm"),
        ("walk the dog at seven pm", "no, at eight pm", "walk the dog at eight pm"),
    ],
)
def test_minutes_past_no_hour_keep_the_one_that_was_said(first: str, anew: str, entry: str) -> None:
    talk = talk_of(first, anew)
    assert talk.entries == [entry]


@pytest.mark.model
def test_a_day_that_stays_is_the_same_day_when_it_is_said_later() -> None:
    talk = talk_of("call mum tomorrow at six pm")
    talk.wait(days=1)
    talk.say("no, make it seven pm")
    assert talk.entries == ["call mum on 2026-03-05 at seven pm"]
    assert talk.start("s1").isoformat() == "2026-03-05T19:00:00+01:00"


@pytest.mark.model
@pytest.mark.parametrize(
    ("first", "time", "entry"),
    [
        ("call mum", "at seven pm", "call mum at seven pm"),
        ("call mum", "Before lunch.", "call mum before lunch"),
        ("call mum", "for ten minutes", "call mum for ten minutes"),
        ("call mum at six pm", "tomorrow", "call mum tomorrow at six pm"),
    ],
)
def test_a_time_alone_is_that_of_what_was_asked_for_last(first: str, time: str, entry: str) -> None:
    talk = talk_of("feed the cat at noon", first)
    assert ":edit 2" in talk.say(time)
    assert talk.entries == ["feed the cat at noon", entry]


@pytest.mark.model
def test_a_time_alone_is_pointed_at_where_nothing_was_asked_for() -> None:
    assert "nothing to do" in Talk().say("at seven")


@pytest.mark.model
@pytest.mark.parametrize(
    ("wish", "line", "anew"),
    [
        ("clean the garage from two to four", "move it to five", "clean the garage at five for 2 h"),
        ("gym every day at six", "move the gym to seven", "gym every day at seven pm"),
        ("meeting 2-2:30", "make it four", "meeting at four for 30 min"),
        ("clean the garage from two to four", "do it tomorrow", "clean the garage tomorrow from two to four"),
        ("call mum at two for ten minutes", "make it four", "call mum at four for ten minutes"),
        ("call mum at five", "make it two to three", "call mum from two to three"),
        ("meeting 2-3", "4 to 5", "meeting 4 to 5"),
        ("stir in about five minutes", "make it six to eight", "stir in about six to eight minutes"),
    ],
)
def test_what_went_on_from_when_to_when_goes_on_as_long_at_another_time(
    wish: str, line: str, anew: str
) -> None:
    talk = talk_of(wish, line)
    assert talk.entries == [anew]


@pytest.mark.model
def test_what_happens_keeps_its_place_when_it_takes_longer() -> None:
    talk = talk_of("meeting at four")
    assert "16:00 17:30 meeting" in talk.say("make it half an hour longer")


@pytest.mark.model
@pytest.mark.parametrize("day", ["on friday", "on friday at six", "tomorrow morning"])
@pytest.mark.parametrize("part", ["tonight", "this evening"])
def test_a_part_of_today_leaves_no_other_day(day: str, part: str) -> None:
    talk = talk_of(f"paint the fence {day}", f"no, {part}")
    assert talk.entries == [f"paint the fence {part}"]


@pytest.mark.model
@pytest.mark.parametrize("counted", ["ten minutes after that", "in ten minutes", "ten minutes before that"])
def test_what_counted_from_now_or_another_does_so_no_more_when_it_moves_to_a_day(counted: str) -> None:
    talk = talk_of("stir the soup at noon", f"serve it {counted}", "make it tomorrow")
    assert talk.entries[-1] == "serve it tomorrow"


@pytest.mark.model
def test_what_waited_and_is_done_is_over() -> None:
    talk = talk_of("serve the soup when the guests sit down", "then clear the table")
    assert "found a place: s2 clear the table" in talk.say("the soup is served")
    assert "the soup waits" in talk.say("undo")


@pytest.mark.model
@pytest.mark.parametrize(
    "line",
    [
        "Order the cake, it's needed by six",
        "Print the poster, they need it by three",
        "Wash the car before lunch, it takes an hour",
        "Mow the lawn after lunch, I can't do it before two",
        "Bake the bread at four, it has to be out by five",
    ],
)
def test_what_is_told_beside_a_new_wish_is_of_that(line: str) -> None:
    talk = talk_of("call Ann at ten")
    talk.say(line)
    assert talk.entries == ["call Ann at ten", line]


@pytest.mark.parametrize("told", ["Ann needs it by three", "by noon", "as soon as possible"])
def test_what_is_running_and_in_time_goes_on_and_keeps_its_label(told: str) -> None:
    talk = talk_of("print the poster")
    talk.wait(seconds=20)
    answer = talk.say(told)
    assert "print the poster goes on: it is in time" in answer
    assert "running: s1 print the poster" in answer
    assert "s2" not in answer
    (entry,) = talk.entries
    assert entry.startswith("print the poster ")


@pytest.mark.parametrize("told", ["not before half past nine", "in an hour"])
def test_what_is_running_is_another_where_it_is_asked_for_later(told: str) -> None:
    talk = talk_of("print the poster")
    talk.wait(seconds=20)
    assert "no longer running: print the poster" in talk.say(told)
