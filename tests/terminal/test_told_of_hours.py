"""What bounds what is planned somewhere, or ends it: "the pool shuts at five", "practice ends at six"."""

import pytest

from terminal.talking import talk_of
from terminal.test_told_of_plans import planned

pytestmark = pytest.mark.model

ASKED = (
    "swim at the pool at four for an hour",
    "take Leo to the library at two",
    "collect the feed at noon",
    "use the lathe at six for an hour",
    "band practice at eight for an hour",
)


@pytest.mark.parametrize(
    ("line", "label", "then"),
    [
        ("the pool closes at half past four", "s1", "15:30"),
        ("the pool is only open till half past four", "s1", "15:30"),
        ("the library doesn't open until three", "s2", "15:00"),
        ("the library is shut until half past two", "s2", "14:30"),
        ("the feed store shuts at half eleven today", "s3", "11:22"),
        ("the lathe's broken till seven", "s4", "19:00"),
        ("the lathe is only free from half past six", "s4", "18:30"),
    ],
)
def test_what_is_open_or_in_use_bounds_what_is_done_there(line: str, label: str, then: str) -> None:
    talk = talk_of(*ASKED)
    before = planned(talk)
    talk.say(line)
    assert planned(talk) == before | {label: (then, before[label][1])}


@pytest.mark.parametrize(
    ("line", "answer"),
    [
        ("the pool shuts at five", "swim at the pool: at 16:00"),
        ("the library opens at one", "and so not before one already"),
    ],
)
def test_what_is_kept_already_changes_nothing(line: str, answer: str) -> None:
    talk = talk_of(*ASKED)
    before = planned(talk)
    assert answer in talk.say(line)
    assert planned(talk) == before
    assert len(talk.entries) == len(ASKED)


def test_where_nothing_is_planned_is_only_told() -> None:
    talk = talk_of(*ASKED)
    talk.say("the bakery shuts at five")
    assert talk.entries[-1] == "the bakery shuts at five"


def test_what_is_asked_for_beside_it_is_a_wish() -> None:
    talk = talk_of("swim at the pool at four for an hour")
    talk.say("the pool shuts at half four, so call Ben at six")
    assert {name: start for name, (start, _) in planned(talk).items()} == {"s1": "15:30", "s2": "18:00"}


@pytest.mark.parametrize(
    ("line", "minutes"),
    [("practice ends at half past nine", 90.0), ("band practice goes on until ten", 120.0)],
)
def test_what_is_over_at_a_time_lasts_until_then(line: str, minutes: float) -> None:
    talk = talk_of(*ASKED)
    before = planned(talk)
    talk.say(line)
    assert planned(talk) == before | {"s5": ("20:00", minutes)}


def test_the_end_of_what_is_repeated_has_to_be_said_anew() -> None:
    talk = talk_of("take readings every hour from 11 am to 3 pm")
    assert "say it anew" in talk.say("the readings only need to go on until two")
    assert len(talk.entries) == 1
