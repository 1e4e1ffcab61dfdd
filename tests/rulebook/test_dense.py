"""Conditions hold as far as their definition says, whatever they are made of and however readings lie."""

import math
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from fuzzytime.context import Context, Reading
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.rulebook import Rulebook
from fuzzytime.rulebook.logic.formula import And, Direction, Formula, Is, Not, Operator, Or, Window, nodes
from fuzzytime.rulebook.over_time.grid import Grid
from fuzzytime.rulebook.over_time.truth import trace
from fuzzytime.rulebook.over_time.world import World
from fuzzytime.rulebook.resolving.inference import holds_now
from rulebook.books import book
from rulebook.dense import Corners, Dense

MAX_GAP = 30.0
TERMS: Mapping[str, Corners] = {
    "low": (-math.inf, -math.inf, 20.0, 60.0),
    "middle": (10.0, 40.0, 60.0, 90.0),
    "high": (40.0, 80.0, math.inf, math.inf),
}
SHAPES = "low: {falling: [20, 60]}, middle: {trapezoid: [10, 40, 60, 90]}, high: {rising: [40, 80]}"
POWERS = {"very": 2.0, "somewhat": 0.5}


@cache
def rulebook() -> Rulebook:
    variables = "".join(f"  {name}: {{of: {name}, terms: {{{SHAPES}}}}}\n" for name in "xy")
    signals = "".join(f"  {name}: {{range: [0, 100], max_gap: {MAX_GAP:g} s}}\n" for name in "xy")
    with TemporaryDirectory() as folder:
        return book(Path(folder), f"signals:\n{signals}variables:\n{variables}")


def found_now(formula: Formula, readings: Mapping[str, Sequence[tuple[float, float]]]) -> tuple[float, float]:
    tables = rulebook().tables
    context = Context(tuple(Reading(name, *pair) for name, read in readings.items() for pair in read))
    degree, _ = holds_now(formula, World.of(context.admitted(tables.signals), tables, readings))
    return degree.low, degree.high


ATOMS = st.builds(
    Is,
    st.sampled_from("xy"),
    st.sampled_from(sorted(TERMS)),
    st.lists(st.sampled_from(sorted(POWERS)), max_size=1).map(tuple),
)
LENGTHS = st.sampled_from([5.0, 12.0, 30.0])
SOFTNESS = st.sampled_from([0.0, 0.25, 0.5])


def made_of(parts: st.SearchStrategy[Formula]) -> st.SearchStrategy[Formula]:
    several = st.lists(parts, min_size=2, max_size=3).map(tuple)
    window = st.builds(
        Window, st.sampled_from(Operator), st.sampled_from(Direction), LENGTHS, SOFTNESS, parts
    )
    return st.one_of(st.builds(Not, parts), st.builds(And, several), st.builds(Or, several), window, window)


FORMULAS: st.SearchStrategy[Formula] = st.recursive(ATOMS, made_of, max_leaves=4)
READ = st.dictionaries(
    st.integers(-50, 0).map(lambda n: 2.0 * n), st.integers(0, 100).map(float), max_size=20
)


@settings(max_examples=150, deadline=None)
@given(FORMULAS, READ, READ)
def test_a_condition_holds_as_far_as_it_is_defined_to(
    formula: Formula, x: dict[float, float], y: dict[float, float]
) -> None:
    readings = {"x": sorted(x.items()), "y": sorted(y.items())}
    dense = Dense(readings, TERMS, POWERS, step=0.05, reach=200.0, max_gap=MAX_GAP)
    # Samples of a twentieth of a second may miss a turn by half of that, in which the steepest degree changes
    # by 0.03; "somewhat" makes 0.18 of it.
    assert found_now(formula, readings) == pytest.approx(dense.now(formula), abs=0.18)


@pytest.mark.parametrize("hours", [1, 24, 24 * 7])
@pytest.mark.parametrize("softness", [0.0, 0.25])
def test_what_lasts_seconds_is_seen_by_a_window_of_days(hours: int, softness: float) -> None:
    length = 3600.0 * hours
    sometime = Window(Operator.SOMETIME, Direction.LAST, length, softness, Is("x", "high"))
    throughout = Window(Operator.THROUGHOUT, Direction.LAST, length, softness, Is("x", "low"))
    for moment in np.random.default_rng(hours).uniform(-0.99 * length, -60.0, 5).tolist():
        beats = [(float(time), 0.0) for time in np.arange(-1.1 * length, 1.0, 25.0)]
        apart = [pair for pair in beats if not -1 < pair[0] - moment < 5]
        peak = [(moment - 0.5, 0.0), (moment, 100.0), (moment + 4.0, 100.0), (moment + 4.5, 0.0)]
        low, high = found_now(sometime, {"x": sorted((*apart, *peak)), "y": []})
        assert (low, high) == (1.0, 1.0)
        assert found_now(throughout, {"x": sorted((*apart, *peak)), "y": []}) == (0.0, 0.0)


@pytest.mark.parametrize("period", [12.0, 37.0, 100.0, 600.0])
@pytest.mark.parametrize("part", [0.55, 0.65, 0.75])
def test_of_what_comes_and_goes_the_share_of_time_counts(period: float, part: float) -> None:
    length = 4 * 3600.0
    begins = np.arange(-5 * 3600.0, 0.0, period)
    turns = np.concatenate([begins + 0.001, begins + part * period, begins + part * period + 0.001])
    times = np.unique(np.concatenate([turns, begins, np.arange(-5 * 3600.0, 0.0, 25.0)]))
    on = (times - begins[0] - 0.0005) % period < part * period
    readings = list(zip(times.tolist(), (100.0 * on).tolist(), strict=True))
    window = Window(Operator.MOSTLY, Direction.LAST, length, 0.0, Is("x", "high"))
    low, _ = found_now(window, {"x": readings, "y": []})
    assert low == pytest.approx((part - 0.5) / 0.3, abs=0.02 + 2 * period / length)


def test_of_very_many_readings_the_peaks_are_looked_at() -> None:
    length = 86_400.0
    times = np.arange(-length, 0.1, 1.0)
    readings = [(float(time), 100.0 if time == -40_007.0 else 0.0) for time in times]
    window = Window(Operator.SOMETIME, Direction.LAST, length, 0.0, Is("x", "high"))
    assert found_now(window, {"x": readings, "y": []}) == (1.0, 1.0)


@settings(max_examples=40, deadline=None)
@given(FORMULAS)
def test_where_nothing_is_forecast_one_curve_stands_for_all(formula: Formula) -> None:
    course = "forecast: {model: approach, set_point: 90, time_constant: 2 min}"
    table = f"signals:\n  x: {{{course}}}\n  y: {{{course}}}\nvariables:\n" + "".join(
        f"  {name}: {{of: {name}, terms: {{{SHAPES}}}}}\n" for name in "xy"
    )
    with TemporaryDirectory() as folder:
        tables = book(Path(folder), table).tables
    values = [(-120.0, 10.0), (-80.0, 60.0), (-30.0, 40.0), (0.0, 55.0)]
    world = World.of(Context.of({"x": values, "y": values}).admitted(tables.signals), tables, "xy")
    past = Grid.of(200.0, 0.0, 5.0)
    further = Grid.of(200.0, 0.5, 5.0)
    for part in nodes(formula):
        if not any(isinstance(node, Window) and node.direction is Direction.NEXT for node in nodes(part)):
            one, all_of_them = trace(part, world, past).truth, trace(part, world, further).truth
            assert one.low == pytest.approx(all_of_them.low[: past.times.size], abs=1e-9)
            assert one.high == pytest.approx(all_of_them.high[: past.times.size], abs=1e-9)


@pytest.mark.parametrize("hours", [0.0, 1.0, 100.0])
def test_what_passes_in_seconds_is_found_beside_what_takes_days(tmp_path: Path, hours: float) -> None:
    """Dough at 230 - 210 exp(-t / 60 s) is full warm from 16 to 24 s, and dry soil is damp for long."""
    rate = f"rate: {-50 / hours:g}, per: h" if hours else "rate: 0, per: h"
    rulebook = book(
        tmp_path,
        f"""
signals:
  dough:
    range: [0, 300]
    forecast: {{model: approach, set_point: 230, time_constant: 60 s, spread: 1.01}}
  soil: {{range: [0, 100], forecast: {{model: linear, {rate}}}}}
variables:
  dough: {{of: dough, terms: {{warm: {{trapezoid: [60, 70, 90, 100]}}}}}}
  bed: {{of: soil, terms: {{damp: {{trapezoid: [10, 20, 60, 80]}}}}}}
rules:
  - {{name: r, on: {{cue: soon}}, if: dough is warm and bed is damp, then: {{model: when, core: 1 min}}}}
""",
    )
    said = TimeRequirement(text="soon", span=(0, 4), constraint=Constraint.VAGUE, word="soon")
    resolved = rulebook.resolve(said, Context.of({"dough": 20.0, "soil": 50.0}))
    assert resolved.reason is None
    assert resolved.parameters["t"] == pytest.approx(60 * np.log(210 / 160), abs=1.0)
    assert resolved.satisfaction([10.0, 20.0, 40.0]).round(1).tolist() == [0.0, 1.0, 0.0]
