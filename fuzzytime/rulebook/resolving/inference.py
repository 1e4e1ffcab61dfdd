"""Rules choose a model and its parameters: zero-order Takagi-Sugeno, with the table's row as one more rule.

A rule whose ``on`` matches has the weight α = weight · ⟦if⟧ now, by the lower bound of its truth. The
table's row takes part with max(0, 1 − Σα), so that a small change of a reading changes ψ a little, except
where another model comes to win. The model with the largest sum of weights wins, the first among equals; a
parameter is the mean over the winner's rules that set it, the row standing in for what they leave of 1.
Rules that only scale do not count there: their factors multiply in as f^α.
"""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.requirement import TimeRequirement
from fuzzytime.rulebook.logic.formula import Formula, Is
from fuzzytime.rulebook.over_time.truth import Truth, followed
from fuzzytime.rulebook.over_time.world import World
from fuzzytime.rulebook.resolving.evidence import evidence_of, signals_of, too_old
from fuzzytime.rulebook.resolving.resolution import AtomDegree, Degree, Share
from fuzzytime.rulebook.tables.contents import Tables
from fuzzytime.rulebook.tables.matching import described
from fuzzytime.rulebook.tables.rules import Rule
from fuzzytime.rulebook.tables.vocabulary import CLAUSE_MODELS
from fuzzytime.satisfaction import Floats


def takagi_sugeno(weights: ArrayLike, outputs: ArrayLike) -> Floats:
    """Give Σ w·z / Σ w over the first axis of both; NaN where no weight is above 0.

    >>> float(takagi_sugeno([1.0, 0.5], [0.0, 10.0]).round(4))
    3.3333
    """
    weight, output = np.asarray(weights, float), np.asarray(outputs, float)
    with np.errstate(invalid="ignore"):
        return np.asarray((weight * output).sum(axis=0) / weight.sum(axis=0))


@dataclass(frozen=True, slots=True)
class Heard:
    """A rule that matches, how far it holds now, and by which atoms.

    ``weight`` is its α. ``missing`` names signals whose readings would say more, ``outdated`` says of which
    the last reading is too old.
    """

    rule: Rule
    weight: float
    degree: Degree
    atoms: tuple[AtomDegree, ...] = ()
    missing: tuple[str, ...] = ()
    outdated: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Base:
    """What the table's own row says, as one more rule; ``width`` gives w for a t."""

    name: str
    source: str
    model: str
    t: float | None
    width: Callable[[float], float]
    core: float = 0.0
    fade: float = 0.0


@dataclass(frozen=True, slots=True)
class Chosen:
    """The model that wins, its parameters in seconds, and who had which share in them.

    ``scale`` is the factor of w that rules multiply in.
    """

    model: str
    t: float | None
    w: float
    core: float
    fade: float
    scale: float
    shares: tuple[Share, ...]


def matching(requirement: TimeRequirement, verb: str | None, tables: Tables) -> tuple[Rule, ...]:
    """Give the rules that speak about a requirement, whatever the context."""
    texts = described(requirement, verb)
    return tuple(rule for rule in tables.rules.values() if rule.match(texts))


def hear(rules: Sequence[Rule], world: World) -> tuple[Heard, ...]:
    """Give what rules say now; those of whose signals nothing is known stay silent and are left out."""
    heard: list[Heard] = []
    for rule in rules:
        if rule.condition is None:
            heard.append(Heard(rule, rule.weight, Degree(1.0, 1.0)))
            continue
        names = signals_of(rule.condition, world.tables)
        missing = tuple(name for name in names if not world.known(name))
        if len(missing) < len(names) or not names:
            degree, atoms = holds_now(rule.condition, world)
            waits = rule.effect.model in CLAUSE_MODELS
            weight = rule.weight * (1.0 if waits else degree.low)
            outdated = tuple(
                f"{name} (the last is {too_old(world.series[name])})"
                for name in names
                if name in world.series and world.known(name) and too_old(world.series[name])
            )
            heard.append(Heard(rule, weight, degree, atoms, missing, outdated))
    return tuple(heard)


def holds_now(formula: Formula, world: World) -> tuple[Degree, tuple[AtomDegree, ...]]:
    """Give how true a formula is at time 0, and each of its parts."""
    traced = followed(formula, world, 0.0)
    zero = traced.grid.zero
    degrees = {part: _at(truth, zero) for part, truth in traced.parts.items()}
    return _at(traced.truth, zero), tuple(_atom(part, degree, world) for part, degree in degrees.items())


def _at(truth: Truth, position: int) -> Degree:
    return Degree(float(truth.low[position]), float(truth.high[position]))


def _atom(part: Formula, degree: Degree, world: World) -> AtomDegree:
    evidence = evidence_of(part, world, certain=degree.low == degree.high)
    return AtomDegree(
        str(part), degree, evidence.value, evidence.unit, evidence.words, meaning=_meaning(part, world)
    )


def _meaning(part: Formula, world: World) -> str:
    return world.tables.variables[part.variable].terms[part.term].meaning if isinstance(part, Is) else ""


def choose(base: Base, heard: Sequence[Heard]) -> Chosen:
    """Let the rules and the table's row decide on a model and its parameters."""
    deciding = [part for part in heard if not part.rule.effect.only_scales]
    models = [part.rule.effect.model or base.model for part in deciding]
    rest = max(0.0, 1.0 - math.fsum(part.weight for part in deciding))
    votes: dict[str, float] = {}
    for model, part in zip(models, deciding, strict=True):
        votes[model] = votes.get(model, 0.0) + part.weight
    votes[base.model] = votes.get(base.model, 0.0) + rest
    winner = max(votes, key=votes.__getitem__)
    winning = [part for part, model in zip(deciding, models, strict=True) if model == winner]
    own = winner == base.model

    def mean(name: str, row: float | None) -> float | None:
        given = [(part.weight, getattr(part.rule.effect, name)) for part in winning]
        return _parameter(given, row if own or all(value is None for _, value in given) else None)

    scale = {name: _scaled(name, heard) for name in ("t", "w")}
    t = mean("t", base.t)
    t = None if t is None else t * scale["t"]
    total = math.fsum(part.weight for part in winning) + (rest if own else 0.0)
    shares = [Share(name=base.name, source=base.source, share=rest / total if own and total > 0 else 0.0)]
    for part in heard:
        won = part in winning and total > 0
        shares.append(_share(part, part.weight / total if won else 0.0))
    return Chosen(
        winner,
        t,
        mean("w", base.width(t or 0.0)) or 0.0,
        mean("core", base.core) or 0.0,
        mean("fade", base.fade) or 0.0,
        scale["w"],
        tuple(shares),
    )


def _scaled(name: str, heard: Sequence[Heard]) -> float:
    """Give the product of the factors that rules ask for, each to the power of its weight."""
    return math.prod(math.pow(part.rule.effect.scale.get(name, 1.0), part.weight) for part in heard)


def _parameter(given: Sequence[tuple[float, float | None]], row: float | None) -> float | None:
    """Give the weighted mean of those who set a parameter, the row standing in for what is left of 1."""
    pairs = [(weight, value) for weight, value in given if value is not None and weight > 0]
    rest = max(0.0, 1.0 - math.fsum(weight for weight, _ in pairs))
    if row is not None and rest > 0:
        pairs.append((rest, row))
    if not pairs:
        return row
    weights, values = zip(*pairs, strict=True)
    return takagi_sugeno(weights, values).item()


def _share(heard: Heard, share: float) -> Share:
    rule = heard.rule
    return Share(
        name=rule.name,
        source=rule.place,
        share=heard.weight if rule.effect.only_scales else share,
        degree=heard.degree,
        atoms=heard.atoms,
        scale={name: factor**heard.weight for name, factor in rule.effect.scale.items()},
    )
