"""ψ of a clause: from the trace of its condition to a wish for a start soon after it comes true.

"When φ" is ψ(t) = min(⟦φ⟧(t), ℓ(t − t*)): t* is the first time at which the trace reaches 0.95 of its
maximum, ℓ is 1 for ``core`` seconds and falls to 0 over ``fade`` seconds. "While φ" is the trace itself,
"until φ" is 1 as long as it has not come true. What is true by all but a little counts as true.
"""

import math
from dataclasses import dataclass

import numpy as np

from fuzzytime.rulebook.logic.formula import Formula
from fuzzytime.rulebook.over_time.thinning import thinned
from fuzzytime.rulebook.over_time.truth import Traced, followed
from fuzzytime.rulebook.over_time.world import World
from fuzzytime.rulebook.resolving.drawing import drawn
from fuzzytime.rulebook.resolving.reasons import why_never
from fuzzytime.rulebook.resolving.resolution import Trace
from fuzzytime.satisfaction import NEVER, Floats, Sampled, SatisfactionFunction

NEVER_BELOW = 0.01
"""A trace that stays below this counts as one that never comes true."""

_REACHED = 0.95
_FULL = 0.99
"""The share of full truth at which a wish for a prompt start counts as satisfied in full."""

_SHOWN_PAST = 60.0
"""Seconds of the past that are drawn at least, where there are readings."""


@dataclass(frozen=True, slots=True)
class Awaited:
    """ψ of a clause, when its condition comes true, and what there is to draw.

    ``comes_true`` is t* in seconds, None where it does not within the horizon; ``reason`` is why ψ is 0
    everywhere, and ``untold`` says that this is only because nobody has told yet what it speaks of.
    """

    satisfaction: SatisfactionFunction
    comes_true: float | None
    reason: str | None
    trace: Trace
    untold: bool = False


def wait_for(formula: Formula, model: str, core: float, fade: float, world: World, horizon: float) -> Awaited:
    """Give ψ of a clause by its model: ``when``, ``while`` or ``until``."""
    changes = world.settled(formula) + world.memory(formula)
    ahead = min(horizon, max(changes, 1.0))
    past = min(-world.first_reading(formula), max(ahead, _SHOWN_PAST))
    traced = followed(formula, world, ahead, past)
    times, degrees = _from_now(traced, ahead)
    if changes < horizon:
        # Nothing changes any more: what holds at the end holds on, as far as anyone asks.
        times, degrees = np.append(times, horizon + core + fade), np.append(degrees, degrees[-1])
    comes_true = _first_reached(times, degrees)
    reason: str | None = None
    untold = False
    if model == "until":
        degrees = 1.0 - np.minimum(np.maximum.accumulate(degrees) / _REACHED, 1.0)
        reason = None if degrees.max() >= NEVER_BELOW else f"too late: {formula} already holds"
    elif comes_true is None:
        reason, untold = why_never(formula, world, traced, horizon, NEVER_BELOW)
    elif model == "when":
        # A moment without any leeway is t* itself, and counts in full.
        share = _FULL if core + fade > 0 else _REACHED
        times, degrees = _prompt(times, _saturated(degrees, share), comes_true, core, fade)
    else:
        degrees = _saturated(degrees, _REACHED)
    satisfaction = NEVER if reason is not None else Sampled(*thinned(times, degrees))
    trace = drawn(formula, world, traced, ahead, satisfaction)
    return Awaited(satisfaction, comes_true, reason, trace, untold)


def _from_now(traced: Traced, ahead: float) -> tuple[Floats, Floats]:
    """Give the trace from now on, to the first regular time that is not before ``ahead``."""
    grid = traced.grid
    last = grid.step * math.ceil(ahead / grid.step - 1e-9) + 1e-9
    shown = (grid.times >= 0) & (grid.times <= last)
    return grid.times[shown], traced.truth.low[shown]


def _first_reached(times: Floats, degrees: Floats) -> float | None:
    """Give t*, between points by the line between them."""
    peak = float(degrees.max())
    if peak < NEVER_BELOW:
        return None
    level = _REACHED * peak
    after = int(np.argmax(degrees >= level))
    if after == 0:
        return float(times[0])
    low, high = degrees[after - 1], degrees[after]
    return float(times[after - 1] + (level - low) / (high - low) * (times[after] - times[after - 1]))


def _saturated(degrees: Floats, share: float) -> Floats:
    """Count what has come true by all but a little as come true, or the best time would lie far away.

    An expected trace creeps up to its maximum, as the last of the curves that it is the mean of come true.
    """
    return np.minimum(degrees / share, float(degrees.max()))


def _prompt(
    times: Floats, degrees: Floats, comes_true: float, core: float, fade: float
) -> tuple[Floats, Floats]:
    """Give min(⟦φ⟧(t), ℓ(t − t*)) by points, also where the two cross."""
    full_until, gone = comes_true + core, comes_true + core + fade
    if fade == 0:
        gone = math.nextafter(full_until, math.inf)

    def promptness(at: Floats) -> Floats:
        return np.interp(at, [full_until, gone], [1.0, 0.0])

    nodes = np.union1d(times[times <= gone], [full_until, gone])
    truth = np.interp(nodes, times, degrees)
    apart = truth - promptness(nodes)
    cells = np.flatnonzero(apart[:-1] * apart[1:] < 0)
    share = apart[cells] / (apart[cells] - apart[cells + 1])
    nodes = np.union1d(nodes, nodes[cells] + share * np.diff(nodes)[cells])
    return nodes, np.minimum(np.interp(nodes, times, degrees), promptness(nodes))
