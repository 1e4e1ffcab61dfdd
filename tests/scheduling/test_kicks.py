"""Kicks of a rough plan: what they may lose on their way, and what they leave."""

import math

import numpy as np
import pytest

from fuzzytime.satisfaction import Trapezoid
from fuzzytime.scheduling import Limits
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.grid import grid_of, step_for
from fuzzytime.scheduling.problem.posing import problem_of
from fuzzytime.scheduling.search import kicks
from fuzzytime.scheduling.search.rough import Rough
from fuzzytime.scheduling.solver import nothing
from fuzzytime.skills import FuzzySkill, FuzzyTask


def crowded(count: int, seed: int, agents: int = 1) -> FuzzyTask:
    """Skills around three rush hours, of which not all can be done."""
    generator = np.random.default_rng(seed)
    rushes = generator.choice([0.2, 0.5, 0.8], count) * count * 60
    skills = []
    for number, rush in enumerate(rushes):
        corners = np.sort(rush + generator.uniform(-300, 300, 4)) + 300
        skills.append(FuzzySkill(f"skill {number}", Trapezoid(*corners.tolist()), generator.uniform(20, 120)))
    return FuzzyTask(tuple(skills), agents)


def plan_of(task: FuzzyTask, watch: Stopwatch) -> Rough:
    """Place the skills by single moves."""
    problem = problem_of(task, 1e-3)
    plan = Rough(problem, grid_of(problem, step_for(problem, 600)), nothing(problem))
    plan.improve(watch, np.random.default_rng(0), math.inf)
    return plan


def cost_of(plan: Rough) -> float:
    """Give what is lost less the rejection of all."""
    return math.fsum(
        curve.gains[plan.slots[job] - curve.first]
        for job, curves in enumerate(plan.grid.curves)
        if plan.placed[job]
        for curve in [curves[plan.lanes[plan.agents[job]]]]
    )


@pytest.mark.parametrize("agents", [1, 2])
@pytest.mark.parametrize("seed", range(3))
def test_a_plan_is_left_as_it_was_at_its_best(
    seed: int, agents: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(kicks, "HOT", 100.0)
    monkeypatch.setattr(kicks, "COLD", 100.0)
    watch = Stopwatch(Limits(seconds=600))
    plan = plan_of(crowded(40, seed, agents), watch)
    before = cost_of(plan)
    kicks.kick(plan, 60, watch, np.random.default_rng(seed))
    assert cost_of(plan) <= before + 1e-9


def test_what_loses_on_the_way_gains_in_the_end(monkeypatch: pytest.MonkeyPatch) -> None:
    watch = Stopwatch(Limits(seconds=600))
    tasks = [crowded(70, seed) for seed in range(3)]

    def kicked() -> float:
        plans = [plan_of(task, watch) for task in tasks]
        for plan in plans:
            kicks.kick(plan, 300, watch, np.random.default_rng(1))
        return math.fsum(map(cost_of, plans))

    warm = kicked()
    monkeypatch.setattr(kicks, "HOT", 1e-9)
    monkeypatch.setattr(kicks, "COLD", 1e-9)
    assert warm < kicked() - 0.1


def test_nothing_moves_when_time_is_over() -> None:
    plan = plan_of(crowded(40, 0), Stopwatch(Limits(seconds=600)))
    state = plan.state()
    kicks.kick(plan, 100, Stopwatch(Limits(seconds=0)), np.random.default_rng(0))
    assert plan.state() == state
