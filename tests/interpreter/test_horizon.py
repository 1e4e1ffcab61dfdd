"""How far a plan looks ahead: as far as is asked, and no further than it must."""

from datetime import datetime

import pytest

from fuzzytime.interpreter import WITHOUT_END, DirectWish, Interpreter, Plan, Request, SpokenWish, plan
from fuzzytime.satisfaction import Trapezoid
from fuzzytime.scheduling import Limits
from fuzzytime.skills import Busy
from fuzzytime.times import DAY, HOUR

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - a Wednesday, in the tests' only zone


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.shipped()


def planned(
    interpreter: Interpreter, *texts: str, horizon: float | None = None, busy: tuple[Busy, ...] = ()
) -> Plan:
    wishes = tuple(SpokenWish(text=text, given=NOW) for text in texts)
    request = Request(now=NOW, wishes=wishes, horizon=horizon, busy=busy)
    return plan(request, interpreter, limits=Limits())


def days_of(made: Plan) -> list[str]:
    assert not any(made.schedule.rejected)
    return [f"{made.instant(start):%Y-%m-%d}" for start in sorted(made.schedule.start_times)]


@pytest.mark.parametrize(
    ("text", "days"),
    [
        ("buy milk on saturday", ["2026-03-07"]),
        ("call mum in ten days", ["2026-03-14"]),
        ("visit gran next christmas", ["2026-12-25"]),
        ("renew the passport in two years", ["2028-03-04"]),
        ("work in the garden during saturday", ["2026-03-07"]),
        ("take the bins out every monday", ["2026-03-09"]),
        ("pay the rent on the first of every month", ["2026-04-01"]),
        ("feed the cat every day", ["2026-03-04", "2026-03-05", "2026-03-06"]),
        ("call mum at six every day until saturday", [f"2026-03-{day:02d}" for day in (4, 5, 6, 7)]),
    ],
)
def test_a_plan_looks_as_far_as_the_words_say(interpreter: Interpreter, text: str, days: list[str]) -> None:
    made = planned(interpreter, text)
    assert days_of(made) == days
    assert min(made.schedule.satisfactions) == 1


def test_what_may_be_done_at_once_is_not_put_off_by_a_far_deadline(interpreter: Interpreter) -> None:
    made = planned(interpreter, "buy a gift before christmas", "set the table")
    assert made.interpretation.horizon < WITHOUT_END + HOUR
    assert days_of(made) == ["2026-03-04"] * 2


@pytest.mark.parametrize("horizon", [3 * DAY, 5 * DAY])
def test_a_repetition_that_goes_on_ends_with_the_horizon_that_is_given(
    interpreter: Interpreter, horizon: float
) -> None:
    made = planned(interpreter, "feed the cat every day", horizon=horizon)
    assert len(days_of(made)) == horizon / DAY
    assert max(made.schedule.start_times) <= horizon


def test_what_is_taken_for_days_leaves_room_behind_it(interpreter: Interpreter) -> None:
    away = (Busy(0, 3 * DAY, "away"), Busy(3 * DAY + 60, 9 * DAY, "away again"))
    assert days_of(planned(interpreter, "call mum", busy=away)) == ["2026-03-13"]


def test_a_wish_that_no_one_lives_to_see_is_rejected(interpreter: Interpreter) -> None:
    far = DirectWish(
        given=NOW, name="wait", satisfaction=Trapezoid(9e9, 9e9, 9e9, 9e9), hands_on=60, elapsed=60
    )
    made = plan(Request(now=NOW, wishes=(far,)), interpreter, limits=Limits())
    assert made.schedule.rejected == (True,)
    assert "beyond the horizon of 3660 d" in made.skills[0].reason
