"""Numbers in clauses: "the oven is above 150 degrees" speaks of a term that is made for the occasion.

A number that a person says is no cliff: the degree falls to 0 over a softness, which is a share of the number
(the tables' ``thresholds``), or the signal's own. "At least 150" is full from 150 on and 0 below 150 less the
softness, "above 150" is 0 at 150; the same downwards.
"""

import math
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np

from fuzzytime.context import Context, Signal
from fuzzytime.context.series import Series
from fuzzytime.context.units import symbol
from fuzzytime.requirement import Comparison, Side
from fuzzytime.rulebook.logic.formula import Is
from fuzzytime.rulebook.tables.contents import Tables
from fuzzytime.rulebook.tables.variables import Term
from fuzzytime.rulebook.wording.measured import Meant, measured
from fuzzytime.rulebook.wording.phrases import plain

_ALL_THE_WAY = 0.5
"""The share of the way to a number that a signal must fall, as expected, for it to be coming down to it."""

_OPEN = math.inf


@dataclass(frozen=True, slots=True)
class Threshold:
    """A number understood: the atom, the tables that know its term, and notes; or why there is none.

    ``impossible`` says that what is measured is never so; else nobody can tell.
    """

    tables: Tables
    atom: Is | None = None
    reason: str | None = None
    impossible: bool = False
    notes: tuple[str, ...] = ()


def without(comparison: Comparison, said: str, mark: str = "") -> str:
    """Give a plain text with a mark in place of a comparison."""
    return " ".join(f" {said} ".replace(f" {plain(comparison.text)} ", f" {mark} ", 1).split())


def threshold(
    comparison: Comparison,
    named: str,
    guess: str | None,
    tables: Tables,
    context: Context,
    before: str | None = None,
    about: str = "",
) -> Threshold:
    """Find what a number measures, and make its term; parameters are those of `measured`.

    Readings tell from which side "at 150" is reached, too.
    """
    found = measured(comparison, named, guess, tables, context, before, about)
    if found.meant is None:
        return Threshold(tables, reason=found.reason)
    return _threshold(comparison, found.meant, tables, context, found.notes)


def _threshold(
    comparison: Comparison, meant: Meant, tables: Tables, context: Context, notes: tuple[str, ...]
) -> Threshold:
    signal = meant.signal
    unit = meant.unit or signal.unit
    side = comparison.side
    low = meant.in_signal(comparison.number)
    high = low if comparison.until is None else meant.in_signal(comparison.until)
    softness, why, unknown = _softness(comparison, meant, tables)
    if side is Side.AT:
        side = Side.AT_MOST if _comes_down(low, signal, context) else Side.AT_LEAST
        if side is Side.AT_MOST:
            notes = (*notes, f"{signal.name} is coming down: {comparison.text!r} is taken as {side.value}")
    corners = _corners(side, low, high, softness)
    said = _said(comparison, side, unit, signal, low, high)
    if corners[0] >= signal.high or corners[3] <= signal.low:
        shown = f"{signal.low:g} and {signal.high:g} {symbol(signal.unit)}".rstrip()
        reason = f"never: {signal.name} lies between {shown}, so it is not {said}"
        return Threshold(tables, reason=reason, impossible=True)
    term = Term(said, corners)
    term = replace(term, meaning=f"{_shown(term, signal)}{why}")
    terms = MappingProxyType({**meant.variable.terms, said: term})
    variable = replace(meant.variable, terms=terms)
    variables = MappingProxyType({**tables.variables, variable.name: variable})
    return Threshold(replace(tables, variables=variables), Is(variable.name, said), notes=(*notes, *unknown))


def _softness(comparison: Comparison, meant: Meant, tables: Tables) -> tuple[float, str, tuple[str, ...]]:
    """Give the softness in the signal's unit, where it comes from, and notes about hedges."""
    soft, signal = tables.thresholds, meant.signal
    if signal.softness is not None:
        softness, why = signal.softness, f"over {signal.name}'s own softness"
    elif soft is None or comparison.number == 0:
        softness, why = 0.0, ""
    else:
        number = comparison.number
        softness = abs(meant.in_signal(number * (1 + soft.share)) - meant.in_signal(number))
        why = f"over {100 * soft.share:.3g} % of the number, {soft.source}"
    known = [hedge for hedge in comparison.fuzziness if hedge in tables.time_hedges]
    for hedge in known:
        softness *= tables.time_hedges[hedge].widen
        why += f", times {tables.time_hedges[hedge].widen:g} for {hedge!r}" if softness else ""
    unknown = tuple(
        f"unknown hedge {hedge!r}: taken as none" for hedge in comparison.fuzziness if hedge not in known
    )
    return softness, f" ({why})" if why else "", unknown


def _corners(side: Side, low: float, high: float, softness: float) -> tuple[float, float, float, float]:
    """Give the term's trapezoid; a side that leaves the number itself out has it at degree 0."""
    match side:
        case Side.ABOVE:
            return low, max(low + softness, math.nextafter(low, _OPEN)), _OPEN, _OPEN
        case Side.AT_LEAST | Side.AT:
            return low - softness, low, _OPEN, _OPEN
        case Side.AT_MOST:
            return -_OPEN, -_OPEN, low, low + softness
        case Side.BELOW:
            return -_OPEN, -_OPEN, min(low - softness, math.nextafter(low, -_OPEN)), low
        case Side.BETWEEN:
            return low - softness, low, high, high + softness


def _comes_down(number: float, signal: Signal, context: Context) -> bool:
    """Tell whether a signal is above a number and, as expected, on its way down to it."""
    forecast = Series.within(context, signal).forecast
    if forecast is None:
        return False
    last = forecast.until if math.isfinite(forecast.until) else max(forecast.settled(), 0.0)
    now, end = forecast.quantiles(np.array([max(forecast.start, 0.0), max(last, 0.0)]), (0.5,))[0]
    return bool(now > number and now - end > _ALL_THE_WAY * (now - number))


def _said(
    comparison: Comparison, side: Side, unit: str | None, signal: Signal, low: float, high: float
) -> str:
    """Say the term: "above 150 °C", "at least 350 °F (177 °C)"."""

    def shown(first: float, second: float, unit: str | None) -> str:
        numbers = f"{first:.4g}" if side is not Side.BETWEEN else f"{first:.4g} and {second:.4g}"
        return f"{numbers} {symbol(unit)}".rstrip()

    until = comparison.number if comparison.until is None else comparison.until
    own = shown(low, high, signal.unit)
    said = shown(comparison.number, until, unit)
    words = " ".join((side.value, *comparison.fuzziness, said))
    return words if said == own else f"{words} ({own})"


def _shown(term: Term, signal: Signal) -> str:
    """Say where a term is full and where it is nothing."""
    rise, full, end, fall = (f"{corner:.4g} {symbol(signal.unit)}".rstrip() for corner in term.corners)
    parts = []
    if math.isfinite(term.corners[1]):
        parts.append(f"nothing at {rise} and full from {full}" if rise != full else f"full from {full}")
    if math.isfinite(term.corners[2]):
        parts.append(f"full to {end} and nothing from {fall}" if end != fall else f"full to {end}")
    return ", ".join(parts)
