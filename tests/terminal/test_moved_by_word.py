"""What is moved, put first, swapped, dropped and delayed by word, and what is answered about that."""

from datetime import datetime, timedelta

import numpy as np
import pytest

from fuzzytime.language.about_wishes import AboutKind, about_wishes
from fuzzytime.language.finding import shipped_lexicon
from terminal.talking import Talk, talk_of

NOW = datetime(2026, 3, 4, 15)  # noqa: DTZ001 - the tests' moment is of no zone


@pytest.mark.parametrize(
    ("line", "kind"),
    [("cancel dinner", AboutKind.DROP), ("dinner is ready", AboutKind.DONE), ("I've had lunch", None)],
)
def test_a_meal_is_named_like_any_other_thing(line: str, kind: AboutKind | None) -> None:
    about = about_wishes(line, NOW, shipped_lexicon())
    assert (about.kind if about is not None else None) is kind
    assert about_wishes("drop lunch at noon", NOW, shipped_lexicon()) is None


@pytest.mark.model
def test_a_correction_changes_the_last_instruction() -> None:
    talk = talk_of("stir the soup at 10", "call mum at 5 pm")
    assert ":edit 2 call mum at 6 pm" in talk.say("no, make it 6 pm")
    assert talk.entries == ["stir the soup at 10", "call mum at 6 pm"]


@pytest.mark.model
def test_what_is_named_is_moved_given_a_length_and_dropped() -> None:
    talk = talk_of("call mum at 5 pm", "simmer the soup at 10 am", "stir it at noon", "make it 20 minutes")
    talk.say("move the soup to 11 am")
    assert talk.entries == ["call mum at 5 pm", "simmer the soup at 11 am", "stir it at noon for 20 minutes"]
    talk.say("never mind")
    talk.say("cancel the call")
    assert talk.entries == ["stir it at noon for 20 minutes"]
    talk.say("undo that")
    assert len(talk.entries) == 2
    assert ":drop all" in talk.say("start over")
    assert talk.entries == []


@pytest.mark.model
def test_everything_is_pushed_back_but_what_was_told() -> None:
    talk = talk_of("stir the soup in about ten minutes", "call mum at 5 pm", "dinner is at 7 pm")
    starts = {name: talk.start(name) for name in ("s1", "s2", "s3")}
    shown = talk.say("push everything back by 20 minutes")
    assert "taken as :delay all 20min" in shown
    assert "3 (dinner)" in shown
    assert "+20 min, at 5 pm" in shown
    later = timedelta(minutes=20)
    assert [talk.start(name) - starts[name] for name in starts] == [later, later, timedelta(0)]
    talk.say("bring the call forward by half an hour")
    assert talk.start("s2") == starts["s2"] - timedelta(minutes=10)
    assert "which is over" in talk.say("bring the call forward by ten hours")
    talk.say("undo")
    assert talk.start("s2") == starts["s2"] + later


@pytest.mark.model
@pytest.mark.parametrize(
    ("line", "by", "towards"),
    [
        ("make tea in about ten minutes", "10min", -1),
        ("call mum at ten", "10min", -1),
        ("call mum this afternoon", "10min", -1),
        ("call mum this afternoon", "-10min", 1),
    ],
)
def test_what_is_delayed_stays_as_vague_as_it_was(line: str, by: str, towards: int) -> None:
    talk = talk_of(line, f":delay 1 {by}")
    assert talk.turns.plan is not None
    (moved,), (start,) = talk.turns.plan.skills, talk.turns.plan.schedule.start_times
    function = moved.skill.satisfaction
    assert float(function(start)) == 1.0
    # What was told as a moment, or a stretch, has flanks on both sides, and falls off nowhere at once.
    beside = function(start + towards * np.arange(0.0, 3600.0, 10.0))
    assert beside.min() < 0.1
    assert np.abs(np.diff(beside)).max() < 0.1


@pytest.mark.model
def test_what_is_delayed_does_not_start_before() -> None:
    talk = talk_of("stir the soup within an hour")
    assert "running" in talk.say("what's next?")
    talk.wait(minutes=1)
    shown = talk.say("push the soup back by ten minutes")
    assert "s2" in shown
    assert talk.start("s2").minute == 10
    talk.wait(minutes=4)
    assert "s2 stir the soup: at 09:10, in 5 min" in talk.say("when is that?")


@pytest.mark.model
def test_what_follows_another_moves_along() -> None:
    talk = talk_of("call mum at 5 pm", "ten minutes after you call mum, water the plants")
    starts = [talk.start("s1"), talk.start("s2")]
    talk.say("delay the plants by an hour")
    assert [talk.start("s1"), talk.start("s2")] == [starts[0], starts[1] + timedelta(hours=1)]
    talk.say("undo")
    talk.say("push everything back by an hour")
    assert [talk.start("s1"), talk.start("s2")] == [start + timedelta(hours=1) for start in starts]


@pytest.mark.model
def test_what_happens_later_takes_along_what_is_tied_to_it() -> None:
    talk = talk_of("the guests come at 7 pm, serve the soup five minutes after they arrive")
    talk.say("set the table 20 minutes before the guests come")
    starts = {name: talk.start(name) for name in ("s1", "s1.2", "s2")}
    talk.wait(minutes=1)
    answer = talk.say("the guests are late, they come at half past seven")
    assert "moved: s1.2 serve the soup from 19:05 to 19:35" in answer
    assert "Which time" not in answer
    half = timedelta(minutes=30)
    assert {name: talk.start(name) for name in starts} == {name: at + half for name, at in starts.items()}
    talk.wait(hours=9, minutes=55)
    assert "start now: set the table" in talk.wait(minutes=15)
    assert "moved: s1.2 serve the soup from 19:35 to 19:45" in talk.say("they are another ten minutes late")
    talk.say(":undo")
    assert talk.start("s1.2") == starts["s1.2"] + half


@pytest.mark.model
def test_news_can_be_changed_as_instructions_can() -> None:
    talk = talk_of("the guests come at 7 pm", "serve the soup five minutes after the guests arrive")
    start = talk.start("s2")
    talk.wait(minutes=1)
    talk.say("the guests are an hour late")
    assert ":delay 3" in talk.say("push the guests back by ten minutes")
    assert talk.start("s2") == start + timedelta(minutes=70)
    talk.say("no, make it half past eight")
    assert talk.start("s2") == start + timedelta(minutes=90)
    assert "what waits for it" not in talk.say("what if the guests are ten minutes late?")
    assert talk.start("s2") == start + timedelta(minutes=90)
    assert "by how much" in talk.say("the guests are late")
    assert len(talk.entries) == 3
    talk.say("forget the guests")
    assert talk.entries == ["serve the soup five minutes after the guests arrive"]


@pytest.mark.model
def test_what_happens_sooner_is_done_by_word() -> None:
    talk = talk_of("the guests come at 7 pm", "serve the soup five minutes after the guests arrive")
    talk.wait(minutes=30)
    talk.say(":done 1")
    assert talk.start("s2") == talk.now + timedelta(minutes=5)


@pytest.mark.model
def test_what_follows_what_is_running_is_pushed_back_too() -> None:
    talk = talk_of("Set the table now, then light the candles")
    talk.wait(seconds=1)
    talk.say("push everything back by ten minutes")
    assert talk.start("s1.2") == talk.now.replace(minute=15, second=0)


@pytest.mark.model
def test_two_swap_their_times() -> None:
    talk = talk_of("call mum at 5 pm", "Water the plants at 6 pm.", "swap the two")
    assert talk.entries == ["call mum at 6 pm", "Water the plants at 5 pm."]
    talk.say("feed the cat at 8 pm")
    assert "which two" in talk.say("swap them")
    talk.say("swap the cat and the plants")
    assert talk.entries[1:] == ["Water the plants at 8 pm.", "feed the cat at 5 pm"]
    assert "nothing that is planned is about dog" in talk.say("swap the cat and the dog")


@pytest.mark.model
def test_what_is_running_is_done_early_or_goes_on() -> None:
    talk = talk_of("paint the wall now for 30 minutes", "then water the plants")
    talk.wait(minutes=5)
    assert "until 09:40" in talk.say("ten more minutes")
    assert talk.start("s2") == talk.now + timedelta(minutes=35)
    assert "until 09:45" in talk.say("I'm five minutes late")
    talk.say("move the plants to noon")
    assert "done: paint the wall" in talk.say("done")
    assert "nothing is running; the last, paint the wall, was done at 09:05" in talk.say("done")


@pytest.mark.model
def test_who_is_late_starts_nothing_before() -> None:
    talk = talk_of("call mum in about five minutes")
    assert "by how much?" in talk.say("I'm running late")
    talk.say("I'm 20 minutes late")
    assert talk.start("s1") == talk.now + timedelta(minutes=20)
    talk.say("undo that")
    assert talk.start("s1") == talk.now + timedelta(minutes=5)


@pytest.mark.model
def test_one_comes_first_or_after_another() -> None:
    talk = talk_of("wash the car at 10 am", "call mum at 5 pm", "move the car to after the call")
    assert talk.start("s1") > talk.start("s2")
    talk.say("do the car first")
    assert talk.start("s1") < talk.now + timedelta(minutes=5)


@pytest.mark.model
def test_doing_something_then_gives_it_another_time() -> None:
    talk = talk_of("Call mum at 5 pm", "let's do the call at 6 pm instead")
    assert talk.entries == ["Call mum at 6 pm"]
    talk.say("could we do it half an hour earlier?")
    assert talk.start("s1") == talk.now.replace(hour=17, minute=30)
    talk.say("do the dishes at noon")
    talk.say("do the dishes at 8 pm")
    assert talk.entries[1:] == ["do the dishes at noon", "do the dishes at 8 pm"]
    talk.say("move everything to tomorrow")
    assert talk.entries[1:] == ["do the dishes tomorrow at noon", "do the dishes tomorrow at 8 pm"]


@pytest.mark.model
def test_suppositions_change_nothing() -> None:
    talk = talk_of("call mum at 5 pm")
    assert "water the plants" in talk.say("what if I water the plants at noon?")
    assert "lost its place" not in talk.say("what if we push the call back by an hour?")
    assert "nothing is changed" in talk.say("what if we drop the call?")
    assert talk.entries == ["call mum at 5 pm"]


@pytest.mark.model
def test_of_several_times_none_is_guessed() -> None:
    talk = talk_of("feed the cat at 10 am and the dog at 11 am")
    assert "several times" in talk.say("no, make it noon")


def test_no_corrects_what_was_told_and_no_answer() -> None:
    talk = talk_of("make the salad in an hour", "call mum at six pm")
    assert "make the salad" in talk.say("what's next?")
    assert ":edit 2 call mum at half past six" in talk.say("no, half past six")


def test_how_long_it_is_until_then_is_in_minutes() -> None:
    talk = talk_of("call mum at six pm")
    talk.now += timedelta(seconds=1)
    assert "in 9 h, done at" in talk.say("what's next?")


def test_why_of_what_is_running_says_so() -> None:
    talk = talk_of("stir the soup for 20 minutes")
    talk.wait(minutes=5)
    assert talk.say("why is the soup so early?") == "s1 stir the soup has started, and is running until 09:20"


def test_earlier_alone_is_asked_back() -> None:
    talk = talk_of("call mum at six pm")
    assert talk.say("do it earlier").startswith("by how much?")


def test_who_must_leave_is_told_when() -> None:
    talk = talk_of("dentist at 11 am, it's 20 minutes away")
    assert "at 10:40" in talk.say("when do I have to leave?")


def test_who_sets_the_table_leaves_nowhere() -> None:
    talk = talk_of("set the table in ten minutes")
    assert "nothing that is planned" in talk.say("when do we set off?")


def test_why_not_at_another_time_is_about_what_is_named() -> None:
    talk = talk_of("pick up the parcel at noon")
    assert "pick up the parcel" in talk.say("why can't I pick up the parcel at eleven?")


@pytest.mark.model
@pytest.mark.parametrize(
    ("line", "left"),
    [
        ("cancel 1", ["call mum", "call dad", "wash the car"]),
        ("delete number 2", ["feed the cat", "call dad", "wash the car"]),
        ("skip #2", ["feed the cat", "call dad", "wash the car"]),
        ("cancel the second one", ["feed the cat", "call dad", "wash the car"]),
        ("forget the first", ["call mum", "call dad", "wash the car"]),
        ("cancel the last two", ["feed the cat", "call mum"]),
        ("drop the first two instructions", ["call dad", "wash the car"]),
        ("cancel the calls", ["feed the cat", "wash the car"]),
        ("cancel everything except the cat", ["feed the cat"]),
        ("clear everything but the calls", ["call mum", "call dad"]),
    ],
)
def test_instructions_are_meant_by_numbers_by_places_and_several_at_once(line: str, left: list[str]) -> None:
    talk = Talk()
    for order in (
        "feed the cat at six pm",
        "call mum at seven pm",
        "call dad at 8 pm",
        "wash the car at 9 pm",
    ):
        talk.say(order)
    talk.say(line)
    assert [entry.partition(" at ")[0] for entry in talk.entries] == left
    talk.say(":undo")
    assert len(talk.entries) == 4


@pytest.mark.model
@pytest.mark.parametrize(
    ("line", "starts"),
    [
        ("push both back by an hour", [19, 20]),
        ("push the second one back by an hour", [18, 20]),
        ("bring the calls forward by an hour", [17, 18]),
        ("move the first to eight pm", [20, 19]),
        ("move number 2 to five pm", [18, 17]),
        ("postpone calling dad until nine pm", [18, 21]),
    ],
)
def test_what_is_meant_so_is_moved(line: str, starts: list[int]) -> None:
    talk = talk_of("call mum at six pm", "call dad at seven pm", line)
    assert [talk.start(name).hour for name in ("s1", "s2")] == starts


@pytest.mark.model
@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("move both to eight pm", "one at a time"),
        ("cancel the third one", "2 are left"),
        ("cancel 7", "nothing that is planned is about s7"),
        ("cancel everything except the dog", "nothing that is planned is about dog"),
    ],
)
def test_what_means_none_is_said_and_changes_nothing(line: str, said: str) -> None:
    talk = talk_of("call mum at six pm", "feed the cat at seven pm")
    assert said in talk.say(line)
    assert talk.entries == ["call mum at six pm", "feed the cat at seven pm"]


@pytest.mark.model
def test_a_timer_tells_what_is_left_and_takes_more() -> None:
    talk = talk_of("set a timer for ten minutes")
    talk.wait(seconds=1)
    assert "until 09:10" in talk.say("how long is left?")
    assert "until 09:10" in talk.say("how long is left on the timer?")
    assert ":more s1 5min" in talk.say("add five minutes to the timer")
    assert "until 09:15" in talk.say("how much time is left?")


@pytest.mark.model
@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("when is the cat fed?", "s1 feed the cat: at 18:00"),
        ("which one is first?", "s1 feed the cat: at 18:00"),
        ("earlier, please", "by how much?"),
        ("sooner", "by how much?"),
    ],
)
def test_questions_name_verbs_in_any_form_and_directions_want_a_length(line: str, said: str) -> None:
    talk = talk_of("feed the cat at six pm", "wash the car at seven pm")
    assert said in talk.say(line)
    assert len(talk.entries) == 2


@pytest.mark.model
def test_what_was_before_another_and_is_moved_to_a_day_is_on_it() -> None:
    talk = talk_of("call the bank at 4 pm", "read the papers before that", "put the papers off till tomorrow")
    assert talk.entries == ["call the bank at 4 pm", "read the papers tomorrow"]


@pytest.mark.model
def test_a_clause_that_leaves_out_a_time_stands_for_no_other_thing() -> None:
    line = "call Ann today, not while the baby sleeps"
    assert talk_of(line).entries == [line]
