"""Why each skill starts when it does."""

import itertools
import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fuzzytime.satisfaction import ALWAYS, Interval, Rectangle, Sampled, Trapezoid, Triangle
from fuzzytime.scheduling import Bond, Limits, elsewhere, explain, solve
from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask, Precedence
from scheduling.random_tasks import random_task

WISH = Triangle(60, 120, 180)


def test_a_skill_that_has_its_best_time_lost_nothing() -> None:
    (why,) = explain(solve(FuzzyTask((FuzzySkill("flip", WISH, 30),))))
    assert (why.alone, why.lost, why.neighbours, why.alternative) == (1, 0, (), None)


def test_the_weaker_of_two_wishes_for_the_same_minutes_lost_to_the_stronger() -> None:
    task = FuzzyTask((FuzzySkill("flip", WISH, 30, priority=2), FuzzySkill("pour", WISH, 30)))
    first, second = explain(solve(task))
    assert first.lost < second.lost
    (neighbour,) = second.neighbours
    assert (neighbour.position, neighbour.bond) == (0, Bond.OVERLAP)
    assert second.alternative is not None
    assert second.alternative.satisfactions[1] == pytest.approx(1)
    assert neighbour.instead == pytest.approx(second.alternative.satisfactions[0])


def test_a_skill_lost_to_the_end_of_a_chain_that_would_have_to_make_room() -> None:
    # What is at work in its minutes could move on at no cost, were there not one more behind it.
    task = FuzzyTask(
        (
            FuzzySkill("flip", Rectangle(100, 110), 30),
            FuzzySkill("stir", Trapezoid(60, 80, 200, 210), 60),
            FuzzySkill("serve", Triangle(180, 190, 200), 30, priority=3),
            FuzzySkill("pour", Triangle(40, 130, 160), 30),
        )
    )
    schedule = solve(task)
    why = explain(schedule)[3]
    assert why.lost > 0.1
    assert {neighbour.position for neighbour in why.neighbours} <= {0, 1, 2}
    assert all(neighbour.loss > 0 for neighbour in why.neighbours)


def test_who_must_wait_for_another_lost_to_that_one() -> None:
    task = FuzzyTask(
        (FuzzySkill("boil", Rectangle(100, 120), 10, elapsed=60), FuzzySkill("peel", WISH, 10)),
        precedences=(Precedence(0, 1),),
    )
    why = explain(solve(task))[1]
    assert [(neighbour.position, neighbour.bond) for neighbour in why.neighbours] == [(0, Bond.ORDER)]
    assert why.neighbours[0].instead is None
    assert why.alternative is None


def test_an_appointment_at_the_best_time_is_named() -> None:
    lunch, later = Busy(100, 140, "lunch"), Busy(500, 600, "call")
    (why,) = explain(solve(FuzzyTask((FuzzySkill("flip", WISH, 30),), busy=(lunch, later))))
    assert why.appointments == (lunch,)
    assert why.lost == 0
    assert why.ideal == 1
    assert why.alone == pytest.approx(2 / 3)


def test_what_came_too_late_could_once_have_been_better() -> None:
    (why,) = explain(solve(FuzzyTask((FuzzySkill("flip", WISH.shifted(-150), 30),))))
    assert why.ideal == 1
    assert why.alone == pytest.approx(0.5)
    assert why.appointments == ()


def test_with_a_second_agent_nothing_is_lost() -> None:
    skills = (FuzzySkill("flip", WISH, 30), FuzzySkill("pour", WISH, 30))
    assert [why.lost for why in explain(solve(FuzzyTask(skills, agents=2)))] == [0, 0]


def test_a_rejected_skill_could_be_done_at_the_cost_of_another() -> None:
    skills = (
        FuzzySkill("flip", Rectangle(60, 60), 30, priority=2),
        FuzzySkill("pour", Rectangle(70, 70), 30),
    )
    schedule = solve(FuzzyTask(skills))
    why = explain(schedule)[1]
    assert list(schedule.rejected) == [False, True]
    assert why.alternative is not None
    assert list(why.alternative.satisfactions) == [0, 1]
    assert why.neighbours[0].position == 0


def test_a_minute_that_nobody_is_free_for_has_no_price() -> None:
    schedule = solve(FuzzyTask((FuzzySkill("flip", WISH, 30),), busy=(Busy(150, 300),)))
    assert elsewhere(schedule, 0, Interval(180, 180)) is None
    assert elsewhere(schedule, 0, Interval(-10, -5)) is None


def test_what_stands_far_off_stays_there() -> None:
    skills = [FuzzySkill(f"skill {k}", Triangle(100 * k, 100 * k + 50, 100 * k + 100), 40) for k in range(30)]
    schedule = solve(FuzzyTask((*skills, FuzzySkill("wash", ALWAYS, 10))))
    found = elsewhere(schedule, 3, Interval(390, 390))
    assert found is not None
    assert found.satisfactions[3] < 0.25
    assert found.satisfactions[20:] == schedule.satisfactions[20:]


def test_out_of_time_those_in_the_way_are_named_without_what_they_would_lose() -> None:
    task = FuzzyTask((FuzzySkill("flip", WISH, 30, priority=2), FuzzySkill("pour", WISH, 30)))
    schedule = solve(task)
    times = itertools.chain([0.0] * 5, itertools.repeat(9.0))
    why = explain(schedule, [1], limits=Limits(seconds=10, clock=lambda: next(times)))[0]
    assert why.alternative is None
    assert [(neighbour.position, neighbour.instead) for neighbour in why.neighbours] == [(0, None)]
    nothing = explain(schedule, [1], limits=Limits(seconds=0))[0]
    assert (nothing.sought, nothing.neighbours, why.sought) == (False, (), True)
    assert nothing.lost == why.lost


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 100_000))
def test_no_other_time_is_better_than_a_proved_schedule(seed: int) -> None:
    schedule = solve(random_task(seed))
    for why in explain(schedule):
        assert why.satisfaction <= why.alone + 1e-9
        if why.alternative is not None:
            assert why.alternative.cost >= schedule.weighted_cost - 1e-3
            assert why.alternative.satisfactions[why.position] == pytest.approx(why.alone, rel=1e-6)
    later = elsewhere(schedule, 0, Interval(schedule.start_times[0] + 10, schedule.start_times[0] + 10))
    assert later is None or any(schedule.rejected) or later.cost >= schedule.weighted_cost - 1e-3


def test_what_is_never_satisfied_enough_lost_nothing_and_what_follows_lost_to_it() -> None:
    faint = FuzzySkill("flip", Sampled([0, 10, 20], [0, 0.3, 0]), 5)
    serve = FuzzySkill("serve", Rectangle(0, 60), 5)
    first, second = explain(solve(FuzzyTask((faint, serve), precedences=(Precedence(0, 1),)), threshold=0.4))
    assert second.lost == 1
    assert [(one.position, one.bond) for one in second.neighbours] == [(0, Bond.ORDER)]
    assert (first.alone, first.lost, first.neighbours, first.alternative) == (0.3, 0, (), None)


def test_the_best_time_is_none_where_it_would_be_too_late_behind_another() -> None:
    fry = FuzzySkill("fry", Rectangle(0, 0), 10)
    serve = FuzzySkill("serve", Trapezoid(0, 40, math.inf, math.inf), 5)
    schedule = solve(FuzzyTask((fry, serve), precedences=(Precedence(0, 1, 0, 5),)))
    (why,) = explain(schedule, [1])
    assert (why.satisfaction, why.alone) == (0.375, 1)
    assert why.alternative is None
    assert [(one.position, one.bond) for one in why.neighbours] == [(0, Bond.ORDER)]


def test_an_appointment_without_length_takes_nothing() -> None:
    task = FuzzyTask((FuzzySkill("flip", WISH, 30),), busy=(Busy(130, 130),))
    (why,) = explain(solve(task))
    assert (why.satisfaction, why.alone, why.appointments) == (1, 1, ())


def test_what_comes_after_a_skill_moves_along_with_it() -> None:
    stir = FuzzySkill("stir", Trapezoid(0, 300, 900, 1500), 60, preferred=600)
    table = FuzzySkill("set the table", Rectangle(0, 2458), 300)
    schedule = solve(FuzzyTask((stir, table), precedences=(Precedence(0, 1),)))
    for start in (540.0, 660.0):
        other = elsewhere(schedule, 0, Interval(start, start))
        assert other is not None
        assert other.satisfactions == (1, 1)


def test_a_minute_that_no_other_needs_costs_nothing() -> None:
    # "Feed the cat in 20 minutes, then water the plants", "make dinner at two", "call mum in ten minutes"
    call = FuzzySkill("call", Trapezoid(0, 300, 900, 1200), duration=600)
    feed = FuzzySkill("feed", Triangle(900, 1200, 1500), duration=120)
    water = FuzzySkill("water", ALWAYS, duration=360)
    dinner = FuzzySkill("dinner", Triangle(17400, 18000, 18600), duration=1800)
    made = solve(FuzzyTask((call, feed, water, dinner), precedences=(Precedence(1, 2),)))
    for later in (60, 300):
        found = elsewhere(made, 0, Interval(made.start_times[0] + later, made.start_times[0] + later))
        assert found is not None
        assert found.product == pytest.approx(1)
