"""How early or late something may start before others satisfy less."""

import math
from datetime import datetime

import pytest

from fuzzytime.interpreter import Interpreter, Leeway, Request, SpokenWish, plan

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - a wall-clock time

HOUR = 3600.0


def _leeway(position: int, *texts: str) -> Leeway:
    wishes = tuple(SpokenWish(given=NOW, text=text) for text in texts)
    request, interpreter = Request(now=NOW, wishes=wishes), Interpreter.shipped()
    return Leeway(plan(request, interpreter), position, request, interpreter)


@pytest.mark.model
def test_a_start_is_limited_by_those_that_would_lose() -> None:
    found = _leeway(0, "paint the fence at ten for two hours", "lunch with Priya at half twelve")
    assert (found.latest().start, found.latest().losing) == (1.5 * HOUR, ("s2",))
    assert found.earliest().start == 0.0


@pytest.mark.model
def test_a_deadline_of_its_own_limits_and_a_named_start_does_not() -> None:
    assert math.isinf(_leeway(0, "call the bank at two").latest().start)
    limit = _leeway(1, "mow the lawn at ten for an hour", "write the report by four for an hour").latest()
    assert (limit.start, limit.losing) == (6 * HOUR, ())


@pytest.mark.model
def test_what_follows_moves_along() -> None:
    texts = (
        "roast the beef at four for two hours",
        "make the gravy when the beef is done",
        "guests come at seven",
        "serve the beef when they're here",
    )
    limit = _leeway(0, *texts).latest()
    assert (limit.start, limit.losing) == (8 * HOUR, ("s4",))
