"""One of several times is enough: the largest satisfaction at every time."""

import copy
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fuzzytime.errors import FuzzytimeError
from fuzzytime.satisfaction import (
    ALWAYS,
    Bell,
    Clipped,
    Either,
    Interval,
    Rectangle,
    SatisfactionFunction,
    Trapezoid,
)
from satisfaction.shapes_of import linear, plain, times

PROBES = np.linspace(-1e5, 1e5, 401)
AROUND = (-1e-3, 0.0, 1e-3)


@given(st.lists(linear, min_size=1, max_size=4), st.lists(times, max_size=8))
def test_it_is_the_largest_everywhere(functions: list[SatisfactionFunction], more: list[float]) -> None:
    either = Either(functions)
    kinks = [kink for function in functions for kink in function.kinks]
    probes = np.concatenate([PROBES, more, *(np.array(kinks) + by for by in AROUND)])
    largest = np.max([function(probes) for function in functions], axis=0)
    assert either(probes) == pytest.approx(largest, abs=1e-9)


@given(st.lists(plain, min_size=1, max_size=3))
def test_what_is_curved_stands_in_it_within_the_tolerance(functions: list[SatisfactionFunction]) -> None:
    kinks = np.array([kink for function in functions for kink in function.kinks])
    probes = PROBES[np.abs(PROBES[:, None] - kinks).min(axis=1) > 1e-6]
    largest = np.max([function(probes) for function in functions], axis=0)
    assert Either(functions)(probes) == pytest.approx(largest, abs=2e-4)


def test_where_two_cross_is_a_kink() -> None:
    either = Either([Trapezoid(0, 10, 10, 20), Trapezoid(10, 20, 20, 30)])
    assert list(either.kinks) == [0, 10, 15, 20, 30]
    assert either(15) == 0.5


def test_open_sides_stay_open_and_moments_stay_moments() -> None:
    either = Either([Trapezoid(-math.inf, -math.inf, 9, 9), Rectangle(12, 12), ALWAYS.shifted(17)])
    assert either([-1e9, 9, 9.5, 12, 12.5, 17, 1e9]).tolist() == [1, 1, 0, 1, 0, 1, 1]
    assert either.support == Interval(-math.inf, math.inf)
    assert either.best == Interval(-math.inf, 9)


def test_it_is_a_value() -> None:
    either = Either([Rectangle(0, 1), Bell(5, 1, 2)])
    assert either == copy.copy(either) == Either([Rectangle(0, 1), Bell(5, 1, 2)])
    assert hash(either) == hash(Either(either.functions))
    assert repr(either) == "Either([Rectangle(start=0, end=1), Bell(centre=5, width=1, slope=2)])"
    assert either != Either([Rectangle(0, 1)])
    lists = either.parameters
    assert isinstance(lists["times"], list)
    assert lists["before"] == lists["after"] == 0
    with pytest.raises(AttributeError, match="does not change"):
        either.functions = ()


def test_one_is_needed_at_least_and_what_is_curved_must_end() -> None:
    with pytest.raises(FuzzytimeError, match="needs at least one"):
        Either([])
    with pytest.raises(FuzzytimeError, match="a finite interval"):
        Either([Clipped(ALWAYS, Interval(5, math.inf))])
