"""States that no reading tells of: what they wait for, and what is said of it."""

from datetime import datetime

import pytest

from fuzzytime.context import Context
from fuzzytime.interpreter import Interpreter, Request, SpokenWish
from interpreter.telling import SEVEN, interpreter, notes, starts, told

pytestmark = pytest.mark.model


def test_a_state_waits_for_the_latest_that_is_about_the_same_thing() -> None:
    made = told(["set the timer for ten minutes", "wipe the table", "when the timer rings, drain the pasta"])
    assert starts(made)["s3"] == "07:10"
    assert any(
        "nothing tells 'when the timer rings'" in note and "set the timer" in note for note in notes(made)
    )


@pytest.mark.parametrize(
    "lines",
    [
        ["sand the shelf for 20 minutes", "paint the wall once it's dust free"],
        ["rinse the beakers for 20 minutes", "put away the rack when they are dry"],
    ],
)
def test_it_may_be_what_was_said_before_and_not_what_is_to_be_done(lines: list[str]) -> None:
    assert starts(told(lines))["s2"] == "07:20"


def test_how_long_a_state_takes_counts_from_when_hands_are_free() -> None:
    made = told(["paint the door for 15 minutes", "once the paint is dry, which takes two hours, sand it"])
    assert starts(made)["s2"] == "09:15"
    assert not notes(made)


def test_how_long_a_state_takes_counts_from_now_where_nothing_brings_it_about() -> None:
    assert starts(told(["once the paint is dry, which takes two hours, sand it"]))["s1"] == "09:00"


def test_how_long_a_thing_to_be_done_takes_may_be_said_aside() -> None:
    made = told(["fold the shirts, which takes half an hour, and iron them"])
    assert starts(made) == {"s1": "07:00", "s1.2": "07:30"}


@pytest.mark.parametrize(
    "lines",
    [
        ["call the guests", "when the guests arrive, open the wine"],
        ["fetch the coats", "if the coats are wet, dry them"],
        ["once they have left, lock the door"],
    ],
)
def test_whoever_comes_and_what_is_only_possible_is_not_assumed(lines: list[str]) -> None:
    assert len(starts(told(lines))) == len(lines) - 1


def test_nothing_is_assumed_where_readings_may_still_tell() -> None:
    said = ["put the kettle on", "when it boils, pour the tea"]
    wishes = tuple(SpokenWish(text=line, given=SEVEN) for line in said)
    made = [_second(interpreter(), wishes, awaits) for awaits in (False, True)]
    assert made == [False, True]


def _second(understanding: Interpreter, wishes: tuple[SpokenWish, ...], awaits: bool) -> bool:  # noqa: FBT001
    """Give whether the second of some wishes waits for readings."""
    now: datetime = SEVEN
    request = Request(now=now, wishes=wishes, context=Context(), awaits_readings=awaits)
    (_, pour) = understanding.interpret(request).skills
    return any(part.condition is not None for part in pour.requirements)


@pytest.mark.parametrize(
    ("lines", "last"),
    [
        (["put the bread in the oven at ten", "take it out 40 minutes after it goes in"], "10:41"),
        (["take the roast out at noon", "carve the roast ten minutes after it comes out"], "12:11"),
        (["put the buns in at noon", "let the cat in at one", "call mum an hour before they go in"], "11:00"),
        (["put the buns in at noon", "let the cat in at one", "feed her an hour after it comes in"], "14:01"),
    ],
)
def test_what_is_put_somewhere_gets_there(lines: list[str], last: str) -> None:
    assert starts(told(lines))[f"s{len(lines)}"] == last


@pytest.mark.parametrize("end", ["until the guests come", "until it rains", "until the pan is hot"])
def test_an_end_that_nothing_tells_of_is_said(end: str) -> None:
    made = told([f"play music {end}"])
    assert starts(made)["s1"] == "07:00"
    assert any(f"nothing tells {end!r}" in note for note in notes(made))
