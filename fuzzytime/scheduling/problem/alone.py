"""What a skill could have if it were the only one: its best start times from now on, beside appointments."""

import math
from dataclasses import dataclass

from fuzzytime.satisfaction import EMPTY, Interval, SatisfactionFunction
from fuzzytime.scheduling.problem.windows import above, free_of, in_common
from fuzzytime.skills import Busy, FuzzySkill, FuzzyTask

EQUAL = 1e-9
"""Satisfactions that differ by a smaller share are equal."""


@dataclass(frozen=True, slots=True)
class Best:
    """The largest satisfaction that a skill can have, and when.

    Parameters
    ----------
    satisfaction
        max ψ, 0 where there is no time at all.
    starts
        The interval of starts that have it; of several the one nearest to a given time. Empty where ψ is 0.
    """

    satisfaction: float
    starts: Interval

    def nearest(self, time: float) -> float:
        """Give the best start that is nearest to a time."""
        return min(max(time, self.starts.low), self.starts.high)


def best_alone(task: FuzzyTask, position: int, near: float) -> Best:
    """Give the best that a skill of a task could have if there were no other skill.

    It starts at or after 0, outside the busy times of an agent that may do it.

    Parameters
    ----------
    task, position
        The skill.
    near
        A time in seconds: of best starts that lie apart, those nearest to it are given.

    >>> from fuzzytime.satisfaction import Trapezoid
    >>> skill = FuzzySkill("call mum", Trapezoid(0, 60, 90, 120), duration=20)
    >>> best = best_alone(FuzzyTask((skill,), busy=(Busy(50.0, 100.0),)), 0, near=70)
    >>> best.starts.low, round(best.satisfaction, 2)
    (100.0, 0.67)
    """
    skill = task.skills[position]
    agents = [skill.agent] if skill.agent is not None else list(range(1, task.agents + 1))
    found = [
        best_beside(skill, [busy for busy in task.busy if busy.agent in {None, agent}], near)
        for agent in agents
    ]
    most = max(best.satisfaction for best in found)
    return min(
        (best for best in found if best.satisfaction >= most * (1 - EQUAL)),
        key=lambda best: _distance(best.starts, near),
    )


def best_beside(skill: FuzzySkill, busy: list[Busy], near: float) -> Best:
    """Give the best that a skill could have at or after 0, outside some busy times."""
    function = skill.satisfaction
    end = _end(function, busy, near) + skill.duration
    # A busy time without length takes no time from anybody.
    spans = {Interval(entry.start, entry.end) for entry in busy if entry.start < entry.end}
    taken = () if skill.needs_nobody else tuple(sorted(spans, key=lambda span: span.low))
    free = free_of((Interval(0.0, end),), taken, skill.duration)
    marks = {function.best.low, function.best.high, *function.kinks}
    times = {min(max(mark, span.low), span.high) for span in free for mark in marks if not math.isnan(mark)}
    most, time = max(((float(function(time)), -time) for time in times), default=(0.0, 0.0))
    if most <= 0:
        return Best(0.0, EMPTY)
    starts = min(
        in_common(above(function, most * (1 - EQUAL), end), free),
        key=lambda span: _distance(span, near),
        default=Interval(-time, -time),
    )
    # Where ψ is as good but for rounding begins at no time that anybody named.
    named = [time for time in times if starts.low <= time <= starts.high]
    low, high = min(named, default=starts.low), max(named, default=starts.high)
    # The end is only how far was looked.
    return Best(most, Interval(low, math.inf if starts.high == end else high))


def _end(function: SatisfactionFunction, busy: list[Busy], near: float) -> float:
    """Give a time from which on nothing changes any more, but for the falling tail of a bell."""
    ends = [entry.end for entry in busy if math.isfinite(entry.end)]
    return 1.0 + max(0.0, near, *function.kinks, *ends)


def _distance(span: Interval, time: float) -> float:
    return max(span.low - time, time - span.high, 0.0)
