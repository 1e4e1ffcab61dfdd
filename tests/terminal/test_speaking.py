"""Plain words about what was asked for already, in a conversation."""

from datetime import datetime

import pytest

from fuzzytime.language.about_wishes import AboutKind, about_wishes
from fuzzytime.language.finding import shipped_lexicon
from terminal.talking import Talk, talk_of

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
        ("move the call to ten to six", "at ten to six"),
        ("he says he can come at four", "at four"),
        ("push the meeting back to four", "at four"),
    ],
)
def test_new_times_are_heard(line: str, time: str) -> None:
    about = about_wishes(line, NOW, shipped_lexicon())
    assert about is not None
    assert (about.kind, about.time) == (AboutKind.MOVE, time)


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
    talk = talk_of(wish)
    assert f"taken as :edit 1 {anew};" in talk.say(line)


@pytest.mark.parametrize(
    "line",
    [
        "wait ten minutes",
        "make the bed at six",
        "put the soup on",
        "ask Bob if he can come before six",
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
def test_what_was_done_is_no_wish() -> None:
    talk = talk_of("feed the cat at 10 am", "call mum at 5 pm")
    assert "done: feed the cat" in talk.say("I've already fed the cat")
    assert "yes: s1 feed the cat" in talk.say("did I feed the cat?")
    assert talk.left == ["call mum at 5 pm"]
    assert "nothing like it is planned" in talk.say("I watered the plants")
    assert "nothing that is planned is about rice" in talk.say("the rice is done")
    assert talk.left == ["call mum at 5 pm"]


@pytest.mark.model
@pytest.mark.parametrize("line", ["check that the soup is ready", "ask at eleven whether the cabin is ready"])
def test_who_asks_for_a_report_makes_none(line: str) -> None:
    talk = talk_of(line)
    assert talk.entries == [line]


@pytest.mark.model
def test_why_is_answered_in_sentences() -> None:
    talk = talk_of("Fry the fish at 5 pm", "Call mum at 5 pm")
    answer = talk.say("why is the fish so late?")
    assert "It asked for “at 5 pm”" in answer
    assert ":why s1 shows" in answer
    assert "nothing that is planned" in talk.say("why is the dog so late?")


@pytest.mark.model
def test_a_label_names_what_it_stands_beside() -> None:
    talk = talk_of("cook the soup at noon", "lay the table at 3 pm")
    assert "s2 lay the table: at 15:00" in talk.say("when is s2?")
    assert "It asked for “at 3 pm”" in talk.say("why is s2 at three?")
    talk.say("move s2 to 4 pm")
    talk.say("push s2 back by half an hour")
    assert f"{talk.start('s2'):%H:%M}" == "16:30"
    assert "taken as :drop 1 (cook the soup at noon)" in talk.say("drop s1")
    assert "done: lay the table" in talk.say("s2 is done")
    assert "nothing that is planned is about s9" in talk.say("why s9?")


@pytest.mark.model
def test_a_label_is_nothing_to_do() -> None:
    talk = talk_of("cook the soup at noon")
    assert "s1 was asked for already" in talk.say("taste s1")
    assert "upload the files to s1" in talk.say("upload the files to s1 at nine")


@pytest.mark.model
def test_what_is_not_known_is_a_wish_of_its_own() -> None:
    talk = talk_of("call mum at 5 pm", "cancel the subscription")
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


def test_a_protest_is_asked_back() -> None:
    talk = talk_of("call mum at six pm")
    assert talk.say("that's wrong").startswith("what is meant instead?")
    assert talk.say("I can't do that now").startswith("when then?")
    assert talk.entries == ["call mum at six pm"]


def test_what_was_forgotten_may_be_kept() -> None:
    talk = talk_of("call mum at six pm", "forget the call", "no wait, keep it")
    assert talk.entries == ["call mum at six pm"]


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
    talk = talk_of("feed the dog at six pm", line)
    assert len(talk.entries) == 2
