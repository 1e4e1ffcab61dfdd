"""Plain words about what was asked for already, in a conversation."""

from datetime import datetime, timedelta

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
    ("line", "kind"),
    [("cancel dinner", AboutKind.DROP), ("dinner is ready", AboutKind.DONE), ("I've had lunch", None)],
)
def test_a_meal_is_named_like_any_other_thing(line: str, kind: AboutKind | None) -> None:
    about = about_wishes(line, NOW, shipped_lexicon())
    assert (about.kind if about is not None else None) is kind
    assert about_wishes("drop lunch at noon", NOW, shipped_lexicon()) is None


@pytest.mark.parametrize(
    ("line", "number"),
    [("no, make it six", "six"), ("make it 15", "15"), ("no, at six", ""), ("make it noon", "")],
)
def test_a_number_alone_is_heard_as_one(line: str, number: str) -> None:
    about = about_wishes(line, NOW, shipped_lexicon())
    assert about is not None
    assert about.number == number


@pytest.mark.model
@pytest.mark.parametrize(
    ("wish", "line", "anew"),
    [
        ("Stir the soup in ten minutes", "no, make it six", "Stir the soup in six minutes"),
        (
            "Stir the soup in exactly 5 seconds please",
            "make it 6",
            "Stir the soup in exactly 6 seconds please",
        ),
        ("Boil the eggs for eight minutes", "make it nine", "Boil the eggs for nine minutes"),
        ("In half an hour, call mum", "actually, one", "In one hour, call mum"),
        ("call mum in about an hour", "no, two", "call mum in about two hours"),
        ("stir it every ten minutes", "make it five", "stir it every five minutes"),
        ("Stir the soup at ten", "no, make it eleven", "Stir the soup at eleven"),
        ("Stir the soup in ten minutes", "no, at six", "Stir the soup at six"),
    ],
)
def test_a_number_alone_counts_what_was_counted(wish: str, line: str, anew: str) -> None:
    talk = Talk()
    talk.say(wish)
    assert f"taken as :edit 1 {anew};" in talk.say(line)


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
        "take back the books",
        "redo the table",
        "why don't you stir the soup?",
        "45 minutes later stir the soup",
        "serve the rice after the soup is done",
        "finish the soup by six",
        "put the potatoes on in five minutes",
        "put the meat back for ten minutes",
        "put the rice on. Five minutes later, start the fish",
        "swap the tyres",
        "clear the table",
        "tell me a joke",
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
    talk.say("make it 20 minutes")
    talk.say("move the soup to 11 am")
    assert talk.entries == ["call mum at 5 pm", "simmer the soup at 11 am", "stir it at noon for 20 minutes"]
    talk.say("never mind")
    talk.say("cancel the call")
    assert talk.entries == ["stir it at noon for 20 minutes"]
    talk.say("undo that")
    assert len(talk.entries) == 2
    assert ":drop all" in talk.say("start over")
    assert talk.entries == []


@pytest.mark.parametrize(
    ("line", "kind", "names", "by"),
    [
        ("delay the pasta by ten minutes", AboutKind.DELAY, {"pasta"}, 600.0),
        ("bring the call forward by an hour", AboutKind.DELAY, {"call"}, -3600.0),
        ("move the call ten minutes earlier", AboutKind.DELAY, {"call"}, -600.0),
        ("no, ten minutes later", AboutKind.DELAY, set(), 600.0),
        ("snooze it for five minutes", AboutKind.DELAY, set(), 300.0),
        ("push back the call", AboutKind.DELAY, {"call"}, None),
        ("I'm about ten minutes late", AboutKind.LATE, set(), 600.0),
        ("we got held up for half an hour", AboutKind.LATE, set(), 1800.0),
        ("I'm running late", AboutKind.LATE, set(), None),
        ("five more minutes", AboutKind.MORE, set(), 300.0),
        ("the pasta needs another five minutes", AboutKind.MORE, {"pasta"}, 300.0),
        ("I'm done with the pasta", AboutKind.DONE, {"pasta"}, None),
        ("the soup is ready", AboutKind.DONE, {"soup"}, None),
        ("it's done", AboutKind.DONE, set(), None),
        ("finished the soup", AboutKind.DONE, {"soup"}, None),
        ("how long until I have to leave?", AboutKind.WHEN, {"leave"}, None),
        ("how long does the soup take?", AboutKind.LASTING, {"soup"}, None),
        ("why is the soup so late?", AboutKind.WHY, {"soup"}, None),
        ("why not earlier?", AboutKind.WHY, set(), None),
        ("take that back", AboutKind.UNDO, set(), None),
        ("what should I be doing now?", AboutKind.NEXT, set(), None),
        ("what else is left?", AboutKind.ALL, set(), None),
        ("what time is it?", AboutKind.CLOCK, set(), None),
        ("ok, thanks!", AboutKind.ANSWER, set(), None),
    ],
)
def test_what_is_said_of_wishes_is_heard(
    line: str, kind: AboutKind, names: set[str], by: float | None
) -> None:
    about = about_wishes(line, NOW, shipped_lexicon())
    assert about is not None
    assert (about.kind, set(about.names), about.by) == (kind, names, by)


@pytest.mark.model
def test_everything_is_pushed_back_but_what_was_told() -> None:
    talk = Talk()
    talk.say("stir the soup in about ten minutes")
    talk.say("call mum at 5 pm")
    talk.say("dinner is at 7 pm")
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
def test_what_is_delayed_does_not_start_before() -> None:
    talk = Talk()
    talk.say("stir the soup within an hour")
    assert "running" in talk.say("what's next?")
    talk.wait(minutes=1)
    shown = talk.say("push the soup back by ten minutes")
    assert "s2" in shown
    assert talk.start("s2").minute == 10
    talk.wait(minutes=4)
    assert "s2 stir the soup: at 09:10, in 5 min" in talk.say("when is that?")


@pytest.mark.model
def test_what_follows_another_moves_along() -> None:
    talk = Talk()
    talk.say("call mum at 5 pm")
    talk.say("ten minutes after you call mum, water the plants")
    starts = [talk.start("s1"), talk.start("s2")]
    assert "follows another one's time" in talk.say("delay the plants by an hour")
    talk.say("push everything back by an hour")
    assert [talk.start("s1"), talk.start("s2")] == [start + timedelta(hours=1) for start in starts]


@pytest.mark.model
def test_what_is_tied_to_what_happens_stays_with_it() -> None:
    talk = Talk()
    talk.say("call mum at 5 pm")
    talk.say("the guests come at 7 pm")
    talk.say("have the soup ready when they come")
    starts = [talk.start("s1"), talk.start("s3")]
    assert "rejected" not in talk.say("push everything back by ten minutes")
    assert [talk.start("s1"), talk.start("s3")] == [starts[0] + timedelta(minutes=10), starts[1]]
    assert "follows another one's time" in talk.say("delay the soup by an hour")


@pytest.mark.model
def test_what_happens_later_takes_along_what_is_tied_to_it() -> None:
    talk = Talk()
    talk.say("the guests come at 7 pm, serve the soup five minutes after they arrive")
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
    talk = Talk()
    talk.say("the guests come at 7 pm")
    talk.say("serve the soup five minutes after the guests arrive")
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
    talk = Talk()
    talk.say("the guests come at 7 pm")
    talk.say("serve the soup five minutes after the guests arrive")
    talk.wait(minutes=30)
    talk.say(":done 1")
    assert talk.start("s2") == talk.now + timedelta(minutes=5)


@pytest.mark.model
def test_what_follows_what_is_running_is_pushed_back_too() -> None:
    talk = Talk()
    talk.say("Set the table now, then light the candles")
    talk.wait(seconds=1)
    talk.say("push everything back by ten minutes")
    assert talk.start("s1.2") == talk.now.replace(minute=15, second=0)


@pytest.mark.model
def test_two_swap_their_times() -> None:
    talk = Talk()
    talk.say("call mum at 5 pm")
    talk.say("Water the plants at 6 pm.")
    talk.say("swap the two")
    assert talk.entries == ["call mum at 6 pm", "Water the plants at 5 pm."]
    talk.say("feed the cat at 8 pm")
    assert "which two" in talk.say("swap them")
    talk.say("swap the cat and the plants")
    assert talk.entries[1:] == ["Water the plants at 8 pm.", "feed the cat at 5 pm"]
    assert "nothing that is planned is about dog" in talk.say("swap the cat and the dog")


@pytest.mark.model
def test_what_is_running_is_done_early_or_goes_on() -> None:
    talk = Talk()
    talk.say("paint the wall now for 30 minutes")
    talk.say("then water the plants")
    talk.wait(minutes=5)
    assert "until 09:40" in talk.say("ten more minutes")
    assert talk.start("s2") == talk.now + timedelta(minutes=35)
    assert "until 09:45" in talk.say("I'm five minutes late")
    talk.say("move the plants to noon")
    assert "done: paint the wall" in talk.say("done")
    assert "nothing is running; the last, paint the wall, was done at 09:05" in talk.say("done")


@pytest.mark.model
def test_who_is_late_starts_nothing_before() -> None:
    talk = Talk()
    talk.say("call mum in about five minutes")
    assert "by how much?" in talk.say("I'm running late")
    talk.say("I'm 20 minutes late")
    assert talk.start("s1") == talk.now + timedelta(minutes=20)
    talk.say("undo that")
    assert talk.start("s1") == talk.now + timedelta(minutes=5)


@pytest.mark.model
def test_what_was_done_is_no_wish() -> None:
    talk = Talk()
    talk.say("feed the cat at 10 am")
    talk.say("call mum at 5 pm")
    assert "done: feed the cat" in talk.say("I've already fed the cat")
    assert talk.entries == ["call mum at 5 pm"]
    assert "nothing that is planned" in talk.say("I watered the plants")
    assert "nothing that is planned is about rice" in talk.say("the rice is done")
    assert talk.entries == ["call mum at 5 pm"]


@pytest.mark.model
@pytest.mark.parametrize("line", ["check that the soup is ready", "ask at eleven whether the cabin is ready"])
def test_who_asks_for_a_report_makes_none(line: str) -> None:
    talk = Talk()
    talk.say(line)
    assert talk.entries == [line]


@pytest.mark.model
def test_one_comes_first_or_after_another() -> None:
    talk = Talk()
    talk.say("wash the car at 10 am")
    talk.say("call mum at 5 pm")
    talk.say("move the car to after the call")
    assert talk.start("s1") > talk.start("s2")
    talk.say("do the car first")
    assert talk.start("s1") < talk.now + timedelta(minutes=5)


@pytest.mark.model
def test_why_is_answered_in_sentences() -> None:
    talk = Talk()
    talk.say("Fry the fish at 5 pm")
    talk.say("Call mum at 5 pm")
    answer = talk.say("why is the fish so late?")
    assert "It asked for “at 5 pm”" in answer
    assert ":why s1 shows" in answer
    assert "nothing that is planned" in talk.say("why is the dog so late?")


@pytest.mark.model
def test_a_label_names_what_it_stands_beside() -> None:
    talk = Talk()
    talk.say("cook the soup at noon")
    talk.say("lay the table at 3 pm")
    assert "s2 lay the table: at 15:00" in talk.say("when is s2?")
    assert "It asked for “at 3 pm”" in talk.say("why is s2 at three?")
    talk.say("move s2 to 4 pm")
    talk.say("push s2 back by half an hour")
    assert f"{talk.start('s2'):%H:%M}" == "16:30"
    assert "taken as :drop 1 (cook the soup at noon)" in talk.say("drop s1")
    assert "done: lay the table" in talk.say("s2 is done")
    assert "nothing that is planned is about s9" in talk.say("why s9?")


@pytest.mark.model
@pytest.mark.parametrize("line", ["start s1", "s1 at eight"])
def test_a_label_is_nothing_to_do(line: str) -> None:
    talk = Talk()
    talk.say("cook the soup at noon")
    assert "s1 was asked for already" in talk.say(line)
    assert "upload the files to s1" in talk.say("upload the files to s1 at nine")


@pytest.mark.model
def test_doing_something_then_gives_it_another_time() -> None:
    talk = Talk()
    talk.say("Call mum at 5 pm")
    talk.say("let's do the call at 6 pm instead")
    assert talk.entries == ["Call mum at 6 pm"]
    talk.say("could we do it half an hour earlier?")
    assert talk.start("s1") == talk.now.replace(hour=17, minute=30)
    talk.say("do the dishes at noon")
    talk.say("do the dishes at 8 pm")
    assert talk.entries[1:] == ["do the dishes at noon", "do the dishes at 8 pm"]
    assert "one at a time" in talk.say("move everything to tomorrow")


@pytest.mark.model
def test_suppositions_change_nothing() -> None:
    talk = Talk()
    talk.say("call mum at 5 pm")
    assert "water the plants" in talk.say("what if I water the plants at noon?")
    assert "lost its place" not in talk.say("what if we push the call back by an hour?")
    assert "nothing is changed" in talk.say("what if we drop the call?")
    assert talk.entries == ["call mum at 5 pm"]


@pytest.mark.model
def test_what_is_said_anew_when_it_is_over_is_planned_again() -> None:
    talk = Talk()
    talk.say("water the plants now")
    talk.wait(minutes=1)
    talk.wait(minutes=30)
    talk.say("do the plants after lunch")
    assert talk.start("s2").hour == 13


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


@pytest.mark.parametrize(
    "line",
    [
        "I haven't started yet",
        "haven't started the soup",
        "we have not begun",
        "I didn't start with the soup",
    ],
)
def test_what_has_not_begun_is_heard(line: str) -> None:
    about = about_wishes(line, NOW, shipped_lexicon())
    assert about is not None
    assert about.kind is AboutKind.UNSTARTED
    assert about.names <= {"soup"}


@pytest.mark.parametrize(
    ("line", "kind"),
    [
        ("that's wrong", AboutKind.WRONG),
        ("I can't do that now", AboutKind.UNABLE),
        ("too early", AboutKind.UNABLE),
        ("come back later", AboutKind.ANSWER),
    ],
)
def test_protests_and_farewells_are_no_wishes(line: str, kind: AboutKind) -> None:
    about = about_wishes(line, NOW, shipped_lexicon())
    assert about is not None
    assert about.kind is kind


def test_what_has_not_begun_is_planned_anew() -> None:
    talk = Talk()
    talk.say("stir the soup for 20 minutes")
    talk.wait(minutes=5)
    answer = talk.say("I haven't started yet")
    assert "no longer running: stir the soup" in answer
    assert talk.start("s2") == talk.now
    assert talk.say("I haven't started the call") == "nothing is running"


def test_no_corrects_what_was_told_and_no_answer() -> None:
    talk = Talk()
    talk.say("make the salad in an hour")
    talk.say("call mum at six pm")
    assert "make the salad" in talk.say("what's next?")
    assert ":edit 2 call mum at half past six" in talk.say("no, half past six")


def test_a_protest_is_asked_back() -> None:
    talk = Talk()
    talk.say("call mum at six pm")
    assert talk.say("that's wrong").startswith("what is meant instead?")
    assert talk.say("I can't do that now").startswith("when then?")
    assert talk.entries == ["call mum at six pm"]


def test_how_long_it_is_until_then_is_in_minutes() -> None:
    talk = Talk()
    talk.say("call mum at six pm")
    talk.now += timedelta(seconds=1)
    assert "in 9 h, done at" in talk.say("what's next?")


def test_why_of_what_is_running_says_so() -> None:
    talk = Talk()
    talk.say("stir the soup for 20 minutes")
    talk.wait(minutes=5)
    assert talk.say("why is the soup so early?") == "s1 stir the soup has started, and is running until 09:20"


def test_a_part_of_the_day_is_a_new_time() -> None:
    about = about_wishes("can you move the parcel to the afternoon?", NOW, shipped_lexicon())
    assert about is not None
    assert (about.kind, about.time) == (AboutKind.MOVE, "in the afternoon")


def test_earlier_alone_is_asked_back() -> None:
    talk = Talk()
    talk.say("call mum at six pm")
    assert talk.say("do it earlier").startswith("by how much?")


def test_what_was_forgotten_may_be_kept() -> None:
    talk = Talk()
    talk.say("call mum at six pm")
    talk.say("forget the call")
    talk.say("no wait, keep it")
    assert talk.entries == ["call mum at six pm"]


def test_who_must_leave_is_told_when() -> None:
    talk = Talk()
    talk.say("dentist at 11 am, it's 20 minutes away")
    assert "at 10:40" in talk.say("when do I have to leave?")


def test_who_sets_the_table_leaves_nowhere() -> None:
    talk = Talk()
    talk.say("set the table in ten minutes")
    assert "nothing that is planned" in talk.say("when do we set off?")


def test_why_not_at_another_time_is_about_what_is_named() -> None:
    talk = Talk()
    talk.say("pick up the parcel at noon")
    assert "pick up the parcel" in talk.say("why can't I pick up the parcel at eleven?")


@pytest.mark.model
@pytest.mark.parametrize(
    ("first", "anew", "entry"),
    [
        ("feed the dog at six pm", "no, feed the dog at half past six", "feed the dog at half past six"),
        ("feed the dog at six pm", "actually feed the dog at seven pm", "feed the dog at seven pm"),
        ("feed the dog at six pm", "Feed the dog at seven pm instead.", "Feed the dog at seven pm"),
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
    talk = Talk()
    talk.say(first)
    talk.say("wash the car tomorrow")
    assert ":edit 1" in talk.say(anew)
    assert talk.entries == [entry, "wash the car tomorrow"]


@pytest.mark.model
@pytest.mark.parametrize(
    "line",
    [
        "feed the dog at seven pm",
        "feed the dog at seven pm then",
        "no, feed the cat at seven pm",
        "actually wash the dog at seven pm",
    ],
)
def test_without_a_correction_or_of_something_else_it_is_another_wish(line: str) -> None:
    talk = Talk()
    talk.say("feed the dog at six pm")
    talk.say(line)
    assert len(talk.entries) == 2


@pytest.mark.model
def test_a_condition_stays_where_the_time_beside_it_moves() -> None:
    talk = Talk()
    talk.say("if it rains, close the window at six pm")
    talk.say("no, make it seven pm")
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
    talk = Talk()
    talk.say(first)
    talk.say(anew)
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
        ("walk the dog at midnight", "no, ten to", "walk the dog at ten to 12 am"),
        ("walk the dog tomorrow at seven am", "no, half past", "walk the dog tomorrow at half past 7 am"),
        ("walk the dog every day at six pm", "no, half past", "walk the dog every day at half past 6 pm"),
        # No hour was said that could be kept, or a new one is.
        ("walk the dog in ten minutes", "no, half past", "walk the dog at half past"),
        ("walk the dog at seven pm", "no, half past eight pm", "walk the dog at half past eight pm"),
        ("walk the dog at seven pm", "no, at eight pm", "walk the dog at eight pm"),
    ],
)
def test_minutes_past_no_hour_keep_the_one_that_was_said(first: str, anew: str, entry: str) -> None:
    talk = Talk()
    talk.say(first)
    talk.say(anew)
    assert talk.entries == [entry]


@pytest.mark.model
def test_a_day_that_stays_is_the_same_day_when_it_is_said_later() -> None:
    talk = Talk()
    talk.say("call mum tomorrow at six pm")
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
    talk = Talk()
    talk.say("feed the cat at noon")
    talk.say(first)
    assert ":edit 2" in talk.say(time)
    assert talk.entries == ["feed the cat at noon", entry]


@pytest.mark.model
def test_a_time_alone_is_pointed_at_where_nothing_was_asked_for() -> None:
    assert "nothing to do" in Talk().say("at seven")


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
    talk = Talk()
    talk.say("call mum at six pm")
    talk.say("call dad at seven pm")
    talk.say(line)
    assert [talk.start(name).hour for name in ("s1", "s2")] == starts


@pytest.mark.model
@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("move both to tomorrow", "one at a time"),
        ("cancel the third one", "2 are left"),
        ("cancel 7", "nothing that is planned is about s7"),
        ("cancel everything except the dog", "nothing that is planned is about dog"),
    ],
)
def test_what_means_none_is_said_and_changes_nothing(line: str, said: str) -> None:
    talk = Talk()
    talk.say("call mum at six pm")
    talk.say("feed the cat at seven pm")
    assert said in talk.say(line)
    assert talk.entries == ["call mum at six pm", "feed the cat at seven pm"]


@pytest.mark.model
def test_a_timer_tells_what_is_left_and_takes_more() -> None:
    talk = Talk()
    talk.say("set a timer for ten minutes")
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
    talk = Talk()
    talk.say("feed the cat at six pm")
    talk.say("wash the car at seven pm")
    assert said in talk.say(line)
    assert len(talk.entries) == 2
