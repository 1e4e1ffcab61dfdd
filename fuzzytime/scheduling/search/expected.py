"""Where each skill would start if agents had time for all at once: where a search begins."""

import math

from fuzzytime.skills import FuzzySkill, FuzzyTask


def expected_starts(task: FuzzyTask) -> list[float]:
    """Give a start for each skill that keeps every lag, the soonest behind the one that was named or is best.

    A search that starts everything as soon as it can begins what must end shortly before another too early,
    and loses that other. A task without such lags needs no such starts, and gets none.
    """
    if all(entry.maximum_lag == math.inf for entry in task.precedences):
        return []
    starts = [_wanted(skill) for skill in task.skills]
    for _ in task.skills:
        before = list(starts)
        for entry in task.precedences:
            lasting = task.skills[entry.first].time_until_done
            lag = entry.minimum_lag if entry.wished_lag is None else entry.wished_lag
            starts[entry.second] = max(starts[entry.second], starts[entry.first] + lasting + lag)
            starts[entry.first] = max(starts[entry.first], starts[entry.second] - lasting - entry.maximum_lag)
        if starts == before:
            break
    return starts


def _wanted(skill: FuzzySkill) -> float:
    if skill.preferred is not None:
        return skill.preferred
    best = skill.satisfaction.best
    return max(0.0, best.low) if not best.empty and math.isfinite(best.low) else 0.0
