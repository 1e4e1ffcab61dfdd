"""Why skills have no time: by their own words, or because of what they must come after."""

from datetime import datetime, timedelta

import pytest

from fuzzytime.context import Context
from fuzzytime.interpreter import Plan, ProblemKind, Request, SpokenWish, plan
from fuzzytime.skills import Busy
from fuzzytime.times import HOUR
from interpreter.telling import SEVEN, interpreter, notes, starts, told

pytestmark = pytest.mark.model

PANCAKES = (
    "Flip the pancakes when the pan is hot",
    "Serve the pancakes after you flip the pancakes",
    "Eat the pancakes after you serve the pancakes",
)


def planned(texts: tuple[str, ...], context: Context, *, given: datetime = SEVEN) -> Plan:
    wishes = tuple(SpokenWish(text=text, given=given) for text in texts)
    return plan(Request(now=SEVEN, wishes=wishes, context=context), interpreter())


def test_what_contradicts_itself_waits_for_nothing() -> None:
    made = told(["call mum really soon but at christmas if the parcel is coming"])
    assert made.schedule.rejected == (True,)
    assert made.skills[0].reason == "what is said about its time contradicts itself"


def test_what_comes_after_a_rejected_skill_says_so() -> None:
    made = planned(
        (
            "Hang up the laundry when the pan is above 300 degrees",
            "Iron the shirts after you hang up the laundry",
            "Fold the shirts after you iron the shirts",
        ),
        Context.of({"pan_temp": 100.0}),
    )
    reasons = [problem.message for problem in made.problems if problem.kind is ProblemKind.REJECTED]
    assert reasons == [
        "hang up the laundry: never: pan_temp settles at 230 °C",
        "iron the shirts: must come after hang up the laundry, which is rejected",
        "fold the shirts: must come after iron the shirts, which is rejected",
    ]


def test_what_busy_times_leave_no_room_for_says_so() -> None:
    wish = SpokenWish(text="Wash the car before noon", given=SEVEN)
    made = plan(Request(now=SEVEN, wishes=(wish,), busy=(Busy(0, 16 * HOUR, "work"),)), interpreter())
    (reason,) = [problem.message for problem in made.problems if problem.kind is ProblemKind.REJECTED]
    assert reason.endswith("is left beside busy times and what else is planned")


def test_what_comes_after_what_waits_waits_as_well() -> None:
    made = planned(PANCAKES, Context.empty)
    assert made.skills == ()
    assert notes(made) == [
        "flip the pancakes: waits: not enough readings of pan_temp",
        "serve the pancakes: waits: flip the pancakes has no time yet",
        "eat the pancakes: waits: serve the pancakes has no time yet",
    ]


@pytest.mark.parametrize(
    ("lines", "waiting"),
    [
        (["sort the post if the courier has been", "stamp the letters"], ["s1"]),
        (
            ["open the shop if the till works", "light the stove ten minutes before opening the shop"],
            ["s1", "s2"],
        ),
        (["open the shop if the till works", "light the stove before opening the shop"], ["s1"]),
        (["order the parts at ten or if the tray is empty"], []),
    ],
)
def test_what_has_no_time_without_what_waits_waits_with_it(lines: list[str], waiting: list[str]) -> None:
    made = told(lines)
    assert [one.identifier for one in made.waiting] == waiting
    assert made.schedule.satisfaction == 1.0
    assert len(starts(made)) == len(lines) - len(waiting)


def test_what_waits_for_what_is_told_too_late_is_rejected() -> None:
    made = planned(
        ("Order the parts at half past six if the tray is empty",),
        Context.empty,
        given=SEVEN - timedelta(hours=1),
    )
    assert made.waiting == ()
    assert notes(made)[-1].startswith("order the parts: its time passed ")


def test_what_waits_leaves_a_strict_plan_possible() -> None:
    lines = ("Call mum at nine", "Order the parts if the tray is empty")
    wishes = tuple(SpokenWish(text=text, given=SEVEN) for text in lines)
    made = plan(Request(now=SEVEN, wishes=wishes), interpreter(), threshold=0)
    assert made.schedule.satisfaction == 1.0
