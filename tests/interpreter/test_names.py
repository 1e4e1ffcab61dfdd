"""What skills are called: after the instruction that asks for them, by its number or its own name."""

from datetime import datetime

import pytest

from fuzzytime.errors import FuzzytimeError
from fuzzytime.interpreter import DirectWish, Interpreter, Plan, ProblemKind, Request, SpokenWish, Wish, plan
from fuzzytime.satisfaction import ALWAYS

NOW = datetime(2026, 3, 4, 9)  # noqa: DTZ001 - the tests' moment is of no zone


@pytest.fixture(scope="module")
def interpreter() -> Interpreter:
    return Interpreter.shipped()


def said(text: str, identifier: str = "", after: tuple[str, ...] = ()) -> SpokenWish:
    return SpokenWish(text=text, given=NOW, identifier=identifier, after=after)


def planned(interpreter: Interpreter, *wishes: Wish) -> Plan:
    return plan(Request(now=NOW, wishes=wishes), interpreter)


def names(made: Plan) -> list[str]:
    return [interpreted.identifier for interpreted in made.skills]


def test_a_skill_is_named_by_the_number_of_its_instruction(interpreter: Interpreter) -> None:
    glue = DirectWish(given=NOW, name="glue", satisfaction=ALWAYS, hands_on=60.0)
    made = planned(
        interpreter, said("Boil the eggs, then set the table"), said("the what"), said("Feed the cat"), glue
    )
    assert names(made) == ["s1", "s1.2", "s3", "s4"]


def test_no_two_skills_share_a_name(interpreter: Interpreter) -> None:
    made = planned(
        interpreter,
        said("Boil the eggs, then set the table", "eggs"),
        said("Feed the cat", "s3"),
        said("Call mum"),
        said("Wash the pan", "eggs.2"),
    )
    assert names(made) == ["eggs", "eggs.2'", "s3", "s3'", "eggs.2"]


def test_what_comes_after_an_instruction_comes_after_all_that_it_asks_for(interpreter: Interpreter) -> None:
    made = planned(
        interpreter, said("Boil the eggs, then set the table"), said("Feed the cat now", after=("s1",))
    )
    starts = dict(zip(names(made), made.schedule.start_times, strict=True))
    assert starts["s2"] >= starts["s1.2"] + 60


def test_what_comes_after_an_instruction_that_is_not_understood_is_planned_and_said(
    interpreter: Interpreter,
) -> None:
    made = planned(interpreter, said("the what"), said("Feed the cat now", after=("s1",)))
    (problem,) = [problem for problem in made.problems if problem.kind is ProblemKind.UNRESOLVED]
    assert names(made) == ["s2"]
    assert "must come after s1, which is not planned" in problem.message
    assert problem.identifier == "s2"


def test_a_name_that_nobody_has_is_refused(interpreter: Interpreter) -> None:
    with pytest.raises(FuzzytimeError, match="must name the id of a skill, got 's7'"):
        planned(interpreter, said("Feed the cat now", after=("s7",)))


def test_what_is_to_come_after_itself_is_told(interpreter: Interpreter) -> None:
    made = planned(interpreter, said("Feed the cat now", identifier="cat", after=("cat",)))
    assert [problem.message for problem in made.problems if problem.kind is ProblemKind.UNRESOLVED] == [
        "cat cannot come after itself: this order is not kept"
    ]
