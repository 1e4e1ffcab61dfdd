"""What was read, in words: a variable's value now, and how far a signal is known."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from fuzzytime.context import Hold
from fuzzytime.context.series import Series
from fuzzytime.context.units import symbol
from fuzzytime.rulebook.logic.formula import Formula, Is, Window, events, variables
from fuzzytime.rulebook.over_time.world import World
from fuzzytime.rulebook.tables.contents import Tables
from fuzzytime.rulebook.tables.variables import Source, Variable
from fuzzytime.times import format_duration

_JUST = 1.0
"""Seconds within which a reading counts as one of now."""

_PER = {1.0: "s", 60.0: "min", 3600.0: "h", 86400.0: "d"}


@dataclass(frozen=True, slots=True)
class Evidence:
    """What tells how true a part of a condition is now: a variable's value, and words about it.

    ``value`` is None where it is unknown, or where the part speaks of several times or variables.
    """

    words: str
    value: float | None = None
    unit: str | None = None


def evidence_of(part: Formula, world: World, *, certain: bool) -> Evidence:
    """Give what tells how true a part of a formula is now.

    That is a value for an atom; for a window that is not ``certain`` how far its signals are known.
    """
    if isinstance(part, Is):
        return _of_variable(world.tables.variables[part.variable], world)
    if isinstance(part, Window) and not certain:
        return Evidence(span_of(signals_of(part, world.tables), world))
    return Evidence("")


def signals_of(formula: Formula, tables: Tables) -> tuple[str, ...]:
    """Give the signals and events that a formula depends on."""
    of_variables = [tables.variables[name].signal for name in variables(formula)]
    return tuple(dict.fromkeys((*of_variables, *events(formula))))


def _of_variable(variable: Variable, world: World) -> Evidence:
    value, signal = _value_now(variable, world), variable.signal
    if variable.source is Source.SINCE:
        known = not math.isnan(value)
        words = f"{signal} {_ago(value)}" if known else f"{signal} has not happened"
        return Evidence(words, value if known else None, "s")
    series = world.series[signal]
    if variable.source is Source.RATE_OF:
        per = f"{symbol(variable.unit)}/{_PER[variable.per]}"
        if math.isnan(value):
            return Evidence(span_of([signal], world), None, per)
        return Evidence(f"changes by {value:+.4g} {per}", value, per)
    if math.isnan(value):
        return Evidence(_why_unknown(series), None, variable.unit)
    shown, age = f"{value:.4g} {symbol(variable.unit)}".strip(), -float(series.times[-1])
    if age <= _JUST:
        words = f"reading {shown}"
    elif isinstance(series.signal.course, Hold):
        words = f"reading {shown}, {_ago(age)}"
    else:
        words = f"expected {shown}, last read {_ago(age)}"
    return Evidence(words, value, variable.unit)


def _value_now(variable: Variable, world: World) -> float:
    """Give the value of a variable now, as expected; NaN where it is unknown."""
    atom = Is(variable.name, "")
    grid = world.grid(atom, 0.0)
    return math.fsum(
        combination.weight * float(world.values(variable, grid, combination)[:, grid.zero].mean())
        for combination in world.combinations((variable.signal,))
    )


def _why_unknown(series: Series) -> str:
    if not series.times.size:
        return "no reading"
    return f"the last reading is {too_old(series)}" if too_old(series) else "not known now"


def too_old(series: Series) -> str:
    """Say that the last reading is older than it is good for, or is forecast by; nothing where it is not."""
    age = -float(series.times[-1])
    limit = min(series.signal.max_age, series.signal.course.horizon)
    return f"{format_duration(age)} old, more than {format_duration(limit)}" if age > limit else ""


def span_of(names: Sequence[str], world: World) -> str:
    """Say from when to when signals and events are known."""
    return ", ".join(f"{name} {_span(name, world)}" for name in names)


def _span(name: str, world: World) -> str:
    if not world.known(name):
        return "was not read"
    if name in world.happened:
        return f"is known from {_when(float(world.happened[name][0]))} on"
    series = world.series[name]
    start, end = float(series.times[0]), series.known_until
    until = f"to {_when(end)}" if math.isfinite(end) else "on"
    return f"is known from {_when(start)} {until}"


def _when(time: float) -> str:
    if abs(time) <= _JUST:
        return "now"
    return _ago(-time) if time < 0 else f"{format_duration(time)} ahead"


def _ago(seconds: float) -> str:
    return "now" if seconds <= _JUST else f"{format_duration(seconds)} ago"
