"""What is said of a part of all that is planned, or leans on the change before: "and the sheep, too"."""

import pytest

from terminal.talking import Talk, talk_of
from terminal.test_told_of_plans import planned

pytestmark = pytest.mark.model

DAY = (
    "write the report at ten for an hour",
    "lunch at half past twelve",
    "the train leaves at three",
    "call Ann at four",
)


def starts(talk: Talk) -> list[str]:
    return [start for start, _ in planned(talk).values()]


@pytest.mark.parametrize(
    ("line", "then"),
    [
        ("push everything from lunch on by twenty minutes", ["10:00", "12:50", "15:00", "16:20"]),
        ("everything after lunch an hour later", ["10:00", "12:30", "15:00", "17:00"]),
        ("push lunch and everything after it back by ten minutes", ["10:00", "12:40", "15:00", "16:10"]),
        ("everything else half an hour earlier", ["09:30", "12:00", "15:00", "16:00"]),
        ("everything half an hour later except the call", ["10:30", "13:00", "15:00", "16:00"]),
        ("move everything but lunch back by an hour", ["11:00", "12:30", "15:00", "17:00"]),
        ("push everything back by an hour", ["11:00", "12:30", "15:00", "17:00"]),
    ],
)
def test_a_part_of_all_that_is_left_moves(line: str, then: list[str]) -> None:
    talk = talk_of(*DAY)
    before = starts(talk)
    assert "not moved, since it was told, not asked for" in talk.say(line) or "lunch an hour" in line
    assert starts(talk) == then
    talk.say("undo")
    assert starts(talk) == before


def test_the_rest_is_dropped_and_what_was_spoken_of_stays() -> None:
    talk = talk_of("water the beds at ten", "mow the lawn at noon", "clean the shed at two")
    talk.say("move the lawn to one")
    talk.say("cancel everything else")
    assert talk.entries == ["mow the lawn at one"]


def test_another_is_moved_by_another_length_and_the_other_way() -> None:
    talk = talk_of("mend the fence at one for an hour", "move the sheep at ten for an hour")
    talk.say("push the fence back by an hour")
    talk.say("and the sheep by half an hour")
    assert starts(talk) == ["14:00", "10:30"]
    talk.say("no, the other way")
    assert starts(talk) == ["14:00", "09:30"]


def test_what_is_done_again_later_counts_from_what_was_asked_for() -> None:
    talk = talk_of("take the readings at ten for ten minutes", "autoclave the flasks at two")
    talk.say("take the readings again an hour later")
    talk.say("and again two hours after that")
    assert starts(talk) == ["10:00", "14:00", "11:00", "13:00"]


def test_something_else_is_done_at_the_time_of_one() -> None:
    talk = talk_of("mend the fence at one for two hours")
    talk.say("do the hay instead of the fence")
    assert talk.entries == ["do the hay at one"]


@pytest.mark.parametrize(
    ("lines", "minutes"),
    [
        (("make the meeting shorter", "by twenty minutes"), 40.0),
        (("shorten the meeting", "a quarter of an hour"), 45.0),
        (("could you make the meeting a bit longer?",), 70.0),
        (("make the meeting ten minutes shorter",), 50.0),
    ],
)
def test_what_is_to_be_shorter_is_asked_by_how_much(lines: tuple[str, ...], minutes: float) -> None:
    talk = talk_of("staff meeting at three for an hour", *lines)
    assert planned(talk) == {"s1": ("15:00", minutes)}


def test_what_was_tried_may_be_taken() -> None:
    talk = talk_of("mark the essays at eleven for two hours", "what if I start the essays at ten?")
    assert starts(talk) == ["11:00"]
    talk.say("ok, do that")
    assert starts(talk) == ["10:00"]
    talk.say("what if we push the essays back by an hour?")
    assert "nothing is changed" in talk.say("no, leave it")
    talk.say("what if we push the essays back by an hour?")
    talk.say("yes please")
    assert starts(talk) == ["11:00"]


def test_what_was_moved_without_a_time_is_asked_when_it_is() -> None:
    talk = talk_of("parents evening at school at six", "swimming at four", "call Ann at two")
    talk.say("when is parents evening?")
    assert "when then?" in talk.say("School has moved it")
    talk.say("to seven")
    assert starts(talk) == ["19:00", "16:00", "14:00"]


@pytest.mark.parametrize(
    ("line", "then"),
    [
        ("move the second viewing to five", ["14:00", "17:00", "18:00"]),
        ("the first viewing is off", ["16:00", "18:00"]),
        ("cancel the last viewing", ["14:00", "16:00"]),
    ],
)
def test_one_of_several_is_called_by_its_turn(line: str, then: list[str]) -> None:
    talk = talk_of(
        "viewing on Elm Road at two", "viewing on Oak Street at four", "viewing on Ash Lane at six"
    )
    talk.say(line)
    assert starts(talk) == then


def test_one_of_several_times_is_left_out() -> None:
    talk = talk_of("take the tablets at 10 am, noon and six")
    talk.say("skip the noon tablets")
    assert sorted(starts(talk)) == ["10:00", "18:00"]


def test_what_was_changed_goes_back_to_where_it_was() -> None:
    talk = talk_of("unpack the delivery at eleven for an hour")
    talk.say("push the delivery back by an hour")
    talk.say("no wait, put the delivery back to where it was")
    assert starts(talk) == ["11:00"]


def test_the_other_call_among_other_things_is_the_other_one() -> None:
    talk = talk_of("ring Tom at four", "paint the shed at ten", "ring Priya at half past five")
    talk.say("cancel the call with Tom")
    talk.say("no, the other one")
    assert talk.entries == ["ring Tom at four", "paint the shed at ten"]


@pytest.mark.parametrize("line", ["it has to be done before six", "it needs to be finished by six"])
def test_what_is_in_time_already_is_only_shown(line: str) -> None:
    talk = talk_of("call Ann at four")
    assert "at 16:00" in talk.say(line)
    assert talk.entries == ["call Ann at four"]


def test_one_of_all_that_moved_is_left_where_it_was() -> None:
    talk = talk_of("write at ten for an hour", "gym at two for an hour", "the customer comes at four")
    talk.say("push everything from the writing on back by an hour")
    assert starts(talk) == ["11:00", "15:00", "16:00"]
    talk.say("no, not the gym")
    assert starts(talk) == ["11:00", "14:00", "16:00"]
    talk.say("push everything after noon back by an hour")
    talk.say("leave the gym where it was")
    assert starts(talk) == ["11:00", "14:00", "16:00"]


def test_what_has_lost_its_place_moves_along() -> None:
    talk = talk_of("sand the table at ten for an hour", "glue the chair at eleven", "varnish the desk at one")
    talk.say("the sanding will take two hours")
    talk.say("so push everything after it back an hour")
    assert starts(talk) == ["10:00", "12:00", "14:00"]


def test_what_is_wanted_of_something_bounds_nobody_who_comes() -> None:
    talk = talk_of("varnish the table at one", "the customer comes at four")
    assert "say it with its name" in talk.say("the customer wants it before half three")
    assert starts(talk) == ["13:00", "16:00"]


def test_what_somebody_has_is_called_off_by_its_name() -> None:
    talk = talk_of("Tom has football at eleven", "call Ann at two")
    talk.say("football's been called off")
    assert talk.entries == ["call Ann at two"]


def test_a_change_goes_on_behind_another() -> None:
    talk = talk_of("gym at five for an hour")
    talk.say("gym at half four instead")
    talk.say("and make it half an hour")
    assert planned(talk) == {"s1": ("16:30", 30.0)}
