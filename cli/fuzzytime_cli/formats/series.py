"""Repetitions as a person sees them: the first few of many that go as asked, and how many more there are."""

from collections import defaultdict
from collections.abc import Mapping

from fuzzytime.interpreter import Plan

SHOWN = 3
"""Occurrences of a repetition that are shown one by one."""
LEAST = 5
"""Further ones at least that stand in one row."""
AS_ASKED = 0.995
"""Satisfaction from which an occurrence is shown as 1.00."""


def folded(plan: Plan) -> Mapping[int, tuple[int, ...]]:
    """Give by the last occurrence that is shown those that stand in one row behind it, in their order.

    What satisfies less, or is rejected, is always shown.
    """
    series: defaultdict[tuple[str, str], list[int]] = defaultdict(list)
    schedule = plan.schedule
    for position in schedule.order:
        one = plan.skills[position]
        if one.repeats and not schedule.rejected[position] and schedule.satisfactions[position] >= AS_ASKED:
            series[one.wish.identifier, one.skill.name].append(position)
    return {
        positions[SHOWN - 1]: tuple(positions[SHOWN:])
        for positions in series.values()
        if len(positions) >= SHOWN + LEAST
    }


def shown(plan: Plan, rows: Mapping[int, tuple[int, ...]]) -> list[int]:
    """Give what is shown by itself, by starts: all but what is `folded` into rows."""
    hidden = {position for more in rows.values() for position in more}
    return [position for position in plan.schedule.order if position not in hidden]
