"""What resolving a requirement gives: ψ, and every row, rule, atom and reading that made it so."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from fuzzytime.requirement import Reference
from fuzzytime.satisfaction import Floats, SatisfactionFunction


@dataclass(frozen=True, slots=True)
class Degree:
    """A truth between two bounds: they differ where a reading is missing."""

    low: float
    high: float


@dataclass(frozen=True, slots=True)
class AtomDegree:
    """How true one part of a condition is now, and the reading that says so.

    ``reading`` is the value of the variable now, None where it is unknown; ``unit`` is its unit. ``evidence``
    says the same in words, or why nothing is known. ``meaning`` says where the part is full and where
    nothing, for a number that was said.
    """

    text: str
    degree: Degree
    reading: float | None = None
    unit: str | None = None
    evidence: str = ""
    meaning: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Share:
    """A row of the lookup or a rule, and what it had to say.

    Parameters
    ----------
    source
        ``file:line`` of the row or rule.
    share
        Its part in the parameters of the model, from 0 to 1; 0 for a rule that stays silent or is outvoted.
    degree
        How far its condition holds now.
    scale
        The factors that it multiplied in, by parameter, for a rule that only scales.
    """

    name: str
    source: str
    share: float
    degree: Degree = Degree(1.0, 1.0)
    atoms: tuple[AtomDegree, ...] = ()
    scale: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))


@dataclass(frozen=True, slots=True)
class HedgeEffect:
    """A hedge, the factor of width that it brought here, and its row."""

    name: str
    factor: float
    source: str


@dataclass(frozen=True, slots=True, kw_only=True)
class SignalTrace:
    """One signal over time: its readings, and the forecast's median and 90 % band.

    ``forecast_*`` have one length; values of events are empty. ``outlook`` says where it ends up, as
    expected: "settles at 150 °C"; it is empty where nothing is forecast.
    """

    name: str
    unit: str | None
    reading_times: Floats
    reading_values: Floats
    forecast_times: Floats
    forecast_low: Floats
    forecast_median: Floats
    forecast_high: Floats
    outlook: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Trace:
    """A condition over time, to draw: signals, the degree of each atom, of the whole, and ψ.

    ``times`` has shape (k,); ``atoms`` are pairs of text and values of that shape; ``low`` and ``high``
    bound the truth of the whole condition, before the wish for promptness makes ψ of it.
    """

    times: Floats
    signals: tuple[SignalTrace, ...]
    atoms: tuple[tuple[str, Floats], ...]
    low: Floats
    high: Floats
    satisfaction: Floats


@dataclass(frozen=True, slots=True, kw_only=True)
class Resolution:
    """ψ over start times, with its explanation.

    Parameters
    ----------
    satisfaction
        ψ over start times in seconds on the requirement's own timeline.
    model
        The model's name in the tables.
    parameters
        What its formula was filled with, in seconds: t, w and the like.
    reference
        The moment of the execution that the words, or else the tables' row, are about.
    shares
        The row and the rules that took part, in the order of the tables.
    hedges
        The hedges applied.
    reason
        Why ψ is 0 everywhere from now on; None where it is not.
    untold
        Whether that is so only because nobody has told yet what it waits for.
    notes
        What a person should know: an unknown hedge, a rule whose readings are missing.
    trace
        For conditions, what there is to draw.
    from_readings
        Whether its times count from the readings' now, and not from when the words were said.
    named
        The start that the words name, where they name one: of equally good times the one that is meant.
    """

    satisfaction: SatisfactionFunction
    model: str
    parameters: Mapping[str, float]
    shares: tuple[Share, ...]
    hedges: tuple[HedgeEffect, ...] = ()
    reason: str | None = None
    untold: bool = False
    notes: tuple[str, ...] = ()
    trace: Trace | None = None
    reference: Reference = Reference.START
    from_readings: bool = False
    named: float | None = None
