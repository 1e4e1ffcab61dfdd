"""How far above a bound labels go, and in how much room."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.scheduling.exact.reach import LEAST, PROBING, PROVING, Reach

MEMORY = 1 << 30
costs = st.floats(0.0, 100.0)


def reach(delta: float) -> Reach:
    found = Reach.within(MEMORY, 50, is_solved=False)
    found.delta = delta
    return found


def test_a_threshold_lies_a_little_above_the_bound() -> None:
    assert reach(1.0).threshold(10.0, 20.0, math.inf) == 11.0


def test_it_is_never_above_the_best_schedule() -> None:
    assert reach(15.0).threshold(10.0, 20.0, math.inf) == 20.0


def test_where_a_schedule_of_the_grid_is_known_below_it_the_best_is_the_threshold() -> None:
    assert reach(1.0).threshold(10.0, 20.0, 10.5) == 20.0


def test_what_took_too_much_room_is_not_tried_again_in_the_same_room() -> None:
    mine = reach(8.0)
    while mine.widen():
        mine.delta = 8.0
    assert mine.shorten(18.0, 10.0, 20.0, math.inf)
    assert mine.threshold(10.0, 20.0, math.inf) == 14.0
    mine.prove(patiently=False)
    assert mine.threshold(14.0, 20.0, math.inf) == 16.0
    mine.prove(patiently=False)
    assert mine.threshold(16.0, 20.0, 16.5) == 17.0


def test_more_room_gives_what_failed_another_chance() -> None:
    mine = reach(8.0)
    mine.too_high = 11.0
    assert mine.widen()
    assert mine.threshold(10.0, 20.0, math.inf) == 14.0


def test_labels_that_proved_something_get_more_room_at_once_unless_one_is_patient() -> None:
    hasty, patient = reach(1.0), reach(1.0)
    hasty.prove(patiently=False)
    patient.prove(patiently=True)
    assert (hasty.cells, patient.cells) == (hasty.whole // PROVING, patient.whole // PROBING)
    assert hasty.delta == patient.delta == 2.0


@pytest.mark.parametrize("is_solved", [False, True])
def test_room_grows_to_the_whole_and_no_further(*, is_solved: bool) -> None:
    mine = Reach.within(MEMORY, 50, is_solved=is_solved)
    for _ in range(2):
        mine.widen()
    assert mine.cells == mine.whole == MEMORY // 16
    assert not mine.widen()


@given(lower=costs, gap=st.floats(0.01, 100.0), share=st.floats(0.0, 1.0), known=st.floats(0.0, 1.0))
def test_failing_ends_and_each_threshold_is_lower_than_the_last(
    lower: float, gap: float, share: float, known: float
) -> None:
    best, mine = lower + gap, reach(share * gap)
    tried = [mine.threshold(lower, best, lower + known * gap)]
    while mine.shorten(tried[-1], lower, best, lower + known * gap):
        tried.append(mine.threshold(lower, best, lower + known * gap))
        assert lower < tried[-1] < tried[-2]
        assert len(tried) < 2 + math.log2(1 / LEAST)
