"""Changes in words: of several that are listed, of all within a stretch, of lengths, and by who can when."""

import pytest

from terminal.talking import talk_of

pytestmark = pytest.mark.model


CALLS = ("call Ann at noon", "call Bob at one pm", "call Carl at two pm")


@pytest.mark.parametrize(
    ("line", "left"),
    [
        ("cancel Ann and Bob", ["call Carl at two pm"]),
        ("cancel Ann, Bob and Carl", []),
        ("cancel Ann and Dora", list(CALLS)),
    ],
)
def test_several_that_are_listed_are_dropped(line: str, left: list[str]) -> None:
    talk = talk_of(*CALLS)
    talk.say(line)
    assert talk.entries == left


def test_several_parts_of_one_line_are_not_dropped_with_the_rest() -> None:
    talk = talk_of(", ".join(CALLS))
    assert "one at a time" in talk.say("cancel Ann and Bob")
    assert talk.entries == [", ".join(CALLS)]


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        ("push Ann and Bob back by an hour", "taken as :delay 1,2 60min"),
        ("push everything after half past twelve back by an hour", "taken as :delay 2,3 60min"),
        ("move everything before half past one half an hour earlier", "taken as :delay 1,2 -30min"),
        ("put Bob at three pm", "taken as :edit 2 call Bob at three pm"),
        ("Bob can only do three pm", "taken as :edit 2 call Bob at three pm"),
        ("he can do four pm", "taken as :edit 3 call Carl at four pm"),
        ("lengthen Bob to an hour", "taken as :edit 2 call Bob at one pm for an hour"),
        ("extend it by ten minutes", "taken as :duration 3 20min"),
        ("shorten it by five minutes", "taken as :duration 3 5min"),
        ("shorten it by an hour", "cannot be 60min shorter"),
        ("Bob can't make it", "when then?"),
        ("Bob rang, move it to three pm", "taken as :edit 2 call Bob at three pm"),
        ("Ann can't make it, reschedule for friday", "taken as :edit 1 call Ann friday at noon"),
        ("the line's down today, do it tomorrow", "taken as :edit 3 call Carl tomorrow at two pm"),
        ("I'm sick, cancel today", "taken as :drop 1,2,3"),
        ("post 11", "says a time but nothing to do"),
        ("move it to yesterday", "nothing is changed"),
        ("Bob's at three pm now", "taken as :edit 2 call Bob at three pm"),
        ("Bob can only come at three pm", "taken as :edit 2 call Bob at three pm"),
        ("Dora is calling Bob", "tells what is"),
        ("anything left?", "call Ann: at 12:00"),
        ("still calling", "call Carl: at 14:00"),
        ("and the cat?", "nothing that is planned is about cat"),
    ],
)
def test_calls_are_changed_by_word(line: str, answer: str) -> None:
    assert answer in talk_of(*CALLS).say(line)


@pytest.mark.parametrize(
    "line", ["put the cat out at ten pm", "put Bob's book on the table at six pm", "extend the lease"]
)
def test_what_is_to_be_done_with_things_is_a_wish(line: str) -> None:
    talk = talk_of(*CALLS)
    talk.say(line)
    assert talk.entries == [*CALLS, line]


def test_what_was_put_off_stays_so_on_another_day() -> None:
    talk = talk_of("call Ann at noon", "push it back by an hour")
    assert "from 13:00 to Fri 13:00" in talk.say("on friday")


@pytest.mark.parametrize("line", ["done", "five more minutes", ":done 1"])
def test_undo_takes_back_what_was_told_of_it(line: str) -> None:
    talk = talk_of("mop the floor")
    assert "09:12" in talk.say("feed the cat at noon")
    talk.say(line)
    assert "undone: what was told of mop the floor" in talk.say("undo")
    assert "running: s1 mop the floor, until 09:12" in talk.say("call Ann at one pm")
    assert talk.entries[:2] == ["mop the floor", "feed the cat at noon"]


def test_undo_plans_again_what_was_told_to_be_done_of_several() -> None:
    talk = talk_of("call Ann at ten am, call Bob at noon", "done with Ann")
    talk.say("undo")
    assert talk.start("s1").hour == 10


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        ("what do I have before one pm", "call Ann: 12:00 to 12:10"),
        ("what do I have after one pm", "call Carl: 14:00 to 14:10"),
        ("what's at five pm", "nothing is planned then"),
        ("do I have anything at five pm", "no: nothing is planned"),
        ("am I busy at noon", "yes: s1 call Ann"),
        ("am I free at five pm", "yes: nothing is planned"),
    ],
)
def test_questions_about_times_count_all_that_is_then(line: str, answer: str) -> None:
    assert answer in talk_of(*CALLS).say(line)


def test_then_behind_a_time_is_no_order() -> None:
    talk = talk_of("call Ann at noon", "breakfast at ten then")
    assert talk.start("s2").hour == 10


@pytest.mark.parametrize(
    "line",
    ["sweep the floor before then", "sweep the floor by then", "wait until then", "mop an hour before then"],
)
def test_then_as_a_time_stays(line: str) -> None:
    assert talk_of("call Ann at noon", line).entries[-1] == line


def test_one_of_several_that_is_moved_to_another_day_keeps_its_hour() -> None:
    talk = talk_of("call Ann at ten am, dinner with Jo on saturday at seven pm")
    talk.say("Jo can't make it, reschedule for friday")
    assert f"{talk.start('s1.2'):%a %H:%M}" == "Fri 19:00"


@pytest.mark.parametrize("line", ["never mind, cancel that", "forget it, skip it", "no, drop it. forget it"])
def test_what_is_let_be_twice_in_a_line_is_one_thing(line: str) -> None:
    talk = talk_of(*CALLS)
    talk.say(line)
    assert talk.entries == list(CALLS[:2])


@pytest.mark.parametrize(
    ("line", "left"),
    [
        ("cancel everything after noon", ["call Ann at ten am", "call Dora tomorrow at two pm"]),
        ("clear my afternoon", ["call Ann at ten am", "call Dora tomorrow at two pm"]),
        ("cancel everything after today", ["call Ann at ten am", "call Bob at two pm"]),
    ],
)
def test_what_comes_after_an_hour_ends_with_its_day(line: str, left: list[str]) -> None:
    talk = talk_of("call Ann at ten am", "call Bob at two pm", "call Dora tomorrow at two pm")
    talk.say(line)
    assert talk.entries == left


def test_what_is_to_be_kept_is_not_dropped() -> None:
    talk = talk_of("meeting at ten am, call the vet at noon, gym at six pm")
    assert "is planned, and stays" in talk.say("oh wait, keep the vet")
    assert len(talk.entries) == 1


def test_the_next_of_several_in_a_line_is_skipped_alone() -> None:
    talk = talk_of("meeting at ten am, call the vet at noon, gym at six pm")
    talk.say("skip the next one")
    assert talk.entries == ["call the vet at noon, gym at six pm"]


def test_what_is_pushed_back_by_nobody_knows_how_much_is_asked() -> None:
    talk = talk_of("call Ann at noon")
    assert "by how much?" in talk.say("push it all back")
    assert talk.start("s1").hour == 12


@pytest.mark.parametrize(
    ("line", "left"),
    [("never mind, forget Bob", [CALLS[0], CALLS[2]]), ("forget that and cancel Bob", [CALLS[0]])],
)
def test_what_opens_a_change_is_no_other_change(line: str, left: list[str]) -> None:
    talk = talk_of(*CALLS)
    talk.say(line)
    assert talk.entries == left


@pytest.mark.parametrize(
    ("line", "length", "start"),
    [
        ("move Ann up", "by half an hour", (11, 30)),
        ("bring it forward", "an hour", (11, 0)),
        ("make it earlier", "10 minutes", (11, 50)),
        ("push it back", "an hour", (13, 0)),
        ("push it back", "an hour earlier", (11, 0)),
    ],
)
def test_a_length_that_was_asked_for_goes_the_way_that_was_said(
    line: str, length: str, start: tuple[int, int]
) -> None:
    talk = talk_of("call Ann at noon")
    assert "by how much?" in talk.say(line)
    talk.say(length)
    assert (talk.start("s1").hour, talk.start("s1").minute) == start


@pytest.mark.parametrize("reason", ["Bob is doing it", "we already talked", "it's raining"])
def test_what_somebody_else_does_is_no_wish_in_its_place(reason: str) -> None:
    talk = talk_of("call Ann at noon")
    assert "changes nothing" in talk.say(f"cancel the call, {reason}")
    assert talk.entries == []


def test_a_change_that_would_lose_one_of_several_changes_nothing() -> None:
    talk = talk_of("saturday: mow the lawn at ten am, wash the car at noon")
    assert "nothing is changed" in talk.say("move the lawn to sunday")
    assert f"{talk.start('s1'):%a %H:%M}" == "Sat 10:00"


@pytest.mark.parametrize(
    "line",
    ["boards are cut", "the boards are cut", "the boards have been cut already", "boards cut"],
)
def test_what_is_said_to_be_cut_is_done(line: str) -> None:
    talk = talk_of("cut the boards at ten", "take the bins out at noon")
    assert "done: cut the boards" in talk.say(line)
    assert talk.left == ["take the bins out at noon"]


@pytest.mark.parametrize(("line", "left"), [("the bins are out", 0), ("the bins aren't out", 1)])
def test_what_is_said_to_be_out_was_taken_out(line: str, left: int) -> None:
    talk = talk_of("take the bins out at noon")
    talk.say(line)
    assert len(talk.left) == left


def test_what_follows_something_done_before_its_time_still_does() -> None:
    talk = talk_of("cut the boards at ten", "then plane them")
    assert "plane the boards" in talk.say("the boards are cut")
    assert talk.left == ["then plane them"]


@pytest.mark.parametrize("line", ["mum called", "the bank just phoned", "Ann texted"])
def test_who_called_is_neither_called_nor_to_be(line: str) -> None:
    talk = talk_of("call mum at noon", "phone the bank at one pm", "text Ann at two pm")
    talk.say(line)
    assert len(talk.entries) == 3


@pytest.mark.parametrize(
    ("line", "anew"),
    [
        ("the ironing can wait till tomorrow", "iron the shirts tomorrow at noon"),
        ("leave the shirts for tomorrow", "iron the shirts tomorrow at noon"),
        ("leave that till six pm", "iron the shirts at six pm"),
        ("Bob wants to move it to one pm", "iron the shirts at one pm"),
        ("she said one pm", "iron the shirts at one pm"),
        ("I'd rather do one pm", "iron the shirts at one pm"),
        ("one pm works better", "iron the shirts at one pm"),
        ("it's too early", "iron the shirts at noon"),
        ("would one pm work?", "iron the shirts at one pm"),
        ("is it possible to do it at one pm?", "iron the shirts at one pm"),
        ("any chance of one pm?", "iron the shirts at one pm"),
        ("one pm I mean", "iron the shirts at one pm"),
        ("that's for tomorrow", "iron the shirts tomorrow at noon"),
        ("it's friday", "iron the shirts at noon"),
        ("trousers not shirts", "iron trousers at noon"),
        ("can we do one pm instead", "iron the shirts at one pm"),
        ("and at one pm not noon", "iron the shirts at one pm"),
        ("leave the shirts where they are", "iron the shirts at noon"),
        ("leave it as it is", "iron the shirts at noon"),
        ("leave it", "iron the shirts at noon"),
        ("the shirts can wait", "iron the shirts at noon"),
        ("do that", "iron the shirts at noon"),
        ("undo both", "iron the shirts at noon"),
    ],
)
def test_what_is_said_of_a_wish_is_no_other_wish(line: str, anew: str) -> None:
    talk = talk_of("iron the shirts at noon")
    talk.say(line)
    assert talk.entries == [anew]


@pytest.mark.parametrize(("line", "left"), [("cancel Ann too", CALLS[1:2]), ("undo that as well", CALLS[:1])])
def test_what_is_changed_too_is_changed(line: str, left: tuple[str, ...]) -> None:
    talk = talk_of(*CALLS[:2])
    talk.say(line)
    assert talk.entries == list(left)


@pytest.mark.parametrize("wish", ["call Bob at noon", "Bob at noon"])
def test_who_is_late_is_so_by_what_is_answered(wish: str) -> None:
    talk = talk_of(wish)
    assert "by how much?" in talk.say("Bob's running late")
    talk.say("about ten minutes")
    assert (talk.start("s1").hour, talk.start("s1").minute) == (12, 10)
