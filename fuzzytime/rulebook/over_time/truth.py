"""How true a formula is over time: two bounds, which differ where readings are missing."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from fuzzytime.rulebook.logic.formula import (
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
from fuzzytime.rulebook.logic.traces import Past
from fuzzytime.rulebook.logic.windows import Extent, mostly, sometime, throughout
from fuzzytime.rulebook.over_time.grid import Grid, jump
from fuzzytime.rulebook.over_time.world import Combination, World
from fuzzytime.rulebook.tables.contents import Tables
from fuzzytime.satisfaction import Floats

_OPERATORS = {Operator.SOMETIME: sometime, Operator.THROUGHOUT: throughout, Operator.MOSTLY: mostly}


@dataclass(frozen=True, slots=True, eq=False)
class Truth:
    """Lower and upper bounds of one shape; what is unknown lies between 0 and 1."""

    low: Floats
    high: Floats

    @property
    def certain(self) -> bool:
        """Whether both are the same array: nothing is unknown."""
        return self.low is self.high


def truth_of_atom(atom: Is, values: Floats, tables: Tables) -> Truth:
    """Give μ(x)^p at values of any shape: the term's membership, to the powers of its hedges."""
    degrees = tables.variables[atom.variable].terms[atom.term](values)
    for hedge in atom.hedges:
        degrees = degrees ** tables.term_hedges[hedge]
    unknown = np.isnan(degrees)
    if not unknown.any():
        return Truth(degrees, degrees)
    return Truth(np.where(unknown, 0.0, degrees), np.where(unknown, 1.0, degrees))


@dataclass(frozen=True, slots=True, eq=False)
class Traced:
    """A formula over the times of a grid, as expected over all curves of the forecasts.

    ``parts`` are the same for each atom and each window in it, from left to right.
    """

    grid: Grid
    truth: Truth
    parts: Mapping[Formula, Truth]


def trace(formula: Formula, world: World, grid: Grid) -> Traced:
    """Follow a formula over time: E[⟦φ⟧(t; θ)] over the whole formula, by a fixed set of curves θ."""
    return trace_all([formula], world, grid)[0]


def followed(formula: Formula, world: World, ahead: float, past: float = 0.0) -> Traced:
    """Follow a formula from ``past`` to ``ahead`` seconds from now, also where its terms begin and end."""
    grid = world.grid(formula, ahead, past)
    return trace(formula, world, grid.refined(crossings(formula, world, grid)))


def trace_all(formulas: Sequence[Formula], world: World, grid: Grid) -> list[Traced]:
    """Follow several formulas over the same times; what they share is worked out once."""
    evaluation = _Evaluation(world, grid)
    return [_traced(formula, evaluation) for formula in formulas]


def _traced(formula: Formula, evaluation: "_Evaluation") -> Traced:
    combinations = evaluation.combinations(formula)
    weights = [combination.weight for combination in combinations]

    def expected(part: Formula) -> Truth:
        return _mean([evaluation.truth(part, combination) for combination in combinations], weights)

    shown = dict.fromkeys(node for node in nodes(formula) if isinstance(node, Is | Window))
    return Traced(evaluation.grid, expected(formula), {part: expected(part) for part in shown})


def _mean(truths: Sequence[Truth], weights: Sequence[float]) -> Truth:
    """Give the means over all curves, each combination of forecasts by its weight."""
    if len(truths) == 1 and len(truths[0].low) == 1:
        return Truth(truths[0].low[0], truths[0].high[0])
    low = _mean_rows([truth.low for truth in truths], weights)
    if all(truth.certain for truth in truths):
        return Truth(low, low)
    return Truth(low, _mean_rows([truth.high for truth in truths], weights))


def _mean_rows(values: Sequence[Floats], weights: Sequence[float]) -> Floats:
    means = [weight * rows.mean(axis=0) for rows, weight in zip(values, weights, strict=True)]
    # Weighted means of ones are 1 up to rounding: that must stay 1.
    return np.asarray(np.clip(np.round(np.sum(means, axis=0), 12), 0.0, 1.0))


class _Evaluation:
    """Evaluates formulas on one grid: each variable and each part of a formula once a set of curves."""

    def __init__(self, world: World, grid: Grid) -> None:
        self.world = world
        self.grid = grid
        self._combinations: dict[tuple[str, ...], tuple[Combination, ...]] = {}
        self._values: dict[tuple[str, int | None], Floats] = {}
        self._truths: dict[tuple[Formula, Combination], Truth] = {}
        self._pasts: dict[tuple[Formula, Combination, Direction], Past] = {}

    def combinations(self, formula: Formula) -> tuple[Combination, ...]:
        """Give the combinations of forecasts to follow a formula over, the same ones for the same signals.

        Where nothing is forecast within the grid, one stands for all.
        """
        names = tuple(self.world.tables.variables[name].signal for name in variables(formula))
        if names not in self._combinations:
            found = self.world.combinations(names)
            if all(self.world.last_read(name) >= self.grid.times[-1] for name in found[0].components):
                found = (replace(found[0], weight=1.0),)
            self._combinations[names] = found
        return self._combinations[names]

    def truth(self, formula: Formula, combination: Combination) -> Truth:
        """Give bounds of shape (curves, k)."""
        key = formula, combination
        found = self._truths.get(key)
        if found is None:
            found = self._truths[key] = self._evaluated(formula, combination)
        return found

    def _evaluated(self, formula: Formula, combination: Combination) -> Truth:
        if isinstance(formula, Is):
            return truth_of_atom(formula, self._variable(formula.variable, combination), self.world.tables)
        if isinstance(formula, Happened):
            happened = (self.world.since(formula.event, self.grid.times) >= 0).astype(float)[None, :]
            known = self.world.known(formula.event)
            return Truth(happened, happened if known else np.ones_like(happened))
        if isinstance(formula, Not):
            part = self.truth(formula.part, combination)
            low = 1.0 - part.high
            return Truth(low, low if part.certain else 1.0 - part.low)
        if isinstance(formula, Window):
            return self._windowed(formula, combination)
        parts = [self.truth(part, combination) for part in formula.parts]
        norm = self.world.tables.norm
        join = norm.conjunction if isinstance(formula, And) else norm.disjunction
        low = join([part.low for part in parts])
        certain = all(part.certain for part in parts)
        return Truth(low, low if certain else join([part.high for part in parts]))

    def _variable(self, name: str, combination: Combination) -> Floats:
        variable = self.world.tables.variables[name]
        key = name, combination.components.get(variable.signal)
        if key not in self._values:
            self._values[key] = self.world.values(variable, self.grid, combination)
        return self._values[key]

    def _windowed(self, window: Window, combination: Combination) -> Truth:
        past = self._past(window.part, combination, window.direction)
        found = _OPERATORS[window.operator](past, Extent.of(window.length, window.reach, self.grid.step))
        if window.direction is Direction.NEXT:
            found = found[:, ::-1]
        found = self.grid.at_all_times(found)
        curves = len(found) // 2
        return Truth(found[:curves], found[curves:])

    def _past(self, part: Formula, combination: Combination, direction: Direction) -> Past:
        """Give both bounds of a part, in the order in which a window passes over them.

        What lies before the first point is 0 to the lower one, 1 to the upper one.
        """
        key = part, combination, direction
        found = self._pasts.get(key)
        if found is None:
            truth = self.truth(part, combination)
            bounds, points = np.concatenate([truth.low, truth.high]), self.grid.points
            if direction is Direction.NEXT:
                bounds, points = np.ascontiguousarray(bounds[:, ::-1]), points.reversed
            found = Past(bounds, np.repeat([[0.0], [1.0]], len(truth.low), axis=0), points)
            self._pasts[key] = found
        return found


def crossings(formula: Formula, world: World, grid: Grid) -> list[float]:
    """Give the times at which a signal crosses a breakpoint of a term that the formula speaks of.

    Where forecasts are uncertain there are none: the mean over their curves has no kinks there.
    """
    combinations = world.combinations(world.tables.variables[name].signal for name in variables(formula))
    found: list[float] = []
    for node in nodes(formula):
        if isinstance(node, Happened):
            found += [moment for time in world.happened[node.event].tolist() for moment in jump(time)]
        if not isinstance(node, Is):
            continue
        variable = world.tables.variables[node.variable]
        values = world.values(variable, grid, combinations[0])
        certain = grid.times.size
        if len(values) > 1 or len(combinations) > 1:
            certain = int(np.searchsorted(grid.times, world.last_read(variable.signal), "right"))
        for corner in variable.terms[node.term].breakpoints:
            found += _passes(grid.times[:certain], values[0, :certain] - corner)
    return found


def _passes(times: Floats, distances: Floats) -> list[float]:
    with np.errstate(invalid="ignore"):
        cells = np.flatnonzero(distances[:-1] * distances[1:] < 0)
    share = distances[cells] / (distances[cells] - distances[cells + 1])
    moments = times[cells] + share * np.diff(times)[cells]
    return [moment for time in moments.tolist() for moment in jump(time)]
