"""Windows beside busy times, moment by moment."""

from itertools import pairwise

from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.satisfaction import Interval
from fuzzytime.scheduling.problem.windows import free_of, in_common

MOMENTS = st.lists(st.integers(0, 30), max_size=10)


def row(moments: list[int]) -> tuple[Interval, ...]:
    ascending = sorted(moments)
    return tuple(Interval(low, high) for low, high in zip(ascending[::2], ascending[1::2], strict=False))


@given(MOMENTS, st.lists(st.tuples(st.integers(0, 30), st.integers(0, 9)), max_size=5), st.integers(0, 5))
def test_a_start_is_free_where_nothing_is_being_done(
    moments: list[int], busy: list[tuple[int, int]], duration: int
) -> None:
    wanted, taken = row(moments), tuple(Interval(low, low + length) for low, length in busy)
    free = free_of(wanted, taken, duration)
    for quarter in range(-4, 170):
        moment = quarter / 4
        at_work = any(one.low - duration < moment < one.high for one in taken)
        assert any(moment in span for span in free) == (
            not at_work and any(moment in span for span in wanted)
        )
    assert all(before.high <= after.low for before, after in pairwise(free))


@given(MOMENTS, MOMENTS)
def test_rows_have_in_common_what_lies_in_both(one: list[int], other: list[int]) -> None:
    common = in_common(row(one), row(other))
    for half in range(62):
        moment = half / 2
        assert any(moment in span for span in common) == all(
            any(moment in span for span in spans) for spans in (row(one), row(other))
        )
