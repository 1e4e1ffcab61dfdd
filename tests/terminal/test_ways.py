"""What is said of what was asked for, in many ways; and what is told, and asks for nothing."""

from datetime import timedelta

import pytest

from terminal.talking import NINE, Talk, talk_of

pytestmark = pytest.mark.model

APART = (
    "judo at ten for an hour",
    "mow the lawn at one for twenty minutes",
    "call mum at four for half an hour",
)
TOGETHER = (f"{APART[0]}, {APART[1]} and {APART[2]}",)


def planned(talk: Talk) -> dict[str, tuple[str, float]]:
    """Give when everything starts, and how many minutes it takes."""
    plan = talk.turns.plan
    assert plan is not None
    found = {}
    for place, one in enumerate(plan.skills):
        start = plan.instant(plan.schedule.start_times[place]) if plan.has_time(place) else None
        day = "" if start is None or start.date() == NINE.date() else f"{start:%a} "
        found[one.skill.name] = (f"{day}{start:%H:%M}" if start else "", one.skill.time_until_done / 60)
    return found


AS_ASKED = {"judo": ("10:00", 60.0), "mow the lawn": ("13:00", 20.0), "call mum": ("16:00", 30.0)}


@pytest.mark.parametrize("asked", [APART, TOGETHER], ids=["apart", "together"])
@pytest.mark.parametrize(
    ("line", "name", "then"),
    [
        ("judo got pushed to six", "judo", ("18:00", 60.0)),
        ("judo's not till half five", "judo", ("17:30", 60.0)),
        ("oh, set the lawn for friday please", "mow the lawn", ("Fri 13:00", 20.0)),
        ("the lawn at six then", "mow the lawn", ("18:00", 20.0)),
        ("can the lawn wait till six, sorry?", "mow the lawn", ("18:00", 20.0)),
        ("mowing the lawn at six", "mow the lawn", ("18:00", 20.0)),
        ("mum wants to make it noon", "call mum", ("12:00", 30.0)),
        ("Ann says judo can wait till six", "judo", ("18:00", 60.0)),
        ("judo at six not ten - the hall is taken", "judo", ("18:00", 60.0)),
        ("the second one has to be at six", "mow the lawn", ("18:00", 20.0)),
        ("let's do the one o'clock at six because I'm tired", "mow the lawn", ("18:00", 20.0)),
        ("I'll start the lawn an hour later", "mow the lawn", ("14:00", 20.0)),
        ("could judo start half an hour earlier", "judo", ("09:30", 60.0)),
        ("allow forty minutes for judo", "judo", ("10:00", 40.0)),
        ("I reckon the lawn will take forty minutes", "mow the lawn", ("13:00", 40.0)),
        ("the last one only takes forty minutes", "call mum", ("16:00", 40.0)),
        ("the lawn wants an extra half hour to dry", "mow the lawn", ("13:00", 50.0)),
        ("add half an hour to judo", "judo", ("10:00", 90.0)),
        ("leave the lawn", "mow the lawn", None),
        ("don't bother with the lawn, it's wet", "mow the lawn", None),
        ("we can skip judo", "judo", None),
        ("take judo off the list", "judo", None),
        ("mum bailed", "call mum", None),
        ("mum's running fifteen late", "call mum", ("16:15", 30.0)),
        ("mum wants half an hour earlier", "call mum", ("15:30", 30.0)),
        ("mum rang, she can't come before five", "call mum", ("17:00", 30.0)),
        ("mum changed it to half five", "call mum", ("17:30", 30.0)),
        ("can you put judo at six?", "judo", ("18:00", 60.0)),
        ("put that lawn at half five", "mow the lawn", ("17:30", 20.0)),
        ("judo might run to two hours", "judo", ("10:00", 120.0)),
        ("my judo class is at half five", "judo", ("17:30", 60.0)),
        ("cancel my judo lesson", "judo", None),
        ("the one at four has to be at six", "call mum", ("18:00", 30.0)),
        ("the one o'clock won't be till six", "mow the lawn", ("18:00", 20.0)),
        ("I can't do judo today after all", "judo", None),
        ("I'm not going to do the lawn today", "mow the lawn", None),
        ("judo is off, they've got someone else", "judo", None),
        ("mum asks whether she could do noon instead", "call mum", ("12:00", 30.0)),
        ("mum wants to know if we can make it noon", "call mum", ("12:00", 30.0)),
        ("can judo go after the lawn?", "judo", ("13:20", 60.0)),
        ("no wait, judo should be after the lawn", "judo", ("13:20", 60.0)),
    ],
)
def test_one_thing_is_changed_and_the_others_stay(
    asked: tuple[str, ...], line: str, name: str, then: tuple[str, float] | None
) -> None:
    talk = talk_of(*asked)
    talk.turns.pending = None
    assert planned(talk) == AS_ASKED
    talk.say(line)
    assert planned(talk) == {key: value for key, value in (AS_ASKED | {name: then}).items() if value}


@pytest.mark.parametrize(
    "line",
    [
        "the lawn might be wet", "I like judo", "hope judo goes well", "good to know", "Bob cooks",
        "I have a headache", "I might skip judo", "the lawn is a bit much today", "I think judo is fine",
        "the lawn is taken until six", "judo already feels late",
    ],
)  # fmt: skip
def test_what_is_told_is_no_wish(line: str) -> None:
    talk = talk_of(*APART)
    talk.say(line)
    assert planned(talk) == AS_ASKED


@pytest.mark.parametrize(
    "line",
    [
        "leave the house at six", "set the alarm for six", "allow an hour for lunch", "feed the cat at six",
        "take the bins out", "the guests arrive at six", "Bob cooks at six",
    ],
)  # fmt: skip
def test_what_names_nothing_that_was_asked_for_is_a_wish(line: str) -> None:
    talk = talk_of(*APART)
    talk.say(line)
    assert planned(talk).items() > AS_ASKED.items()


def test_what_stands_before_another_has_its_own_time_when_it_moves() -> None:
    talk = talk_of("call mum at ten for an hour, then mow the lawn at one for twenty minutes")
    talk.say("move the call to six")
    assert planned(talk) == {"call mum": ("18:00", 60.0), "mow the lawn": ("13:00", 20.0)}
    talk.say("swap the call and the lawn")
    assert planned(talk) == {"call mum": ("13:00", 60.0), "mow the lawn": ("18:00", 20.0)}
    talk.say("first the lawn, then the call")
    assert planned(talk) == {"call mum": ("18:20", 60.0), "mow the lawn": ("18:00", 20.0)}


def test_a_label_is_of_one_thing_of_a_line() -> None:
    talk = talk_of(*TOGETHER)
    talk.turns.pending = None
    talk.say("drop s1")
    assert sorted(planned(talk)) == ["call mum", "mow the lawn"]
    talk.say("let's skip s1.3, it's raining")
    assert sorted(planned(talk)) == ["mow the lawn"]


@pytest.mark.parametrize("line", ["bring the ladder back by noon", "ring mum at six", "sing at six"])
def test_what_only_ends_like_what_goes_on_is_asked_for_again(line: str) -> None:
    talk = talk_of(line, line)
    assert [entry.text for entry in talk.turns.conversation.state.entries] == [line, line]


@pytest.mark.parametrize(
    ("line", "start"),
    [("half ten", "22:30"), ("nine", "21:00"), ("one", "Thu 01:00"), ("five", "Thu 05:00")],
)
def test_what_is_late_moves_to_the_hour_next_to_its_own(line: str, start: str) -> None:
    talk = Talk()
    talk.now = NINE.replace(hour=20)
    for said in ("obs at ten pm", "ring the ward at eight am", f"move the obs to {line}"):
        talk.say(said)
        talk.now += timedelta(seconds=5)
    assert planned(talk)["obs"][0] == start
    assert planned(talk)["ring the ward"][0] == "Thu 08:00"


@pytest.mark.parametrize(
    "line",
    ["delay the pick-up by an hour", "could the pick-up be an hour later?", "put the pick up back an hour"],
)
def test_a_thing_with_a_direction_in_its_name_goes_where_it_is_said_to(line: str) -> None:
    talk = talk_of("pick up the kids at three")
    talk.say(line)
    assert talk.start("s1").hour == 16


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        ("do I have the second one today?", "s2 call Bob: at 14:00"),
        ("what time do I have the one at two?", "s2 call Bob: at 14:00"),
        ("have I got judo today?", "s1 judo: at 10:00"),
        ("what time's my judo class?", "s1 judo: at 10:00"),
        ("when does judo finish?", "done at 11:00"),
        ("what was at two?", "s2 call Bob: 14:00"),
        ("why do I call Bob at two?", "s2 call Bob"),
        ("have I got time before judo?", "free from 09:00 to 10:00"),
        ("don't forget Bob", "s2 call Bob: at 14:00"),
        ("how long am I in the library?", "s3 library: 2 h"),
    ],
)
def test_a_question_is_answered_and_changes_nothing(line: str, answer: str) -> None:
    talk = talk_of("judo at ten for an hour", "call Bob at two", "library from four till six")
    before = planned(talk)
    assert answer in talk.say(line)
    assert planned(talk) == before


def test_what_comes_after_a_label_or_what_was_spoken_of_comes_after_that() -> None:
    talk = talk_of(*APART)
    assert ":edit 3 call mum for half an hour after judo" in talk.say(
        "move the last one to after the first one"
    )
    assert talk.start("s3").hour == 11
    assert "after call mum" in talk.say("do the lawn after that")


def test_what_is_left_out_in_front_leaves_its_verb_to_the_others() -> None:
    talk = talk_of("water the roses at ten, the lawn at eleven and the beds at noon")
    talk.say("cancel the roses")
    assert talk.entries == ["water the lawn at eleven and the beds at noon"]


def test_what_is_left_as_it_was_is_so_again() -> None:
    talk = talk_of(*APART)
    talk.say("judo an hour later")
    talk.say("actually no, leave judo as it was")
    assert planned(talk) == AS_ASKED


@pytest.mark.parametrize(
    "line",
    [
        "the film got cancelled",
        "Theo has no homework today",
        "the shop is shut till nine",
        "Dave isn't in until six",
        "lunch with Ben isn't free till two",
    ],
)
def test_what_is_told_of_nothing_planned_is_refused(line: str) -> None:
    talk = Talk()
    assert "says nothing to do" in talk.say(line)
    assert not talk.entries
