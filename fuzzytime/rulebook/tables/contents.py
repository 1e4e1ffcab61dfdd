"""What rule files say, as values: models, rows, hedges, and how later files override earlier ones.

Every row keeps its ``source``, ``file:line``, so that an explanation can point at it.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from types import MappingProxyType
from typing import Any, TypeVar

from fuzzytime.context import Signal
from fuzzytime.requirement import Constraint, Reference, Unit
from fuzzytime.rulebook.logic.norms import Norm
from fuzzytime.rulebook.tables.durations import Durations
from fuzzytime.rulebook.tables.expression import Sum
from fuzzytime.rulebook.tables.matching import Match
from fuzzytime.rulebook.tables.profile import Actor
from fuzzytime.rulebook.tables.rules import Rule
from fuzzytime.rulebook.tables.variables import Variable
from fuzzytime.rulebook.tables.width import Points, Roundness, Softness

_K = TypeVar("_K")
_T = TypeVar("_T")


def _none() -> Mapping[_K, _T]:
    return MappingProxyType({})


@dataclass(frozen=True, slots=True)
class Corners:
    """A trapezoid whose corners depend on what was said."""

    sums: tuple[Sum, Sum, Sum, Sum]


@dataclass(frozen=True, slots=True)
class BellForm:
    """A generalised bell whose centre and width depend on what was said."""

    centre: Sum
    width: Sum
    slope: float


@dataclass(frozen=True, slots=True)
class Model:
    """A satisfaction function with its parameters open; ``constraint`` says what it can express."""

    name: str
    form: Corners | BellForm
    source: str
    constraint: Constraint | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Row:
    """One row of the lookup: the model for some words, and what they fix of it.

    Parameters
    ----------
    model
        A model's name: one of the tables, or ``when``, ``while`` and ``until`` for clauses.
    own
        The model itself, where the row states its own breakpoints.
    begun
        The model for an interval that has begun.
    dated
        The model for a deadline on a day that is said, which begins with that day: "on sunday by six".
    t, w
        In seconds, where the words fix them.
    reference
        The moment of the execution that is meant where the sentence names none: "by six" is done by six.
    hedges
        Hedges that the words imply: "around" is "at about".
    core, fade
        For clauses: seconds of full satisfaction from when the condition holds, and seconds until none.
    """

    name: str
    source: str
    model: str
    own: Model | None = None
    begun: str | None = None
    dated: str | None = None
    t: float | None = None
    w: float | None = None
    reference: Reference | None = None
    hedges: tuple[str, ...] = ()
    core: float | None = None
    fade: float | None = None


@dataclass(frozen=True, slots=True)
class Entry:
    """A row for one exact combination of modifiers, which wins over adapting (direct lookup)."""

    match: Match
    row: Row


@dataclass(frozen=True, slots=True, kw_only=True)
class Hedge:
    """What a hedge does to a model.

    Parameters
    ----------
    widen
        Factor of the half-base w and the plateau.
    shift
        By how many w everything moves later.
    spread
        Factors of t between which the plateau stretches: "a few minutes" are 3 to 5.75 of them.
    model
        The model to take instead: "shortly before".
    """

    name: str
    source: str
    widen: float = 1.0
    shift: float = 0.0
    spread: tuple[float, float] = (1.0, 1.0)
    model: str | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Tables:
    """All sections of one or more rule files."""

    width: Points | None = None
    plateau: float | None = None
    clock: Mapping[Unit, float] = field(default_factory=_none)
    repetition: float | None = None
    roundness: Roundness | None = None
    thresholds: Softness | None = None
    actors: Mapping[Actor, Points] = field(default_factory=_none)
    models: Mapping[str, Model] = field(default_factory=_none)
    prepositions: Mapping[str, Row] = field(default_factory=_none)
    words: Mapping[str, Row] = field(default_factory=_none)
    clauses: Mapping[str, Row] = field(default_factory=_none)
    grains: Mapping[Unit, Row] = field(default_factory=_none)
    constraints: Mapping[Constraint, Row] = field(default_factory=_none)
    entries: tuple[Entry, ...] = ()
    time_hedges: Mapping[str, Hedge] = field(default_factory=_none)
    durations: Durations = field(default_factory=Durations)
    signals: Mapping[str, Signal] = field(default_factory=_none)
    variables: Mapping[str, Variable] = field(default_factory=_none)
    term_hedges: Mapping[str, float] = field(default_factory=_none)
    rules: Mapping[str, Rule] = field(default_factory=_none)
    options: Norm | None = None

    @property
    def norm(self) -> Norm:
        """How degrees are joined."""
        return self.options or Norm.MIN

    def overridden(self, by: "Tables") -> "Tables":
        """Give these tables with another's laid over them: its rows replace rows of the same name.

        The other's entries and rules come first, as the first that matches, or among equals, wins.
        """
        names = [entry.name for entry in fields(self)]
        merged: dict[str, Any] = {name: _merged(getattr(self, name), getattr(by, name)) for name in names}
        return Tables(**merged)


def _merged(lower: object, upper: object) -> object:
    if isinstance(lower, Durations) and isinstance(upper, Durations):
        return lower.overridden(upper)
    if isinstance(lower, Mapping) and isinstance(upper, Mapping):
        return MappingProxyType({**upper, **{key: row for key, row in lower.items() if key not in upper}})
    if isinstance(lower, tuple) and isinstance(upper, tuple):
        return (*upper, *lower)
    return lower if upper is None else upper
