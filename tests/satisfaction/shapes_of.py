"""Strategies that draw satisfaction functions of every shape."""

import math

from hypothesis import strategies as st

from fuzzytime.satisfaction import (
    Bell,
    Clipped,
    Either,
    Floored,
    Interval,
    Rectangle,
    Sampled,
    SatisfactionFunction,
    Trapezoid,
    Triangle,
)

times = st.floats(-1e5, 1e5).map(lambda value: round(value, 3))
levels = st.floats(0, 1).map(lambda value: round(value, 4))


def _ascending(count: int) -> st.SearchStrategy[list[float]]:
    return st.lists(times, min_size=count, max_size=count).map(sorted)


@st.composite
def _points(draw: st.DrawFn) -> Sampled:
    at = draw(st.lists(times, min_size=1, max_size=12, unique=True).map(sorted))
    values = draw(st.lists(levels, min_size=len(at), max_size=len(at)))
    if draw(st.booleans()):  # a jump: two points at one time
        middle = len(at) // 2
        at, values = (
            [*at[: middle + 1], *at[middle:]],
            [*values[: middle + 1], draw(levels), *values[middle + 1 :]],
        )
    return Sampled(at, values)


trapezoids = _ascending(4).map(lambda corners: Trapezoid(*corners))
points = _points()
bells = st.builds(Bell, times, st.floats(0.5, 1e4), st.floats(0.3, 6))
linear: st.SearchStrategy[SatisfactionFunction] = st.one_of(
    trapezoids,
    _ascending(3).map(lambda corners: Triangle(*corners)),
    _ascending(2).map(lambda corners: Rectangle(*corners)),
    points,
)
plain: st.SearchStrategy[SatisfactionFunction] = st.one_of(linear, bells)
windows = st.one_of(
    _ascending(2).map(lambda ends: Interval(*ends)),
    times.map(lambda time: Interval(time, math.inf)),
    times.map(lambda time: Interval(-math.inf, time)),
)
clipped = st.builds(Clipped, plain, windows)
eithers = st.lists(plain, min_size=1, max_size=3).map(Either)
functions: st.SearchStrategy[SatisfactionFunction] = st.one_of(
    plain, clipped, eithers, st.builds(Floored, plain, st.floats(1e-4, 1.0))
)
