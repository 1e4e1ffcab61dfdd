"""What is told of a thing that was asked for, or called by its time: "the gym is off", "my ten o'clock"."""

import pytest

from terminal.talking import Talk, talk_of

pytestmark = pytest.mark.model

MEETING = "meeting thursday at two pm"


@pytest.mark.parametrize(
    ("wish", "told", "left"),
    [
        ("walk the dog at four pm", "the walk is off", []),
        ("gym at six pm", "gym's off today", []),
        ("gym at six pm", "gym is at seven pm today", ["gym at seven pm today"]),
        ("gym at six pm", "so the gym is half an hour later", ["gym at six pm"]),
        ("patient at ten am for 45 min", "the ten o'clock cancelled", []),
        ("patient at ten am for 45 min", "the 10am is off", []),
        ("patient at ten am for 45 min", "move my ten o'clock up to 9:30", ["patient at 9:30 for 45 min"]),
        ("call Ann at ten, call Bob at five pm", "cancel the ten o'clock", ["call Bob at five pm"]),
        ("judo at four pm", "judo starts at five pm", ["judo at five pm"]),
        ("put the wine in the fridge at ten am", "wine's in", []),
        ("post office at five pm", "then the post office tomorrow", ["post office tomorrow at five pm"]),
        ("electrician at 11 am", "electrician can't do 11, he'll come at 3 pm", ["electrician at 3 pm"]),
        ("dentist at ten am", "friday, same time", ["dentist friday at ten am"]),
        ("hay delivery at ten am", "cancel the hay, they rang to say monday", []),
        # What only has to do with it stays.
        ("buy lunch at noon", "lunch is off", ["buy lunch at noon"]),
        ("gym at six pm", "gym's off on sunday", ["gym at six pm"]),
        ("patient at ten am", "cancel the four o'clock", ["patient at ten am"]),
        ("milk, eggs and bread before noon", "forget the eggs", ["milk, eggs and bread before noon"]),
    ],
)
def test_what_is_told_of_a_thing_changes_that_itself(wish: str, told: str, left: list[str]) -> None:
    talk = talk_of(wish, told)
    assert talk.left == left


@pytest.mark.parametrize(
    ("wish", "told", "answer"),
    [
        ("strip the wallpaper for an hour", "wallpaper's taking longer, another half hour", "10:30"),
        ("gel at ten am for an hour", "the gel's running slow, 20 minutes", ":duration 1 80min"),
        ("strip the wallpaper at ten am for an hour", "the wallpaper is taking longer", "by how much?"),
        ("guests come at seven pm", "guests are stuck in traffic, half an hour", "from 19:00 to 19:30"),
        ("meeting with tom at ten am", "tom's running late, about 20 minutes", "from 10:00 to 10:20"),
        ("walk the dog", "the loaf is taking longer, ten minutes", "nothing that is planned is about loaf"),
    ],
)
def test_by_how_much_something_is_late_or_longer_may_stand_behind_a_comma(
    wish: str, told: str, answer: str
) -> None:
    talk = talk_of(wish)
    assert answer in talk.say(told)


def test_of_several_that_start_then_one_must_be_named() -> None:
    talk = talk_of("call bob at ten", "call mum at ten")
    assert "several start then" in talk.say("cancel my ten o'clock")
    assert len(talk.entries) == 2


@pytest.mark.parametrize(
    "told",
    [
        "tom's out thursday",
        "the incubator's full until eight",
        "looks like rain at four",
        "anna's sick",
        "granny's not home till seven",
        "move the essay to tomorrow night",
        "skip the gravy",
        "that's it for today",
        "anything else today?",
        "and at six?",
    ],
)
def test_what_asks_for_nothing_becomes_no_task(told: str) -> None:
    talk = talk_of("walk the dog at noon", told)
    assert talk.entries == ["walk the dog at noon"]


@pytest.mark.parametrize("told", ["bob is back at six", "the essay is due friday", "mum's old car at six"])
def test_what_happens_at_a_time_is_planned(told: str) -> None:
    talk = talk_of(told)
    assert talk.entries == [told]


def test_what_a_question_was_about_is_meant_next() -> None:
    talk = talk_of("put a wash on at ten am for an hour", "hang it out at four pm")
    talk.say("how long does the wash take?")
    talk.say("make that two hours")
    assert talk.entries[0] == "put a wash on at ten am for two hours"


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        ("block four to five for email", "taken as: email from four to five"),
        ("set aside two hours for writing tomorrow", "taken as: writing tomorrow for two hours"),
        ("keep the afternoon free", "taken from 12:00 to 18:00: kept free"),
        ("I'm busy until noon", "taken from 09:00 to 12:00"),
        ("keep the door free", "keep the door free"),
        ("save ten for bob", "save ten for bob"),
    ],
)
def test_time_is_kept_free(line: str, answer: str) -> None:
    assert answer in Talk().say(line)


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        ("is there a gap before noon?", "free from 09:00"),
        ("how's tomorrow look?", "nothing is planned then"),
        ("where are we?", "s1 gym"),
        ("how are we doing", "everything that is planned has its time"),
        ("when is the gym up?", "s1 gym"),
    ],
)
def test_how_the_day_looks_may_be_asked_in_many_ways(line: str, answer: str) -> None:
    talk = talk_of("gym at four pm")
    assert answer in talk.say(line)


@pytest.mark.parametrize(
    ("told", "said", "entries"),
    [
        ("tom's out thursday, move it to friday", "moved: s1 meeting", ["meeting friday at two pm"]),
        ("ella's sick, call the doctor at two pm", "changes nothing", [MEETING, "call the doctor at two pm"]),
        ("oven's hot, put the pie in now", ":ctx oven_temp=180", [MEETING, "put the pie in now"]),
    ],
)
def test_what_only_tells_in_front_of_what_is_asked_is_no_task(
    told: str, said: str, entries: list[str]
) -> None:
    talk = Talk()
    talk.say(MEETING)
    assert said in talk.say(told)
    assert talk.entries == entries


@pytest.mark.parametrize(
    ("change", "also", "left"),
    [
        ("cancel dinner", "and the gym too", []),
        ("move dinner to nine pm", "the gym too", ["gym at nine pm", "dinner at nine pm"]),
        # Nothing was changed.
        ("thanks", "the gym too", ["gym at six pm", "dinner at seven pm"]),
    ],
)
def test_another_thing_is_changed_the_same_way(change: str, also: str, left: list[str]) -> None:
    talk = Talk()
    for line in ("gym at six pm", "dinner at seven pm", change, also):
        talk.say(line)
    assert talk.left == left


@pytest.mark.parametrize(
    ("lines", "answer"),
    [
        (("strip the paint at ten am for an hour", "another hour"), ":duration 1 120min"),
        (("parts come at eleven am", "parts are late, more like noon"), "from 11:00 to 12:00"),
        (("gym at six pm", "dinner at eight pm", "what's next after gym?"), "s2 dinner"),
    ],
)
def test_how_much_more_and_how_late_something_is(lines: tuple[str, ...], answer: str) -> None:
    talk = Talk()
    assert answer in [talk.say(line) for line in lines][-1]
