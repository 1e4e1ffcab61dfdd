"""How far a plan looks ahead, and what that means for wishes that are open or lie beyond it."""

import math
from collections.abc import Sequence
from dataclasses import replace

from fuzzytime.interpreter.interpretation import Interpreted
from fuzzytime.interpreter.joining import either
from fuzzytime.interpreter.request import MAX_HORIZON, WITHOUT_END, Request
from fuzzytime.satisfaction import NEVER, Either, Rectangle, SatisfactionFunction, Trapezoid, Triangle
from fuzzytime.scheduling import THRESHOLD
from fuzzytime.skills import FuzzySkill
from fuzzytime.times import DAY, HOUR, MINUTE, SECOND, format_duration

ROOM = 600.0
"""Seconds that a plan has to spare behind all its work."""


def horizon_of(skills: Sequence[Interpreted], request: Request) -> float:
    """Give the horizon in seconds: as asked, else past the last window, at most `MAX_HORIZON`.

    A wish that is satisfied from now on, by a deadline far away perhaps, is not put off for longer than
    `WITHOUT_END`. Behind the last window there is free time for all the work and all waits, so that what has
    no time of its own finds one.
    """
    if request.horizon is not None:
        return request.horizon
    ends = (_end(interpreted.skill.satisfaction) for interpreted in skills)
    taken = (busy.end for busy in request.busy if busy.end <= WITHOUT_END)
    last = max((0.0, *(end for end in ends if end <= MAX_HORIZON), *taken))
    work = sum(interpreted.skill.time_until_done for interpreted in skills)
    waits = sum(_waits(interpreted) for interpreted in skills)
    until = last + work + waits + ROOM
    for busy in sorted(request.busy, key=lambda busy: busy.start):
        if busy.start < until:
            until += max(0.0, busy.end - max(busy.start, last))
    return min(MAX_HORIZON, until)


def _end(function: SatisfactionFunction) -> float:
    """Give the end of a wish's window, or where it begins; soon where it may be done at once."""
    if isinstance(function, Either):
        ends = [_end(one) for one in function.functions]
        return max((end for end in ends if end <= MAX_HORIZON), default=min(ends))
    window = function.acceptable(THRESHOLD)
    end = window.high if math.isfinite(window.high) else window.low if math.isfinite(window.low) else 0.0
    return end if function.best.low > 0 else min(end, WITHOUT_END)


def _waits(interpreted: Interpreted) -> float:
    """Give how long a skill waits for others, or they for it, where its window does not show it."""
    anchors = (part.anchor for part in interpreted.requirements)
    # "An hour later" is no window of its own, where nothing says when that comes which it counts from.
    shown = math.isfinite(interpreted.skill.satisfaction.acceptable(THRESHOLD).high)
    lags = (abs(anchor.lag) for anchor in anchors if anchor is not None and not (anchor.exact and shown))
    return max(lags, default=0.0)


def passed(since: float) -> str:
    """Say that the last time that would satisfy is over, since so many seconds."""
    # How wide words are, and so when their time is over, is known to no second.
    unit = HOUR if since >= DAY else MINUTE if since >= MINUTE else SECOND
    return f"its time passed {format_duration(round(since / unit) * unit)} ago"


def within_horizon(interpreted: Interpreted, horizon: float, request: Request) -> Interpreted:
    """Close an open wish at the horizon; one beyond what the request allows, or before now, never satisfies.

    The reason is said.
    """
    function = _near(interpreted.skill.satisfaction, horizon)
    support = function.acceptable(THRESHOLD)
    reason = interpreted.reason
    if support.empty:
        return interpreted
    if support.low > horizon:
        ahead, limit = format_duration(support.low), format_duration(request.horizon or MAX_HORIZON)
        reason = f"its time is {ahead} ahead, beyond the horizon of {limit} (a longer one can be given)"
    elif support.high < 0:
        reason = passed(-support.high)
    closed = NEVER if reason != interpreted.reason else _closed(function, horizon)
    return replace(interpreted, skill=_with(interpreted.skill, closed), reason=reason)


def _near(function: SatisfactionFunction, horizon: float) -> SatisfactionFunction:
    """Give what is left of alternatives within the horizon, where any is."""
    if not isinstance(function, Either):
        return function
    near = [one for one in function.functions if one.acceptable(THRESHOLD).low <= horizon]
    return either(near) if near else function


def _closed(function: SatisfactionFunction, horizon: float) -> SatisfactionFunction:
    if isinstance(function, Either):
        return Either([_closed(one, horizon) for one in function.functions])
    if not isinstance(function, (Trapezoid, Triangle, Rectangle)):
        return function
    rise_start, full_start, full_end, fall_end = function.corners
    if full_start == -math.inf:
        rise_start = full_start = min(0.0, full_end)
    if full_end == math.inf:
        full_end = fall_end = max(horizon, full_start)
    return Trapezoid(rise_start, full_start, full_end, fall_end)


def _with(skill: FuzzySkill, function: SatisfactionFunction) -> FuzzySkill:
    return replace(skill, satisfaction=function) if function is not skill.satisfaction else skill
