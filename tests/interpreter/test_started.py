"""Planning on: what started stays, what waits is released, and what needs a failed skill has no time."""

import math
from datetime import datetime

import pytest

from fuzzytime.interpreter import DirectWish, Interpreter, Plan, Request, SpokenWish, Started, plan
from fuzzytime.satisfaction import Rectangle

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - the tests' moment is of no zone


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.shipped()


def wish(name: str, *after: str) -> DirectWish:
    return DirectWish(
        name=name,
        satisfaction=Rectangle(0, 3600),
        given=NOW,
        identifier=name,
        hands_on=60.0,
        elapsed=60.0,
        after=after,
    )


def planned(interpreter: Interpreter, *started: Started) -> Plan:
    wishes = (wish("cook"), wish("serve", "cook"), wish("sweep"))
    return plan(Request(now=NOW, wishes=wishes, started=started), interpreter)


def start_of(made: Plan, identifier: str) -> float:
    position = [interpreted.identifier for interpreted in made.skills].index(identifier)
    return made.schedule.start_times[position]


def test_a_started_skill_leaves_the_plan_and_holds_its_agent(interpreter: Interpreter) -> None:
    made = planned(interpreter, Started(identifier="cook", start=-10, end=50, done=50))
    assert [interpreted.identifier for interpreted in made.skills] == ["serve", "sweep"]
    assert start_of(made, "sweep") >= 50
    assert start_of(made, "serve") >= 50


def test_what_asked_to_come_after_a_failed_skill_has_no_time_and_says_why(interpreter: Interpreter) -> None:
    made = planned(interpreter, Started(identifier="cook", start=-10, end=-1, done=math.inf))
    assert made.schedule.rejected == (True, False)
    assert "serve: must come after cook, which failed" in [problem.message for problem in made.problems]


@pytest.mark.model
def test_what_was_to_be_done_before_another_is_not_needed_by_it(interpreter: Interpreter) -> None:
    texts = ("Serve the soup in ten minutes", "Set the table before serving the soup")
    wishes = tuple(SpokenWish(text=text, given=NOW, identifier=f"s{i}") for i, text in enumerate(texts, 1))
    failed = Started(identifier="s2", start=-10, end=-1, done=math.inf)
    made = plan(Request(now=NOW, wishes=wishes, started=(failed,)), interpreter)
    assert made.schedule.rejected == (False,)
    assert made.skills[0].follows == ()
    assert plan(Request(now=NOW, wishes=wishes), interpreter).interpretation.precedences
