"""Numbers in clauses: "the oven is above 150 degrees" speaks of a term that is made for the occasion.

A number that a person says is no cliff: the degree falls to 0 over a softness, which is a share of the number
(the tables' ``thresholds``), or the signal's own. "At least 150" is full from 150 on and 0 below 150 less the
softness, "above 150" is 0 at 150; the same downwards.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np

from fuzzytime.context import Context, Signal
from fuzzytime.context.series import Series
from fuzzytime.context.units import convert, fits, measured_in, symbol
from fuzzytime.requirement import Comparison, Side
from fuzzytime.rulebook.formula import Is
from fuzzytime.rulebook.phrases import in_numbers, plain, ways_to_name, within
from fuzzytime.rulebook.tables import Tables
from fuzzytime.rulebook.variables import Source, Term, Variable

_ALL_THE_WAY = 0.5
"""The share of the way to a number that a signal must fall, as expected, for it to be coming down to it."""

MOST_SHOWN = 4
"""Signals that a reason names at most."""

_OPEN = math.inf
_NAMELESS = frozenset(("", "it", "they", "there", "temperature"))


@dataclass(frozen=True, slots=True)
class Threshold:
    """A number understood: the atom, the tables that know its term, and notes; or why there is none."""

    tables: Tables
    atom: Is | None = None
    reason: str | None = None
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class _Meant:
    """A variable that may be meant, its signal, and the unit that was said, None where none was."""

    variable: Variable
    signal: Signal
    unit: str | None


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
) -> Threshold:
    """Find what a number measures, and make its term.

    Parameters
    ----------
    named
        The clause, plain, without the words of the comparison.
    guess
        What the clause is about, or what a pronoun in it stands for, as far as the sentence tells.
    context
        Readings: they tell what "it" is, and from which side "at 150" is reached.
    before
        The variable that the clause spoke of before: "above 100 degrees, but below 150".
    """
    meant = _meant(comparison, named, guess, tables) or _gone_on(comparison, before, tables)
    named_none = not meant
    if named_none and _is_nameless(guess, named):
        meant = [one for one in _of_unit(comparison, tables) if context.of_signal(one.signal.name)]
    meant = [one for one in meant if _can_be(comparison, one)] or meant
    signals = list(dict.fromkeys(one.signal.name for one in meant))
    if not meant:
        return Threshold(tables, reason=_why_unknown(comparison, named, guess, tables))
    if len(signals) > 1:
        return Threshold(tables, reason=f"{comparison.text!r} may be about {' or '.join(signals)}: name it")
    notes: tuple[str, ...] = ()
    if named_none:
        notes = (f"{comparison.text!r} is taken as about {signals[0]}: nothing else of its kind was read",)
    return _made(comparison, meant[0], tables, context, notes)


def candidates(comparison: Comparison, named: str, guess: str | None, tables: Tables) -> frozenset[str]:
    """Give the signals that a number may be about, whatever has been read."""
    meant = _meant(comparison, named, guess, tables) or _of_unit(comparison, tables)
    return frozenset(one.signal.name for one in meant)


def _meant(comparison: Comparison, named: str, guess: str | None, tables: Tables) -> list[_Meant]:
    """Give what the words name and the unit fits: by a unit that was said, then by the longest words."""
    for text in (named, plain(guess or "")):
        ranked: dict[tuple[bool, int], list[_Meant]] = {}
        for variable, length in _named(text, tables):
            signal = tables.signals[variable.signal]
            if fits(comparison.behind, signal.unit):
                unit = measured_in(comparison.behind, signal.unit)
                # A bare number is the very thing for a signal without a unit.
                exact = unit is not None or signal.unit is None
                ranked.setdefault((exact, length), []).append(_Meant(variable, signal, unit))
        if ranked:
            return ranked[max(ranked)]
    return []


def _gone_on(comparison: Comparison, before: str | None, tables: Tables) -> list[_Meant]:
    """Give what the clause spoke of before, if the number fits that."""
    variable = tables.variables.get(before or "")
    if variable is None or variable.source is not Source.OF:
        return []
    signal = tables.signals[variable.signal]
    if not fits(comparison.behind, signal.unit):
        return []
    return [_Meant(variable, signal, measured_in(comparison.behind, signal.unit))]


def _of_unit(comparison: Comparison, tables: Tables) -> list[_Meant]:
    """Give everything that is measured in the unit that was said: "hotter than 150 degrees"."""
    found = []
    for variable in _values(tables):
        signal = tables.signals[variable.signal]
        unit = measured_in(comparison.behind, signal.unit)
        if unit is not None:
            found.append(_Meant(variable, signal, unit))
    return found


def _named(text: str, tables: Tables) -> Iterator[tuple[Variable, int]]:
    """Give the variables whose names stand in a plain text, and how long the names are."""
    for variable in _values(tables):
        ways = in_numbers((*ways_to_name(variable), *_as_spoken(variable.signal)))
        length = max((len(way) for way in ways if within(way, text)), default=0)
        if length:
            yield variable, length


def _values(tables: Tables) -> Iterator[Variable]:
    """Give the variables over values of signals, and one for each signal that has none."""
    spoken = set()
    for variable in tables.variables.values():
        if variable.source is Source.OF:
            spoken.add(variable.signal)
            yield variable
    for signal in tables.signals.values():
        if not signal.event and signal.name not in spoken:
            taken = signal.name in tables.variables
            yield Variable(
                name=f"{signal.name}_value" if taken else signal.name, source=Source.OF, signal=signal.name
            )


def _as_spoken(signal: str) -> tuple[str, ...]:
    """Give the ways to say a signal's own name: "kiln_temp" is the kiln temperature."""
    words = signal.replace("_", " ").lower()
    return (words, f"{words}erature") if words.endswith("temp") else (words,)


def _is_nameless(guess: str | None, named: str) -> bool:
    """Tell whether a clause names nothing: "it" and "there" leave open what the number is about."""
    subject = plain(guess or "")
    return subject in _NAMELESS or not within(subject, named)


def _can_be(comparison: Comparison, meant: _Meant) -> bool:
    """Tell whether a signal can have a value that is said: no room is at 150 degrees."""
    number = _converted(comparison.number, meant.unit or meant.signal.unit, meant.signal)
    return meant.signal.low <= number <= meant.signal.high


def _why_unknown(comparison: Comparison, named: str, guess: str | None, tables: Tables) -> str:
    said = f"{comparison.text} {comparison.behind}".strip()
    for text in (named, plain(guess or "")):
        for variable, _ in _named(text, tables):
            unit = tables.signals[variable.signal].unit
            return f"{variable.signal} is measured in {symbol(unit) or 'a bare number'}, got {said!r}"
    if not _is_nameless(guess, named):
        return f"no signal of {guess!r} tells {said!r}"
    possible = [one for one in _of_unit(comparison, tables) if _can_be(comparison, one)]
    signals = dict.fromkeys(one.signal.name for one in possible)
    if not signals:
        return f"no signal tells {said!r}"
    shown = ", ".join(list(signals)[:MOST_SHOWN]) + (", …" if len(signals) > MOST_SHOWN else "")
    return f"not enough readings: {said!r} may be about {shown}"


def _made(
    comparison: Comparison, meant: _Meant, tables: Tables, context: Context, notes: tuple[str, ...]
) -> Threshold:
    signal = meant.signal
    unit = meant.unit or signal.unit
    side = comparison.side
    low = _converted(comparison.number, unit, signal)
    high = low if comparison.until is None else _converted(comparison.until, unit, signal)
    softness, why, unknown = _softness(comparison, unit, signal, tables)
    if side is Side.AT:
        side = Side.AT_MOST if _comes_down(low, signal, context) else Side.AT_LEAST
        if side is Side.AT_MOST:
            notes = (*notes, f"{signal.name} is coming down: {comparison.text!r} is taken as {side.value}")
    corners = _corners(side, low, high, softness)
    said = _said(comparison, side, unit, signal, low, high)
    if corners[0] >= signal.high or corners[3] <= signal.low:
        shown = f"{signal.low:g} and {signal.high:g} {symbol(signal.unit)}".rstrip()
        return Threshold(tables, reason=f"never: {signal.name} lies between {shown}, so it is not {said}")
    term = Term(said, corners)
    term = replace(term, meaning=f"{_shown(term, signal)}{why}")
    terms = MappingProxyType({**meant.variable.terms, said: term})
    variable = replace(meant.variable, terms=terms)
    variables = MappingProxyType({**tables.variables, variable.name: variable})
    return Threshold(replace(tables, variables=variables), Is(variable.name, said), notes=(*notes, *unknown))


def _converted(value: float, unit: str | None, signal: Signal) -> float:
    return value if unit is None or signal.unit is None else convert(value, unit, signal.unit)


def _softness(
    comparison: Comparison, unit: str | None, signal: Signal, tables: Tables
) -> tuple[float, str, tuple[str, ...]]:
    """Give the softness in the signal's unit, where it comes from, and notes about hedges."""
    soft = tables.thresholds
    if signal.softness is not None:
        softness, why = signal.softness, f"over {signal.name}'s own softness"
    elif soft is None or comparison.number == 0:
        softness, why = 0.0, ""
    else:
        number = comparison.number
        softness = abs(_converted(number * (1 + soft.share), unit, signal) - _converted(number, unit, signal))
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
    readings = context.of_signal(signal.name)
    forecast = Series.of(signal, readings).forecast if readings else None
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
