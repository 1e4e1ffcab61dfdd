"""From a request to a plan, and on to the next one."""

from dataclasses import dataclass, field, replace
from datetime import datetime, timedelta
from typing import ClassVar

import numpy as np
import pytest

from fuzzytime.interpreter import DirectWish, Interpreter, Plan, Request, SpokenWish, plan
from fuzzytime.satisfaction import Triangle
from fuzzytime.scheduling import LocalSearch
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.solver import Draft
from fuzzytime.skills import Busy
from fuzzytime.times import HOUR

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - the tests' moment is of no zone


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.shipped()


@dataclass(frozen=True)
class Watched:
    """A local search that keeps from which starts it began."""

    name: ClassVar[str] = "watched"

    begun: list[dict[int, float]] = field(default_factory=list)

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        if warm is not None:
            times = zip(problem.jobs, warm.starts.tolist(), strict=True)
            self.begun.append({job.position: time for job, time in times if not np.isnan(time)})
        return LocalSearch().search(problem, watch, warm)


def wish(name: str, middle: float) -> DirectWish:
    return DirectWish(
        given=NOW,
        name=name,
        identifier=name,
        satisfaction=Triangle(middle - 300, middle, middle + 300),
        hands_on=60.0,
    )


def test_a_later_plan_begins_from_the_starts_of_the_one_before(interpreter: Interpreter) -> None:
    request = Request(now=NOW, wishes=(wish("stir", 400), wish("serve", 500)))
    before = plan(request, interpreter)
    assert list(before.schedule.start_times) == [400, 500]
    solver = Watched()
    later = replace(
        request,
        now=NOW + timedelta(seconds=30),
        wishes=(wish("call", 900), wish("serve", 500), wish("stir", 400)),
    )
    made = plan(later, interpreter, solver=solver, previous=before)
    assert solver.begun == [{1: 470, 2: 370}]
    assert list(made.schedule.start_times) == [870, 470, 370]


def test_without_an_earlier_plan_the_search_begins_from_nothing(interpreter: Interpreter) -> None:
    solver = Watched()
    made = plan(Request(now=NOW, wishes=(wish("stir", 400),)), interpreter, solver=solver)
    assert isinstance(made, Plan)
    assert solver.begun == []


def test_an_appointment_gives_way_to_no_wish(interpreter: Interpreter) -> None:
    texts = ("I have a meeting from 2 to 4 pm", "Call Anna at 2:30 pm", "Call Tom at 3 pm", "Rest at 3:30 pm")
    wishes = tuple(SpokenWish(text=text, given=NOW) for text in texts)
    made = plan(Request(now=NOW, wishes=wishes), interpreter)
    assert list(made.schedule.rejected) == [False, True, True, True]
    (taken,) = made.request.busy
    assert (taken.start, taken.end, taken.what, taken.agent) == (5 * HOUR, 7 * HOUR, "a meeting", None)
    shared = plan(Request(now=NOW, wishes=wishes, agents=2), interpreter)
    assert [taken.agent for taken in shared.request.busy] == [1]
    assert not any(shared.schedule.rejected)


def test_busy_times_after_all_that_is_asked_for_are_not_scheduled_around(interpreter: Interpreter) -> None:
    days = tuple(Busy(day * 24 * HOUR, day * 24 * HOUR + HOUR) for day in range(365))
    made = plan(Request(now=NOW, wishes=(wish("stir", 400),), busy=days), interpreter)
    assert made.schedule.task.busy == days[:1]
    assert made.request.busy == days
