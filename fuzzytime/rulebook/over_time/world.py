"""What a context tells over time: each variable's value at each time, for each curve of a forecast."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from fuzzytime.context import Context
from fuzzytime.context.series import Series
from fuzzytime.rulebook.logic.formula import (
    Direction,
    Formula,
    Window,
    events,
    nodes,
    variables,
    window_reach,
)
from fuzzytime.rulebook.logic.windows import Extent, slope
from fuzzytime.rulebook.over_time.grid import Grid, jump
from fuzzytime.rulebook.tables.contents import Tables
from fuzzytime.rulebook.tables.variables import Source, Variable
from fuzzytime.satisfaction import Floats

MOST_COMBINATIONS = 8
"""Combinations of forecasts' components that are followed at most, the likeliest."""

_AFTER = 1e-6
_STEPS_A_COURSE = 800
_STRIDES = (1, 37, 11, 53, 23, 5, 43, 29)
"""Orders in which the curves of several signals are paired: coprime to their number, and unlike."""


@dataclass(frozen=True, slots=True, eq=False)
class Combination:
    """One component of the forecast of each signal, by name, and the weight of these together."""

    weight: float
    components: Mapping[str, int]


@dataclass(frozen=True, slots=True, eq=False)
class World:
    """The series of signals and the times of events, in the order of the tables."""

    tables: Tables
    series: Mapping[str, Series]
    happened: Mapping[str, Floats]

    @classmethod
    def of(cls, context: Context, tables: Tables, names: Iterable[str]) -> "World":
        """Gather the signals that are named from an admitted context."""
        series: dict[str, Series] = {}
        happened: dict[str, Floats] = {}
        for name in names:
            signal = tables.signals[name]
            if signal.event:
                happened[name] = np.array([reading.at for reading in context.of_signal(name)], float)
            else:
                series[name] = Series.within(context, signal)
        return cls(tables, series, happened)

    def combinations(self, names: Iterable[str]) -> tuple[Combination, ...]:
        """Give the likeliest combinations of the components of some signals' forecasts."""
        kept = [Combination(1.0, {})]
        for name in dict.fromkeys(names):
            if name in self.series:
                found = [
                    Combination(part.weight * weight, {**part.components, name: index})
                    for part in kept
                    for index, weight in enumerate(self.series[name].components)
                ]
                # What is left out here has as many likelier ones in front of it with any component to come.
                kept = sorted(found, key=lambda combination: -combination.weight)[:MOST_COMBINATIONS]
        total = math.fsum(combination.weight for combination in kept)
        return tuple(Combination(part.weight / total, part.components) for part in kept)

    def known(self, name: str) -> bool:
        """Tell whether a signal was read, or an event has happened or is announced."""
        if name in self.happened:
            return bool(self.happened[name].size)
        return self.series[name].forecast is not None

    def last_read(self, name: str) -> float:
        """Give the time of a signal's last reading; −∞ where there is none, or where it is an event."""
        return float(self.series[name].times.max(initial=-math.inf)) if name in self.series else -math.inf

    def values(self, variable: Variable, grid: Grid, combination: Combination) -> Floats:
        """Give a variable's values, of shape (curves, k), NaN where they are unknown."""
        if variable.source is Source.SINCE:
            return self.since(variable.signal, grid.times)[None, :]
        values = self._signal(variable.signal, grid.times, combination)
        if variable.source is Source.OF:
            return values
        extent = Extent.of(variable.over, variable.over, grid.step)
        return grid.at_all_times(slope(values, extent, grid.points) / grid.step * variable.per)

    def since(self, event: str, times: Floats) -> Floats:
        """Give the seconds since an event last happened, NaN before it did."""
        happened = self.happened[event]
        if not happened.size:
            return np.full(times.size, np.nan)
        latest = np.searchsorted(happened, times, "right") - 1
        return np.where(latest >= 0, times - happened[np.maximum(latest, 0)], np.nan)

    def _signal(self, name: str, times: Floats, combination: Combination) -> Floats:
        values = self.series[name].at(times, combination.components[name])
        number = len(values)
        stride = _STRIDES[list(self.series).index(name) % len(_STRIDES)]
        return values if number == 1 else values[stride * np.arange(number) % number]

    # -- how far to look ------------------------------------------------------------------------------------

    def settled(self, formula: Formula) -> float:
        """Give the time from which nothing that a formula speaks of changes any more."""
        latest = [0.0]
        for name in variables(formula):
            variable = self.tables.variables[name]
            latest.append(self._settled(variable) + variable.over)
        latest += [float(self.happened[event].max(initial=0.0)) for event in events(formula)]
        return max(latest)

    def _settled(self, variable: Variable) -> float:
        if variable.source is Source.SINCE:
            beyond = max(variable.breakpoints, default=0.0)
            return float(self.happened[variable.signal].max(initial=-math.inf)) + beyond
        known_until = self.series[variable.signal].known_until
        # Where knowledge ends the value changes once more: it becomes unknown.
        return max(known_until, 0.0) + _AFTER if known_until < math.inf else self._course(variable)

    def _course(self, variable: Variable) -> float:
        """Give the time from which a signal goes on as it is, or is not known any more."""
        series = self.series[variable.signal]
        if series.forecast is None:
            return 0.0
        within = variable.breakpoints if variable.source is Source.OF else ()
        return min(series.forecast.settled(within), max(series.known_until, 0.0))

    def memory(self, formula: Formula) -> float:
        """Give how many seconds back a formula looks, through windows and rates."""
        return window_reach(formula, Direction.LAST) + max(self._stretches(formula), default=0.0)

    def first_reading(self, formula: Formula) -> float:
        """Give the time of the earliest reading of what a formula speaks of, at most 0."""
        names = {self.tables.variables[name].signal for name in variables(formula)} | set(events(formula))
        times = [self.series[name].times for name in names & set(self.series)]
        times += [self.happened[name] for name in names & set(self.happened)]
        return min((float(part.min(initial=0.0)) for part in times), default=0.0)

    def grid(self, formula: Formula, ahead: float, past: float = 0.0) -> Grid:
        """Make a grid on which a formula can be followed from ``past`` to ``ahead`` seconds from now.

        No signal changes much between its times, however much slower others are; and where the formula looks
        through windows, nothing that was read in them falls between.
        """
        future = ahead + window_reach(formula, Direction.NEXT)
        lengths = [node.length for node in nodes(formula) if isinstance(node, Window)]
        lengths += self._stretches(formula)
        grid = Grid.of(max(past, self.memory(formula)), future, min(lengths, default=math.inf))
        return grid.refined([*self._courses(formula, grid), *(self._turns(formula, grid) if lengths else ())])

    def _courses(self, formula: Formula, grid: Grid) -> list[float]:
        """Give times at which signals are followed beside those of the grid.

        One that settles long before the grid ends is followed more finely; and one that is not known for ever
        has a last time at which it is.
        """
        found: list[float] = []
        for name in variables(formula):
            variable = self.tables.variables[name]
            if variable.source is Source.SINCE:
                continue
            known_until = self.series[variable.signal].known_until
            if math.isfinite(known_until):
                found += jump(math.nextafter(known_until, math.inf))
            settled = self._course(variable)
            if 0 < settled < grid.step * _STEPS_A_COURSE:
                found += np.linspace(0.0, settled, _STEPS_A_COURSE).tolist()
        return found

    def _turns(self, formula: Formula, grid: Grid) -> list[float]:
        """Give the times within a grid at which what a formula speaks of was read, or an event happens."""
        names = {self.tables.variables[name].signal for name in variables(formula)} | set(events(formula))
        found: list[float] = []
        for name in names & set(self.series):
            series = self.series[name]
            found += grid.telling(series.times, series.values).tolist()
        for name in names & set(self.happened):
            found += [moment for time in self.happened[name].tolist() for moment in jump(time)]
        return found

    def _stretches(self, formula: Formula) -> list[float]:
        """Give the stretches of time over which rates are taken."""
        stretches = [self.tables.variables[name].over for name in variables(formula)]
        return [stretch for stretch in stretches if stretch > 0]
