"""Intervals of starts: where ψ is high enough, where agents are free, and what two rows have in common."""

import math
from collections.abc import Iterable
from itertools import islice

import numpy as np

from fuzzytime.satisfaction import Interval, SatisfactionFunction
from fuzzytime.scheduling.problem.jobs import Job

INSIDE = 1e-9
"""Seconds, or share of a time: so near to a time that is not good enough nobody starts."""


def above(function: SatisfactionFunction, floor: float, horizon: float) -> tuple[Interval, ...]:
    """Give the closed intervals of [0, horizon] with ψ > floor, by signs between kinks and crossings."""
    marks = np.array([0.0, horizon, *function.kinks, *function.crossings(floor)])
    marks = np.unique(marks[(marks >= 0) & (marks <= horizon)])
    inside = np.asarray(function((marks[:-1] + marks[1:]) / 2)) > floor
    points = np.asarray(function(marks)) > floor
    found: list[Interval] = []
    for index, mark in enumerate(marks.tolist()):
        if found and index and inside[index - 1]:
            found[-1] = Interval(found[-1].low, mark)
        elif points[index] or (index < inside.size and inside[index]):
            found.append(Interval(mark, mark))
    return tuple(found)


def strictly_above(function: SatisfactionFunction, floor: float, horizon: float) -> tuple[Interval, ...]:
    """Give what `above` does without the ends at which ψ is the floor itself: a skill is rejected there."""
    return tuple(_drawn_in(function, floor, span) for span in above(function, floor, horizon))


def _drawn_in(function: SatisfactionFunction, floor: float, span: Interval) -> Interval:
    low, high = (
        end if float(function(end)) > floor else end + inward * INSIDE * max(1.0, end)
        for end, inward in ((span.low, 1.0), (span.high, -1.0))
    )
    return Interval(low, high) if low <= high else span


def good_enough(job: Job) -> tuple[Interval, ...]:
    """Give the times, the last without end, at which a job that may be late costs no more than if it is."""
    level = math.exp(-job.rejection / job.weight) * (1 - 1e-9)
    beyond = max(0.0, *job.function.kinks, *job.function.crossings(level)) + 1.0
    spans = above(job.function, level, beyond)
    return (*spans[:-1], Interval(spans[-1].low, math.inf))


def in_common(spans: Iterable[Interval], others: Iterable[Interval]) -> tuple[Interval, ...]:
    """Give what two rows of intervals have in common; both ends of each row ascend."""
    kept, first = [*others], 0
    found: list[Interval] = []
    for span in spans:
        while first < len(kept) and kept[first].high < span.low:
            first += 1
        for other in islice(kept, first, None):
            if other.low > span.high:
                break
            part = span.intersection(other)
            if not part.empty:
                found.append(part)
    return tuple(found)


def free_of(
    wanted: tuple[Interval, ...], busy: tuple[Interval, ...], duration: float
) -> tuple[Interval, ...]:
    """Cut busy times out of windows: a start may not lie in (busy start − duration, busy end)."""
    free, gaps = -math.inf, []
    for taken in sorted(busy, key=lambda taken: taken.low):
        gaps.append(Interval(free, taken.low - duration))
        free = max(free, taken.high)
    return in_common(wanted, [*gaps, Interval(free, math.inf)])
