"""Why a condition never comes true, in words a person can act on."""

import math

import numpy as np

from fuzzytime.context.forecast import Forecast
from fuzzytime.context.signals import Approach, Hold, Signal
from fuzzytime.context.units import symbol
from fuzzytime.rulebook.logic.formula import And, Formula, Is, Not, Or, nodes
from fuzzytime.rulebook.over_time.truth import Traced, Truth
from fuzzytime.rulebook.over_time.world import World
from fuzzytime.rulebook.resolving.evidence import signals_of, span_of, too_old
from fuzzytime.rulebook.tables.variables import Source, Variable
from fuzzytime.times import format_duration

Mask = np.ndarray[tuple[int], np.dtype[np.bool_]]

_LITTLE = 0.02
"""The share of its way, or of where it leads, that may be left where a signal counts as settled."""


def why_never(
    formula: Formula, world: World, traced: Traced, horizon: float, never_below: float
) -> tuple[str, bool]:
    """Say which readings are missing, or where the signals end up instead; and whether more may be told.

    ``traced`` is the condition's trace, which stays below ``never_below``.
    """
    missing = [name for name in signals_of(formula, world.tables) if _unknown_now(name, world)]
    if missing and float(traced.truth.high[traced.grid.times >= 0].max()) >= never_below:
        return _missing(missing, world), True
    known = _known(formula, world, traced)
    if float(traced.truth.high[known].max()) >= never_below:
        spans = span_of(signals_of(formula, world.tables), world)
        return f"cannot be told whether {formula}: {spans}", True
    apart = [
        world.tables.variables[node.variable]
        for node in nodes(formula)
        if isinstance(node, Is) and _stays_apart(node, formula, traced.parts[node], known, never_below)
    ]
    if not apart and isinstance(formula, And):
        return "never: its parts do not hold at the same time", False
    if not apart:
        return f"never: it does not come true that {formula}", False
    described = ", ".join(dict.fromkeys(_end_of(variable, world, horizon) for variable in apart))
    ends = [_has_end(variable, world, horizon) for variable in apart]
    # Who holds a reading only does so until somebody reads another.
    untold = not all(ends) if isinstance(formula, Or) else not any(ends)
    return (f"not yet: {described}" if untold else f"never: {described}"), untold


def _known(formula: Formula, world: World, traced: Traced) -> Mask:
    """Tell at which times from now on everything that a formula speaks of is read or forecast."""
    ends = [
        world.series[name].known_until for name in signals_of(formula, world.tables) if name in world.series
    ]
    until = max(min(ends, default=math.inf), 0.0)
    return np.asarray((traced.grid.times >= 0) & (traced.grid.times <= until))


def _stays_apart(atom: Is, formula: Formula, truth: Truth, known: Mask, never_below: float) -> bool:
    """Tell whether an atom never does what the formula wants of it, as far as that is known."""
    if any(isinstance(node, Not) and node.part == atom for node in nodes(formula)):
        return bool(truth.high[known].min() > 1 - never_below)
    return bool(truth.low[known].max() < never_below)


def _unknown_now(name: str, world: World) -> bool:
    if not world.known(name):
        return True
    return name in world.series and world.series[name].known_until <= 0


def _missing(names: list[str], world: World) -> str:
    events = [name for name in names if name in world.happened]
    signals = [name for name in names if name not in world.happened]
    parts: list[str] = []
    if signals:
        ages = [too_old(world.series[name]) for name in signals if world.known(name)]
        last = "".join(f" (the last is {age})" for age in ages if age)
        parts.append(f"not enough readings of {' and '.join(signals)}{last}")
    parts += [f"not yet: {event} has not happened" for event in events]
    return "; ".join(parts)


def _end_of(variable: Variable, world: World, horizon: float) -> str:
    """Say where what a variable looks at ends up."""
    if variable.source is Source.SINCE:
        since = float(world.since(variable.signal, np.zeros(1))[0])
        return f"it is {format_duration(since)} since {variable.signal}"
    series = world.series[variable.signal]
    if series.forecast is None:
        return f"nothing is known of {variable.signal}"
    return f"{variable.signal} {outlook(series.signal, series.forecast, min(horizon, series.known_until))}"


def _has_end(variable: Variable, world: World, horizon: float) -> bool:
    """Tell whether it is known where what a variable looks at leads: a time since an event, a level."""
    if variable.source is Source.SINCE:
        return True
    series = world.series[variable.signal]
    until = min(horizon, series.known_until)
    return series.forecast is not None and _settles(series.signal, series.forecast, until)


def outlook(signal: Signal, forecast: Forecast, until: float = math.inf) -> str:
    """Say where a signal ends up, as expected, within ``until`` seconds from now: "settles at 150 °C"."""
    start, end, last = _way(forecast, until)
    if _settles(signal, forecast, until):
        return f"settles at {with_unit(forecast.level, signal.unit)}"
    shown = with_unit(end, signal.unit)
    if isinstance(signal.course, Hold) or start == end:
        return f"is at {shown}"
    return f"is at {shown} after {format_duration(last)}, as far as it is forecast"


def _settles(signal: Signal, forecast: Forecast, until: float) -> bool:
    """Tell whether a signal is forecast to where it leads: one that is held or drawn on may go anywhere."""
    start, end, _ = _way(forecast, until)
    if not isinstance(signal.course, Approach) or start == end:
        return False
    level = forecast.level
    return abs(end - level) <= _LITTLE * max(abs(start - level), abs(level))


def _way(forecast: Forecast, until: float) -> tuple[float, float, float]:
    """Give the expected value now, the last one within ``until`` seconds, and when that is."""
    last = min(until, forecast.until)
    if not math.isfinite(last):
        last = max(forecast.settled(), 0.0)
    start, end = forecast.quantiles(np.array([forecast.start, last]), (0.5,))[0]
    return float(start), float(end), last


def with_unit(value: float, unit: str | None) -> str:
    """Print a value to three digits, with its unit as people write it."""
    rounded = 0.0 if value == 0 else round(value, 2 - math.floor(math.log10(abs(value))))
    return f"{rounded:g} {symbol(unit)}".strip()
