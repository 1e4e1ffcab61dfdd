"""What is asked of the tables, and what they say about one moment of an execution."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from types import MappingProxyType

from fuzzytime.context import Context
from fuzzytime.requirement import Reference, TimeRequirement
from fuzzytime.rulebook.logic.formula import Formula
from fuzzytime.rulebook.over_time.world import World
from fuzzytime.rulebook.resolving.adapt import said_width
from fuzzytime.rulebook.resolving.evidence import signals_of
from fuzzytime.rulebook.resolving.inference import Heard, hear, holds_now
from fuzzytime.rulebook.resolving.resolution import HedgeEffect, Share, Trace
from fuzzytime.rulebook.tables.contents import Row, Tables
from fuzzytime.rulebook.tables.profile import Actor
from fuzzytime.rulebook.tables.rules import Rule
from fuzzytime.satisfaction import SatisfactionFunction


@dataclass(frozen=True, slots=True)
class Question:
    """A requirement with what it is asked under; the context's readings are admitted ones."""

    requirement: TimeRequirement
    verb: str | None
    context: Context
    horizon: float
    tables: Tables
    actor: Actor | None

    def width(self, row: Row, t: float) -> float:
        """Give the half-base w for a time named, where the row does not fix it."""
        return row.w if row.w is not None else said_width(self.requirement, self.tables, t, self.actor)

    def world(self, formulas: Sequence[Formula]) -> World:
        """Gather what is known of everything that some formulas speak of."""
        names = [name for formula in formulas for name in signals_of(formula, self.tables)]
        return World.of(self.context, self.tables, dict.fromkeys(names))

    def known(self, formula: Formula) -> bool:
        """Tell whether something is known of every signal and event that a formula speaks of."""
        world = self.world([formula])
        return all(world.known(name) for name in signals_of(formula, self.tables))

    def heard(self, rules: Sequence[Rule]) -> tuple[Heard, ...]:
        """Ask rules what they say now."""
        return hear(rules, self.world([rule.condition for rule in rules if rule.condition is not None]))

    def explained(
        self, formula: Formula, shares: Sequence[Share], heard: Sequence[Heard]
    ) -> tuple[Share, ...]:
        """Say of the row, which comes first, how far a sentence's own condition holds now.

        One that is a rule's is explained by the rule.
        """
        if any(part.rule.condition == formula for part in heard):
            return tuple(shares)
        degree, atoms = holds_now(formula, self.world([formula]))
        return (replace(shares[0], degree=degree, atoms=atoms), *shares[1:])


@dataclass(frozen=True, slots=True, kw_only=True)
class Said:
    """ψ over the moment that a requirement speaks of, with everything that explains it.

    The fields are those of `Resolution`, before the moment becomes a start time; ``reference`` is the moment
    that the model or the row asks for, None where that is the requirement's own.
    """

    satisfaction: SatisfactionFunction
    model: str
    parameters: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))
    shares: tuple[Share, ...] = ()
    hedges: tuple[HedgeEffect, ...] = ()
    reason: str | None = None
    untold: bool = False
    notes: tuple[str, ...] = ()
    trace: Trace | None = None
    reference: Reference | None = None
    named: float | None = None


_OPEN = 0.5
"""Bounds of a truth that lie further apart say nothing."""


def notes_on(row: str, heard: Sequence[Heard]) -> tuple[str, ...]:
    """Say which rules miss readings, and that the table's row stands where no rule speaks."""
    notes = [
        f"the rule {part.rule.name!r} misses readings of {' and '.join((*part.missing, *part.outdated))}"
        for part in heard
        if part.missing or part.outdated
    ]
    notes += [
        f"the rule {part.rule.name!r} cannot tell: the readings do not cover the time that it looks at"
        for part in heard
        if not part.missing and not part.outdated and part.degree.high - part.degree.low > _OPEN
    ]
    if heard and all(part.weight == 0 for part in heard):
        notes.append(f"no rule over context speaks: the table's row {row!r} stands")
    return tuple(notes)
