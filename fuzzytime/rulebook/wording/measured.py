"""What a number in a clause measures: the variable that the words name, or that the unit tells."""

from collections.abc import Iterator
from dataclasses import dataclass

from fuzzytime.context import Context, Signal
from fuzzytime.context.units import convert, fits, measured_in, symbol
from fuzzytime.english import NAMELESS
from fuzzytime.requirement import Comparison
from fuzzytime.rulebook.tables.contents import Tables
from fuzzytime.rulebook.tables.variables import Source, Variable
from fuzzytime.rulebook.wording.phrases import in_numbers, is_of_another, plain, ways_to_name, within

MOST_SHOWN = 4
"""Signals that a reason names at most."""

_NAMELESS = NAMELESS | {"", "temperature"}


@dataclass(frozen=True, slots=True)
class Meant:
    """A variable that may be meant, its signal, and the unit that was said, None where none was."""

    variable: Variable
    signal: Signal
    unit: str | None

    def in_signal(self, value: float) -> float:
        """Give a value that was said in the signal's unit."""
        unit = self.unit or self.signal.unit
        return value if unit is None or self.signal.unit is None else convert(value, unit, self.signal.unit)


@dataclass(frozen=True, slots=True)
class Measured:
    """What a number measures, and notes; or why nothing is known to be measured by it."""

    meant: Meant | None = None
    reason: str | None = None
    notes: tuple[str, ...] = ()


def measured(
    comparison: Comparison,
    named: str,
    guess: str | None,
    tables: Tables,
    context: Context,
    before: str | None = None,
    about: str = "",
) -> Measured:
    """Find what a number measures.

    Parameters
    ----------
    named
        The clause, plain, without the words of the comparison.
    guess
        What the clause is about, or what a pronoun in it stands for, as far as the sentence tells.
    context
        Readings: they tell what "it" is.
    before
        The variable that the clause spoke of before: "above 100 degrees, but below 150".
    about
        The noun phrase that the clause is about, where it is one: things named beside it are not measured.
    """
    meant = _meant_by(comparison, named, guess, tables, about) or _gone_on(comparison, before, tables)
    named_none = not meant
    if named_none and _is_nameless(guess, named):
        meant = [one for one in _of_unit(comparison, tables) if context.of_signal(one.signal.name)]
    meant = [one for one in meant if _can_be(comparison, one)] or meant
    signals = list(dict.fromkeys(one.signal.name for one in meant))
    if not meant:
        return Measured(reason=_why_unknown(comparison, named, guess, tables, about))
    if len(signals) > 1:
        return Measured(reason=f"{comparison.text!r} may be about {' or '.join(signals)}: name it")
    notes: tuple[str, ...] = ()
    if named_none:
        notes = (f"{comparison.text!r} is taken as about {signals[0]}: nothing else of its kind was read",)
    return Measured(meant[0], notes=notes)


def candidates(comparison: Comparison, named: str, guess: str | None, tables: Tables) -> frozenset[str]:
    """Give the signals that a number may be about, whatever has been read."""
    meant = _meant_by(comparison, named, guess, tables) or _of_unit(comparison, tables)
    return frozenset(one.signal.name for one in meant)


def _meant_by(
    comparison: Comparison, named: str, guess: str | None, tables: Tables, about: str = ""
) -> list[Meant]:
    """Give what the words name and the unit fits: by a unit that was said, then by the longest words."""
    for text in (named, plain(guess or "")):
        ranked: dict[tuple[bool, int], list[Meant]] = {}
        for variable, length in _named(text, tables, about):
            signal = tables.signals[variable.signal]
            if fits(comparison.behind, signal.unit):
                unit = measured_in(comparison.behind, signal.unit)
                # A bare number is the very thing for a signal without a unit.
                exact = unit is not None or signal.unit is None
                ranked.setdefault((exact, length), []).append(Meant(variable, signal, unit))
        if ranked:
            return ranked[max(ranked)]
    return []


def _gone_on(comparison: Comparison, before: str | None, tables: Tables) -> list[Meant]:
    """Give what the clause spoke of before, if the number fits that."""
    variable = tables.variables.get(before or "")
    if variable is None or variable.source is not Source.OF:
        return []
    signal = tables.signals[variable.signal]
    if not fits(comparison.behind, signal.unit):
        return []
    return [Meant(variable, signal, measured_in(comparison.behind, signal.unit))]


def _of_unit(comparison: Comparison, tables: Tables) -> list[Meant]:
    """Give everything that is measured in the unit that was said: "hotter than 150 degrees"."""
    found = []
    for variable in _values(tables):
        signal = tables.signals[variable.signal]
        unit = measured_in(comparison.behind, signal.unit)
        if unit is not None:
            found.append(Meant(variable, signal, unit))
    return found


def _named(text: str, tables: Tables, about: str) -> Iterator[tuple[Variable, int]]:
    """Give the variables whose names stand in a plain text, and how long the names are.

    What is only named beside the thing that the clause is about ("bed 3's sats") is not measured.
    """
    for variable in _values(tables):
        ways = in_numbers((*ways_to_name(variable), *_as_spoken(variable.signal)))
        length = max((len(way) for way in ways if within(way, text)), default=0)
        if length and not is_of_another(ways, about):
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


def _can_be(comparison: Comparison, meant: Meant) -> bool:
    """Tell whether a signal can have a value that is said: no room is at 150 degrees."""
    return meant.signal.low <= meant.in_signal(comparison.number) <= meant.signal.high


def _why_unknown(comparison: Comparison, named: str, guess: str | None, tables: Tables, about: str) -> str:
    said = f"{comparison.text} {comparison.behind}".strip()
    for text in (named, plain(guess or "")):
        for variable, _ in _named(text, tables, about):
            unit = tables.signals[variable.signal].unit
            return f"{variable.signal} is measured in {symbol(unit) or 'a bare number'}, got {said!r}"
    if not _is_nameless(guess, named):
        thing = (guess or "").replace(" 's", "'s")
        return f"no signal of {thing!r} tells {said!r}"
    possible = [one for one in _of_unit(comparison, tables) if _can_be(comparison, one)]
    signals = dict.fromkeys(one.signal.name for one in possible)
    if not signals:
        return f"nothing tells {said!r}"
    shown = ", ".join(list(signals)[:MOST_SHOWN]) + (", …" if len(signals) > MOST_SHOWN else "")
    return f"not enough readings: {said!r} may be about {shown}"
