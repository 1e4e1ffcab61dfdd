"""Solving whole tasks: against an independent optimiser, and what a person would expect."""

import math
from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np
import pytest

from fuzzytime.errors import FuzzytimeError, RefusedError
from fuzzytime.satisfaction import ALWAYS, NEVER, Bell, Rectangle, Trapezoid, Triangle
from fuzzytime.scheduling import HeldKarp, Labels, Limits, Status, solve
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.alone import best_alone
from fuzzytime.scheduling.problem.jobs import Problem
from fuzzytime.scheduling.problem.posing import problem_of
from fuzzytime.scheduling.schedule import THRESHOLD
from fuzzytime.scheduling.solver import Draft, nothing
from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask, Precedence
from scheduling.oracle import best_cost
from scheduling.random_tasks import faults, random_far_task, random_task


@pytest.mark.parametrize("block", range(6))
def test_random_tasks_are_solved_as_all_permutations_are(block: int) -> None:
    for seed in range(20 * block, 20 * block + 20):
        task = random_task(seed)
        schedule = solve(task)
        best = best_cost(task, 1e-3)
        assert not faults(schedule), seed
        # The oracle's lattice is not infinitely fine.
        assert best - 1e-3 <= schedule.weighted_cost <= best + 1e-6, seed
        assert schedule.certificate.lower_cost <= best + 1e-9, seed
        assert schedule.certificate.status is Status.OPTIMAL, seed


@pytest.mark.parametrize("block", range(3))
def test_days_that_are_months_apart_are_solved_as_each_day_alone(block: int) -> None:
    for seed in (*range(12 * block, 12 * block + 12), *((106, 117, 127) if not block else ())):
        task, days = random_far_task(seed)
        schedule = solve(task)
        # Later days may also use what lies before their beginning.
        best = math.fsum(best_cost(day, THRESHOLD) for day in days)
        assert not faults(schedule), seed
        assert schedule.certificate.status is Status.OPTIMAL, seed
        assert schedule.weighted_cost <= best + 1e-4 * 2 * len(task.skills), seed
        assert schedule.certificate.lower_cost <= best + 1e-9, seed


def test_two_jobs_at_the_same_time_share_the_loss() -> None:
    wish = Trapezoid(480, 576, 624, 720)
    schedule = solve(FuzzyTask((FuzzySkill("sweep", wish, 300), FuzzySkill("mop", wish, 300))))
    assert list(schedule.order) == [0, 1]
    assert sum(schedule.rejected) == 1


def test_a_skill_that_never_satisfies_is_rejected_and_the_rest_is_planned() -> None:
    task = FuzzyTask((FuzzySkill("flip", NEVER, 60), FuzzySkill("stir", Triangle(0, 60, 120), 30)))
    schedule = solve(task)
    assert list(schedule.rejected) == [True, False]
    assert list(schedule.start_times) == [90, 60]
    assert schedule.satisfaction == pytest.approx(1e-3)
    assert schedule.certificate.status is Status.OPTIMAL


def test_what_comes_too_late_behind_another_is_not_satisfied_however_long_it_would_be() -> None:
    bacon = FuzzySkill("fry the bacon", Rectangle(0, 0), 60)
    work = FuzzySkill("ring the bell", Rectangle(60, 60), 600, priority=2)
    serve = FuzzySkill("serve it", ALWAYS, 60)
    schedule = solve(FuzzyTask((bacon, work, serve), precedences=(Precedence(0, 2, 0, 300),)))
    assert list(schedule.rejected) == [False, False, True]
    assert list(schedule.satisfactions) == [1, 1, 0]
    assert schedule.weighted_cost == pytest.approx(-math.log(THRESHOLD))
    assert schedule.certificate.lower_cost == pytest.approx(-math.log(THRESHOLD))


def test_what_must_follow_closely_what_is_rejected_is_not_satisfied_either() -> None:
    bacon = FuzzySkill("fry the bacon", NEVER, 60)
    serve = FuzzySkill("serve it", ALWAYS, 60)
    eat = FuzzySkill("eat it", ALWAYS, 60)
    order = (Precedence(0, 1, 0, 300), Precedence(1, 2, 0, 300))
    schedule = solve(FuzzyTask((bacon, serve, eat), precedences=order))
    assert list(schedule.rejected) == [True, True, True]
    assert list(solve(FuzzyTask((bacon, serve), precedences=(Precedence(0, 1),))).rejected) == [True, False]


def test_an_event_that_follows_another_is_when_it_must_be() -> None:
    ring = FuzzySkill("the bell rings", Rectangle(2, 2), 0, happens=True)
    stop = FuzzySkill("the music stops", ALWAYS, 0, happens=True)
    assert solve(FuzzyTask((ring, stop), precedences=(Precedence(0, 1, 2, 2),))).start_times == (2, 4)


def test_what_must_follow_a_rejected_skill_is_rejected() -> None:
    task = FuzzyTask(
        (FuzzySkill("fry", NEVER, 60), FuzzySkill("serve", Triangle(0, 60, 120), 30)),
        precedences=(Precedence(0, 1),),
    )
    assert list(solve(task).rejected) == [True, True]


def test_skills_without_a_wish_are_done_at_once_and_in_their_order() -> None:
    task = FuzzyTask(
        (FuzzySkill("a", ALWAYS, 60), FuzzySkill("b", ALWAYS, 30), FuzzySkill("c", Rectangle(70, 75), 10))
    )
    schedule = solve(task)
    assert list(schedule.start_times) == [0, 80, 70]
    assert schedule.satisfaction == 1


def test_no_skill_starts_before_now() -> None:
    schedule = solve(FuzzyTask((FuzzySkill("late already", Trapezoid(-100, -80, -60, 60), 10),)))
    assert list(schedule.start_times) == [0]
    assert list(schedule.satisfactions) == [0.5]


def test_appointments_are_kept_free() -> None:
    wish = Trapezoid(0, 60, 80, 200)
    task = FuzzyTask((FuzzySkill("call", wish, 20),), busy=(Busy(50, 95, "lunch"),))
    schedule = solve(task)
    assert list(schedule.start_times) == [95]
    assert not faults(schedule)


def test_an_empty_task_is_satisfied() -> None:
    schedule = solve(FuzzyTask(()))
    assert schedule.satisfaction == 1
    assert schedule.certificate.status is Status.OPTIMAL


def test_the_strict_product_of_a_clash_is_infeasible() -> None:
    task = FuzzyTask((FuzzySkill("a", Rectangle(10, 12), 5), FuzzySkill("b", Rectangle(10, 12), 5)))
    schedule = solve(task, threshold=0)
    assert schedule.certificate.status is Status.INFEASIBLE
    assert schedule.satisfaction == 0
    assert schedule.certificate.upper_bound == 0


def test_the_strict_product_prefers_many_small_losses_to_a_rejection() -> None:
    wish = Triangle(0, 1, 1000)
    schedule = solve(FuzzyTask(tuple(FuzzySkill(str(k), wish, 120) for k in range(8))), threshold=0)
    assert not any(schedule.rejected)
    assert schedule.certificate.status is Status.OPTIMAL


def test_priority_decides_who_gets_the_better_time() -> None:
    wish = Triangle(0, 100, 200)
    task = FuzzyTask((FuzzySkill("a", wish, 60), FuzzySkill("b", wish, 60, priority=3)))
    schedule = solve(task)
    assert schedule.satisfactions[1] > schedule.satisfactions[0]


@dataclass
class Timed:
    """Notes the size of each group and the share of time that is left for it; may be interrupted at once."""

    name: ClassVar[str] = "timed"

    interrupted: bool = False
    seen: list[tuple[int, float]] = field(default_factory=list)

    def search(self, problem: Problem, watch: Stopwatch, warm: Draft | None = None) -> Draft:
        """Place nothing."""
        self.seen.append((len(problem.jobs), 0.0 if watch.is_over() else watch.remaining))
        if self.interrupted:
            watch.stop()
        return warm or nothing(problem)


def groups(*sizes: int) -> FuzzyTask:
    centres = [1000.0 * group for group, size in enumerate(sizes, 1) for _ in range(size)]
    return FuzzyTask(
        tuple(FuzzySkill(f"skill {i}", Triangle(c - 60, c, c + 60), 30.0) for i, c in enumerate(centres))
    )


def test_groups_that_cannot_meet_share_the_time_and_leave_what_they_do_not_need() -> None:
    solver = Timed()
    solve(groups(5, 3), solver=solver, limits=Limits(seconds=80, clock=lambda: 0.0), objectives=())
    assert solver.seen == [(3, 30.0), (5, 80.0)]


def test_an_interrupt_in_one_group_is_one_for_all() -> None:
    solver = Timed(interrupted=True)
    solve(groups(5, 3), solver=solver, limits=Limits(seconds=80, clock=lambda: 0.0), objectives=())
    assert solver.seen == [(3, 30.0), (5, 0.0)]


def test_out_of_time_the_best_so_far_comes_back_with_its_gap() -> None:
    generator = np.random.default_rng(1)
    skills = tuple(
        FuzzySkill(str(k), Triangle(t - 500, t, t + 500), 100)
        for k, t in enumerate(generator.uniform(500, 1500, 10))
    )
    schedule = solve(FuzzyTask(skills), limits=Limits(seconds=0))
    assert not faults(schedule)
    assert schedule.certificate.lower_cost <= schedule.weighted_cost


@pytest.mark.parametrize("threshold", [-0.1, 1.0, math.nan])
def test_a_threshold_that_is_none_is_refused(threshold: float) -> None:
    with pytest.raises(FuzzytimeError, match="threshold"):
        solve(FuzzyTask(()), threshold=threshold)


def test_a_skill_that_nobody_ever_has_time_for_is_an_error() -> None:
    task = FuzzyTask((FuzzySkill("sleep", ALWAYS, 60),), busy=(Busy(30, math.inf),))
    with pytest.raises(FuzzytimeError, match="sleep"):
        solve(task)


def test_held_karp_says_what_it_cannot_do() -> None:
    skills = tuple(FuzzySkill(str(k), Triangle(0, 50, 100), 10) for k in range(17))
    with pytest.raises(RefusedError, match="17 skills"):
        solve(FuzzyTask(skills), solver=HeldKarp())


def test_the_label_program_says_what_it_cannot_do() -> None:
    skills = tuple(FuzzySkill(str(k), Triangle(0, 50, 100), 10) for k in range(3))
    with pytest.raises(RefusedError, match="one agent, got 2"):
        solve(FuzzyTask(skills, agents=2), solver=Labels())


def test_no_schedule_costs_less_than_each_skill_alone() -> None:
    for seed in range(200, 240):
        task = random_task(seed)
        alone = [best_alone(task, position, 0.0).satisfaction for position in range(len(task.skills))]
        problem = problem_of(task, THRESHOLD)
        least = problem.least_cost + math.fsum(job.rejection for job in problem.apart)
        weights = [skill.priority for skill in task.skills]
        costs = [
            -weight * math.log(max(best, THRESHOLD)) for weight, best in zip(weights, alone, strict=True)
        ]
        # What must wait for another has its best time later than alone.
        assert least >= math.fsum(costs) - 1e-6, seed
        assert least <= solve(task).weighted_cost + 1e-9, seed


def test_what_happens_by_itself_takes_no_agent_and_no_room() -> None:
    leaves = FuzzySkill("the train leaves", Rectangle(900, 900), 0, happens=True)
    paint = FuzzySkill("paint", Triangle(0, 300, 600), 1200)
    wave = FuzzySkill("wave", ALWAYS, 60)
    follows = (Precedence(0, 2, maximum_lag=30.0),)
    alone = solve(FuzzyTask((paint,)))
    schedule = solve(FuzzyTask((leaves, paint)))
    assert schedule.start_times == (900, *alone.start_times)
    assert schedule.certificate.status is Status.OPTIMAL
    assert schedule.satisfaction == pytest.approx(1.0)
    sand = FuzzySkill("sand", Triangle(0, 300, 600), 800)
    after = solve(FuzzyTask((leaves, sand, wave), precedences=follows))
    assert not faults(after)
    assert not any(after.rejected)
    assert after.start_times == pytest.approx((900, 130, 930), abs=1)
    busy = solve(FuzzyTask((leaves,), busy=(Busy(0, 3600),)))
    assert busy.start_times == (900,)


def test_what_happens_at_no_certain_moment_happens_when_it_is_best() -> None:
    rings = FuzzySkill("the bell rings", Triangle(0, 300, 600), 0, happens=True)
    paint = FuzzySkill("paint", Triangle(0, 200, 600), 1200)
    assert solve(FuzzyTask((rings, paint))).start_times == pytest.approx((300, 200))


def test_what_happens_by_itself_has_no_duration() -> None:
    with pytest.raises(FuzzytimeError, match="must take no agent's time, got a duration of 60 s"):
        FuzzySkill("the train leaves", ALWAYS, 60, happens=True)


def test_what_is_pushed_to_the_edge_of_what_satisfies_is_placed_where_what_follows_it_is() -> None:
    # At its edge the bell's own rounding takes it below the threshold.
    first = FuzzySkill("mix the dough", Bell(130, 40, 1), 30.0)
    second = FuzzySkill("bake the bread", Triangle(30, 40, 100), 30.0, priority=100.0)
    schedule = solve(FuzzyTask((first, second), precedences=(Precedence(0, 1),)), threshold=0.1)
    assert float(first.satisfaction(10.0)) <= 0.1
    assert schedule.start_times == pytest.approx((10.0, 40.0))
    assert schedule.rejected == (False, False)
