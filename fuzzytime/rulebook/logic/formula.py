"""Conditions as values: atoms such as "pan is very hot", joined and looked at through windows of time."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from enum import StrEnum

from fuzzytime.times import format_duration


class Operator(StrEnum):
    """What is asked of a condition over a window of time."""

    SOMETIME = "sometime"
    THROUGHOUT = "throughout"
    MOSTLY = "mostly"


class Direction(StrEnum):
    """Which way a window lies."""

    LAST = "last"
    NEXT = "next"


@dataclass(frozen=True, slots=True)
class Is:
    """``variable is [hedges] term``."""

    variable: str
    term: str
    hedges: tuple[str, ...] = ()

    def __str__(self) -> str:
        """As it is written in a rule."""
        return " ".join((self.variable, "is", *self.hedges, self.term))


@dataclass(frozen=True, slots=True)
class Happened:
    """An event has happened: what "when the timer rings" waits for."""

    event: str

    def __str__(self) -> str:
        """As a person says it."""
        return f"{self.event} has happened"


@dataclass(frozen=True, slots=True)
class Not:
    """The contrary of a condition."""

    part: "Formula"

    def __str__(self) -> str:
        """As it is written in a rule."""
        return f"not {_grouped(self.part)}"


@dataclass(frozen=True, slots=True)
class And:
    """All of several conditions."""

    parts: tuple["Formula", ...]

    def __str__(self) -> str:
        """As it is written in a rule."""
        return " and ".join(map(_grouped, self.parts))


@dataclass(frozen=True, slots=True)
class Or:
    """One of several conditions."""

    parts: tuple["Formula", ...]

    def __str__(self) -> str:
        """As it is written in a rule."""
        return " or ".join(map(_grouped, self.parts))


@dataclass(frozen=True, slots=True)
class Window:
    """A condition over the last or next ``length`` seconds.

    ``softness`` σ lets the window fade: its weight is 1 up to the length d and falls to 0 at d·(1 + σ).
    """

    operator: Operator
    direction: Direction
    length: float
    softness: float
    part: "Formula"

    @property
    def reach(self) -> float:
        """Where the window's weight has fallen to 0, in seconds."""
        return self.length * (1 + self.softness)

    def __str__(self) -> str:
        """As it is written in a rule."""
        soft = {0.25: "about ", 0.5: "roughly "}.get(self.softness, "")
        inside = "the" if self.operator is Operator.THROUGHOUT else "in the"
        length = f"{soft}{format_duration(self.length)}"
        part = f"({self.part})" if isinstance(self.part, Not) else _grouped(self.part)
        return f"{part} {self.operator} {inside} {self.direction} {length}"


Formula = Is | Happened | Not | And | Or | Window


def _grouped(formula: Formula) -> str:
    return str(formula) if isinstance(formula, Is | Happened | Not) else f"({formula})"


def nodes(formula: Formula) -> Iterator[Formula]:
    """Walk through a formula from left to right, each node before its parts."""
    yield formula
    if isinstance(formula, Not | Window):
        yield from nodes(formula.part)
    elif isinstance(formula, And | Or):
        for part in formula.parts:
            yield from nodes(part)


def variables(formula: Formula) -> tuple[str, ...]:
    """Give the variables that a formula speaks of, each once."""
    return tuple(dict.fromkeys(node.variable for node in nodes(formula) if isinstance(node, Is)))


def events(formula: Formula) -> tuple[str, ...]:
    """Give the events that a formula waits for, each once."""
    return tuple(dict.fromkeys(node.event for node in nodes(formula) if isinstance(node, Happened)))


def with_hedges_of(said: Formula, formula: Formula) -> Formula:
    """Give a formula with the hedges that a sentence's atom has on the same term: "very hot" for "hot"."""
    if isinstance(formula, Is):
        if not isinstance(said, Is) or (said.variable, said.term) != (formula.variable, formula.term):
            return formula
        return replace(formula, hedges=(*said.hedges, *formula.hedges))
    if isinstance(formula, Not | Window):
        return replace(formula, part=with_hedges_of(said, formula.part))
    if isinstance(formula, And | Or):
        return replace(formula, parts=tuple(with_hedges_of(said, part) for part in formula.parts))
    return formula


def window_reach(formula: Formula, direction: Direction) -> float:
    """Give how many seconds back, or ahead, windows inside windows look at most."""
    if isinstance(formula, And | Or):
        return max(window_reach(part, direction) for part in formula.parts)
    if isinstance(formula, Not):
        return window_reach(formula.part, direction)
    if isinstance(formula, Window):
        own = formula.reach if formula.direction is direction else 0.0
        return own + window_reach(formula.part, direction)
    return 0.0
