"""Stretches: valid schedules that are never worse, with all that stands still left in its place."""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fuzzytime.satisfaction import Triangle
from fuzzytime.scheduling import Auto, LocalSearch, solve
from fuzzytime.scheduling.bound import refinement
from fuzzytime.scheduling.exact import threshold
from fuzzytime.scheduling.limits import Limits, Stopwatch
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.problem.posing import problem_of
from fuzzytime.scheduling.search.parts import part_of
from fuzzytime.scheduling.search.stretches import Stretches
from fuzzytime.scheduling.solver import Draft, draft_of, nothing
from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask, Precedence
from scheduling.checks import FAMILIES, wrong
from scheduling.random_tasks import faults, random_task


def exactly(part: Problem, _: list[int], watch: Stopwatch, warm: Draft) -> Draft:
    return Auto().search(part, watch, warm)


@dataclass(frozen=True)
class InStretches:
    """Local search, if any, and stretches of three."""

    name: ClassVar[str] = "in stretches"

    begins: bool = True

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Improve what local search begins with."""
        begun = LocalSearch(sweeps=1).search(problem, watch, warm) if self.begins else nothing(problem)
        found = Stretches(exactly, length=3, rejected=2).improve(problem, watch, begun)
        assert found.cost <= begun.cost
        return found


@pytest.mark.parametrize("begins", [True, False])
@settings(max_examples=60, deadline=None)
@given(seed=st.integers(0, 100_000))
def test_a_schedule_made_in_stretches_is_valid_and_never_better_than_the_exact_one(
    seed: int, *, begins: bool
) -> None:
    task = random_task(seed, most=6)
    exact, found = solve(task, objectives=()), solve(task, solver=InStretches(begins), objectives=())
    assert not faults(found)
    assert found.weighted_cost >= exact.certificate.lower_cost - 1e-6


def test_a_stretch_as_long_as_all_is_solved_exactly() -> None:
    centres = np.random.default_rng(3).uniform(60, 240, 8).tolist()
    task = FuzzyTask(tuple(FuzzySkill(f"skill {c}", Triangle(c - 90, c, c + 90), 40.0) for c in centres))
    problem, watch = problem_of(task, 0.001), Stopwatch(Limits())
    (members,) = problem.groups()
    group = problem.select(members)
    found = Stretches(exactly, length=8, rejected=8).improve(group, watch, nothing(group))
    found = Stretches(exactly, length=8, rejected=8).improve(group, watch, found)
    assert found.cost == pytest.approx(Auto().search(group, watch).cost, abs=1e-6)


def test_an_interrupt_ends_with_the_best_so_far() -> None:
    def interrupted(part: Problem, members: list[int], watch: Stopwatch, warm: Draft) -> Draft:
        if len(done) == 2:
            raise KeyboardInterrupt
        done.append(members)
        return exactly(part, members, watch, warm)

    done: list[list[int]] = []
    problem, watch = row(100, 105, 200, 205, 300, 305), Stopwatch(Limits())
    begun = draft_of(problem, np.array([90.0, 125.0, 190.0, 225.0, 290.0, 325.0]), np.ones(6, np.int64))
    found = Stretches(interrupted, length=2, rejected=2).improve(problem, watch, begun)
    assert watch.is_over()
    assert (found.starts != begun.starts).tolist() == [True, True, True, True, False, False]
    assert found.cost < begun.cost


def row(*centres: float, agents: int = 1, **others: tuple[object, ...]) -> Problem:
    """Skills of 10 s, each wished for within 30 s of a moment."""
    skills = tuple(FuzzySkill(f"skill {c}", Triangle(c - 30, c, c + 30), 10.0) for c in centres)
    return problem_of(FuzzyTask(skills, agents=agents, **others), 0.0)  # type: ignore[arg-type]


def room(part: Problem) -> list[tuple[float, float]]:
    return [(job.earliest, job.latest) for job in part.jobs]


def test_a_part_has_the_room_between_what_stands_still() -> None:
    problem = row(100, 110, 120, 130)
    draft = draft_of(problem, np.array([100.0, 110.0, 125.0, 140.0]), np.ones(4, np.int64))
    members, part = part_of(problem, draft, [1, 2], rejected=5)
    assert members == [1, 2]
    assert [(job.earliest, job.latest) for job in part.jobs] == [(110.0, 130.0), (110.0, 130.0)]


def test_each_agent_has_its_own_room_in_a_part() -> None:
    problem = row(100, 105, 110, 115, agents=2, busy=(Busy(0.0, 108.0, agent=2),))
    draft = draft_of(problem, np.array([90.0, 108.0, 118.0, 105.0]), np.array([1, 2, 2, 1]))
    members, part = part_of(problem, draft, [1, 3], rejected=5)
    assert members == [1, 3]
    windows = [(span.low, span.high) for lane in part.jobs[0].windows for span in lane]
    assert windows == [pytest.approx((100, 135)), pytest.approx((108, 108))]


def test_a_part_keeps_lags_to_what_stands_still() -> None:
    problem = row(100, 120, 140, precedences=(Precedence(0, 1, 5.0, 20.0), Precedence(1, 2, 8.0, math.inf)))
    draft = draft_of(problem, np.array([95.0, 110.0, 140.0]), np.ones(3, np.int64))
    _, part = part_of(problem, draft, [1], rejected=5)
    assert (part.jobs[0].earliest, part.jobs[0].latest) == (110.0, 122.0)


def test_a_skill_comes_in_only_with_what_must_come_before_it() -> None:
    problem = row(100, 200, precedences=(Precedence(0, 1, 0.0, math.inf),))
    rejecting = nothing(problem)
    assert part_of(problem, rejecting, [], rejected=2)[0] in ([0, 1], [1, 0])
    assert part_of(problem, rejecting, [], rejected=1)[0] in ([0], [])


def test_a_rejected_skill_comes_in_with_the_one_that_it_waits_for() -> None:
    problem = row(100, 110, 120, precedences=(Precedence(2, 0, 0.0, math.inf),))
    draft = draft_of(problem, np.array([math.nan, 110.0, 149.0]), np.ones(3, np.int64))
    assert part_of(problem, draft, [1], rejected=1)[0] == [1]
    members, part = part_of(problem, draft, [1], rejected=2)
    assert members == [1, 0, 2]
    assert room(part) == [pytest.approx(span) for span in ((80, 140), (100, 130), (90, 150))]


def test_a_day_of_one_agent_has_room_between_what_the_agent_does_not_move() -> None:
    problem = row(100, 105, 110, 115, agents=2)
    draft = draft_of(problem, np.array([100.0, 105.0, 110.0, math.nan]), np.array([1, 2, 1, 1]))
    members, part = part_of(problem, draft, [1], rejected=9, agents=[2])
    assert members == [1, 3]
    assert [lane.agents for lane in part.lanes] == [(2,)]
    assert room(part) == [pytest.approx(span) for span in ((75, 135), (85, 145))]


def test_a_day_does_not_take_from_others_what_a_skill_waits_for() -> None:
    problem = row(100, 110, 120, agents=2, precedences=(Precedence(2, 0, 0.0, math.inf),))
    draft = draft_of(problem, np.array([math.nan, 110.0, 149.0]), np.array([1, 1, 2]))
    assert part_of(problem, draft, [1], rejected=9, agents=[1])[0] == [1]
    assert part_of(problem, draft, [1], rejected=9)[0] == [1, 0, 2]


@pytest.mark.parametrize("seed", range(700, 730))
def test_what_is_proved_with_stretches_holds_beside_an_independent_optimiser(
    seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name, value in {"MANY": 2, "MOST_TOGETHER": 2, "STRETCH": 3, "REJECTED": 2}.items():
        monkeypatch.setattr(threshold, name, value)
    monkeypatch.setattr(refinement, "DOUBTFUL", 0.0)
    assert not list(wrong(FAMILIES["one agent, labels"], seed))


def test_many_skills_are_searched_in_stretches(monkeypatch: pytest.MonkeyPatch) -> None:
    rounds: list[float] = []
    improve = Stretches.improve

    def noting(self: Stretches, problem: Problem, watch: Stopwatch, best: Draft) -> Draft:
        found = improve(self, problem, watch, best)
        rounds.append(best.cost - found.cost)
        return found

    monkeypatch.setattr(Stretches, "improve", noting)
    monkeypatch.setattr(threshold, "MANY", 20)
    monkeypatch.setattr(threshold, "MOST_TOGETHER", 20)
    monkeypatch.setattr(refinement, "DOUBTFUL", 0.0)
    generator = np.random.default_rng(5)
    centres, durations = generator.uniform(60, 900, 40).tolist(), generator.integers(10, 60, 40).tolist()
    wishes = [Triangle(centre - 120, centre, centre + 120) for centre in centres]
    skills = [FuzzySkill(f"skill {k}", wishes[k], float(durations[k])) for k in range(40)]
    task = FuzzyTask(tuple(skills))
    schedule = solve(task)
    assert not faults(schedule)
    assert rounds
    assert min(rounds) >= 0
