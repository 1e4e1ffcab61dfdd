"""Stories for the tests: lines said at one moment, planned together."""

from collections.abc import Sequence
from datetime import datetime, timedelta
from functools import cache

from fuzzytime.interpreter import Interpreter, Plan, Request, SpokenWish, plan
from fuzzytime.scheduling import Limits

SEVEN = datetime(2026, 3, 4, 7)  # noqa: DTZ001 - the tests' moment is of no zone


@cache
def interpreter() -> Interpreter:
    """Give the shipped interpreter, loaded once."""
    return Interpreter.shipped()


def told(
    lines: Sequence[str],
    *,
    now: datetime = SEVEN,
    in_order: bool = False,
    limits: Limits | None = None,
    agents: int = 1,
) -> Plan:
    """Plan lines, each a wish."""
    wishes = tuple(SpokenWish(text=line, given=now) for line in lines)
    request = Request(now=now, wishes=wishes, in_order=in_order, agents=agents)
    return plan(request, interpreter(), limits=limits or Limits())


def listed(lines: Sequence[str], *, now: datetime = SEVEN) -> Plan:
    """Plan the lines of a file."""
    wishes = tuple(SpokenWish(text=line, given=now, line=place) for place, line in enumerate(lines, 1))
    return plan(Request(now=now, wishes=wishes), interpreter())


def starts(made: Plan) -> dict[str, str]:
    """Give the starts of what is planned by the clock, by identifiers, in the order of the wishes."""
    return {
        one.identifier: f"{made.instant(time) + timedelta(seconds=0.5):%H:%M}"
        for one, time, rejected in zip(
            made.skills, made.schedule.start_times, made.schedule.rejected, strict=True
        )
        if not rejected
    }


def order(made: Plan) -> list[str]:
    """Give the identifiers of what is planned in the order of their starts."""
    times = dict(zip((one.identifier for one in made.skills), made.schedule.start_times, strict=True))
    return sorted(starts(made), key=lambda name: times[name])


def notes(made: Plan) -> list[str]:
    """Give everything that is said about the lines."""
    return [problem.message for problem in made.problems]
