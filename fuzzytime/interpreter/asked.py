"""Who is asked: of several agents, "robot 2" is the second, and each name that is called is one of them."""

from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.interpreter.interpretation import Interpreted, Problem, ProblemKind
from fuzzytime.interpreter.remarks import problem_of
from fuzzytime.interpreter.request import Request


def by_agents(skills: Sequence[Interpreted], request: Request) -> tuple[list[Interpreted], list[Problem]]:
    """Give skills to the agents that their words call, and say who is taken for which, and who for none."""
    called: dict[str, Interpreted] = {}
    for one in skills:
        if (name := _called(one)) is not None:
            called.setdefault(name.lower(), one)
    agents = _agents(list(called), request.agents)
    problems = []
    for name, one in called.items():
        agent, number = agents.get(name), _number(name)
        told = one.operation.addressee if one.operation is not None else name
        if agent is None and (number is not None or request.agents > 1):
            message = f"{told!r} is called, and there {_counted(request.agents)} here: more can be given"
            problems.append(problem_of(one.wish, ProblemKind.NOTE, message, identifier=one.identifier))
        elif agent is not None and number is None:
            message = f"{told!r} is taken as agent {agent}"
            problems.append(problem_of(one.wish, ProblemKind.NOTE, message, identifier=one.identifier))
    given = []
    for one in skills:
        agent = agents.get((_called(one) or "").lower())
        free = one.skill.agent is None and agent is not None
        given.append(replace(one, skill=replace(one.skill, agent=agent)) if free else one)
    return given, problems


def _called(one: Interpreted) -> str | None:
    """Give who is asked for a skill, and not by what agent the wish says."""
    operation = one.operation
    return None if operation is None or operation.stated or one.wish.agent else operation.addressee


def _agents(names: Sequence[str], count: int) -> dict[str, int]:
    """Give the agent of each name: a numbered one by its number, the others those that are left, in order.

    One agent, and fewer agents than names, need no names.
    """
    numbered = {name: number for name in names if (number := _number(name)) is not None}
    agents = {name: number for name, number in numbered.items() if 1 <= number <= count}
    others = [name for name in names if name not in numbered]
    left = [agent for agent in range(1, count + 1) if agent not in agents.values()]
    if count > 1 and len(others) <= len(left):
        agents |= dict(zip(others, left, strict=False))
    return agents


def _number(name: str) -> int | None:
    last = name.rpartition(" ")[2]
    return int(last) if last.isdecimal() else None


def _counted(agents: int) -> str:
    return "is one agent" if agents == 1 else f"are {agents} agents"
