"""A smallest set of skills that cannot all be satisfied."""

import itertools

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fuzzytime.satisfaction import ALWAYS, NEVER, Rectangle, SatisfactionFunction, Triangle
from fuzzytime.scheduling import HillClimbing, Limits, Status, solve
from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask, Precedence
from scheduling.checks import wrong_if_strict
from scheduling.random_closeness import random_endless_task
from scheduling.random_tasks import LAST, random_bound_task


def task_of(*skills: tuple[SatisfactionFunction, float], **given: object) -> FuzzyTask:
    made = tuple(FuzzySkill(f"skill {k}", function, d) for k, (function, d) in enumerate(skills))
    return FuzzyTask(made, **given)  # type: ignore[arg-type]


def clash_of(task: FuzzyTask) -> tuple[int, ...]:
    schedule = solve(task, threshold=0)
    assert (schedule.certificate.status is Status.INFEASIBLE) == bool(schedule.clash)
    return schedule.clash


def test_a_task_that_can_be_done_has_no_clash() -> None:
    assert clash_of(task_of((Triangle(0, 10, 20), 5), (Triangle(0, 10, 20), 5))) == ()


def test_two_that_want_one_moment_exclude_each_other() -> None:
    far = (Triangle(500, 510, 520), 5.0)
    assert clash_of(task_of(far, (Rectangle(10, 12), 5), far, (Rectangle(11, 13), 5))) == (1, 3)


def test_one_that_can_never_be_satisfied_is_a_clash_of_its_own() -> None:
    assert clash_of(task_of((Rectangle(10, 12), 5), (NEVER, 5), (Rectangle(11, 13), 5))) == (1,)


def test_an_appointment_can_make_one_impossible() -> None:
    assert clash_of(task_of((Rectangle(10, 20), 5), busy=(Busy(0, 30),))) == (0,)


def test_three_may_clash_of_which_any_two_can_be_had() -> None:
    one = (Rectangle(0, 10), 6.0)
    assert clash_of(task_of(one, (ALWAYS, 5), one, (Rectangle(0, 9), 6.0))) == (0, 2, 3)


def test_an_order_can_be_what_clashes() -> None:
    task = task_of((Rectangle(50, 60), 5), (Rectangle(0, 40), 5), precedences=(Precedence(0, 1),))
    assert clash_of(task) == (0, 1)


def test_of_two_agents_three_can_clash() -> None:
    one = (Rectangle(0, 3), 6.0)
    assert clash_of(task_of(one, one, (ALWAYS, 9), one, agents=2)) == (0, 1, 3)


def test_a_lag_can_be_what_clashes() -> None:
    task = task_of(
        (Rectangle(0, 5), 5),
        (Rectangle(0, 90), 5),
        (Rectangle(30, 40), 5),
        precedences=(Precedence(0, 2, 60),),
    )
    assert clash_of(task) == (0, 2)


def test_an_event_during_work_clashes_with_nothing() -> None:
    event = FuzzySkill("the bell rings", Rectangle(5, 5), 0, happens=True)
    work = [FuzzySkill(f"skill {k}", Rectangle(0, 2), 10) for k in range(3)]
    assert clash_of(FuzzyTask((event, work[0]), busy=(Busy(4, 6),))) == (1,)
    assert clash_of(FuzzyTask((event, *work))) == (1, 2)


def test_a_method_without_a_bound_still_proves_a_clash() -> None:
    task = task_of((Rectangle(10, 12), 5), (Rectangle(11, 13), 5))
    assert solve(task, solver=HillClimbing(), threshold=0).certificate.status is Status.INFEASIBLE


def test_what_touches_only_where_nothing_satisfies_clashes() -> None:
    assert clash_of(task_of((Triangle(0, 10, 20), 20), (Triangle(0, 10, 20), 20))) == (0, 1)


@pytest.mark.parametrize("seed", [*range(20), 35, 41, 100])
def test_of_random_tasks_a_clash_cannot_be_had_and_nothing_in_it_is_superfluous(seed: int) -> None:
    for draw, last in ((random_bound_task, LAST), (random_endless_task, 40)):
        assert not list(wrong_if_strict(draw(seed), last))


def test_without_time_no_clash_is_claimed() -> None:
    task = task_of((Rectangle(10, 12), 5), (Rectangle(11, 13), 5))
    assert solve(task, threshold=0, limits=Limits(seconds=0)).clash in {(), (0, 1)}


def test_among_many_the_two_that_clash_are_found() -> None:
    skills = [(Rectangle(100.0 * k, 100.0 * k + 60), 30.0) for k in range(40)]
    assert clash_of(task_of(*skills, (Rectangle(1510, 1515), 60.0))) == (15, 40)


def fits(task: FuzzyTask, order: tuple[int, ...]) -> bool:
    free = 0.0
    for position in order:
        function = task.skills[position].satisfaction
        assert isinstance(function, Rectangle)
        start = max(free, function.start)
        if start > function.end:
            return False
        free = start + task.skills[position].duration
    return True


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 100_000))
def test_a_clash_is_as_small_as_trying_all_sets_finds(seed: int) -> None:
    generator = np.random.default_rng(seed)
    count = int(generator.integers(2, 6))
    starts, widths = generator.integers(0, 40, count), generator.integers(0, 25, count)
    durations = generator.integers(1, 15, count).tolist()
    task = task_of(
        *(
            (Rectangle(float(start), float(start + width)), float(duration))
            for start, width, duration in zip(starts.tolist(), widths.tolist(), durations, strict=True)
        )
    )
    impossible = [
        members
        for size in range(1, count + 1)
        for members in itertools.combinations(range(count), size)
        if not any(fits(task, order) for order in itertools.permutations(members))
    ]
    clash = clash_of(task)
    assert len(clash) == (len(impossible[0]) if impossible else 0)
    assert not clash or clash in impossible


@pytest.mark.parametrize("threshold", [0.001, 0.2])
def test_with_a_threshold_there_is_no_clash(threshold: float) -> None:
    task = task_of((Rectangle(10, 12), 5), (Rectangle(11, 13), 5))
    schedule = solve(task, threshold=threshold)
    assert schedule.clash == ()
    assert schedule.certificate.status is Status.OPTIMAL
