"""What there is to draw of a clause: readings, forecasts, degrees and ψ on one axis of time."""

import numpy as np

from fuzzytime.rulebook.logic.formula import Formula
from fuzzytime.rulebook.logic.traces import Positions
from fuzzytime.rulebook.over_time.truth import Traced
from fuzzytime.rulebook.over_time.world import World
from fuzzytime.rulebook.resolving.evidence import signals_of
from fuzzytime.rulebook.resolving.reasons import outlook
from fuzzytime.rulebook.resolving.resolution import SignalTrace, Trace
from fuzzytime.satisfaction import Floats, SatisfactionFunction

POINTS = 400
"""How many times a trace shows at most."""

_BAND = (0.05, 0.5, 0.95)


def drawn(
    formula: Formula, world: World, traced: Traced, until: float, satisfaction: SatisfactionFunction
) -> Trace:
    """Give the traces of a formula over the times of its grid, to ``until`` seconds from now."""
    shown = np.flatnonzero(traced.grid.times <= until)
    # Readings may lie closely; what is to come is drawn as finely all the same.
    parts = np.split(shown, [int(np.searchsorted(shown, traced.grid.zero))])
    positions = np.concatenate([_some_of(part, POINTS // 2) for part in parts])
    times = traced.grid.times[positions]
    names = [name for name in signals_of(formula, world.tables) if name in world.series]
    # ψ is about starts from now on.
    satisfied = np.where(times >= 0, satisfaction(times), 0.0)
    return Trace(
        times=times,
        signals=tuple(_signal_trace(name, world, times) for name in names),
        atoms=tuple((str(part), truth.low[positions]) for part, truth in traced.parts.items()),
        low=traced.truth.low[positions],
        high=traced.truth.high[positions],
        satisfaction=satisfied,
    )


def _some_of(positions: Positions, most: int) -> Positions:
    """Give so many positions at most, evenly, with the first and the last."""
    chosen = np.unique(np.linspace(0, positions.size - 1, min(most, positions.size)).astype(int))
    return np.asarray(positions[chosen])


def _signal_trace(name: str, world: World, times: Floats) -> SignalTrace:
    series = world.series[name]
    read = series.times >= times[0]
    ahead = times[:0]
    if series.forecast is not None:
        ahead = times[(times > series.forecast.start) & (times <= series.known_until)]
    band = np.empty((3, 0))
    if series.forecast is not None and ahead.size:
        band = series.forecast.quantiles(ahead, _BAND)
    return SignalTrace(
        name=name,
        unit=series.signal.unit,
        reading_times=series.times[read],
        reading_values=series.values[read],
        forecast_times=ahead,
        forecast_low=band[0],
        forecast_median=band[1],
        forecast_high=band[2],
        outlook=outlook(series.signal, series.forecast) if series.forecast is not None and ahead.size else "",
    )
