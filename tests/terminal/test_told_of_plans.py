"""What is told of what was asked for, or of those that it is of: it is bounded, moved, or has begun."""

from datetime import timedelta

import pytest

from terminal.talking import Talk, talk_of

pytestmark = pytest.mark.model

ASKED = (
    "call with Ann at eleven for half an hour",
    "fix the leak on Elm Road at one for an hour",
    "roast the lamb at four for two hours",
    "post the letter to Olga at two",
)


def planned(talk: Talk) -> dict[str, tuple[str, float]]:
    """Give when everything starts, and how many minutes it takes, by its label."""
    plan = talk.turns.plan
    assert plan is not None
    times = plan.schedule.start_times
    return {
        one.identifier: (f"{plan.instant(times[place]):%H:%M}", one.skill.time_until_done / 60)
        for place, one in enumerate(plan.skills)
    }


@pytest.mark.parametrize(
    ("line", "label", "then"),
    [
        ("Ann can't talk before noon", "s1", ("12:00", 30.0)),
        ("Ann says she isn't free till noon", "s1", ("12:00", 30.0)),
        ("Ann's boss can only do the call from half past eleven", "s1", ("11:30", 30.0)),
        ("Elm Road says it can't be before half past two", "s2", ("14:30", 60.0)),
        ("Dave can't help with the leak before half past two", "s2", ("14:30", 60.0)),
        ("the Elm Road people want me there at half past two", "s2", ("14:30", 60.0)),
        ("the lamb can't go in before half past four", "s3", ("16:30", 120.0)),
        ("Olga won't be in till three", "s4", ("15:00", 10.0)),
        ("the call has slipped to quarter to twelve", "s1", ("11:45", 30.0)),
        ("the leak needs to be pushed to half past two", "s2", ("14:30", 60.0)),
        ("the call slipped by half an hour", "s1", ("11:30", 30.0)),
        ("Ann wants to talk at noon instead", "s1", ("12:00", 30.0)),
        ("Ann asked whether we could make it noon", "s1", ("12:00", 30.0)),
        ("then the call can start at noon", "s1", ("12:00", 30.0)),
        ("the call overran by 15 minutes", "s1", ("11:00", 45.0)),
        ("call ran over by 15 minutes", "s1", ("11:00", 45.0)),
        ("the call can be cut to twenty minutes", "s1", ("11:00", 20.0)),
        ("the call needs to be shortened by ten minutes", "s1", ("11:00", 20.0)),
        ("give it three hours to roast, it's a big one", "s3", ("16:00", 180.0)),
        ("the lamb wants three hours to roast", "s3", ("16:00", 180.0)),
    ],
)
def test_what_is_told_of_a_thing_changes_that_and_nothing_else(
    line: str, label: str, then: tuple[str, float]
) -> None:
    talk = talk_of(*ASKED)
    before = planned(talk)
    assert len(before) == len(ASKED)
    talk.say(line)
    assert planned(talk) == before | {label: then}


@pytest.mark.parametrize(
    "line",
    [
        "Ann needs to be texted at three", "the lamb must be carved at seven", "buy Ann's baked beans",
        "the leak has to be reported by five", "ask Bob if he can come before six",
        "we can't leave before six", "Ann needs a lift at three", "the lamb has to cool for an hour",
        "the hall can be hosed down at four", "Gareth needs to be called",
    ],
)  # fmt: skip
def test_what_has_to_be_done_with_a_thing_is_something_else(line: str) -> None:
    talk = talk_of(*ASKED)
    talk.say(line)
    assert talk.entries == [*ASKED, line]


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        ("Ann says she can't hear me", "says something of Ann that is not understood"),
        ("serving has slipped to half two", "nothing planned is about"),
        ("Gareth can't help before twelve", "nothing planned is about"),
        ("the guests can't get here till half two", "nothing planned is about"),
        ("Gareth's got a cold", "says nothing to do"),
        ("the lamb has a bone", "says nothing to do"),
        ("Olga can't have the call before ten", "is at 11:00, and so not before ten already"),
    ],
)
def test_what_is_told_and_not_understood_is_said_and_changes_nothing(line: str, answer: str) -> None:
    talk = talk_of(*ASKED)
    before = planned(talk)
    assert answer in talk.say(line)
    assert planned(talk) == before


@pytest.mark.parametrize("line", ["lamb's in", "the lamb has gone in", "the lamb is in the oven"])
def test_what_is_told_to_be_in_has_begun_where_it_goes_on_by_itself(line: str) -> None:
    talk = talk_of(*ASKED, "put the bins out at three")
    talk.say(line)
    assert f"{talk.start('s3'):%H:%M}" == "09:00"
    assert "done: put out the bins" in talk.say("the bins are out")


def test_what_is_not_before_a_time_keeps_its_deadline_and_its_place() -> None:
    talk = talk_of("send the slides to Olga by five", "Olga can't have them before two")
    assert talk.entries == ["send the slides to Olga by five not before two"]
    line = "clean the hall at ten for an hour, then polish the floor for half an hour, then lock up"
    talk = talk_of(line, "the floor can't be polished before noon")
    assert [f"{talk.start(label):%H:%M}" for label in ("s1", "s1.2", "s1.3")] == ["10:00", "12:00", "12:30"]


def test_what_is_asked_for_behind_what_is_done_is_done_now() -> None:
    talk = talk_of("put the soup on at five", "fry the onions at nine for 8 minutes")
    talk.now += timedelta(minutes=6)
    talk.say("the onions are done, put the soup on")
    assert f"{talk.start('s1'):%H:%M}" == "09:06"
    assert talk.entries[0] == "put the soup on right now"


def test_why_everything_is_later_asks_for_nothing() -> None:
    talk = talk_of(
        "lay the table at one", "the guests can't get here till two, so move everything by half an hour"
    )
    assert talk.entries == ["lay the table at one"]
    assert f"{talk.start('s1'):%H:%M}" == "13:30"


def test_nothing_is_begun_beside_what_keeps_the_hands() -> None:
    talk = talk_of("wash the salad now for ten minutes", "roast the lamb at four for two hours")
    before = talk.entries
    assert "nothing else is begun beside it" in talk.say("lamb's in")
    assert talk.entries == before


def test_of_several_things_the_one_that_was_moved_is_moved() -> None:
    talk = talk_of("lecture at two for ninety minutes, then library till six")
    talk.say("lecture's been moved to half two")
    assert {name: start for name, (start, _) in planned(talk).items()} == {"s1": "14:30", "s1.2": "16:00"}
