"""Where the strict product is 0 whatever one does: a smallest set of skills that cannot all be satisfied.

For one agent whether a set of skills can be done is decided exactly, in continuous time: the earliest moment
by which the set can be done is, over its last skill, that skill's first possible start after the earliest
moment for the others. Sets are tried by size, so that the first impossible one is a smallest. For several
agents and for lags skills are left out, one after the other, as long as the rest is still proved impossible:
no skill of what remains is superfluous, though another set might be smaller.
"""

import math
from collections.abc import Callable, Sequence

from fuzzytime.satisfaction import Interval
from fuzzytime.scheduling.limits import Stopwatch
from fuzzytime.scheduling.problem.posing import horizon_of
from fuzzytime.scheduling.problem.windows import free_of, strictly_above
from fuzzytime.scheduling.schedule import TINY
from fuzzytime.skills import FuzzyTask, Precedence

MOST_SETS = 100_000
"""How many sets of skills are tried by size."""


def clash_of(
    task: FuzzyTask, is_impossible: Callable[[tuple[int, ...]], bool], watch: Stopwatch
) -> tuple[int, ...]:
    """Give a smallest set of skills of which every arrangement leaves one without any satisfaction.

    Parameters
    ----------
    task
        What was to be scheduled.
    is_impossible
        Says of positions of skills whether it is proved that they cannot all be satisfied.
    watch
        When it is over the smallest set so far is given; nothing where none is proved.
    """
    if task.agents == 1 and all(_only_orders(task, entry) for entry in task.precedences):
        found = _by_size(task, watch)
        if found is not None:
            return found
    for position in range(len(task.skills)):
        if is_impossible((position,)):
            return (position,)
    everyone = tuple(range(len(task.skills)))
    return _thinned(everyone, is_impossible, watch) if is_impossible(everyone) else ()


def _thinned(
    members: tuple[int, ...], is_impossible: Callable[[tuple[int, ...]], bool], watch: Stopwatch
) -> tuple[int, ...]:
    """Leave out what is not needed for the set to be impossible: first whole parts, then one by one."""
    part = max(1, len(members) // 2)
    while part:
        begin = 0
        while begin < len(members) and not watch.is_over():
            rest = members[:begin] + members[begin + part :]
            if rest and is_impossible(rest):
                members = rest
            else:
                begin += part
        part //= 2
    return members


def _only_orders(task: FuzzyTask, entry: Precedence) -> bool:
    """Tell whether a precedence only says which of two skills comes first, on one agent who does both."""
    first, second = task.skills[entry.first], task.skills[entry.second]
    low = first.time_until_done + entry.minimum_lag
    works = not (first.needs_nobody or second.needs_nobody)
    return works and -second.duration < low <= first.duration and entry.maximum_lag == math.inf


def _by_size(task: FuzzyTask, watch: Stopwatch) -> tuple[int, ...] | None:
    """Give a smallest impossible set, nothing where all is possible, None where there are too many sets."""
    windows = _windows(task)
    members = [
        position
        for position, spans in enumerate(windows)
        if not (spans and task.skills[position].needs_nobody) and not _is_never_over(task, position, spans)
    ]
    before = {
        position: {entry.first for entry in task.precedences if entry.second == position}
        for position in members
    }
    done: dict[frozenset[int], float] = {frozenset(): 0.0}
    tried = 0
    while done:
        larger: dict[frozenset[int], float] = {}
        for chosen in done:
            highest = max(chosen, default=-1)
            for position in (position for position in members if position > highest):
                tried += 1
                if tried > MOST_SETS or watch.is_over():
                    return None
                together = chosen | {position}
                moments = [
                    _done(done[together - {last}], task.skills[last].duration, windows[last])
                    for last in together
                    if not any(last in before[other] for other in together)
                ]
                larger[together] = min(moments)
                if larger[together] == math.inf:
                    return tuple(sorted(together))
        done = larger
    return ()


def _windows(task: FuzzyTask) -> list[tuple[Interval, ...]]:
    """Give for each skill the starts with some satisfaction, outside appointments."""
    horizon = horizon_of(task, TINY)
    taken = tuple(sorted((Interval(busy.start, busy.end) for busy in task.busy), key=lambda span: span.low))
    wanted = (strictly_above(skill.satisfaction, TINY, horizon) for skill in task.skills)
    return [
        spans if skill.needs_nobody else free_of(spans, taken, skill.duration)
        for spans, skill in zip(wanted, task.skills, strict=True)
    ]


def _is_never_over(task: FuzzyTask, position: int, windows: Sequence[Interval]) -> bool:
    """Tell whether a skill is as possible after all others, and need not come before one of them."""
    if any(entry.first == position for entry in task.precedences) or not windows:
        return False
    is_open = task.skills[position].satisfaction.support.high == math.inf
    return is_open and all(busy.end < math.inf for busy in task.busy)


def _done(begin: float, duration: float, windows: Sequence[Interval]) -> float:
    """Give the earliest moment at which a skill is done that starts at or after another moment."""
    for window in windows:
        start = max(begin, window.low)
        if start <= window.high:
            return start + duration
    return math.inf
