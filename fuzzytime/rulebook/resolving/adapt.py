"""Adapting a model: the width law, hedges, the actor and rules' factors give its parameters, and so ψ.

The paper's formulas (section III-B1) need care. Its shift ψ(t + m_n) with m_n ≥ 0 moves a function
*earlier*: to move it to the number said, ψ(t − t_spec) is meant. Its scaling ψ(m_p·t) is about 0 and so
moves the peak as well: here a hedge scales about the anchor, by m_p = 1 / widen, before the shift.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate
from types import MappingProxyType

from fuzzytime.errors import FuzzytimeError
from fuzzytime.requirement import Constraint, TimeRequirement
from fuzzytime.rulebook.resolving.resolution import HedgeEffect
from fuzzytime.rulebook.tables.contents import BellForm, Hedge, Model, Tables
from fuzzytime.rulebook.tables.profile import Actor
from fuzzytime.satisfaction import Bell, SatisfactionFunction, Trapezoid

_NARROWEST = 1e-3
"""The least half-base, in seconds: a series may be as dense as its words like."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Wanted:
    """A model and what rows and rules fix of it, before hedges and widths.

    ``width`` is the half-base in seconds, ``scale`` a factor of it that rules ask for.
    """

    model: Model
    t: float | None
    width: float
    interval: tuple[float, float] | None = None
    hedges: tuple[str, ...] = ()
    scale: float = 1.0


@dataclass(frozen=True, slots=True)
class Adapted:
    """ψ, and the numbers that its model was filled with."""

    satisfaction: SatisfactionFunction
    parameters: Mapping[str, float]
    hedges: tuple[HedgeEffect, ...]
    notes: tuple[str, ...]


def law(tables: Tables, t: float, actor: Actor | None) -> float:
    """Give the half-base w(t) for a time named, in seconds, and an actor.

    Raises
    ------
    FuzzytimeError
        If no table gives a width.
    """
    if tables.width is None:
        raise FuzzytimeError("rule tables must give a width")
    ahead = max(t, 0.0)
    factor = tables.actors[actor](ahead) if actor is not None and actor in tables.actors else 1.0
    return tables.width(ahead) * factor


def adapt(wanted: Wanted, requirement: TimeRequirement, tables: Tables) -> Adapted:
    """Fill a model: scale it about its anchor by the hedges, then shift it to the time that was said."""
    known = [tables.time_hedges[name] for name in wanted.hedges if name in tables.time_hedges]
    notes = tuple(
        f"unknown hedge {name!r}: taken as none" for name in wanted.hedges if name not in tables.time_hedges
    )
    t = wanted.t if wanted.t is not None else max(wanted.interval[0], 0.0) if wanted.interval else 0.0
    effects = tuple(_effect(hedge, requirement, tables) for hedge in known)
    width = wanted.width * wanted.scale * math.prod(effect.factor for effect in effects)
    plateau = (tables.plateau or 0.0) * width
    # A moment is an interval without length, to a model that asks for one.
    start, end = wanted.interval if wanted.interval is not None else (t, t)
    parameters = {"t": t, "w": width, "c": plateau, "a": start, "b": end}
    shift = width * math.fsum(hedge.shift for hedge in known)
    early = t * math.fsum(hedge.spread[0] - 1.0 for hedge in known)
    late = t * math.fsum(hedge.spread[1] - 1.0 for hedge in known)
    function = _filled(wanted.model, parameters, shift + min(early, 0.0), shift + max(late, 0.0))
    used = _variables(wanted.model)
    spoken = {name: value for name, value in parameters.items() if name in used}
    return Adapted(function, MappingProxyType(spoken), effects, notes)


def said_width(requirement: TimeRequirement, tables: Tables, t: float, actor: Actor | None) -> float:
    """Give the law's width, limited by what was said.

    A clock time has at most the width of its grain ("at 6:28" is meant finely), an occurrence of a series at
    most a share of the interval ("every twenty minutes" is not thrice at once).
    """
    limits = [law(tables, t, actor)]
    if requirement.constraint is Constraint.AT and requirement.grain is not None:
        limits.append(tables.clock.get(requirement.grain, math.inf))
    interval = requirement.recurrence.interval if requirement.recurrence is not None else None
    if interval is not None and tables.repetition is not None:
        limits.append(tables.repetition * interval)
    return max(min(limits), _NARROWEST)


def _effect(hedge: Hedge, requirement: TimeRequirement, tables: Tables) -> HedgeEffect:
    factor = hedge.widen
    if factor > 1 and tables.roundness is not None:
        factor *= tables.roundness(requirement.number, requirement.unit)
    return HedgeEffect(hedge.name, factor, hedge.source)


def _variables(model: Model) -> frozenset[str]:
    sums = (model.form.centre, model.form.width) if isinstance(model.form, BellForm) else model.form.sums
    return frozenset[str]().union(*(part.variables for part in sums))


def _filled(model: Model, parameters: Mapping[str, float], early: float, late: float) -> SatisfactionFunction:
    if isinstance(model.form, BellForm):
        centre = model.form.centre.value(parameters) + (early + late) / 2
        width = model.form.width.value(parameters) + (late - early) / 2
        return Bell(centre, max(width, 1e-3), model.form.slope)
    corners = [part.value(parameters) for part in model.form.sums]
    moved = [corner + (early if i < 2 else late) for i, corner in enumerate(corners)]
    return Trapezoid(*_ordered(moved))


def _ordered(corners: Sequence[float]) -> tuple[float, float, float, float]:
    """Let later corners win over earlier ones, where a deadline has passed or an interval is short."""
    ordered = list(accumulate(reversed(corners), min))[::-1]
    first, second, third, fourth = ordered
    return first, second, third, fourth
