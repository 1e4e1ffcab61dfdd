"""Who is asked, where several agents are planned."""

import pytest

from fuzzytime.interpreter import Plan, Request, SpokenWish, plan
from interpreter.telling import SEVEN, interpreter, notes

pytestmark = pytest.mark.model


def _told(*lines: str, agents: int = 2) -> Plan:
    wishes = tuple(SpokenWish(text=line, given=SEVEN) for line in lines)
    return plan(Request(now=SEVEN, wishes=wishes, agents=agents), interpreter())


def _agents(made: Plan) -> dict[str, int | None]:
    return {one.skill.name: one.skill.agent for one in made.skills}


def test_a_numbered_worker_is_the_agent_of_its_number() -> None:
    made = _told("Robot 2 cleans the tank", "Then robot 1 mounts the cover.", "Robot 2: dock at 9 am")
    assert _agents(made) == {"clean the tank": 2, "mount the cover": 1, "dock": 2}
    assert made.problems == ()


def test_a_worker_on_a_line_of_its_own_does_what_is_below() -> None:
    made = _told("Robot 1:", "fetch the part", "Robot 2:", "- clean the tank", "charge at 9 am")
    assert _agents(made) == {"fetch the part": 1, "clean the tank": 2, "charge": 2}


def test_a_worker_beyond_the_agents_is_told() -> None:
    made = _told("Robot 2 cleans the tank", "robot 1 docks at 9 am", agents=1)
    assert _agents(made) == {"clean the tank": None, "dock": 1}
    assert notes(made) == ["'Robot 2' is called, and there is one agent here: more can be given"]


def test_names_take_the_agents_that_no_number_takes() -> None:
    made = _told("Anna, wash the dishes", "Robot 1: sweep the floor", "Anna, dry the cups", agents=2)
    assert _agents(made) == {"wash the dishes": 2, "sweep the floor": 1, "dry the cups": 2}
    assert notes(made) == ["'Anna' is taken as agent 2"]


def test_more_names_than_agents_bind_nobody() -> None:
    made = _told("Anna, wash the dishes", "Ben, dry the cups", "Carl, sweep the floor")
    assert set(_agents(made).values()) == {None}
    assert len(notes(made)) == 3


@pytest.mark.parametrize("line", ["Machine 3 starts at 9 am", "Truck 3 arrives at 9 am"])
def test_what_starts_or_arrives_is_not_asked(line: str) -> None:
    (one,) = _told(line).skills
    assert one.skill.agent is None
    assert one.skill.duration == 0
