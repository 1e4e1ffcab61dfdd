"""What was read: values and events on the instruction's timeline, where 0 is the moment it was given."""

from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import groupby
from typing import ClassVar, TypeVar, cast

from fuzzytime.context.signals import Signal
from fuzzytime.context.units import parse_quantity
from fuzzytime.errors import FuzzytimeError
from fuzzytime.spelling import suggestion

MAX_READINGS = 200_000
FARTHEST = 1e10
"""How many seconds from now a reading may lie at most."""

_T = TypeVar("_T")

Value = float | str | None
"""A number, a text such as ``"180 degC"``, or None for an event that happens."""


@dataclass(frozen=True, slots=True)
class Reading:
    """One value of a signal at one time, in seconds; an event has no value.

    Raises
    ------
    FuzzytimeError
        If the value is not finite, or the time is not within some centuries.
    """

    signal: str
    at: float
    value: float | None = None
    unit: str | None = None

    def __post_init__(self) -> None:
        if not abs(self.at) <= FARTHEST:
            raise FuzzytimeError(f"a reading's time must lie within {FARTHEST:g} s, got {self.at}")
        if self.value is not None and not abs(self.value) < float("inf"):
            raise FuzzytimeError(f"a reading's value must be finite, got {self.value}")

    @classmethod
    def of(cls, signal: str, value: Value, at: float = 0.0) -> "Reading":
        """Make a reading of a number, of a text with a unit, or of an event (None).

        Raises
        ------
        FuzzytimeError
            If the text is no value.
        """
        if isinstance(value, str):
            return cls(signal, at, *parse_quantity(value))
        return cls(signal, at, None if value is None else float(value))

    def shifted(self, by: float) -> "Reading":
        """Give the same on a timeline whose origin is ``by`` seconds earlier."""
        return Reading(self.signal, self.at + by, self.value, self.unit)


@dataclass(frozen=True, slots=True)
class Context:
    """Readings, ordered by signal and time; of two at one time the later one given stands.

    Readings lie at times ≤ 0, that is up to now. An event may lie ahead, where it is announced; and a
    context that was `shifted` to an older timeline has readings after that timeline's origin.

    >>> context = Context.of({"pan_temp": "356 degF", "queue": 3, "timer": None})
    >>> [reading.signal for reading in context.readings]
    ['pan_temp', 'queue', 'timer']
    """

    empty: ClassVar["Context"]

    readings: tuple[Reading, ...] = ()
    _by_signal: Mapping[str, tuple[Reading, ...]] = field(init=False, repr=False, compare=False)
    _derived: dict[object, object] = field(default_factory=dict, init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        if len(self.readings) > MAX_READINGS:
            raise FuzzytimeError(
                f"a context must hold at most {MAX_READINGS:,} readings, got {len(self.readings):,}"
            )
        latest = {(reading.signal, reading.at): reading for reading in self.readings}
        object.__setattr__(self, "readings", tuple(latest[key] for key in sorted(latest)))
        each = groupby(self.readings, lambda reading: reading.signal)
        object.__setattr__(self, "_by_signal", {name: tuple(readings) for name, readings in each})

    @classmethod
    def of(cls, values: Mapping[str, Value | Sequence[tuple[float, Value]]]) -> "Context":
        """Make a context of values now, or of lists of (time in seconds, value).

        Raises
        ------
        FuzzytimeError
            If a text is no value.
        """
        readings: list[Reading] = []
        for signal, given in values.items():
            pairs = [(0.0, given)] if given is None or isinstance(given, float | int | str) else given
            readings += [Reading.of(signal, value, at) for at, value in pairs]
        return cls(tuple(readings))

    def of_signal(self, name: str) -> tuple[Reading, ...]:
        """Give one signal's readings by time."""
        return self._by_signal.get(name, ())

    def derived(self, key: Hashable, derive: Callable[[], _T]) -> _T:
        """Give what is derived from these readings alone, and remember it by a key: a forecast, say."""
        if key not in self._derived:
            self._derived[key] = derive()
        return cast("_T", self._derived[key])

    def with_reading(self, *readings: Reading) -> "Context":
        """Give a context with more readings."""
        return Context((*self.readings, *readings))

    def merged(self, other: "Context") -> "Context":
        """Give a context with the readings of both; at one time those of the other stand."""
        return Context((*self.readings, *other.readings))

    def shifted(self, by: float) -> "Context":
        """Give the same readings on a timeline whose origin is ``by`` seconds earlier."""
        return Context(tuple(reading.shifted(by) for reading in self.readings))

    def admitted(self, signals: Mapping[str, Signal]) -> "Context":
        """Give the readings in the units of the declared signals.

        Raises
        ------
        FuzzytimeError
            If a signal is not declared, or a value is not one that it can have.
        """
        declared = tuple(_declared(name, signals) for name in self._by_signal)
        return self.derived(("admitted", declared), lambda: self._as(signals))

    def _as(self, signals: Mapping[str, Signal]) -> "Context":
        found = tuple(admitted(reading, signals) for reading in self.readings)
        same = all(one is other for one, other in zip(found, self.readings, strict=True))
        return self if same else Context(found)


Context.empty = Context()


def admitted(reading: Reading, signals: Mapping[str, Signal]) -> Reading:
    """Give a reading in its declared signal's unit.

    Raises
    ------
    FuzzytimeError
        If the signal is not declared, or the value is not one that it can have.
    """
    signal = _declared(reading.signal, signals)
    value, unit = signal.admitted(reading.value, reading.unit), None if signal.event else signal.unit
    return (
        reading
        if (value, unit) == (reading.value, reading.unit)
        else replace(reading, value=value, unit=unit)
    )


def _declared(name: str, signals: Mapping[str, Signal]) -> Signal:
    signal = signals.get(name)
    if signal is None:
        raise FuzzytimeError(f"unknown signal {name!r}{suggestion(name, signals)}")
    return signal
