"""How true a formula is over time: two bounds, which differ where readings are missing."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from fuzzytime.rulebook.formula import (
    And,
    Direction,
    Formula,
    Happened,
    Is,
    Not,
    Operator,
    Window,
    nodes,
    variables,
)
from fuzzytime.rulebook.tables import Tables
from fuzzytime.rulebook.windows import Extent, mostly, sometime, throughout
from fuzzytime.rulebook.world import Combination, Grid, World, on_all_times
from fuzzytime.satisfaction import Floats

_OPERATORS = {Operator.SOMETIME: sometime, Operator.THROUGHOUT: throughout, Operator.MOSTLY: mostly}


@dataclass(frozen=True, slots=True, eq=False)
class Truth:
    """Lower and upper bounds of one shape; what is unknown lies between 0 and 1."""

    low: Floats
    high: Floats


def truth_of_atom(atom: Is, values: Floats, tables: Tables) -> Truth:
    """Give μ(x)^p at values of any shape: the term's membership, to the powers of its hedges."""
    degrees = tables.variables[atom.variable].terms[atom.term](values)
    for hedge in atom.hedges:
        degrees = degrees ** tables.term_hedges[hedge].power
    unknown = np.isnan(degrees)
    return Truth(np.where(unknown, 0.0, degrees), np.where(unknown, 1.0, degrees))


@dataclass(frozen=True, slots=True, eq=False)
class Traced:
    """A formula over the times of a grid, as expected over all curves of the forecasts.

    ``parts`` are the same for each atom and each window in it, by their text.
    """

    grid: Grid
    truth: Truth
    parts: Mapping[str, Truth]


def trace(formula: Formula, world: World, grid: Grid) -> Traced:
    """Follow a formula over time: E[⟦φ⟧(t; θ)] over the whole formula, by a fixed set of curves θ."""
    names = [world.tables.variables[name].signal for name in variables(formula)]
    low = high = np.zeros(grid.times.size)
    parts: dict[str, Truth] = {}
    for combination in world.combinations(names):
        found = _Evaluation(world, grid, combination)
        whole = _mean(found.truth(formula), combination.weight)
        low, high = low + whole.low, high + whole.high
        for part, truth in found.parts.items():
            mean = _mean(truth, combination.weight)
            before = parts.get(part)
            parts[part] = mean if before is None else Truth(before.low + mean.low, before.high + mean.high)
    return Traced(grid, Truth(_clipped(low), _clipped(high)), parts)


def _mean(truth: Truth, weight: float) -> Truth:
    return Truth(weight * truth.low.mean(axis=0), weight * truth.high.mean(axis=0))


def _clipped(values: Floats) -> Floats:
    # Weighted means of ones are 1 up to rounding: that must stay 1.
    return np.clip(np.round(values, 12), 0.0, 1.0)


class _Evaluation:
    """Evaluates formulas on one grid and one combination of forecasts, each variable once."""

    def __init__(self, world: World, grid: Grid, combination: Combination) -> None:
        self._world = world
        self._grid = grid
        self._combination = combination
        self._values: dict[str, Floats] = {}
        self.parts: dict[str, Truth] = {}

    def truth(self, formula: Formula) -> Truth:
        """Give bounds of shape (curves, k)."""
        if isinstance(formula, Is):
            found = truth_of_atom(formula, self._variable(formula.variable), self._world.tables)
            self.parts[str(formula)] = found
            return found
        if isinstance(formula, Happened):
            since = self._world.since(formula.event, self._grid.times)
            known = self._world.known(formula.event)
            low = (since >= 0).astype(float)[None, :]
            return Truth(low, low if known else np.ones_like(low))
        if isinstance(formula, Not):
            part = self.truth(formula.part)
            return Truth(1.0 - part.high, 1.0 - part.low)
        if isinstance(formula, Window):
            found = self._windowed(formula)
            self.parts[str(formula)] = found
            return found
        parts = [self.truth(part) for part in formula.parts]
        norm = self._world.tables.norm
        join = norm.conjunction if isinstance(formula, And) else norm.disjunction
        return Truth(join([part.low for part in parts]), join([part.high for part in parts]))

    def _variable(self, name: str) -> Floats:
        if name not in self._values:
            variable = self._world.tables.variables[name]
            self._values[name] = self._world.values(variable, self._grid, self._combination)
        return self._values[name]

    def _windowed(self, window: Window) -> Truth:
        part = self.truth(window.part)
        grid = self._grid
        extent = Extent.of(window.length, window.reach, grid.step)
        bounds: list[Floats] = []
        for values, unknown in ((part.low, 0.0), (part.high, 1.0)):
            regular = values[:, grid.regular]
            if window.direction is Direction.NEXT:
                found = _OPERATORS[window.operator](regular[:, ::-1], extent, unknown)[:, ::-1]
            else:
                found = _OPERATORS[window.operator](regular, extent, unknown)
            bounds.append(on_all_times(found, grid))
        return Truth(*bounds)


def crossings(formula: Formula, world: World, grid: Grid) -> list[float]:
    """Give the times at which a certain signal crosses a breakpoint of a term that the formula speaks of.

    Where forecasts are uncertain there are none: the mean over their curves has no kinks there.
    """
    names = [world.tables.variables[name].signal for name in variables(formula)]
    combinations = world.combinations(names)
    found: list[float] = []
    for node in nodes(formula):
        if isinstance(node, Happened):
            found += [moment for time in world.happened[node.event] for moment in _jump(float(time))]
        if not isinstance(node, Is) or len(combinations) > 1:
            continue
        variable = world.tables.variables[node.variable]
        values = world.values(variable, grid, combinations[0])
        if len(values) == 1:
            for corner in variable.terms[node.term].breakpoints:
                found += _passes(grid.times, values[0] - corner)
    return found


def _jump(time: float) -> tuple[float, float]:
    return float(np.nextafter(time, -np.inf)), time


def _passes(times: Floats, distances: Floats) -> list[float]:
    with np.errstate(invalid="ignore"):
        cells = np.flatnonzero(distances[:-1] * distances[1:] < 0)
    share = distances[cells] / (distances[cells] - distances[cells + 1])
    moments = times[cells] + share * np.diff(times)[cells]
    return [moment for time in moments.tolist() for moment in _jump(time)]
