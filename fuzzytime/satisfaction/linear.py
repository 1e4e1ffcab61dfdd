"""What all piecewise linear ψ share: evaluation and geometry from one table of knots."""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from fuzzytime.satisfaction.chord import linear_chord_error
from fuzzytime.satisfaction.protocol import ACCEPTABLE, EMPTY, EVERYWHERE, Floats, Interval


@dataclass(frozen=True, slots=True, eq=False)
class Knots:
    """Where ψ bends or jumps: its limit from the left, its value, its limit from the right.

    ``times`` ascend strictly; all arrays have shape (k,), k ≥ 0. ψ is ``before`` left of the first knot,
    ``after`` right of the last, and linear between neighbours.
    """

    times: Floats
    left: Floats
    at: Floats
    right: Floats
    before: float
    after: float
    _nodes: tuple[Floats, Floats] = field(init=False)
    _jumps: tuple[Floats, Floats] = field(init=False)

    def __post_init__(self) -> None:
        nodes = np.repeat(self.times, 2), np.column_stack([self.left, self.right]).ravel()
        jumps = (self.at != self.left) | (self.at != self.right)
        object.__setattr__(self, "_nodes", nodes)
        object.__setattr__(self, "_jumps", (self.times[jumps], self.at[jumps]))

    def segments(self) -> tuple[Floats, Floats]:
        """Values at the start and end of the segments between neighbouring knots."""
        return self.right[:-1], self.left[1:]

    def evaluate(self, times: Floats) -> Floats:
        """Give ψ at times of any shape."""
        if not self.times.size:
            return np.where(np.isnan(times), np.nan, self.before)
        value = np.asarray(np.interp(times, *self._nodes, left=self.before, right=self.after))
        jump_times, jump_values = self._jumps
        if jump_times.size:
            # Between two equal nodes interpolation takes the later one: the limit from the right.
            index = np.minimum(np.searchsorted(jump_times, times), jump_times.size - 1)
            value = np.where(times == jump_times[index], jump_values[index], value)
        return value


class PiecewiseLinear(ABC):
    """ψ by knots; implementations give the knots, the rest follows."""

    __slots__ = ()

    @property
    @abstractmethod
    def knots(self) -> Knots:
        """The table of knots."""

    def __call__(self, times: ArrayLike) -> Floats:
        """Give ψ at times of any shape, in that shape."""
        return np.asarray(self.knots.evaluate(np.asarray(times, float)))

    def log(self, times: ArrayLike) -> Floats:
        """Give log ψ at times of any shape, −inf where ψ is 0."""
        with np.errstate(divide="ignore"):
            return np.asarray(np.log(self(times)))

    @property
    def kinks(self) -> tuple[float, ...]:
        """The knots."""
        return tuple(self.knots.times.tolist())

    @property
    def support(self) -> Interval:
        """The smallest interval that holds every time with ψ > 0."""
        knots = self.knots
        if not knots.times.size:
            return EVERYWHERE if knots.before > 0 else EMPTY
        following = np.append(knots.left[1:], knots.after)
        preceding = np.insert(knots.right[:-1], 0, knots.before)
        opens = np.flatnonzero((knots.at > 0) | (knots.right > 0) | (following > 0))
        closes = np.flatnonzero((knots.at > 0) | (knots.left > 0) | (preceding > 0))
        low = -math.inf if knots.before > 0 else knots.times[opens[0]] if opens.size else math.inf
        high = math.inf if knots.after > 0 else knots.times[closes[-1]] if closes.size else -math.inf
        return Interval(float(low), float(high))

    @property
    def best(self) -> Interval:
        """The interval, from the earliest best time on, on which ψ keeps its maximum; empty where ψ is 0."""
        knots = self.knots
        peak = max(knots.before, knots.after, *knots.at.tolist())
        if peak <= 0:
            return EMPTY
        if not knots.times.size:
            return EVERYWHERE
        if knots.before == peak:
            first, low = -1, -math.inf
        else:
            first = int(np.argmax(knots.at == peak))
            low = float(knots.times[first])
        last = max(first, 0) if first >= 0 or knots.left[0] == peak else -1
        while 0 <= last < knots.times.size - 1 and knots.right[last] == peak == knots.left[last + 1]:
            last += 1
        if last == knots.times.size - 1 and knots.after == peak:
            return Interval(low, math.inf)
        return Interval(low, float(knots.times[max(last, 0)]))

    @property
    def log_concave(self) -> bool:
        """Whether ψ is concave where it is not 0, without a jump or a hole there.

        Between knots log ψ is concave where ψ is linear; at a knot it is where ψ is, as both slopes of
        log ψ are those of ψ over the same value.
        """
        knots = self.knots
        support = self.support
        inside = (knots.times >= support.low) & (knots.times <= support.high)
        times, left, at, right = (x[inside] for x in (knots.times, knots.left, knots.at, knots.right))
        if times.size < 2 and math.isfinite(support.low) and math.isfinite(support.high):
            return True
        # Outer limits at the support's finite ends do not count: ψ may jump from and to 0 there.
        if math.isfinite(support.low):
            left[0] = at[0]
        if math.isfinite(support.high):
            right[-1] = at[-1]
        if (left != at).any() or (right != at).any() or (at[1:-1] <= 0).any():
            return False
        slopes = np.diff(at) / np.diff(times)
        if not math.isfinite(support.low):
            slopes = np.insert(slopes, 0, 0.0)
        if not math.isfinite(support.high):
            slopes = np.append(slopes, 0.0)
        return bool((np.diff(slopes) <= 1e-12).all())

    def crossings(self, level: float) -> tuple[float, ...]:
        """Give the finite times, ascending, at which ψ reaches, leaves or jumps across a level."""
        knots = self.knots
        lowest = np.minimum(np.minimum(knots.left, knots.right), knots.at)
        highest = np.maximum(np.maximum(knots.left, knots.right), knots.at)
        found = set(knots.times[(lowest <= level) & (level <= highest)].tolist())
        first, last = knots.segments()
        passes = np.flatnonzero((first - level) * (last - level) < 0)
        share = (level - first[passes]) / (last[passes] - first[passes])
        found.update((knots.times[passes] + share * np.diff(knots.times)[passes]).tolist())
        return tuple(sorted(found))

    def acceptable(self, level: float = ACCEPTABLE) -> Interval:
        """Give the smallest interval that holds every time with ψ ≥ level."""
        if level <= 0:
            return EVERYWHERE
        knots = self.knots
        times = np.asarray(self.crossings(level))
        # A crossing computed with rounding may miss the level by as much.
        reached = times[self(times) >= level - 1e-9] if times.size else times
        reached = np.concatenate([reached, knots.times[knots.at >= level]])
        low = -math.inf if knots.before >= level else float(reached.min(initial=math.inf))
        high = math.inf if knots.after >= level else float(reached.max(initial=-math.inf))
        return Interval(low, high)

    def chord_error(self, starts: ArrayLike, ends: ArrayLike) -> Floats:
        """Give the chord error of −log ψ on pieces on which ψ is linear."""
        first, last = np.asarray(starts, float), np.asarray(ends, float)
        return linear_chord_error(self(np.nextafter(first, last)), self(np.nextafter(last, first)))
